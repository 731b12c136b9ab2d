//! `cargo xtask theorem-2`: the proof of Theorem 2 by machine; see `curvecrust_proof`.

use anyhow::Context;
use curvecrust_lab::{root, write_atomically};
use curvecrust_proof::{Certificate, check, prove};
use std::process::ExitCode;
use std::time::Instant;

/// Where the certificate is.
const PLACE: &str = "fixtures/theorem-2.certificate";

/// Boxes narrower than this are given up.
const LEAST: f64 = 1e-5;

/// What was typed.
#[derive(clap::Args)]
pub(crate) struct Args {
    /// Prove that HNN-Crust is right for every rho below this one
    #[arg(long, default_value_t = 0.888)]
    rho: f64,
    /// Only check the certificate that is there
    #[arg(long, conflicts_with = "rho")]
    check: bool,
}

/// Writes a certificate and checks it; says how long each took. Status 1 if there is no proof.
pub(crate) fn run(args: &Args) -> anyhow::Result<ExitCode> {
    let path = root().join(PLACE);
    if !args.check {
        let start = Instant::now();
        let certificate = match prove(args.rho, LEAST) {
            Ok(certificate) => certificate,
            Err(resisting) => {
                println!("rho < {}: not proven: {resisting}", args.rho);
                return Ok(ExitCode::FAILURE);
            }
        };
        println!("proven in {:.1} s", start.elapsed().as_secs_f64());
        write_atomically(&path, certificate.to_string())?;
    }
    let text = std::fs::read_to_string(&path).with_context(|| format!("cannot read {PLACE}"))?;
    let start = Instant::now();
    let certificate: Certificate = text.parse()?;
    let verdict = check(&certificate);
    println!(
        "rho < {}: {} boxes, checked in {:.1} s: {}",
        certificate.rho,
        certificate.nodes.len(),
        start.elapsed().as_secs_f64(),
        verdict
            .as_ref()
            .map_or_else(ToString::to_string, |()| "accepted".to_owned())
    );
    Ok(ExitCode::from(u8::from(verdict.is_err())))
}
