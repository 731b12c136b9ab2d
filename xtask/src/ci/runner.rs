//! Runs steps one after the other, and says what each one does and how it went.

use super::outcome::Outcome;
use super::step::Step;
use std::fmt;
use std::time::{Duration, Instant};

/// The steps that ran, in their order; only the last one can have failed.
#[derive(Debug)]
pub(super) struct Run {
    report: Vec<(Step, Duration, Outcome)>,
}

/// Announces and performs each step, up to the first that fails.
pub(super) fn until_failure(
    steps: &[Step],
    mut perform: impl FnMut(Step) -> anyhow::Result<Outcome>,
) -> anyhow::Result<Run> {
    let mut report = Vec::new();
    for &step in steps {
        eprintln!("\n== {}: {}", step.name(), step.about());
        let start = Instant::now();
        let outcome = perform(step)?;
        let failed = matches!(outcome, Outcome::Failed(_));
        report.push((step, start.elapsed(), outcome));
        if failed {
            break;
        }
    }
    Ok(Run { report })
}

impl Run {
    /// What failed, and how to run that step alone.
    pub(super) fn failure(&self) -> Option<String> {
        let (step, _, Outcome::Failed(what)) = self.report.last()? else {
            return None;
        };
        Some(format!("{what}; alone: cargo xtask ci {}", step.name()))
    }
}

/// One line for each step: name, time and, where there is more to say, a note.
impl fmt::Display for Run {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (step, time, outcome) in &self.report {
            let note = match outcome {
                Outcome::Passed => String::new(),
                Outcome::PassedBy(what) => format!("  by {what}"),
                Outcome::Failed(_) => "  failed".to_owned(),
                Outcome::Skipped(why) => format!("  skipped: {why}"),
            };
            writeln!(f, "{:>16} {:7.1} s{note}", step.name(), time.as_secs_f64())?;
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_first_failure_ends_the_run() {
        let mut ran = Vec::new();
        let run = until_failure(&[Step::Format, Step::Clippy, Step::Docs], |step| {
            ran.push(step);
            Ok(match step {
                Step::Clippy => Outcome::Failed("`cargo clippy` failed".to_owned()),
                _ => Outcome::Passed,
            })
        })
        .unwrap();
        assert_eq!(ran, [Step::Format, Step::Clippy]);
        let failure = "`cargo clippy` failed; alone: cargo xtask ci clippy";
        assert_eq!(run.failure().as_deref(), Some(failure));
        assert_eq!(run.to_string().lines().count(), 2);
    }

    #[test]
    fn a_step_that_cannot_start_is_an_error() {
        assert!(until_failure(&[Step::Format], |_| anyhow::bail!("no cargo")).is_err());
    }

    #[test]
    fn a_skipped_step_says_why_and_is_no_failure() {
        let why = || Outcome::Skipped("no cargo-deny".to_owned());
        let mut run = until_failure(&[Step::Deny], |_| Ok(why())).unwrap();
        assert_eq!(run.failure(), None);
        run.report[0].1 = Duration::from_millis(1500);
        let shown = "            deny     1.5 s  skipped: no cargo-deny\n";
        assert_eq!(run.to_string(), shown);
    }
}
