//! One-step crust: C. M. Gold, "Crust and Anti-Crust: A One-Step Boundary and Skeleton Extraction
//! Algorithm", Symposium on Computational Geometry (SoCG), 1999; C. Gold, J. Snoeyink, "A One-Step
//! Crust and Skeleton Extraction Algorithm", Algorithmica 30, 2001.
//!
//! Take a Delaunay edge pq and its dual, the Voronoi edge v1 v2. If some disc through p and q holds
//! neither v1 nor v2, then pq belongs to the crust, else v1 v2 belongs to the skeleton or
//! anti-crust, an estimate of the medial axis from samples alone. In terms of the angles that pq
//! subtends at its apexes, it is a crust edge iff both are acute and sum to 90 degrees at most;
//! with the offsets t1, t2 of v1, v2 from the midpoint along the bisector, iff t1 < 0 < t2 and
//! |t1| t2 >= |pq|^2 / 4. An unbounded side has an angle of 0.
//!
//! Contains every edge of [`crust`](mod@crate::crust), which asks the same of all Voronoi vertices
//! and not only of v1 and v2. The two agree on dense samples; elsewhere another Voronoi vertex may
//! lie in every disc that v1 and v2 leave. Here it belongs to a sliver three points away:
//!
//! ```
//! use curvecrust_geometry::{DVec2, Edge, PointSet};
//! use curvecrust_reconstruct::{crust, one_step_crust};
//!
//! let points = [(1.0, 7.0), (4.0, 3.0), (2.0, 2.0), (5.0, 1.0), (6.0, 0.0)];
//! let points = PointSet::new(points.map(DVec2::from).to_vec())?;
//! // Outside of the hull edge (1, 7) - (4, 3), its dual is unbounded. But there lies the
//! // circumcentre (9.5, 4.5) of (4, 3), (5, 1), (6, 0), and a disc that avoids it and touches both
//! // ends of the edge holds (2, 4.6), the circumcentre on the other side of the edge.
//! let hull_edge = Edge::new(0.into(), 1.into());
//! let one_step = one_step_crust(&points).crust;
//! assert!(one_step.difference(&crust(&points)).eq(hull_edge));
//! # Ok::<(), curvecrust_geometry::PointSetError>(())
//! ```
//!
//! Cost: that of the Delaunay triangulation, O(n log n).

use curvecrust_geometry::{EdgeSet, PointSet};
use curvecrust_voronoi::Delaunay;

use crate::algorithm::{AlgorithmInfo, Basis, Reconstructor, Scope};
use crate::delaunay_edges::{edge_of, filtered, is_crust_edge};
use crate::skeleton::{Skeleton, SkeletonEdge};

/// What the one-step crust finds: each Delaunay edge is in the crust, or its dual in the skeleton.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct CrustAndSkeleton {
    /// The crust.
    pub crust: EdgeSet,
    /// The anti-crust.
    pub skeleton: Skeleton,
}

/// The one-step crust with its skeleton; what belongs to which is decided exactly.
///
/// Where four points are cocircular, the dual edge is a point and belongs to the skeleton, so the
/// crust does not depend on which triangulation is taken.
///
/// ```
/// use curvecrust_geometry::{DVec2, PointSet};
/// use curvecrust_reconstruct::one_step_crust;
///
/// let circle: Vec<DVec2> = (0..32)
///     .map(|i| DVec2::from_angle(f64::from(i) * std::f64::consts::TAU / 32.0))
///     .collect();
/// let points = PointSet::new(circle)?;
/// let found = one_step_crust(&points);
/// assert_eq!(found.crust.len(), 32);
/// // The medial axis of a circle is its centre.
/// assert!(found.skeleton.lfs(&points).iter().all(|lfs| (lfs - 1.0).abs() < 1e-12));
/// # Ok::<(), curvecrust_geometry::PointSetError>(())
/// ```
#[must_use]
pub fn one_step_crust(points: &PointSet) -> CrustAndSkeleton {
    let delaunay = Delaunay::new(points);
    let (crust, anti): (Vec<_>, Vec<_>) = delaunay
        .edges()
        .partition(|dual| is_crust_edge(points, dual));
    let skeleton = anti
        .iter()
        .filter_map(|dual| SkeletonEdge::dual_of(points, &delaunay, dual));
    CrustAndSkeleton {
        crust: EdgeSet::new(points.len(), crust.iter().filter_map(edge_of)),
        skeleton: Skeleton::new(points, skeleton.collect()),
    }
}

/// The one-step crust behind the common contract.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct OneStepCrust;

impl Reconstructor for OneStepCrust {
    fn info(&self) -> AlgorithmInfo {
        AlgorithmInfo {
            name: "one-step-crust",
            citation: "Gold, Snoeyink: A One-Step Crust and Skeleton Extraction Algorithm. \
                       Algorithmica 2001",
            guarantees: &[],
            cost: "O(n log n)",
            honours_termini: false,
            honours_known: false,
            scope: Scope::CLOSED,
            basis: Basis::Published,
        }
    }

    fn reconstruct(&self, points: &PointSet) -> EdgeSet {
        filtered(points, |dual| is_crust_edge(points, dual))
    }
}
