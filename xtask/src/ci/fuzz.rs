//! The fuzz targets, built with plain cargo on a stable toolchain, and run for a while.

use super::cargo::{command, outcome, succeeds};
use super::outcome::Outcome;
use anyhow::Context;
use curvecrust_lab::{output_of, root};
use std::path::Path;
use std::process::Command;
use std::{env, fs};

/// Seconds for each target.
const SECONDS: u32 = 30;

/// Coverage as libFuzzer reads it: what cargo-fuzz passes, none of which is unstable.
const FLAGS: &str = "--cfg fuzzing -Cpasses=sancov-module \
    -Cllvm-args=-sanitizer-coverage-level=4 \
    -Cllvm-args=-sanitizer-coverage-inline-8bit-counters \
    -Cllvm-args=-sanitizer-coverage-pc-table \
    -Cllvm-args=-sanitizer-coverage-trace-compares \
    -Ccodegen-units=1";

/// Builds all targets and runs each, from the corpus that is there.
pub(super) fn run() -> anyhow::Result<Outcome> {
    // LibFuzzer is built from its sources.
    let compiler = env::var_os("CXX").unwrap_or_else(|| "c++".into());
    if !succeeds(Command::new(&compiler).arg("--version")) {
        let compiler = compiler.to_string_lossy();
        return Ok(Outcome::Skipped(format!("no C++ compiler {compiler}")));
    }
    let workspace = root().join("fuzz");
    let host = host()?;
    let mut build = command();
    build.current_dir(&workspace).env("RUSTFLAGS", FLAGS);
    // With a target, flags are not for build scripts.
    build.args(["build", "--release", "--target", &host]);
    let built = outcome(build, "cargo build --release, in fuzz")?;
    if !matches!(built, Outcome::Passed) {
        return Ok(built);
    }
    let programs = workspace.join("target").join(&host).join("release");
    for target in targets()? {
        eprintln!("   {target}, {SECONDS} s");
        let program = programs.join(&target);
        if let Some(find) = fuzz(&workspace, &program, &target)? {
            eprintln!("{find}");
            return Ok(Outcome::Failed(format!("fuzz target {target}")));
        }
    }
    Ok(Outcome::Passed)
}

/// Runs a target for a while: what it says if it finds something, shown in short if not.
fn fuzz(workspace: &Path, program: &Path, target: &str) -> anyhow::Result<Option<String>> {
    let corpus = workspace.join("corpus").join(target);
    let artifacts = workspace.join("artifacts").join(target);
    fs::create_dir_all(&corpus)?;
    fs::create_dir_all(&artifacts)?;
    let mut command = Command::new(program);
    command.arg(&corpus);
    command.arg(format!("-max_total_time={SECONDS}"));
    command.arg(format!("-artifact_prefix={}/", artifacts.display()));
    command.args(["-print_final_stats=1", "-timeout=300"]);
    let dictionary = format!("dictionaries/{target}.dict");
    let dictionary = workspace.join(dictionary);
    if dictionary.is_file() {
        command.arg(format!("-dict={}", dictionary.display()));
    }
    let output = command.output();
    let output = output.with_context(|| format!("cannot start {}", program.display()))?;
    let message = String::from_utf8_lossy(&output.stderr);
    if !output.status.success() {
        return Ok(Some(message.into_owned()));
    }
    let done = message.lines().rfind(|line| line.contains("DONE"));
    eprintln!("   {}", done.unwrap_or_default().trim());
    Ok(None)
}

/// The names of the targets, which are those of their files.
fn targets() -> anyhow::Result<Vec<String>> {
    let mut names = Vec::new();
    for entry in fs::read_dir(root().join("fuzz/fuzz_targets"))? {
        let path = entry?.path();
        names.extend(
            path.file_stem()
                .map(|name| name.to_string_lossy().into_owned()),
        );
    }
    names.sort();
    Ok(names)
}

/// The platform of this compiler.
fn host() -> anyhow::Result<String> {
    let text = output_of("rustc", &["-vV"]).context("cannot run rustc")?;
    let line = text.lines().find_map(|line| line.strip_prefix("host: "));
    Ok(line.context("rustc names no host")?.to_owned())
}
