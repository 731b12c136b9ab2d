//! Steps that are other programs, each with its settings in a file at the root.

use super::cargo::{outcome, succeeds};
use super::outcome::Outcome;
use curvecrust_lab::root;
use std::process::{Command, Stdio};

/// The format of TOML files, as `taplo.toml` has it.
pub(super) fn taplo() -> anyhow::Result<Outcome> {
    run("taplo", &["fmt", "--check"])
}

/// Spelling, as `_typos.toml` has it.
pub(super) fn typos() -> anyhow::Result<Outcome> {
    run("typos", &[])
}

/// Runs a program at the root, where it is installed.
fn run(program: &str, arguments: &[&str]) -> anyhow::Result<Outcome> {
    if !succeeds(Command::new(program).arg("--version")) {
        return Ok(Outcome::Skipped(format!("no {program}")));
    }
    let mut command = Command::new(program);
    command.args(arguments).current_dir(root());
    command.stdin(Stdio::null());
    let typed = [&[program], arguments].concat().join(" ");
    outcome(command, &typed)
}
