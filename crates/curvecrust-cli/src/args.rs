//! What was typed.

use crate::format::Format;
use clap::builder::PossibleValuesParser;
use clap::{Parser, Subcommand};
use curvecrust::reconstruct::ALGORITHMS;
use std::num::NonZeroUsize;
use std::path::PathBuf;
use std::str::FromStr;

/// Samples of smooth curves as sparse as a theorem allows, and curves from bare points.
#[derive(Debug, Parser)]
#[command(
    name = "curvecrust",
    version,
    after_help = "\
Exit status: 0 when all is well, 1 when a condition or an evaluation failed, 2 when a command could not
be carried out.

Example: sample a drawing, forget the order of the samples, and find the curve again
  curvecrust sample drawing.svg --rho 0.9 -o samples.csv
  curvecrust reconstruct samples.csv -o found.svg"
)]
pub(crate) struct Cli {
    #[command(subcommand)]
    pub(crate) command: Command,
    /// Threads to compute with [default: all processors]; results do not depend on it
    #[arg(long, global = true, value_name = "N")]
    pub(crate) threads: Option<NonZeroUsize>,
    /// Print nothing but results and errors
    #[arg(long, short, global = true)]
    pub(crate) quiet: bool,
}

#[derive(Debug, Subcommand)]
pub(crate) enum Command {
    Sample(Sample),
    Reconstruct(Reconstruct),
    Lfs(Lfs),
    Algorithms(Algorithms),
}

/// Sample the curves of an SVG as sparsely as a condition allows
#[derive(Debug, clap::Args)]
#[command(after_help = "\
Example: as few samples as HNN-Crust needs, none farther than 1 % of the curve's extent from its chords
  curvecrust sample drawing.svg --rho 0.9 --max-distance 1% -o samples.csv")]
pub(crate) struct Sample {
    #[command(flatten)]
    pub(crate) curve: Curve,
    #[command(flatten)]
    pub(crate) condition: Condition,
    #[command(flatten)]
    pub(crate) output: Output,
    /// Print one JSON object to stdout
    #[arg(long)]
    pub(crate) json: bool,
}

/// Find the curves that points were sampled from
#[derive(Debug, clap::Args)]
#[command(after_help = "\
Example: find the curves of a point file and look at them
  curvecrust reconstruct points.csv -o found.svg")]
pub(crate) struct Reconstruct {
    #[command(flatten)]
    pub(crate) points: Points,
    /// The algorithm: see `curvecrust algorithms`
    #[arg(long, value_name = "NAME", default_value = "hnn-crust", value_parser = algorithm_names())]
    pub(crate) algorithm: String,
    /// The point at this position of the input, counted from 0, is the end of an open curve
    #[arg(long, value_name = "N")]
    pub(crate) terminus: Vec<u32>,
    #[command(flatten)]
    pub(crate) output: Output,
    /// Print one JSON object to stdout
    #[arg(long)]
    pub(crate) json: bool,
}

/// Print the local feature size along the curves of an SVG
#[derive(Debug, clap::Args)]
#[command(after_help = "\
Example: a table of curve, x, y, lfs
  curvecrust lfs drawing.svg -o lfs.csv")]
pub(crate) struct Lfs {
    #[command(flatten)]
    pub(crate) curve: Curve,
    #[command(flatten)]
    pub(crate) output: Output,
    /// Print one JSON object to stdout
    #[arg(long)]
    pub(crate) json: bool,
}

/// List the algorithms, what they are proven for and where they come from
#[derive(Debug, clap::Args)]
#[command(after_help = "\
Example: the names alone
  curvecrust algorithms --json | jq -r '.[].name'")]
pub(crate) struct Algorithms {
    /// Print one JSON array to stdout
    #[arg(long)]
    pub(crate) json: bool,
}

/// A curve and how it is made into dense points.
#[derive(Debug, clap::Args)]
pub(crate) struct Curve {
    /// Smooth curves: an SVG document, or - for stdin
    #[arg(value_name = "CURVE.svg")]
    pub(crate) path: PathBuf,
    /// Largest gap between the dense points that stand for the curve, as a share of the local feature size
    #[arg(long, value_name = "SHARE", default_value_t = 0.02)]
    pub(crate) gap: f64,
    /// So many dense points on each cubic segment instead; 300 in the paper
    #[arg(long, value_name = "N", conflicts_with = "gap")]
    pub(crate) per_segment: Option<u32>,
}

/// How near the samples have to be.
#[derive(Debug, clap::Args)]
pub(crate) struct Condition {
    /// Every interval between samples within RHO times its reach; HNN-Crust is proven for 0.9
    #[arg(long, value_name = "RHO", required_unless_present = "epsilon")]
    pub(crate) rho: Option<f64>,
    /// Every point within EPSILON times its local feature size; HNN-Crust is proven for 0.47
    #[arg(long, value_name = "EPSILON", conflicts_with = "rho")]
    pub(crate) epsilon: Option<f64>,
    /// No curve point farther than this from the line through its two samples: a length, or a share of the
    /// curve's extent such as 1%
    #[arg(long, value_name = "LENGTH")]
    pub(crate) max_distance: Option<Distance>,
}

/// A file of points.
#[derive(Debug, clap::Args)]
pub(crate) struct Points {
    /// Points: a file, or - for stdin
    #[arg(value_name = "POINTS")]
    pub(crate) path: PathBuf,
    /// The format of the points, if neither name nor content tells
    #[arg(long, value_name = "FORMAT")]
    pub(crate) from: Option<Format>,
    /// Take equal points for one, instead of refusing them
    #[arg(long)]
    pub(crate) merge_duplicates: bool,
}

/// Where a result goes.
#[derive(Debug, clap::Args)]
pub(crate) struct Output {
    /// The file to write; - for stdout, which is the default
    #[arg(long, short, value_name = "FILE")]
    pub(crate) output: Option<PathBuf>,
    /// The format to write, if the name does not tell
    #[arg(long, value_name = "FORMAT")]
    pub(crate) to: Option<Format>,
    /// Overwrite an existing file
    #[arg(long)]
    pub(crate) force: bool,
}

/// A length, or a share of the extent of a curve.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Distance {
    Length(f64),
    Percent(f64),
}

impl FromStr for Distance {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let (number, percent) = match text.strip_suffix('%') {
            Some(number) => (number, true),
            None => (text, false),
        };
        match number.trim().parse::<f64>() {
            Ok(value) if value.is_finite() && value > 0.0 => Ok(if percent {
                Self::Percent(value)
            } else {
                Self::Length(value)
            }),
            _ => Err(String::from(
                "give a length above 0, such as 2.5, or a share, such as 1%",
            )),
        }
    }
}

fn algorithm_names() -> PossibleValuesParser {
    PossibleValuesParser::new(ALGORITHMS.iter().map(|algorithm| algorithm.info().name))
}
