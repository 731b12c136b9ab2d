//! The module, built for WebAssembly by the first toolchain that has a standard library for it.

use anyhow::{Context, ensure};
use curvecrust_lab::{output_of, root};
use std::path::{Path, PathBuf};
use std::process::Command;

pub(crate) const TARGET: &str = "wasm32-unknown-unknown";

/// Vectors, which all browsers have known since 2023: the search of neighbours takes half the time.
/// And few copies of inlined functions and loops, which take a thirtieth of the module and gain
/// nothing.
const FLAGS: &str = "-Ctarget-feature=+simd128 -Cllvm-args=-inline-threshold=26 \
    -Cllvm-args=-inlinehint-threshold=38 -Cllvm-args=-unroll-runtime=false";

/// What only the source of the standard library allows, on top of [`FLAGS`]: a panic has nowhere
/// to print its message and its place, and these are a twentieth of the module.
const QUIET: &str = "-Zlocation-detail=none -Zunstable-options -Cpanic=immediate-abort";

/// Debian's packages, which bring the source of the standard library: it is built with the module.
const DEBIAN: [&str; 2] = ["/usr/bin/rustc", "/usr/bin/cargo"];

/// Builds the module: its file, or in words what has to be installed for that.
pub(super) fn build() -> anyhow::Result<Result<PathBuf, String>> {
    let Some(mut cargo) = toolchain() else {
        return Ok(Err(format!(
            "no standard library for WebAssembly: rustup target add {TARGET}, or on Debian \
             apt-get install rustc-web cargo-web rust-web-src"
        )));
    };
    cargo.args(["build", "--package", "curvecrust-web", "--lib"]);
    cargo.args(["--profile", "web", "--target", TARGET]);
    // Apart from the other builds: another compiler would make cargo build all of them again.
    cargo
        .args(["--target-dir", "target/wasm"])
        .current_dir(root());
    let status = cargo.status().context("cannot start cargo")?;
    ensure!(status.success(), "the module could not be built");
    let built = format!("target/wasm/{TARGET}/web/curvecrust_web.wasm");
    Ok(Ok(root().join(built)))
}

/// The cargo that can build for the target: the ordinary one, else Debian's.
pub(crate) fn toolchain() -> Option<Command> {
    let folder = output_of("rustc", &["--print", "target-libdir", "--target", TARGET]);
    if folder.is_some_and(|folder| Path::new(&folder).is_dir()) {
        return Some(cargo("cargo", FLAGS));
    }
    let [rustc, cargo] = DEBIAN;
    let sysroot = output_of(rustc, &["--print", "sysroot"])?;
    let source = Path::new(&sysroot).join("lib/rustlib/src/rust/library/std");
    let linker = linker()?;
    if !source.is_dir() || !Path::new(cargo).is_file() {
        return None;
    }
    let mut command = self::cargo(cargo, &format!("{FLAGS} {QUIET}"));
    command.args([
        "-Z",
        "build-std=std,panic_abort",
        "-Zbuild-std-features=optimize_for_size",
    ]);
    command.env("RUSTC", rustc).env("RUSTC_BOOTSTRAP", "1");
    command.env("CARGO_TARGET_WASM32_UNKNOWN_UNKNOWN_LINKER", linker);
    // Of the toolchain that runs this task; they would lead back to it.
    for name in ["RUSTUP_TOOLCHAIN", "CARGO", "RUSTDOC", "RUSTC_WRAPPER"] {
        command.env_remove(name);
    }
    Some(command)
}

/// A cargo with flags for the compiler. What it would keep to build again only fills the disk.
fn cargo(program: &str, flags: &str) -> Command {
    let mut command = Command::new(program);
    command
        .env("RUSTFLAGS", flags)
        .env("CARGO_INCREMENTAL", "0");
    command
}

/// The linker for WebAssembly that comes with every toolchain of rustup.
fn linker() -> Option<PathBuf> {
    let libraries = output_of("rustc", &["--print", "target-libdir"])?;
    let beside = Path::new(&libraries).parent()?.join("bin/rust-lld");
    beside.is_file().then_some(beside)
}
