//! What an algorithm says of its edges and of its free ends.

use std::fmt;

use curvecrust_geometry::{Edge, EdgeSet, PointId};

/// The edges of a reconstruction and its free ends, each with its reason: see
/// [`Reconstructor::explain`](crate::algorithm::Reconstructor::explain).
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Explanation {
    /// The edges, ascending.
    pub edges: Vec<ExplainedEdge>,
    /// The points with fewer than two edges, ascending. A terminus has a free end only if it has no
    /// edge.
    pub free_ends: Vec<FreeEnd>,
}

/// An edge and why it is there.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct ExplainedEdge {
    /// The edge.
    pub edge: Edge,
    /// How it came to be there.
    pub reason: Reason,
    /// By how much the cost would rise at most without this edge: an upper bound, from the best
    /// edges without it that the search finds. Near 0, another answer is as good. The logarithm of
    /// a ratio of likelihoods, without a unit. `None` for certified edges, which are not exchanged,
    /// for required ones, and where the search finds no edges without it.
    pub margin_at_most: Option<f64>,
}

/// How an edge came to be there.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[non_exhaustive]
pub enum Reason {
    /// HNN-Crust finds it, and either leaves no free end in the cluster around it, or the one-step
    /// crust finds it too and it continues almost straight at both ends.
    Certified,
    /// It was the shortest that was left when it was added, and no exchange removed it.
    Completed,
    /// An exchange that lowered the cost added it.
    Exchanged,
    /// What is [known](crate::known::Known) about the curves requires it: without that, it would
    /// not be there.
    Required,
}

impl Reason {
    /// The reason in one word, lower case.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Certified => "certified",
            Self::Completed => "completed",
            Self::Exchanged => "exchanged",
            Self::Required => "required",
        }
    }
}

/// The reason in one word: [`Reason::name`].
impl fmt::Display for Reason {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.name())
    }
}

/// A point where a curve ends, or that is isolated.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct FreeEnd {
    /// The point.
    pub point: PointId,
    /// How many free ends it has: 1 where a curve ends, 2 if it is isolated.
    pub count: u8,
    /// What they cost: minus the logarithm of a likelihood, without a unit.
    pub penalty: f64,
    /// Of the exchanges that the search finds and that give the point one edge more, the one that
    /// costs least; `None` if it finds none.
    pub rejected: Option<Rejected>,
}

/// An edge that a free end could have, but that costs more.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Rejected {
    /// The other end of the edge.
    pub partner: PointId,
    /// By how much the cost would rise at most with this edge: an upper bound, from the best edges
    /// with it that the search finds. The logarithm of a ratio of likelihoods, without a unit.
    pub cost_at_most: f64,
}

impl Explanation {
    /// The edges alone, between as many vertices as there are points.
    #[must_use]
    pub fn edge_set(&self, points: usize) -> EdgeSet {
        EdgeSet::new(points, self.edges.iter().map(|explained| explained.edge))
    }
}
