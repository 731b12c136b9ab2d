//! The commands, one file each.

pub(crate) mod algorithms;
mod bare_points;
pub(crate) mod check;
pub(crate) mod completions;
mod curves;
pub(crate) mod draw;
pub(crate) mod evaluate;
pub(crate) mod lfs;
pub(crate) mod medial_axis;
pub(crate) mod reconstruct;
pub(crate) mod sample;

use curvecrust::evaluate::Bounds as KnownBounds;
use serde::Serialize;

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
