//! `cargo xtask ci`: what has to pass before a change goes in, all of it or step by step.
//!
//! A step whose tool is absent says so and is skipped. `cargo xtask test` runs those of the steps
//! that need nothing but cargo, by the same runner.

mod advisories;
pub(crate) mod cargo;
mod fuzz;
mod instructions;
mod lines;
pub(crate) mod outcome;
mod packages;
mod runner;
mod rust_version;
mod step;
mod tools;
mod wasm;
mod web;
#[cfg(test)]
mod workflow;

use clap::ValueEnum;
use outcome::Outcome;
use std::process::ExitCode;
use step::Step;

/// What was typed.
#[derive(clap::Args)]
pub(crate) struct Args {
    /// The steps to run, in their order; all if none is given
    steps: Vec<Step>,
    /// Write the instruction counts as the new baseline instead of comparing with it
    #[arg(long)]
    renew_instructions: bool,
    /// Fail where a step would be skipped
    #[arg(long)]
    no_skip: bool,
}

/// Runs the steps that were asked for, up to the first that fails.
pub(crate) fn run(args: &Args) -> anyhow::Result<ExitCode> {
    let wanted = |step: &Step| args.steps.is_empty() || args.steps.contains(step);
    let steps: Vec<Step> = Step::value_variants()
        .iter()
        .copied()
        .filter(wanted)
        .collect();
    run_steps(&steps, |step| {
        Ok(match step.run(args.renew_instructions)? {
            Outcome::Skipped(why) if args.no_skip => Outcome::Failed(why),
            outcome => outcome,
        })
    })
}

/// Runs the steps that need nothing but cargo, up to the first that fails.
pub(crate) fn test() -> anyhow::Result<ExitCode> {
    run_steps(&Step::TEST, |step| step.run(false))
}

/// Performs steps up to the first that fails, and shows the time of each: status 0 or 1.
fn run_steps(
    steps: &[Step],
    perform: impl FnMut(Step) -> anyhow::Result<Outcome>,
) -> anyhow::Result<ExitCode> {
    let run = runner::until_failure(steps, perform)?;
    eprint!("\n{run}");
    Ok(match run.failure() {
        None => ExitCode::SUCCESS,
        Some(failure) => {
            eprintln!("error: {failure}");
            ExitCode::FAILURE
        }
    })
}
