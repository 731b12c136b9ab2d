//! The oldest Rust that the manifests promise.

use super::cargo::{cargo, outcome, succeeds};
use super::outcome::Outcome;
use super::packages::{Package, packages};
use anyhow::Context;
use curvecrust_lab::root;
use std::process::Command;

/// By that Rust itself where it is installed. Else by what can be known without it: no dependency
/// asks for a younger one, and clippy knows since when each part of the standard library is there
/// (`incompatible_msrv`).
pub(super) fn run() -> anyhow::Result<Outcome> {
    let all = packages(&[])?;
    let promised = all.iter().filter(|p| p.source.is_none());
    let promised = promised.filter_map(|p| p.rust_version.as_deref());
    let oldest = promised.min_by_key(|version| numbers(version));
    let oldest = oldest.context("no manifest has a rust-version")?;
    let younger: Vec<&str> = all
        .iter()
        .filter(|package| asks_for_more(package, oldest))
        .map(|package| package.name.as_str())
        .collect();
    if !younger.is_empty() {
        let which = younger.join(", ");
        return Ok(Outcome::Failed(format!(
            "Rust {oldest} is promised, and a younger one is asked for by {which}"
        )));
    }
    if installed(oldest) {
        return by_itself(oldest);
    }
    let linted = cargo("clippy --workspace --all-targets -- -D warnings")?;
    Ok(if let Outcome::Passed = linted {
        Outcome::PassedBy(format!(
            "clippy and what dependencies ask for, Rust {oldest} is not installed"
        ))
    } else {
        linted
    })
}

fn asks_for_more(package: &Package, oldest: &str) -> bool {
    let asked = package.rust_version.as_deref();
    asked.is_some_and(|asked| numbers(asked) > numbers(oldest))
}

/// The numbers of a version, for comparison: 1.90 and 1.90.0 are equal.
fn numbers(version: &str) -> [u32; 3] {
    let mut numbers = version.split('.').map(|part| part.parse().unwrap_or(0));
    [(); 3].map(|()| numbers.next().unwrap_or(0))
}

/// Checks the workspace by another Rust than this one.
fn by_itself(version: &str) -> anyhow::Result<Outcome> {
    let mut command = foreign(version);
    command.args(["check", "--workspace", "--all-targets"]);
    command.args(["--target-dir", "target/oldest-rust"]);
    let checked = outcome(command, &format!("cargo +{version} check --workspace"))?;
    Ok(if let Outcome::Passed = checked {
        Outcome::PassedBy(format!("Rust {version} itself"))
    } else {
        checked
    })
}

fn installed(version: &str) -> bool {
    // Without this, rustup would fetch it.
    let mut probe = foreign(version);
    probe.env("RUSTUP_AUTO_INSTALL", "0");
    succeeds(probe.arg("--version"))
}

/// The cargo of another Rust.
fn foreign(version: &str) -> Command {
    let mut command = Command::new("cargo");
    command.current_dir(root());
    // Not those of the Rust that runs this.
    for name in ["RUSTUP_TOOLCHAIN", "CARGO", "RUSTC"] {
        command.env_remove(name);
    }
    command.arg(format!("+{version}"));
    command
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn versions_are_compared_by_number() {
        assert_eq!(numbers("1.90"), numbers("1.90.0"));
        assert!(numbers("1.100") > numbers("1.90.1"));
        assert!(numbers("1.9") < numbers("1.90"));
    }
}
