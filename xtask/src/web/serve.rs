//! The page at a port of this machine, for whoever builds it.

use anyhow::Context;
use std::path::Path;
use std::process::Command;

/// Shows a folder until interrupted. Any static server will do; Python's is on most machines.
pub(super) fn run(folder: &Path, port: u16) -> anyhow::Result<()> {
    eprintln!("http://localhost:{port}");
    let mut server = Command::new("python3");
    server.args([
        "-m",
        "http.server",
        "--bind",
        "localhost",
        &port.to_string(),
    ]);
    let status = server.current_dir(folder).status();
    status.context("cannot start python3: show target/web by any other static server")?;
    Ok(())
}
