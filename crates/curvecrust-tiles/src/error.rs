//! What can be wrong with the samples of a tile.

use curvecrust_geometry::{DVec2, PointSet};
use thiserror::Error;

/// Why samples cannot be reconstructed.
#[derive(Clone, Debug, Error, PartialEq)]
#[non_exhaustive]
pub enum TilesError {
    /// A coordinate is NaN or infinite.
    #[error("point {id} is ({x}, {y}): coordinates must be finite")]
    NotFinite {
        /// The sample.
        id: u64,
        /// Its x coordinate.
        x: f64,
        /// Its y coordinate.
        y: f64,
    },
    /// A coordinate is too large or too small for the exact predicates.
    #[error(
        "point {id} has the coordinate {value:e}, which exact predicates cannot carry: \
         scale the points so that every coordinate is zero or between {:e} and {:e} in magnitude",
        PointSet::MIN_MAGNITUDE,
        PointSet::MAX_MAGNITUDE
    )]
    Magnitude {
        /// The sample.
        id: u64,
        /// The coordinate.
        value: f64,
    },
    /// Two samples are at one place, of one tile or of two.
    #[error("points {first} and {second} are both ({x}, {y}): remove one")]
    Duplicate {
        /// The smaller id.
        first: u64,
        /// The larger id.
        second: u64,
        /// Their x coordinate.
        x: f64,
        /// Their y coordinate.
        y: f64,
    },
    /// A chain goes on in a tile whose pieces are missing.
    #[error("the chain from point {from} goes on at point {to}, but no tile has that piece")]
    NoPiece {
        /// The last sample that is there.
        from: u64,
        /// The next one.
        to: u64,
    },
    /// A tile and its halo have more samples than a point set can hold.
    #[error("a tile of {count} points: make tiles of at most {}", u32::MAX - 1)]
    TooMany {
        /// The number of samples.
        count: usize,
    },
}

impl TilesError {
    /// The error about two samples at one place, in the order of their ids.
    pub(crate) fn duplicate(one: u64, other: u64, at: DVec2) -> Self {
        Self::Duplicate {
            first: one.min(other),
            second: one.max(other),
            x: at.x,
            y: at.y,
        }
    }
}
