//! The packages of the workspace, each by itself: its features, and what would be published of it.

use super::cargo::{cargo, command};
use super::outcome::Outcome;
use anyhow::{Context, ensure};
use curvecrust_lab::root;
use serde::Deserialize;
use std::collections::BTreeMap;
use std::fs;

/// What is read of `cargo metadata`.
#[derive(Deserialize)]
struct Metadata {
    packages: Vec<Package>,
}

#[derive(Deserialize)]
pub(super) struct Package {
    pub(super) name: String,
    pub(super) rust_version: Option<String>,
    /// Where it comes from, if not from the workspace.
    pub(super) source: Option<String>,
    /// The registries it may go to: all if there is no list.
    publish: Option<Vec<String>>,
    features: BTreeMap<String, Vec<String>>,
}

impl Package {
    pub(super) fn is_published(&self) -> bool {
        self.publish.as_ref().is_none_or(|to| !to.is_empty())
    }
}

/// The packages that `cargo metadata` lists, given more arguments.
pub(super) fn packages(arguments: &[&str]) -> anyhow::Result<Vec<Package>> {
    let mut command = command();
    command.args(["metadata", "--format-version", "1"]);
    let output = command.args(arguments).output();
    let output = output.context("cannot run cargo metadata")?;
    let error = String::from_utf8_lossy(&output.stderr);
    ensure!(output.status.success(), "cargo metadata failed: {error}");
    let metadata: Metadata = serde_json::from_slice(&output.stdout)?;
    Ok(metadata.packages)
}

/// Each crate without features, if it has any, and with each one alone.
pub(super) fn each_feature_alone() -> anyhow::Result<Outcome> {
    for Package { name, features, .. } in packages(&["--no-deps"])? {
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

/// Every crate as it would be published, built from nothing but its package. In a folder of its own
/// each time: cargo takes two packages of one version and place for the same, changed or not.
pub(super) fn publishable() -> anyhow::Result<Outcome> {
    let target = root().join("target");
    fs::create_dir_all(&target)?;
    let fresh = tempfile::Builder::new()
        .prefix("package-")
        .tempdir_in(target)?;
    let name = fresh.path().file_name().unwrap_or_default();
    let name = name.to_string_lossy();
    let mut without = String::new();
    for package in packages(&["--no-deps"])? {
        if !package.is_published() {
            without += &format!(" --exclude {}", package.name);
        }
    }
    cargo(&format!(
        "package --workspace{without} --allow-dirty --config profile.dev.debug=0 \
         --target-dir target/{name}"
    ))
}
