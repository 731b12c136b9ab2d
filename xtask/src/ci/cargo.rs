//! Steps that are commands of cargo.

use super::Outcome;
use crate::test;
use anyhow::Context;
use std::process::{Command, Stdio};

/// Runs a command of cargo, its arguments separated by spaces.
pub(super) fn cargo(arguments: &str) -> anyhow::Result<Outcome> {
    eprintln!("   cargo {arguments}");
    let mut command = test::cargo();
    command.args(arguments.split(' '));
    outcome(command, &format!("cargo {arguments}"))
}

/// Runs a command; its output goes straight through.
pub(super) fn outcome(mut command: Command, typed: &str) -> anyhow::Result<Outcome> {
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
    succeeds(test::cargo().args([subcommand, "--version"]))
}

pub(super) fn succeeds(command: &mut Command) -> bool {
    let quiet = command.stdout(Stdio::null()).stderr(Stdio::null());
    quiet.status().is_ok_and(|status| status.success())
}
