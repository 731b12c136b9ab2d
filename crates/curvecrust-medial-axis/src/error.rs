//! Why a curve has no medial axis that can be computed.

use curvecrust_curve::DenseError;
use curvecrust_geometry::{DVec2, Segment};
use thiserror::Error;

/// Why the medial axis or the local feature size cannot be computed.
#[derive(Clone, Debug, Error, PartialEq)]
#[non_exhaustive]
pub enum MedialAxisError {
    /// The curve crosses itself or another.
    #[error(
        "components {} and {} of the curve cross at ({}, {}): curves must be disjoint and simple",
        components[0], components[1], at.x, at.y
    )]
    Crossing {
        /// Where.
        at: DVec2,
        /// The components, which are the same where a curve crosses itself.
        components: [usize; 2],
    },
    /// The curve touches itself or another, or comes too near to tell, or bends with no radius.
    #[error(
        "near ({}, {}) the curve touches itself or another, or bends too sharply: its local \
         feature size is not above {distance}. Curves must be disjoint, simple and smooth",
        at.x, at.y
    )]
    Touching {
        /// Where.
        at: DVec2,
        /// The local feature size below which curves count as touching.
        distance: f64,
    },
    /// The dense points are too far apart for what lies near them.
    #[error(
        "the discretisation is too coarse near ({}, {}): another part of the curve \
         comes within its gap of {gap:e}. Take more points a segment, or adaptive discretisation",
        at.x, at.y
    )]
    TooCoarse {
        /// Where.
        at: DVec2,
        /// The distance between the two consecutive dense points there.
        gap: f64,
    },
    /// The ratio of adaptive discretisation is not in (0, 1].
    #[error("gap_to_lfs is {0}: it must be above 0 and at most 1")]
    GapToLfs(f64),
    /// The discretisation is not possible.
    #[error(transparent)]
    Dense(#[from] DenseError),
}

impl MedialAxisError {
    /// Where curves cross or touch, if that is the error: there lfs is 0, and no finite sampling
    /// suffices.
    #[must_use]
    pub fn touch(&self) -> Option<DVec2> {
        match *self {
            Self::Crossing { at, .. } | Self::Touching { at, .. } => Some(at),
            _ => None,
        }
    }

    pub(crate) fn too_coarse(gap: Segment) -> Self {
        Self::TooCoarse {
            at: gap.a.midpoint(gap.b),
            gap: gap.length(),
        }
    }
}
