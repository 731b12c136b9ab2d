//! Steps that are commands of cargo or of other programs.

use super::outcome::Outcome;
use anyhow::Context;
use curvecrust_lab::root;
use std::env;
use std::ffi::OsString;
use std::process::{Command, Stdio};

/// The cargo that runs this task, at the root. Each step builds once: what cargo keeps to build
/// again would fill the disk.
pub(super) fn command() -> Command {
    let program = env::var_os("CARGO").unwrap_or_else(|| OsString::from("cargo"));
    let mut command = Command::new(program);
    command.current_dir(root()).stdin(Stdio::null());
    command.env("CARGO_INCREMENTAL", "0");
    command
}

/// Runs a command of cargo, its arguments separated by spaces.
pub(super) fn cargo(arguments: &str) -> anyhow::Result<Outcome> {
    let mut command = command();
    command.args(arguments.split(' '));
    outcome(command, &format!("cargo {arguments}"))
}

/// Runs a command of cargo with one more flag in a variable that holds flags.
pub(super) fn cargo_with((name, flag): (&str, &str), arguments: &str) -> anyhow::Result<Outcome> {
    let mut flags = env::var_os(name).unwrap_or_default();
    flags.push(" ");
    flags.push(flag);
    let mut command = command();
    command.args(arguments.split(' ')).env(name, flags);
    outcome(command, &format!("{name}={flag} cargo {arguments}"))
}

/// Shows and runs a command; its output goes straight through.
pub(crate) fn outcome(mut command: Command, typed: &str) -> anyhow::Result<Outcome> {
    eprintln!("   {typed}");
    let status = command
        .status()
        .with_context(|| format!("cannot start `{typed}`"))?;
    Ok(if status.success() {
        Outcome::Passed
    } else {
        Outcome::Failed(format!("`{typed}` failed"))
    })
}

/// Whether cargo has a subcommand.
pub(super) fn has(subcommand: &str) -> bool {
    succeeds(command().args([subcommand, "--version"]))
}

/// Whether a command succeeds; it is not heard.
pub(crate) fn succeeds(command: &mut Command) -> bool {
    let quiet = command.stdout(Stdio::null()).stderr(Stdio::null());
    quiet.status().is_ok_and(|status| status.success())
}
