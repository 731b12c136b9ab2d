//! Splines, and how they are fitted to points.

mod banded;
mod basis;
mod fit;
mod guide;
mod knots;
mod nearest;
mod penalty;
mod spread;
mod start;

pub(crate) use fit::{Fit, fit};
pub(crate) use guide::Guide;
pub(crate) use nearest::Samples;
pub(crate) use penalty::Rough;
