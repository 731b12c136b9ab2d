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
mod system;

pub(crate) use basis::{Spline, breaks};
pub(crate) use fit::{Fit, fit};
pub(crate) use guide::Guide;
pub(crate) use nearest::Samples;
pub(crate) use penalty::Rough;
