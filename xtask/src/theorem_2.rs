//! `cargo xtask theorem-2`: the proofs of Theorem 2 by machine; see `curvecrust_proof`.

use anyhow::Context;
use curvecrust_lab::{root, write_atomically};
use curvecrust_proof::{Certificate, Curves, check, prove};
use std::process::ExitCode;
use std::time::Instant;

/// Boxes narrower than this are given up.
const LEAST: f64 = 1e-5;

/// What is proven, and where the certificate is.
struct Proof {
    name: &'static str,
    curves: Curves,
    rho: f64,
    place: &'static str,
}

const PROOFS: [Proof; 2] = [
    Proof {
        name: "smooth",
        curves: Curves::Smooth,
        rho: 0.888,
        place: "fixtures/theorem-2.certificate",
    },
    Proof {
        name: "arcs",
        curves: Curves::Arcs,
        rho: 0.895,
        place: "fixtures/theorem-2-arcs.certificate",
    },
];

/// What was typed.
#[derive(clap::Args)]
pub(crate) struct Args {
    /// Only for these curves: all smooth ones, or those with arcs of constant curvature
    #[arg(long, value_parser = PROOFS.map(|proof| proof.name))]
    curves: Option<String>,
    /// Prove that HNN-Crust is right for every rho below this one
    #[arg(long, requires = "curves")]
    rho: Option<f64>,
    /// Only check the certificates that are there
    #[arg(long, conflicts_with = "rho")]
    check: bool,
}

/// Writes the certificates and checks them; says how long each took. Status 1 without a proof.
pub(crate) fn run(args: &Args) -> anyhow::Result<ExitCode> {
    let name = args.curves.as_deref();
    let mut all = true;
    for proof in PROOFS {
        if name.is_none_or(|name| name == proof.name) {
            all &= (args.check || proof.write(args.rho.unwrap_or(proof.rho))?) && proof.check()?;
        }
    }
    Ok(ExitCode::from(u8::from(!all)))
}

impl Proof {
    /// Writes the certificate; false if a box resists.
    fn write(&self, rho: f64) -> anyhow::Result<bool> {
        let start = Instant::now();
        let certificate = match prove(self.curves, rho, LEAST) {
            Ok(certificate) => certificate,
            Err(resisting) => {
                println!("{}, rho < {rho}: not proven: {resisting}", self.name);
                return Ok(false);
            }
        };
        let seconds = start.elapsed().as_secs_f64();
        println!("{}, rho < {rho}: proven in {seconds:.1} s", self.name);
        write_atomically(&root().join(self.place), certificate.to_string())?;
        Ok(true)
    }

    /// Whether the certificate that is there is accepted.
    fn check(&self) -> anyhow::Result<bool> {
        let text = std::fs::read_to_string(root().join(self.place))
            .with_context(|| format!("cannot read {}", self.place))?;
        let start = Instant::now();
        let certificate: Certificate = text.parse()?;
        anyhow::ensure!(
            certificate.curves == self.curves,
            "{} is about other curves",
            self.place
        );
        let verdict = check(&certificate);
        println!(
            "{}, rho < {}: {} boxes, checked in {:.1} s: {}",
            self.name,
            certificate.rho,
            certificate.nodes.len(),
            start.elapsed().as_secs_f64(),
            verdict
                .as_ref()
                .map_or_else(ToString::to_string, |()| "accepted".to_owned())
        );
        Ok(verdict.is_ok())
    }
}
