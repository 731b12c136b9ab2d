//! Termini: the points that a caller knows to be ends of open curves.

use curvecrust_geometry::{PointId, PointSet};

use crate::error::ReconstructError;

/// Refuses the first terminus that is not in the set.
pub(crate) fn check(points: &PointSet, termini: &[PointId]) -> Result<(), ReconstructError> {
    let count = points.len();
    match termini.iter().enumerate().find(|(_, t)| t.index() >= count) {
        Some((index, &terminus)) => Err(ReconstructError::TerminusNotAPoint {
            index,
            terminus,
            count,
        }),
        None => Ok(()),
    }
}
