//! The explorer in a browser, against the native library.

use super::cargo::{command, outcome, succeeds};
use super::outcome::Outcome;
use anyhow::{Context, ensure};
use curvecrust_lab::{root, write_atomically};
use std::process::Command;

/// The names under which browsers are installed.
const BROWSERS: [&str; 3] = ["chromium", "chromium-browser", "google-chrome"];

/// Builds the page and its test, and runs it where there is a browser.
pub(super) fn run() -> anyhow::Result<Outcome> {
    let has = |program: &&str| succeeds(Command::new(program).arg("--version"));
    let skipped = |why: &str| Ok(Outcome::Skipped(why.to_owned()));
    let Some(browser) = BROWSERS.iter().find(|program| has(program)) else {
        return skipped("no chromium");
    };
    if !has(&"node") {
        return skipped("no node");
    }
    let playwright = root().join("target/tools/node");
    if !playwright.join("node_modules/playwright-core").is_dir() {
        return skipped("no playwright: npm install --prefix target/tools/node playwright-core");
    }
    let folder = match crate::web::build()? {
        Ok(folder) => folder,
        Err(missing) => return Ok(Outcome::Skipped(missing)),
    };
    let expected = root().join("target/web-expected.json");
    write_atomically(&expected, native_results()?)?;
    let mut test = Command::new("node");
    test.arg("crates/curvecrust-web/browser/explorer.mjs");
    test.args([&folder, &expected, &root().join("target/web-pictures")]);
    test.env("PLAYWRIGHT", playwright)
        .env("BROWSER", path_of(browser));
    test.current_dir(root());
    outcome(test, "node crates/curvecrust-web/browser/explorer.mjs")
}

/// What the library finds on all fixtures, on one thread as in the browser.
fn native_results() -> anyhow::Result<Vec<u8>> {
    let mut native = command();
    native.args(["run", "--release", "--package", "curvecrust-web"]);
    native
        .args(["--example", "expected"])
        .env("RAYON_NUM_THREADS", "1");
    let output = native.output().context("cannot run cargo")?;
    let error = String::from_utf8_lossy(&output.stderr);
    ensure!(
        output.status.success(),
        "the native results failed: {error}"
    );
    Ok(output.stdout)
}

/// Where a program is: browsers are started by their path.
fn path_of(program: &str) -> String {
    let found = curvecrust_lab::output_of("which", &[program]);
    found.unwrap_or_else(|| program.to_owned())
}
