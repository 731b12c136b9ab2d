//! `cargo xtask test`: every check of the project, in the order in which they fail fastest.

use crate::ci::Outcome;
use anyhow::Context;
use curvecrust_lab::root;
use std::env;
use std::ffi::OsString;
use std::process::{Command, ExitCode, Stdio};
use std::time::{Duration, Instant};

/// What was typed.
#[derive(clap::Args)]
pub(crate) struct Args {}

/// One command of cargo.
pub(crate) struct Step {
    name: &'static str,
    /// A variable that holds flags, and the flag to add to it.
    flag: Option<(&'static str, &'static str)>,
    /// What follows `cargo`, separated by spaces.
    arguments: &'static str,
}

pub(crate) const FORMAT: Step = Step {
    name: "format",
    flag: None,
    arguments: "fmt --all -- --check",
};
pub(crate) const CLIPPY: Step = Step {
    name: "clippy",
    flag: None,
    arguments: "clippy --workspace --all-targets -- -D warnings",
};
const NEXTEST: Step = Step {
    name: "tests",
    flag: None,
    arguments: "nextest run --workspace",
};
// Without the doctests, which are a step of their own, and the benches, which are no tests.
const CARGO_TEST: Step = Step {
    name: "tests",
    flag: None,
    arguments: "test --workspace --lib --bins --tests --examples",
};
pub(crate) const DOCTESTS: Step = Step {
    name: "doctests",
    flag: None,
    arguments: "test --workspace --doc",
};
pub(crate) const DOCS: Step = Step {
    name: "docs",
    flag: Some(("RUSTDOCFLAGS", "-Dwarnings")),
    arguments: "doc --workspace --no-deps",
};

/// How the steps went, in the order of the run.
struct Run {
    times: Vec<(&'static str, Duration)>,
    failed: Option<Step>,
}

/// Runs the steps up to the first that fails, and shows the time of each.
pub(crate) fn run(_: &Args) -> anyhow::Result<ExitCode> {
    let steps = [FORMAT, CLIPPY, tests(), DOCTESTS, DOCS];
    let Run { times, failed } = run_until_failure(steps, |step| {
        eprintln!("\n== {}: {}", step.name, step.typed());
        step.succeeds()
    })?;
    eprintln!();
    for (name, time) in times {
        eprintln!("{name:>10} {:7.1} s", time.as_secs_f64());
    }
    Ok(match failed {
        None => {
            eprintln!("all checks passed");
            ExitCode::SUCCESS
        }
        Some(step) => {
            eprintln!("error: {} failed; alone: {}", step.name, step.typed());
            ExitCode::FAILURE
        }
    })
}

fn run_until_failure(
    steps: impl IntoIterator<Item = Step>,
    mut succeeds: impl FnMut(&Step) -> anyhow::Result<bool>,
) -> anyhow::Result<Run> {
    let mut times = Vec::new();
    for step in steps {
        let start = Instant::now();
        let success = succeeds(&step)?;
        times.push((step.name, start.elapsed()));
        if !success {
            let failed = Some(step);
            return Ok(Run { times, failed });
        }
    }
    let failed = None;
    Ok(Run { times, failed })
}

/// The tests, by nextest if it is there.
pub(crate) fn tests() -> Step {
    if has_nextest() { NEXTEST } else { CARGO_TEST }
}

impl Step {
    /// The command as one would type it.
    fn typed(&self) -> String {
        let flag = self.flag.map(|(name, flag)| format!("{name}={flag} "));
        format!("{}cargo {}", flag.unwrap_or_default(), self.arguments)
    }

    /// Runs the step as one of `cargo xtask ci`.
    pub(crate) fn outcome(&self) -> anyhow::Result<Outcome> {
        eprintln!("   {}", self.typed());
        Ok(if self.succeeds()? {
            Outcome::Passed
        } else {
            Outcome::Failed(format!("`{}` failed", self.typed()))
        })
    }

    /// Runs the step; its output goes straight through.
    fn succeeds(&self) -> anyhow::Result<bool> {
        let mut command = cargo();
        command.args(self.arguments.split(' '));
        if let Some((name, flag)) = self.flag {
            let mut flags = env::var_os(name).unwrap_or_default();
            flags.push(" ");
            flags.push(flag);
            command.env(name, flags);
        }
        let status = command
            .status()
            .with_context(|| format!("cannot start `{}`", self.typed()))?;
        Ok(status.success())
    }
}

/// The cargo that runs this task, at the root.
pub(crate) fn cargo() -> Command {
    let program = env::var_os("CARGO").unwrap_or_else(|| OsString::from("cargo"));
    let mut command = Command::new(program);
    command.current_dir(root()).stdin(Stdio::null());
    command
}

fn has_nextest() -> bool {
    cargo()
        .args(["nextest", "--version"])
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .status()
        .is_ok_and(|status| status.success())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_first_failure_ends_the_run() {
        let mut ran = Vec::new();
        let outcome = run_until_failure([FORMAT, CLIPPY, DOCS], |step| {
            ran.push(step.name);
            Ok(step.name != "clippy")
        })
        .unwrap();
        assert_eq!(ran, ["format", "clippy"]);
        assert_eq!(outcome.failed.unwrap().name, "clippy");
        assert_eq!(outcome.times.len(), 2);
    }

    #[test]
    fn a_step_that_cannot_start_is_an_error() {
        let outcome = run_until_failure([FORMAT], |_| anyhow::bail!("no cargo"));
        assert!(outcome.is_err());
    }

    #[test]
    fn steps_are_shown_as_typed() {
        assert_eq!(FORMAT.typed(), "cargo fmt --all -- --check");
        assert_eq!(
            DOCS.typed(),
            "RUSTDOCFLAGS=-Dwarnings cargo doc --workspace --no-deps"
        );
    }
}
