//! `cargo xtask reproduce-paper`.

use anyhow::bail;
use std::process::ExitCode;

/// What was typed.
#[derive(clap::Args)]
pub(crate) struct Args {}

/// Runs the task.
pub(crate) fn run(_: &Args) -> anyhow::Result<ExitCode> {
    bail!("not built yet")
}
