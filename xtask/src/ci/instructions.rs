//! Instructions of the kernels, counted by valgrind: what a loaded machine cannot hide.

use super::cargo::{command, succeeds};
use super::outcome::Outcome;
use anyhow::{Context, bail};
use curvecrust_lab::{output_of, root, write_atomically};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::process::Command;

/// The share by which a count may differ from the baseline.
const TOLERANCE: f64 = 0.03;

/// The kernels, as the program `instructions` of the benches names them.
const KERNELS: &[&str] = &[
    "point-set",
    "neighbours",
    "delaunay",
    "crust",
    "least-detour",
    "lfs",
    "sampling",
];

/// The committed counts.
#[derive(Deserialize, Serialize)]
struct Baseline {
    /// The compiler that they are of: those of others differ.
    rustc: String,
    /// Instructions of one run, in millions.
    millions: BTreeMap<String, f64>,
}

/// Compares with the baseline, or renews it.
pub(super) fn run(renew: bool) -> anyhow::Result<Outcome> {
    if !succeeds(Command::new("valgrind").arg("--version")) {
        return Ok(Outcome::Skipped("no valgrind".to_owned()));
    }
    if !cfg!(all(target_arch = "x86_64", target_os = "linux")) {
        return Ok(Outcome::Skipped(
            "counts are those of x86-64 Linux".to_owned(),
        ));
    }
    let path = root().join("benches/instructions.toml");
    let rustc = output_of("rustc", &["--version"]).context("cannot run rustc")?;
    if renew {
        let millions = count_all()?;
        let text = toml::to_string(&Baseline { rustc, millions })?;
        let head = "# Made by `cargo xtask ci instructions --renew-instructions`.\n";
        write_atomically(&path, format!("{head}{text}"))?;
        return Ok(Outcome::Passed);
    }
    let baseline = std::fs::read_to_string(&path);
    let baseline: Baseline = toml::from_str(&baseline.context("no baseline")?)?;
    if baseline.rustc != rustc {
        let why = format!("the baseline is of {}, not of {rustc}", baseline.rustc);
        return Ok(Outcome::Skipped(why));
    }
    let mut beyond = Vec::new();
    for (kernel, found) in count_all()? {
        let before = baseline.millions.get(&kernel);
        let before = *before.with_context(|| format!("no baseline of {kernel}"))?;
        let change = found / before - 1.0;
        println!("{kernel:>12} {found:9.2} million, {:+.2} %", 100.0 * change);
        if change.abs() > TOLERANCE {
            beyond.push(kernel);
        }
    }
    Ok(if beyond.is_empty() {
        Outcome::Passed
    } else {
        let which = beyond.join(", ");
        Outcome::Failed(format!(
            "instructions of {which} are not within 3 % of the baseline (--renew-instructions)"
        ))
    })
}

/// Builds the kernels and counts each.
fn count_all() -> anyhow::Result<BTreeMap<String, f64>> {
    build()?;
    let mut millions = BTreeMap::new();
    for &kernel in KERNELS {
        // What start and input cost is in both.
        let [once, twice] = [count(kernel, 1)?, count(kernel, 2)?];
        millions.insert(kernel.to_owned(), (twice - once) / 1e6);
    }
    Ok(millions)
}

/// Without dispatch: every processor is counted alike.
fn build() -> anyhow::Result<()> {
    let mut command = command();
    command.args(["build", "--release", "-p", "curvecrust-benches"]);
    command.args(["--bin", "instructions", "--features", "portable"]);
    command.args(["--target-dir", "target/instructions"]);
    if !command.status().context("cannot run cargo")?.success() {
        bail!("the kernels do not build");
    }
    Ok(())
}

/// The instructions of `runs` runs of a kernel, and of all around them.
fn count(kernel: &str, runs: u32) -> anyhow::Result<f64> {
    let out = "--callgrind-out-file=/dev/null";
    let output = Command::new("valgrind")
        .args(["--tool=callgrind", out])
        .arg(root().join("target/instructions/release/instructions"))
        .args([kernel, &runs.to_string()])
        // The C library chooses by processor too.
        .env(
            "GLIBC_TUNABLES",
            "glibc.cpu.hwcaps=-AVX2,-AVX512F,-AVX512VL,-ERMS,-FSRM",
        )
        .output()
        .context("cannot run valgrind")?;
    let text = String::from_utf8_lossy(&output.stderr);
    let line = text
        .lines()
        .find_map(|line| line.split_once("Collected : "));
    let (_, number) = line.with_context(|| format!("valgrind counted nothing: {text}"))?;
    Ok(number.trim().parse()?)
}
