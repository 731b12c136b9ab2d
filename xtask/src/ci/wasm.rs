//! The libraries for WebAssembly, which have neither files nor threads there.

use super::cargo::cargo;
use super::outcome::Outcome;
use super::packages::packages;
use anyhow::Context;
use curvecrust_lab::output_of;
use std::path::Path;

const TARGET: &str = "wasm32-unknown-unknown";

/// Checks every library that is published, where the standard library of the target is installed.
pub(super) fn run() -> anyhow::Result<Outcome> {
    let folder = output_of("rustc", &["--print", "target-libdir", "--target", TARGET]);
    let folder = folder.context("cannot run rustc")?;
    if !Path::new(&folder).is_dir() {
        let why = format!("no standard library: rustup target add {TARGET}");
        return Ok(Outcome::Skipped(why));
    }
    let mut names = String::new();
    for package in packages(&["--no-deps"])? {
        if package.is_published() && package.name != "curvecrust-cli" {
            names += &format!(" -p {}", package.name);
        }
    }
    cargo(&format!("check --target {TARGET}{names}"))
}
