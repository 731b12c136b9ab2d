//! The arguments of `curvecrust fit`.

use super::known::shape;
use super::{Output, Points};
use curvecrust::denoise::Options;
use std::num::NonZeroU32;
use std::path::PathBuf;

/// Fit smooth curves to points that scatter about them, some of which belong to none
///
/// It needs no parameter: it estimates how far points scatter, which of them are outliers and how
/// many curves there are. Points that do not scatter are joined as by `reconstruct`.
#[derive(Debug, clap::Args)]
#[command(after_help = "\
Examples: smooth curves of a noisy scan as cubic Béziers; the same as lines for a map, and the points
that belong to them
  curvecrust fit scan.csv -o curve.svg
  curvecrust fit scan.csv -o curve.geojson --inliers inliers.csv")]
pub(crate) struct Fit {
    #[command(flatten)]
    pub(crate) points: Points,
    #[command(flatten)]
    pub(crate) known: FitKnown,
    /// How far lines may be from the curves, in all formats but SVG and JSON: a length [default: a
    /// twentieth of the points' deviation]
    #[arg(long, value_name = "LENGTH", allow_negative_numbers = true)]
    pub(crate) tolerance: Option<f64>,
    /// Write the points that belong to a curve to this file: a table with their row, curve and
    /// distance
    #[arg(long, value_name = "FILE")]
    pub(crate) inliers: Option<PathBuf>,
    #[command(flatten)]
    pub(crate) output: Output,
    /// Print one JSON object to stdout
    #[arg(long)]
    pub(crate) json: bool,
}

/// What the user knows about curves that points scatter about.
#[derive(Debug, clap::Args)]
pub(crate) struct FitKnown {
    /// No curve ends
    #[arg(long)]
    pub(crate) closed: bool,
    /// No curve is closed
    #[arg(long, conflicts_with = "closed")]
    pub(crate) open: bool,
    /// How many curves there are
    #[arg(long, value_name = "N")]
    pub(crate) curves: Option<NonZeroU32>,
    /// The standard deviation of the points from their curves, as a length; 0 if they lie on them
    #[arg(long, value_name = "LENGTH", allow_negative_numbers = true)]
    pub(crate) sigma: Option<f64>,
}

impl From<FitKnown> for Options {
    fn from(known: FitKnown) -> Self {
        Self {
            shape: shape(known.closed, known.open),
            curves: known.curves,
            sigma: known.sigma,
        }
    }
}
