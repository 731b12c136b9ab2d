//! Splines, and how they are fitted to points.

mod banded;
mod basis;
mod fit;
mod nearest;
mod spread;

pub(crate) use fit::{Fit, Guide, fit};
pub(crate) use nearest::Samples;
