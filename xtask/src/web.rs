//! `cargo xtask web`: the explorer as a folder of static files, `target/web`.
//!
//! The module is built for WebAssembly by the first toolchain that can; the page is copied beside
//! it, with the fixtures as one script, so that the page asks for nothing after it has loaded.

mod fixtures;
pub(crate) mod module;
mod serve;

use anyhow::Context;
use curvecrust_lab::{root, write_atomically};
use std::fs;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

/// What was typed.
#[derive(clap::Args)]
pub(crate) struct Args {
    /// Show the page at a port of this machine until interrupted
    #[arg(long)]
    serve: bool,
    /// The port
    #[arg(long, default_value_t = 8080, requires = "serve")]
    port: u16,
}

/// What the page is copied from; the folder of each file is left out.
const PAGE: &str = "crates/curvecrust-web/page";

/// Builds the page, and shows it if that was asked for.
pub(crate) fn run(args: &Args) -> anyhow::Result<ExitCode> {
    let built = build()?;
    match built {
        Ok(folder) if args.serve => serve::run(&folder, args.port)?,
        Ok(folder) => eprintln!("written: {}", folder.display()),
        Err(missing) => anyhow::bail!("{missing}"),
    }
    Ok(ExitCode::SUCCESS)
}

/// Builds the page: its folder, or in words what has to be installed for that.
pub(crate) fn build() -> anyhow::Result<Result<PathBuf, String>> {
    let module = match module::build()? {
        Ok(module) => module,
        Err(missing) => return Ok(Err(missing)),
    };
    let folder = root().join("target/web");
    fs::create_dir_all(&folder)?;
    for entry in fs::read_dir(root().join(PAGE))? {
        let from = entry?.path();
        copy(&from, &folder)?;
    }
    let bytes = fs::read(&module).with_context(|| format!("cannot read {}", module.display()))?;
    write_atomically(&folder.join("curvecrust.wasm"), bytes)?;
    write_atomically(&folder.join("fixtures.js"), fixtures::script()?)?;
    Ok(Ok(folder))
}

fn copy(from: &Path, folder: &Path) -> anyhow::Result<()> {
    let name = from.file_name().context("a file of the page has no name")?;
    fs::copy(from, folder.join(name)).with_context(|| format!("cannot copy {}", from.display()))?;
    Ok(())
}
