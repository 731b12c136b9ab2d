//! The commands, one file each.

mod algorithms;
mod bare_points;
mod check;
mod completions;
mod condition;
mod curve_source;
mod draw;
mod evaluate;
mod fit;
mod guarantee;
mod lfs;
mod medial_axis;
mod puzzle;
mod reconstruct;
mod sample;

use crate::args::Command;
use crate::console::Console;
use clap_complete::Shell;
use curvecrust::evaluate::Bounds as KnownBounds;
use serde::Serialize;

/// What is to be done: a command whose arguments are understood, and whose output can be written.
#[derive(Debug)]
pub(crate) enum Job {
    Sample(sample::Job),
    Reconstruct(reconstruct::Job),
    Tiled(reconstruct::tiled::Job),
    /// By far the largest.
    Fit(Box<fit::Job>),
    Check(check::Job),
    Evaluate(evaluate::Job),
    MedialAxis(medial_axis::Job),
    Lfs(lfs::Job),
    Draw(draw::Job),
    Puzzle(puzzle::Job),
    Algorithms {
        json: bool,
    },
    Completions(Shell),
}

impl Job {
    pub(crate) fn new(command: Command) -> anyhow::Result<Self> {
        Ok(match command {
            Command::Sample(args) => Self::Sample(sample::Job::new(args)?),
            Command::Reconstruct(args) => match args.tiles.tiles.clone() {
                Some(folder) => Self::Tiled(reconstruct::tiled::Job::new(args, folder)?),
                None => Self::Reconstruct(reconstruct::Job::new(args)?),
            },
            Command::Fit(args) => Self::Fit(Box::new(fit::Job::new(args)?)),
            Command::Check(args) => Self::Check(check::Job::new(args)?),
            Command::Evaluate(args) => Self::Evaluate(args.into()),
            Command::MedialAxis(args) => Self::MedialAxis(medial_axis::Job::new(args)?),
            Command::Lfs(args) => Self::Lfs(lfs::Job::new(args)?),
            Command::Draw(args) => Self::Draw(draw::Job::new(args)?),
            Command::Puzzle(args) => Self::Puzzle(puzzle::Job::new(args)?),
            Command::Algorithms(args) => Self::Algorithms { json: args.json },
            Command::Completions(args) => Self::Completions(args.shell),
        })
    }

    /// Whether it computes anything, which it may do in many threads.
    pub(crate) fn computes(&self) -> bool {
        !matches!(self, Self::Algorithms { .. } | Self::Completions(_))
    }

    pub(crate) fn run(self, console: &Console) -> anyhow::Result<Outcome> {
        match self {
            Self::Sample(job) => job.run(console),
            Self::Reconstruct(job) => job.run(console),
            Self::Tiled(job) => job.run(console),
            Self::Fit(job) => job.run(console),
            Self::Check(job) => job.run(console),
            Self::Evaluate(job) => job.run(console),
            Self::MedialAxis(job) => job.run(console),
            Self::Lfs(job) => job.run(console),
            Self::Draw(job) => job.run(console),
            Self::Puzzle(job) => job.run(console),
            Self::Algorithms { json } => algorithms::run(json),
            Self::Completions(shell) => completions::run(shell),
        }
    }
}

/// A number that is known to lie between two others; in JSON, infinity is null.
#[derive(Clone, Copy, Debug, Serialize)]
struct Bounds {
    lower: f64,
    upper: f64,
}

impl From<KnownBounds> for Bounds {
    fn from(KnownBounds { lower, upper }: KnownBounds) -> Self {
        Self { lower, upper }
    }
}

/// How a command that could be carried out ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Outcome {
    /// All is well.
    Fine,
    /// A condition does not hold, or an evaluation found faults: exit status 1.
    Failed,
}

impl Outcome {
    pub(crate) fn fine_if(all_is_well: bool) -> Self {
        if all_is_well {
            Self::Fine
        } else {
            Self::Failed
        }
    }
}
