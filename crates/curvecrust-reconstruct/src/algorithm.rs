//! The contract that all algorithms share, and the list of them.

use std::fmt;

use curvecrust_geometry::{EdgeSet, PointId, PointSet};

use crate::beta_skeleton::BetaSkeleton;
use crate::crust::Crust;
use crate::error::ReconstructError;
use crate::explanation::Explanation;
use crate::hnn_crust::HnnCrust;
use crate::least_detour::LeastDetour;
use crate::nn_crust::NnCrust;
use crate::one_step_crust::OneStepCrust;
use crate::sphere_of_influence::SphereOfInfluence;

/// Every algorithm of this crate, the recommended one first.
///
/// Programs, documents, benches and tests iterate this list, so that none of them forgets one.
///
/// ```
/// use curvecrust_geometry::{DVec2, PointSet};
/// use curvecrust_reconstruct::ALGORITHMS;
///
/// let on_a_line = [0.0, 1.0, 2.5, 3.0].map(|x| DVec2::new(x, 2.0 * x));
/// let points = PointSet::new(on_a_line.to_vec())?;
/// for algorithm in ALGORITHMS {
///     assert_eq!(algorithm.reconstruct(&points).len(), 3, "{}", algorithm.info().name);
/// }
/// # Ok::<(), curvecrust_geometry::PointSetError>(())
/// ```
pub const ALGORITHMS: &[&dyn Reconstructor] = &[
    &LeastDetour,
    &HnnCrust::MUTUAL,
    &HnnCrust::UNION,
    &NnCrust,
    &Crust,
    &OneStepCrust,
    &BetaSkeleton::CRUST,
    &BetaSkeleton::GABRIEL,
    &SphereOfInfluence,
];

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

    /// The edges of [`reconstruct_open`](Self::reconstruct_open), each with why it is there, and the
    /// ends with why they stay open; `None` by algorithms whose definition says all there is to say.
    ///
    /// # Errors
    /// Those of [`reconstruct_open`](Self::reconstruct_open).
    fn explain(
        &self,
        points: &PointSet,
        termini: &[PointId],
    ) -> Result<Option<Explanation>, ReconstructError> {
        let _ = (points, termini);
        Ok(None)
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
        // As many digits as the literature prints.
        write!(f, "{name} < {}", (self.bound * 1000.0).round() / 1000.0)
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_crate_doc_lists_every_algorithm() {
        let row = |info: AlgorithmInfo| {
            let guarantees: Vec<_> = info.guarantees.iter().map(Guarantee::to_string).collect();
            let guarantees = match &guarantees[..] {
                [] => "none known".to_owned(),
                some => some.join(", "),
            };
            let termini = if info.honours_termini { "yes" } else { "no" };
            format!(
                "//! | [`{}`] | {} | {guarantees} | {} | {termini} |\n",
                info.name, info.citation, info.cost,
            )
        };
        let rows: String = ALGORITHMS.iter().map(|a| row(a.info())).collect();
        let rule = "//! |---|---|---|---|---|\n";
        let doc = include_str!("lib.rs");
        let table = doc
            .split_once(rule)
            .unwrap()
            .1
            .split_once("//!\n")
            .unwrap()
            .0;
        assert_eq!(table, rows, "paste into lib.rs:\n{rows}");
    }

    #[test]
    fn names_are_unique() {
        let mut names: Vec<_> = ALGORITHMS.iter().map(|a| a.info().name).collect();
        names.sort_unstable();
        names.dedup();
        assert_eq!(names.len(), ALGORITHMS.len());
    }
}
