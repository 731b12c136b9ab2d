//! The contract that all algorithms share, and the list of them.

use std::fmt;

use curvecrust_geometry::{EdgeSet, PointId, PointSet};

use crate::error::ReconstructError;
use crate::hnn_crust::HnnCrust;

/// Every algorithm of this crate, the recommended one first.
///
/// Programs, documents, benches and tests iterate this list, so that none of them forgets one.
///
/// ```
/// use curvecrust_geometry::{DVec2, PointSet};
/// use curvecrust_reconstruct::ALGORITHMS;
///
/// let corners = [DVec2::ZERO, DVec2::X, DVec2::ONE, DVec2::Y];
/// let square = PointSet::new(corners.to_vec())?;
/// for algorithm in ALGORITHMS {
///     assert_eq!(algorithm.reconstruct(&square).len(), 4, "{}", algorithm.info().name);
/// }
/// # Ok::<(), curvecrust_geometry::PointSetError>(())
/// ```
pub const ALGORITHMS: &[&dyn Reconstructor] = &[&HnnCrust::MUTUAL, &HnnCrust::UNION];

/// An algorithm that joins bare points by the edges of the curves they were sampled from.
///
/// # Guarantees
/// For every point set, degenerate ones included, the edges are the same bytes on every run and any
/// number of threads; permuting the points permutes the edges; scaling by a power of two or an
/// exactly representable shift leaves them as they are.
pub trait Reconstructor: fmt::Debug + Sync {
    /// What is known about the algorithm.
    fn info(&self) -> AlgorithmInfo;

    /// The edges between the points; there are as many vertices as points.
    fn reconstruct(&self, points: &PointSet) -> EdgeSet;

    /// The edges when some points are known to be termini: ends of open curves.
    ///
    /// Without termini this is [`reconstruct`](Self::reconstruct), whatever the algorithm.
    ///
    /// # Errors
    /// [`TerminiNotHonoured`](ReconstructError::TerminiNotHonoured) by algorithms that cannot use
    /// termini; [`TerminusNotAPoint`](ReconstructError::TerminusNotAPoint) otherwise, for the first
    /// that is not in the set.
    fn reconstruct_open(
        &self,
        points: &PointSet,
        termini: &[PointId],
    ) -> Result<EdgeSet, ReconstructError> {
        if termini.is_empty() {
            Ok(self.reconstruct(points))
        } else {
            Err(ReconstructError::TerminiNotHonoured {
                algorithm: self.info().name,
            })
        }
    }
}

/// What is known about an algorithm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AlgorithmInfo {
    /// The name by which programs select it: lower case, with hyphens.
    pub name: &'static str,
    /// Authors, title, venue and year.
    pub citation: &'static str,
    /// Sampling conditions of smooth closed curves, each enough for the edges to be exactly those
    /// between consecutive samples; empty if none is known.
    pub guarantees: &'static [Guarantee],
    /// Time in the number n of points.
    pub cost: &'static str,
    /// Whether [`Reconstructor::reconstruct_open`] takes termini.
    pub honours_termini: bool,
}

/// A sampling condition with the bound below which an algorithm is proven correct.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Guarantee {
    /// The condition.
    pub condition: Condition,
    /// The bound, exclusive.
    pub bound: f64,
}

impl fmt::Display for Guarantee {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let name = match self.condition {
            Condition::Epsilon => "epsilon",
            Condition::Rho => "rho",
        };
        write!(f, "{name} < {}", self.bound)
    }
}

/// How the distance of curve points to samples is limited.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Condition {
    /// Every curve point p has a sample nearer than epsilon times the local feature size at p.
    Epsilon,
    /// Every point between consecutive samples is nearer to one of them than rho times the reach
    /// of the curve between them.
    Rho,
}
