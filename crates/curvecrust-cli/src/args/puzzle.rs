//! The arguments of `curvecrust puzzle`.

use super::values::percent;
use super::{Curve, Distance, Output};

/// Make a connect-the-closest-dot puzzle of the curves of an SVG
///
/// Each dot has one colour or more. To solve the puzzle, join each dot with the closest other dot
/// of its colour, and a dot of several colours once for each of them. That draws the curves again.
#[derive(Debug, clap::Args)]
#[command(after_help = "\
Examples: a puzzle and its solution; the dots as a table of x, y and colours
  curvecrust puzzle drawing.svg -o puzzle.svg
  curvecrust puzzle drawing.svg --solved -o solved.svg
  curvecrust puzzle drawing.svg -o dots.csv")]
pub(crate) struct Puzzle {
    #[command(flatten)]
    pub(crate) curve: Curve,
    /// Draw the lines of the solution too
    #[arg(long)]
    pub(crate) solved: bool,
    /// No curve point farther than this from the line through its two dots: a length, or a share of
    /// the curve's extent
    #[arg(
        long,
        value_name = "LENGTH",
        default_value = "1%",
        allow_negative_numbers = true
    )]
    pub(crate) max_distance: Distance,
    /// How much farther than the closest dot of a colour the second closest is at least: the
    /// larger, the easier to solve, by more dots and colours
    #[arg(long, value_name = "PERCENT", default_value = "10%", value_parser = percent)]
    pub(crate) margin: f64,
    /// Take a new colour where the colours so far would make a step shorter than this share of what
    /// --max-distance allows: the larger, the fewer dots and the more colours
    #[arg(long, value_name = "PERCENT", default_value = "50%", value_parser = percent)]
    pub(crate) least_step: f64,
    #[command(flatten)]
    pub(crate) output: Output,
    /// Print one JSON object to stdout
    #[arg(long)]
    pub(crate) json: bool,
}
