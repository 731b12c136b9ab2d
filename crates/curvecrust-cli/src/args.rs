//! The arguments as they were typed. Commands make jobs of them, and never look at them again.

mod fit;
mod known;
mod puzzle;
mod tiles;
mod values;

pub(crate) use fit::Fit;
pub(crate) use known::Known;
pub(crate) use puzzle::Puzzle;
pub(crate) use tiles::Tiles;
pub(crate) use values::{Algorithm, Corners, Count, Distance, Keep, Strokes};

use crate::format::Format;
use clap::builder::ArgPredicate;
use clap::{ArgGroup, Parser, Subcommand};
use clap_complete::Shell;
use std::num::NonZeroUsize;
use std::path::PathBuf;
use values::{algorithm, readable, share};

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
    /// Threads to compute with, at most four for each processor [default: one for each]; results do
    /// not depend on it
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
    Fit(Fit),
    Check(Check),
    Evaluate(Evaluate),
    MedialAxis(MedialAxis),
    Lfs(Lfs),
    Draw(Draw),
    Puzzle(Puzzle),
    Algorithms(Algorithms),
    Completions(Completions),
}

/// Sample the curves of an SVG as sparsely as a condition allows
#[derive(Debug, clap::Args)]
#[command(group(ArgGroup::new("bound").args(["rho", "epsilon"]).required(true)), after_help = "\
Example: as few samples as HNN-Crust needs, none farther than 1 % of the curve's extent from its chords
  curvecrust sample drawing.svg --rho 0.9 --max-distance 1% -o samples.csv")]
pub(crate) struct Sample {
    #[command(flatten)]
    pub(crate) curve: Curve,
    #[command(flatten)]
    pub(crate) condition: Condition,
    /// How to choose among the samplings that satisfy the condition
    #[arg(long, value_enum, value_name = "HOW", default_value_t = Count::Fewest)]
    pub(crate) count: Count,
    /// What to do where strokes touch or cross
    #[arg(long, value_enum, value_name = "HOW", default_value_t = Strokes::Auto)]
    pub(crate) strokes: Strokes,
    /// Add samples near wrong edges until this algorithm returns the curves [default: least-detour,
    /// where no theorem says that hnn-crust does]
    #[arg(long, value_name = "ALGORITHM", value_parser = algorithm())]
    pub(crate) decoder: Option<Algorithm>,
    #[command(flatten)]
    pub(crate) output: Output,
    /// Print one JSON object to stdout
    #[arg(long)]
    pub(crate) json: bool,
}

/// Find the curves that points were sampled from
#[derive(Debug, clap::Args)]
#[command(after_help = "\
Examples: find the curves of a point file and look at them; the outline through all points of another;
the points of a third sorted along a line
  curvecrust reconstruct points.csv -o found.svg
  curvecrust reconstruct outline.csv --closed --curves 1 -o outline.svg
  curvecrust reconstruct track.csv --open --curves 1 -o sorted.csv
Points that memory cannot hold:
  curvecrust reconstruct big.npy --tiles folder --memory 2GB -o edges.npy
  curvecrust reconstruct big.npy --tiles folder --memory 2GB --polylines curves")]
pub(crate) struct Reconstruct {
    #[command(flatten)]
    pub(crate) points: Points,
    /// The algorithm: see `curvecrust algorithms`
    #[arg(
        long,
        value_name = "NAME",
        default_value = "least-detour",
        default_value_if("tiles", ArgPredicate::IsPresent, "hnn-crust"),
        value_parser = algorithm()
    )]
    pub(crate) algorithm: Algorithm,
    #[command(flatten)]
    pub(crate) known: Known,
    /// Carry this along to the result: z, the heights of the points
    #[arg(long, value_name = "COLUMN")]
    pub(crate) keep: Option<Keep>,
    /// Say in JSON why edges are there and ends are open, which takes much longer than to find them
    #[arg(long)]
    pub(crate) why: bool,
    #[command(flatten)]
    pub(crate) tiles: Tiles,
    #[command(flatten)]
    pub(crate) output: Output,
    /// Print one JSON object to stdout
    #[arg(long)]
    pub(crate) json: bool,
}

/// Measure how good samples of a curve are, and whether a condition holds
///
/// Prints the smallest epsilon and rho for which the samples satisfy the condition, and the
/// intervals that violate the one given, in which case the exit status is 1.
#[derive(Debug, clap::Args)]
#[command(group(ArgGroup::new("bound").args(["rho", "epsilon"])), after_help = "\
Example: is HNN-Crust sure to find the curve from these samples?
  curvecrust check drawing.svg samples.csv --rho 0.9")]
pub(crate) struct Check {
    #[command(flatten)]
    pub(crate) curve: Curve,
    #[command(flatten)]
    pub(crate) points: Points,
    #[command(flatten)]
    pub(crate) condition: Condition,
    #[command(flatten)]
    pub(crate) tolerance: Tolerance,
    /// Print one JSON object to stdout
    #[arg(long)]
    pub(crate) json: bool,
}

/// Compare what algorithms find with the curve that the points were sampled from
///
/// The exit status is 1 unless every algorithm finds exactly the edges between consecutive samples.
#[derive(Debug, clap::Args)]
#[command(after_help = "\
Example: two algorithms on the same samples
  curvecrust evaluate drawing.svg samples.csv --algorithm hnn-crust --algorithm crust")]
pub(crate) struct Evaluate {
    #[command(flatten)]
    pub(crate) curve: Curve,
    #[command(flatten)]
    pub(crate) points: Points,
    /// An algorithm, and another one: see `curvecrust algorithms`
    #[arg(long, value_name = "NAME", default_value = "least-detour", value_parser = algorithm())]
    pub(crate) algorithm: Vec<Algorithm>,
    #[command(flatten)]
    pub(crate) tolerance: Tolerance,
    /// Print one JSON object to stdout
    #[arg(long)]
    pub(crate) json: bool,
}

/// Compute the medial axis of the curves of an SVG
#[derive(Debug, clap::Args)]
#[command(after_help = "\
Example: a picture of a drawing and its medial axis
  curvecrust medial-axis drawing.svg -o axis.svg")]
pub(crate) struct MedialAxis {
    #[command(flatten)]
    pub(crate) curve: Curve,
    #[command(flatten)]
    pub(crate) output: Output,
    /// Print one JSON object to stdout
    #[arg(long)]
    pub(crate) json: bool,
}

/// Draw a curve, its medial axis, points and their reconstruction, over each other
#[derive(Debug, clap::Args)]
#[command(
    group(ArgGroup::new("what").args(["curve", "points"]).required(true).multiple(true)),
    after_help = "\
Example: samples over their curve, with the edges found from them and where they are too few
  curvecrust draw --curve drawing.svg --points samples.csv --edges --violations -o picture.svg"
)]
pub(crate) struct Draw {
    /// Curves: an SVG document
    #[arg(long, value_name = "CURVE.svg")]
    pub(crate) curve: Option<PathBuf>,
    #[command(flatten)]
    pub(crate) strokes: StrokesOf,
    /// The medial axis of the curve
    #[arg(long, requires = "curve")]
    pub(crate) medial_axis: bool,
    /// The local feature size of the curve, as its colour
    #[arg(long, requires = "curve")]
    pub(crate) lfs: bool,
    /// Points: a file, or - for stdin
    #[arg(long, value_name = "POINTS")]
    pub(crate) points: Option<PathBuf>,
    #[command(flatten)]
    pub(crate) reading: Reading,
    /// The edges that an algorithm finds between the points
    #[arg(
        long,
        value_name = "NAME",
        num_args = 0..=1,
        default_missing_value = "least-detour",
        requires = "points",
        value_parser = algorithm()
    )]
    pub(crate) edges: Option<Algorithm>,
    /// Colour edges by the reasons for them, and show rejected partners of open ends
    #[arg(long, requires = "edges")]
    pub(crate) why: bool,
    /// Smooth curves fitted to the points, which may scatter: see `curvecrust fit`
    #[arg(long, requires = "points", conflicts_with = "edges")]
    pub(crate) fit: bool,
    /// Marks at points with another number of edges than on a closed curve
    #[arg(long, requires = "points")]
    pub(crate) violations: bool,
    /// The file to write; - for stdout, which is the default
    #[arg(long, short, value_name = "FILE")]
    pub(crate) output: Option<PathBuf>,
    /// Overwrite an existing file
    #[arg(long)]
    pub(crate) force: bool,
}

/// Print a script that completes commands and options in a shell
#[derive(Debug, clap::Args)]
#[command(after_help = "\
Example: for bash
  curvecrust completions bash > ~/.local/share/bash-completion/completions/curvecrust")]
pub(crate) struct Completions {
    /// The shell
    pub(crate) shell: Shell,
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

/// List the algorithms with their guarantees and sources
#[derive(Debug, clap::Args)]
#[command(after_help = "\
Example: the names alone
  curvecrust algorithms --json | jq -r '.algorithms[].name'")]
pub(crate) struct Algorithms {
    /// Print one JSON object to stdout
    #[arg(long)]
    pub(crate) json: bool,
}

/// A curve and how it is made into dense points.
#[derive(Debug, clap::Args)]
pub(crate) struct Curve {
    /// Curves: an SVG document, or - for stdin
    #[arg(id = "curve_path", value_name = "CURVE.svg")]
    pub(crate) path: PathBuf,
    /// Largest gap between the dense points that stand for the curve, as a share of the local
    /// feature size [default: 0.02, or finer where a condition asks for it]
    #[arg(long, value_name = "SHARE", allow_negative_numbers = true, value_parser = share)]
    pub(crate) gap: Option<f64>,
    /// Number of dense points on each cubic segment instead
    #[arg(long, value_name = "N", conflicts_with = "gap")]
    pub(crate) per_segment: Option<u32>,
    #[command(flatten)]
    pub(crate) strokes: StrokesOf,
}

/// Which strokes of a document are curves.
#[derive(Debug, clap::Args)]
pub(crate) struct StrokesOf {
    /// What to do where a curve has corners
    #[arg(long, value_enum, value_name = "HOW", default_value_t = Corners::Split)]
    pub(crate) corners: Corners,
    /// Join gaps and leave out segments up to this share of the drawing, where corners are split
    #[arg(long, value_name = "PERCENT", default_value = "0.01%", value_parser = values::percent)]
    pub(crate) snap: f64,
    /// Take only elements of this id, class or layer; may be given more than once
    #[arg(long, value_name = "NAME")]
    pub(crate) select: Vec<String>,
    /// Leave out elements of this id, class or layer; may be given more than once
    #[arg(long, value_name = "NAME")]
    pub(crate) exclude: Vec<String>,
}

/// How near the samples have to be.
#[derive(Debug, clap::Args)]
pub(crate) struct Condition {
    /// Every interval between samples within RHO times its reach; HNN-Crust is proven for 0.888
    #[arg(long, value_name = "RHO", allow_negative_numbers = true)]
    pub(crate) rho: Option<f64>,
    /// Every point within EPSILON times its local feature size; HNN-Crust is proven for 0.47
    #[arg(long, value_name = "EPSILON", allow_negative_numbers = true)]
    pub(crate) epsilon: Option<f64>,
    /// No curve point farther than this from the line through its two samples: a length, or a share
    /// of the curve's extent such as 1%
    #[arg(
        long,
        value_name = "LENGTH",
        requires = "bound",
        allow_negative_numbers = true
    )]
    pub(crate) max_distance: Option<Distance>,
}

/// How near points have to be to a curve to be its samples.
#[derive(Debug, clap::Args)]
pub(crate) struct Tolerance {
    /// Points farther from the curve than this are an error: a length, or a share of the curve's
    /// extent
    #[arg(
        long,
        value_name = "LENGTH",
        default_value = "0.1%",
        allow_negative_numbers = true
    )]
    pub(crate) tolerance: Distance,
}

/// A file of points.
#[derive(Debug, clap::Args)]
pub(crate) struct Points {
    /// Points: a file, or - for stdin
    #[arg(id = "points", value_name = "POINTS")]
    pub(crate) path: PathBuf,
    #[command(flatten)]
    pub(crate) reading: Reading,
}

/// How a file of points is read.
#[derive(Debug, clap::Args)]
pub(crate) struct Reading {
    /// The format of the points [default: that of the name or of the content]
    #[arg(long, value_name = "FORMAT", requires = "points", value_parser = readable())]
    pub(crate) from: Option<Format>,
    /// The column of a table that holds x [default: x, lon, longitude or easting]
    #[arg(long, value_name = "NAME", requires = "points", requires = "y")]
    pub(crate) x: Option<String>,
    /// The column of a table that holds y [default: y, lat, latitude or northing]
    #[arg(long, value_name = "NAME", requires = "points", requires = "x")]
    pub(crate) y: Option<String>,
    /// Take the vertices of lines and polygons for points, in maps: geojson, wkt, wkb, kml,
    /// shapefile, flatgeobuf and geoparquet
    #[arg(long, requires = "points")]
    pub(crate) vertices: bool,
    /// Take equal points for one, instead of refusing them
    #[arg(long, requires = "points")]
    pub(crate) merge_duplicates: bool,
    /// Take points within a distance for one: a length, or a share of the points' extent, as 0.001%
    #[arg(
        long,
        value_name = "LENGTH|PERCENT",
        requires = "points",
        conflicts_with = "merge_duplicates"
    )]
    pub(crate) merge_within: Option<Distance>,
}

/// Where a result goes.
#[derive(Debug, clap::Args)]
pub(crate) struct Output {
    /// The file to write; - for stdout, which is the default
    #[arg(long, short, value_name = "FILE")]
    pub(crate) output: Option<PathBuf>,
    /// The format to write [default: that of the name]
    #[arg(long, value_name = "FORMAT")]
    pub(crate) to: Option<Format>,
    /// Overwrite an existing file
    #[arg(long)]
    pub(crate) force: bool,
}
