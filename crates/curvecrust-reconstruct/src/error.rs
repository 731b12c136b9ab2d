//! Why a reconstruction cannot be made as asked.

use curvecrust_geometry::PointId;
use thiserror::Error;

/// A request that no algorithm can carry out; the points themselves are valid once they are a
/// [`PointSet`](curvecrust_geometry::PointSet).
#[derive(Clone, Debug, Error, PartialEq)]
#[non_exhaustive]
pub enum ReconstructError {
    /// A terminus is not the id of a point.
    #[error(
        "terminus {index} is point {}, but the ids of the points are below {count}: \
         mark termini by the ids of points in the set",
        .terminus.index()
    )]
    TerminusNotAPoint {
        /// Index of the terminus in the list of termini.
        index: usize,
        /// The terminus.
        terminus: PointId,
        /// The number of points.
        count: usize,
    },
    /// Termini were given to an algorithm that knows none.
    #[error(
        "{algorithm} does not honour termini: \
         use an algorithm that does, such as hnn-crust, or mark none"
    )]
    TerminiNotHonoured {
        /// Name of the algorithm.
        algorithm: &'static str,
    },
    /// Edges have more or fewer vertices than there are points.
    #[error(
        "the edges have {vertices} vertices, but there are {count} points: \
         give the points that the edges were reconstructed from"
    )]
    VertexCount {
        /// The number of vertices.
        vertices: usize,
        /// The number of points.
        count: usize,
    },
    /// The parameter of a beta-skeleton is below 1, infinite or not a number.
    #[error("beta is {beta}: give a finite number of at least 1, such as 1.7")]
    Beta {
        /// The parameter.
        beta: f64,
    },
}
