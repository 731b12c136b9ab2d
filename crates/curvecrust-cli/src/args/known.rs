//! What the user knows, as it was typed.

use curvecrust::reconstruct::Shape;
use std::num::NonZeroU32;
use std::path::PathBuf;

/// What the user knows about the curves.
#[derive(Debug, clap::Args)]
pub(crate) struct Known {
    /// No curve ends: every point has two partners
    #[arg(long)]
    pub(crate) closed: bool,
    /// No curve is closed; with `--curves 1`, points are sorted along a line
    #[arg(long, conflicts_with = "closed")]
    pub(crate) open: bool,
    /// How many curves there are, which go through all points; one closed curve is a simple polygon
    #[arg(long, value_name = "N")]
    pub(crate) curves: Option<NonZeroU32>,
    /// The point at this position of the input, counted from 0, is the end of an open curve
    #[arg(long, value_name = "N")]
    pub(crate) terminus: Vec<u32>,
    /// The points of this file are ends of open curves: those that its column `terminus` marks, as
    /// `sample` writes it, or all
    #[arg(long, value_name = "FILE")]
    pub(crate) termini_from: Option<PathBuf>,
}

impl Known {
    pub(crate) fn shape(&self) -> Option<Shape> {
        shape(self.closed, self.open)
    }
}

/// What `--closed` and `--open` say, which exclude each other.
pub(super) fn shape(closed: bool, open: bool) -> Option<Shape> {
    match (closed, open) {
        (true, _) => Some(Shape::Closed),
        (_, true) => Some(Shape::Open),
        _ => None,
    }
}
