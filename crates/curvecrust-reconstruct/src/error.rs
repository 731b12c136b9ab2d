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
    /// More than termini is known to an algorithm that cannot use it.
    #[error(
        "{algorithm} cannot use whether curves are closed, nor how many there are: \
         use an algorithm that can, such as least-detour, or leave it out"
    )]
    KnownNotHonoured {
        /// Name of the algorithm.
        algorithm: &'static str,
    },
    /// Fewer points than the curves have: a closed one has three or more, an open one two.
    #[error(
        "{count} points are too few for {curves} such curves, which have {needed} at least: \
         give more points, or ask for fewer curves"
    )]
    TooFewPoints {
        /// The number of points.
        count: usize,
        /// The number of curves.
        curves: usize,
        /// The least number of points of these curves.
        needed: usize,
    },
    /// All points lie on one line, on which no closed curve can go through them.
    #[error(
        "all {count} points lie on one line, so no closed curve goes through them \
         without meeting itself: ask for open curves"
    )]
    ClosedOnALine {
        /// The number of points.
        count: usize,
    },
    /// Termini of closed curves.
    #[error(
        "{termini} points are marked as termini, but closed curves have none: mark none, or ask for open curves"
    )]
    TerminiOfClosedCurves {
        /// The number of termini.
        termini: usize,
    },
    /// More termini than curves have ends.
    #[error(
        "{termini} points are marked as termini, but {curves} curves have {} ends: \
         mark fewer, or ask for more curves",
        .curves.saturating_mul(2)
    )]
    TooManyTermini {
        /// The number of termini.
        termini: usize,
        /// The number of curves.
        curves: usize,
    },
    /// There are enough points for the number of closed curves asked for, but such curves were not
    /// found, as where many of the points lie on one line.
    #[error(
        "no {asked} closed curves through all points were found, but {found}: \
         ask for as many, or give no number"
    )]
    CurvesNotFound {
        /// The number of curves asked for.
        asked: usize,
        /// The number of curves found.
        found: usize,
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
    /// Dots have more or fewer sets of colours than there are points.
    #[error(
        "there are {sets} sets of colours for {count} points: give each point one, in their order"
    )]
    ColourCount {
        /// The number of sets.
        sets: usize,
        /// The number of points.
        count: usize,
    },
    /// The radius of an alpha-shape is not above 0, infinite or not a number.
    #[error("alpha is {alpha}: give a finite number above 0, about the spacing of the samples")]
    Alpha {
        /// The radius.
        alpha: f64,
    },
    /// The parameter of Conservative Crust is below 1, infinite or not a number.
    #[error("rho of Conservative Crust is {rho}: give a finite number of at least 1")]
    ConservativeRho {
        /// The parameter.
        rho: f64,
    },
    /// The parameter of a beta-skeleton is below 1, infinite or not a number.
    #[error("beta is {beta}: give a finite number of at least 1, such as 1.7")]
    Beta {
        /// The parameter.
        beta: f64,
    },
}
