//! The edges of a reconstruction against the true ones.

use curvecrust_geometry::{Edge, EdgeSet};

/// Which edges of a reconstruction are right.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct EdgeComparison {
    /// Edges that both have, ascending.
    pub correct: Vec<Edge>,
    /// True edges that were not found, ascending.
    pub missing: Vec<Edge>,
    /// Edges that were found and are not true, ascending.
    pub wrong: Vec<Edge>,
}

impl EdgeComparison {
    /// Compares what was `found` with the `truth`, usually the manifold boundary of a sampled
    /// curve.
    #[must_use]
    pub fn new(truth: &EdgeSet, found: &EdgeSet) -> Self {
        let is_found = |edge: &Edge| found.contains(*edge);
        let (correct, missing) = truth.edges().iter().partition(|&edge| is_found(edge));
        Self {
            correct,
            missing,
            wrong: found.difference(truth).collect(),
        }
    }

    /// Whether exactly the true edges were found.
    #[must_use]
    pub fn is_exact(&self) -> bool {
        self.missing.is_empty() && self.wrong.is_empty()
    }
}
