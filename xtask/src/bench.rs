//! `cargo xtask bench`: the table of medians and ratios to peers and goals.
//!
//! The measuring is the program `summary` of the benches package, in a build of its own: no task
//! but this one has to compile the peers.

use anyhow::Context;
use curvecrust_lab::root;
use std::process::{Command, ExitCode};

/// What was typed.
#[derive(clap::Args)]
pub(crate) struct Args {
    /// A tenth of the sizes, to see that all runs
    #[arg(long)]
    quick: bool,
    /// Without dispatch at run time: only the neighbour kernel, as for the oldest processors
    #[arg(long)]
    no_dispatch: bool,
    /// Only these stages: kiddo, neighbours, growth, threads, delaunay, least-detour, lfs, sampling
    stages: Vec<String>,
}

/// Builds and runs the program.
pub(crate) fn run(args: &Args) -> anyhow::Result<ExitCode> {
    let mut cargo = Command::new(std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into()));
    cargo.current_dir(root()).args([
        "run",
        "--release",
        "--package",
        "curvecrust-benches",
        "--bin",
        "summary",
    ]);
    if args.no_dispatch {
        cargo.args(["--features", "portable"]);
    }
    cargo.arg("--");
    if args.quick {
        cargo.arg("quick");
    }
    cargo.args(&args.stages);
    let status = cargo.status().context("cannot run cargo")?;
    Ok(ExitCode::from(if status.success() { 0 } else { 2 }))
}
