//! Splines, and how they are fitted to points.

mod banded;
mod basis;
mod fit;
mod guide;
mod nearest;
mod spread;

pub(crate) use fit::{Fit, fit};
pub(crate) use guide::Guide;
pub(crate) use nearest::Samples;
