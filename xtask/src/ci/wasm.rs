//! The libraries for WebAssembly, which have neither files nor threads there.

use super::cargo::outcome;
use super::outcome::Outcome;
use super::packages::packages;
use crate::web::module::{TARGET, toolchain};
use curvecrust_lab::root;

/// Checks every library that is published, where there is a standard library for the target.
pub(super) fn run() -> anyhow::Result<Outcome> {
    let Some(mut cargo) = toolchain() else {
        let why = format!("no standard library: rustup target add {TARGET}");
        return Ok(Outcome::Skipped(why));
    };
    let mut names = String::new();
    for package in packages(&["--no-deps"])? {
        if package.is_published() && package.name != "curvecrust-cli" {
            names += &format!(" -p {}", package.name);
        }
    }
    let arguments = format!("check --target {TARGET} --target-dir target/wasm{names}");
    cargo.args(arguments.split(' ')).current_dir(root());
    outcome(cargo, &format!("cargo {arguments}"))
}
