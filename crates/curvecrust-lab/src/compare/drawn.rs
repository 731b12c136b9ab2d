//! The points of a trial.

use super::true_curves::TrueCurves;
use curvecrust::geometry::{EdgeSet, PointId, PointSet};
use std::sync::Arc;

/// Points with a known truth.
pub(super) struct Sampled {
    pub(super) points: PointSet,
    pub(super) boundary: EdgeSet,
    /// The ends of open curves, if algorithms are to be told.
    pub(super) termini: Vec<PointId>,
}

/// The points of a trial, and the curves that they are of.
pub(super) struct Drawn {
    pub(super) sampled: Sampled,
    pub(super) curves: Arc<TrueCurves>,
}
