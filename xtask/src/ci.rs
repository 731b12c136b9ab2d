//! `cargo xtask ci`: what has to pass before a change goes in, all of it or step by step.
//!
//! A step whose tool is absent says so and is skipped: the first of them need nothing but cargo.

mod cargo;
mod fuzz;
mod instructions;
mod packages;
mod rust_version;

use crate::test;
use cargo::{cargo, has};
use clap::ValueEnum;
use curvecrust_lab::root;
use std::process::ExitCode;
use std::time::{Duration, Instant};

/// What was typed.
#[derive(clap::Args)]
pub(crate) struct Args {
    /// The steps to run, in their order; all if none is given
    steps: Vec<Step>,
    /// Write the instruction counts as the new baseline instead of comparing with it
    #[arg(long)]
    renew_instructions: bool,
}

/// What is run, in this order.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Step {
    /// Format of all sources
    Format,
    /// Lints, of the libraries and programs alone and with all tests and benches
    Clippy,
    /// Tests of the workspace
    Tests,
    /// Examples in the documentation
    Doctests,
    /// Documentation without a warning
    Docs,
    /// Each feature of each crate alone
    Features,
    /// The oldest Rust that the manifests promise
    RustVersion,
    /// Every crate as it would be published
    Package,
    /// Licences, bans and sources of all dependencies
    Deny,
    /// Hard points in every order, answered by every algorithm
    Adversarial,
    /// The tables of the paper within their bounds
    ReproducePaper,
    /// The experiments of compare, at few trials
    Compare,
    /// Instructions of the kernels against the committed baseline
    Instructions,
    /// Each fuzz target, for half a minute
    Fuzz,
}

/// How a step went.
pub(crate) enum Outcome {
    Passed,
    /// By which of several ways.
    PassedBy(String),
    /// What failed.
    Failed(String),
    /// What is absent.
    Skipped(String),
}

/// Runs the steps up to the first that fails, and shows the time of each.
pub(crate) fn run(args: &Args) -> anyhow::Result<ExitCode> {
    let wanted = |step: &Step| args.steps.is_empty() || args.steps.contains(step);
    let mut report = Vec::new();
    let mut failure = None;
    for step in Step::value_variants().iter().copied().filter(wanted) {
        eprintln!("\n== {}", step.name());
        let start = Instant::now();
        let outcome = step.run(args.renew_instructions)?;
        report.push((step, start.elapsed(), outcome));
        if let Some((step, _, Outcome::Failed(what))) = report.last() {
            failure = Some(format!("{what}; alone: cargo xtask ci {}", step.name()));
            break;
        }
    }
    eprintln!();
    for (step, time, outcome) in &report {
        eprintln!("{}", line(*step, *time, outcome));
    }
    Ok(match failure {
        None => ExitCode::SUCCESS,
        Some(what) => {
            eprintln!("error: {what}");
            ExitCode::FAILURE
        }
    })
}

fn line(step: Step, time: Duration, outcome: &Outcome) -> String {
    let note = match outcome {
        Outcome::Passed => String::new(),
        Outcome::PassedBy(what) => format!("  by {what}"),
        Outcome::Failed(_) => "  failed".to_owned(),
        Outcome::Skipped(why) => format!("  skipped: {why}"),
    };
    format!("{:>16} {:7.1} s{note}", step.name(), time.as_secs_f64())
}

impl Step {
    /// The name by which it is asked for.
    fn name(self) -> String {
        let value = self.to_possible_value();
        value.map_or_else(String::new, |value| value.get_name().to_owned())
    }

    fn run(self, renew_instructions: bool) -> anyhow::Result<Outcome> {
        match self {
            Self::Format => test::FORMAT.outcome(),
            Self::Clippy => {
                let alone = cargo("clippy --workspace -- -D warnings")?;
                if let Outcome::Passed = alone {
                    test::CLIPPY.outcome()
                } else {
                    Ok(alone)
                }
            }
            Self::Tests => test::tests().outcome(),
            Self::Doctests => test::DOCTESTS.outcome(),
            Self::Docs => test::DOCS.outcome(),
            Self::Features => packages::each_feature_alone(),
            Self::RustVersion => rust_version::run(),
            Self::Package => packages::publishable(),
            Self::Deny if !has("deny") => Ok(Outcome::Skipped("no cargo-deny".to_owned())),
            Self::Deny => cargo("deny check licenses bans sources"),
            Self::Adversarial => cargo("test -p curvecrust --test adversarial"),
            Self::ReproducePaper => reproduce_paper(),
            Self::Compare => cargo("xtask compare --quick"),
            Self::Instructions => instructions::run(renew_instructions),
            Self::Fuzz => fuzz::run(),
        }
    }
}

/// The tables on the authors' curves, where these are at hand.
fn reproduce_paper() -> anyhow::Result<Outcome> {
    let beside = root().join("../shared/paper-data");
    if beside.is_dir() {
        let fetched = cargo("xtask fetch-paper-data --from ../shared/paper-data")?;
        if !matches!(fetched, Outcome::Passed) {
            return Ok(fetched);
        }
    } else if !root().join("fixtures/paper").is_dir() {
        let why = "no curves of the paper: cargo xtask fetch-paper-data lays them under fixtures";
        return Ok(Outcome::Skipped(why.to_owned()));
    }
    cargo("xtask reproduce-paper")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_skipped_step_says_why() {
        let why = Outcome::Skipped("no cargo-deny".to_owned());
        let shown = line(Step::Deny, Duration::from_millis(1500), &why);
        assert_eq!(shown, "            deny     1.5 s  skipped: no cargo-deny");
    }

    #[test]
    fn the_workflow_runs_every_step() {
        let workflow = root().join(".github/workflows/ci.yml");
        let workflow = std::fs::read_to_string(workflow).unwrap();
        for step in Step::value_variants() {
            let name = step.name();
            let is_step = |line: &str| line.trim_end().ends_with(&format!("cargo xtask ci {name}"));
            assert!(workflow.lines().any(is_step), "{name}");
        }
    }
}
