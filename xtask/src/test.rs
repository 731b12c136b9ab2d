//! `cargo xtask test`: the steps of `cargo xtask ci` that need nothing but cargo.

use crate::ci;
use std::process::ExitCode;

/// What was typed.
#[derive(clap::Args)]
pub(crate) struct Args {}

/// Runs the steps up to the first that fails, and shows the time of each.
pub(crate) fn run(_: &Args) -> anyhow::Result<ExitCode> {
    let status = ci::test()?;
    if status == ExitCode::SUCCESS {
        eprintln!("all checks passed");
    }
    Ok(status)
}
