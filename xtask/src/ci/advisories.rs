//! Known vulnerabilities of dependencies, by the database of RustSec.

use super::cargo::{cargo, command, has};
use super::outcome::Outcome;

/// Both lock files: that of the workspace and that of the fuzz targets.
const MANIFESTS: [&str; 2] = ["Cargo.toml", "fuzz/Cargo.toml"];

/// Fetches the database once and asks it for each lock file. The step is skipped where the database
/// cannot be reached: it says nothing about the sources then.
pub(super) fn run() -> anyhow::Result<Outcome> {
    if !has("deny") {
        return Ok(Outcome::Skipped("no cargo-deny".to_owned()));
    }
    eprintln!("   cargo deny fetch db");
    let fetched = command().args(["deny", "fetch", "db"]).output()?;
    if !fetched.status.success() {
        let why = "the database of advisories cannot be reached";
        return Ok(Outcome::Skipped(why.to_owned()));
    }
    for manifest in MANIFESTS {
        let checked = cargo(&format!(
            "deny --manifest-path {manifest} --config deny.toml check advisories"
        ))?;
        if !matches!(checked, Outcome::Passed) {
            return Ok(checked);
        }
    }
    Ok(Outcome::Passed)
}
