//! Dense points of a curve, and the local feature size at each of them.

use std::sync::Arc;

use curvecrust_curve::DenseCurve;

use crate::axis::MedialAxis;
use crate::crossing::chord;
use crate::error::MedialAxisError;
use crate::lfs::LocalFeatureSize;
use crate::shrinking_ball;

/// How lfs is estimated from dense points.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Estimator {
    /// The distance to the medial axis by the Voronoi diagram: see [`axis`](crate::axis).
    #[default]
    Voronoi,
    /// The distance to the authors' medial points: see [`shrinking_ball`].
    ShrinkingBall,
}

/// A discretised curve and the local feature size at each of its dense points. Clones share both.
#[derive(Clone, Debug, PartialEq)]
pub struct MeasuredCurve {
    dense: Arc<DenseCurve>,
    lfs: Arc<LocalFeatureSize>,
}

impl MeasuredCurve {
    /// Estimates the lfs of points that are dense already.
    ///
    /// # Errors
    /// With [`Estimator::Voronoi`], those of [`MedialAxis::new`], and
    /// [`TooCoarse`](MedialAxisError::TooCoarse) where a gap is not below twice the lfs found at
    /// its ends: then the points are no epsilon-sample for any epsilon < 1, and what was found is
    /// no lfs.
    pub fn new(dense: DenseCurve, estimator: Estimator) -> Result<Self, MedialAxisError> {
        let lfs = match estimator {
            Estimator::Voronoi => LocalFeatureSize::new(&dense, &MedialAxis::new(&dense)?),
            Estimator::ShrinkingBall => {
                let lfs = shrinking_ball::lfs(&dense);
                return Ok(Self::from_parts(dense, lfs));
            }
        };
        for i in 0..dense.len() {
            let Some(next) = dense.next(i) else { continue };
            let gap = chord(&dense, i);
            if gap.length() >= 2.0 * lfs.at(i).min(lfs.at(next)) {
                return Err(MedialAxisError::too_coarse(gap));
            }
        }
        Ok(Self::from_parts(dense, lfs))
    }

    pub(crate) fn from_parts(dense: DenseCurve, lfs: LocalFeatureSize) -> Self {
        Self {
            dense: Arc::new(dense),
            lfs: Arc::new(lfs),
        }
    }

    /// The dense points, without a copy if no other clone has them.
    pub(crate) fn into_dense(self) -> DenseCurve {
        Arc::unwrap_or_clone(self.dense)
    }

    /// The dense points.
    #[must_use]
    pub fn dense(&self) -> &DenseCurve {
        &self.dense
    }

    /// The lfs at each of them.
    #[must_use]
    pub fn lfs(&self) -> &LocalFeatureSize {
        &self.lfs
    }
}
