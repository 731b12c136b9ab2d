//! Steps that are commands of cargo.

use super::Outcome;
use crate::test;
use anyhow::Context;
use serde::Deserialize;
use std::collections::BTreeMap;
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

/// What is read of `cargo metadata`.
#[derive(Deserialize)]
struct Metadata {
    packages: Vec<Package>,
}

#[derive(Deserialize)]
struct Package {
    name: String,
    rust_version: Option<String>,
    features: BTreeMap<String, Vec<String>>,
}

fn packages() -> anyhow::Result<Vec<Package>> {
    let mut command = test::cargo();
    command.args(["metadata", "--no-deps", "--format-version", "1"]);
    let output = command.output().context("cannot run cargo metadata")?;
    let metadata: Metadata = serde_json::from_slice(&output.stdout)?;
    Ok(metadata.packages)
}

/// Each crate without features, if it has any, and with each one alone.
pub(super) fn each_feature_alone() -> anyhow::Result<Outcome> {
    for Package { name, features, .. } in packages()? {
        for feature in features.keys() {
            let only = format!("--no-default-features --features {feature}");
            let alone = cargo(&format!("check --all-targets -p {name} {only}"))?;
            if !matches!(alone, Outcome::Passed) {
                return Ok(alone);
            }
        }
    }
    Ok(Outcome::Passed)
}

/// Checks the workspace by the Rust that the manifests promise. Clippy refuses younger parts of the
/// standard library whatever Rust there is (`incompatible_msrv`).
pub(super) fn oldest_rust() -> anyhow::Result<Outcome> {
    let versions = packages()?.into_iter().filter_map(|p| p.rust_version);
    let oldest = versions.min().context("no manifest has a rust-version")?;
    let mut command = Command::new("cargo");
    command.current_dir(crate::root::root());
    // Not those of the Rust that runs this.
    for name in ["RUSTUP_TOOLCHAIN", "CARGO", "RUSTC"] {
        command.env_remove(name);
    }
    let toolchain = format!("+{oldest}");
    command.arg(&toolchain);
    let mut probe = Command::new("cargo");
    probe.arg(&toolchain).arg("--version");
    // Without this, rustup would fetch it.
    probe
        .env("RUSTUP_AUTO_INSTALL", "0")
        .env_remove("RUSTUP_TOOLCHAIN");
    if !succeeds(&mut probe) {
        return Ok(Outcome::Skipped(format!("no Rust {oldest}")));
    }
    command.args(["check", "--workspace", "--all-targets"]);
    outcome(
        command,
        &format!("cargo {toolchain} check --workspace --all-targets"),
    )
}
