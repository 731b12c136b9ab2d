//! `cargo xtask theorem-2`: the proof by machine; see `curvecrust_lab::theorem_2`.

use curvecrust_lab::theorem_2::{accepts, prove};
use std::process::ExitCode;
use std::time::Instant;

/// What was typed.
#[derive(clap::Args)]
pub(crate) struct Args {
    /// Prove that HNN-Crust is right for every rho below this one
    #[arg(long, default_value_t = 0.86)]
    rho: f64,
}

/// Proves and checks; says how long each took.
pub(crate) fn run(args: &Args) -> anyhow::Result<ExitCode> {
    let start = Instant::now();
    let certificate = match prove(args.rho) {
        Ok(certificate) => certificate,
        Err(resisting) => {
            println!("rho < {}: not proven: {resisting}", args.rho);
            return Ok(ExitCode::FAILURE);
        }
    };
    let proven = start.elapsed();
    let accepted = accepts(args.rho, &certificate);
    println!(
        "rho < {}: {} nodes in {:.1} s, checked in {:.1} s: {}",
        args.rho,
        certificate.len(),
        proven.as_secs_f64(),
        (start.elapsed() - proven).as_secs_f64(),
        if accepted { "accepted" } else { "refused" }
    );
    Ok(ExitCode::from(u8::from(!accepted)))
}
