//! One-step crust: C. M. Gold, "Crust and Anti-Crust: A One-Step Boundary and Skeleton Extraction
//! Algorithm", Symposium on Computational Geometry (SoCG), 1999; C. Gold, J. Snoeyink, "A One-Step
//! Crust and Skeleton Extraction Algorithm", Algorithmica 30, 2001.
//!
//! Take a Delaunay edge pq and its dual, the Voronoi edge v1 v2. If some disc through p and q holds
//! neither v1 nor v2, then pq belongs to the crust, else v1 v2 belongs to the skeleton or
//! anti-crust, an estimate of the medial axis from samples alone. Seen from its
//! apexes, pq is a crust edge iff both angles are acute and sum to 90 degrees at most; with the
//! offsets t1, t2 of v1, v2 from the midpoint along the bisector, iff t1 < 0 < t2 and
//! |t1| t2 >= |pq|^2 / 4. An unbounded side has an angle of 0.
//!
//! Contains every edge of [`crust`](mod@crate::crust), which asks the same of all Voronoi vertices
//! and not only of v1 and v2. Cost: that of the Delaunay triangulation, O(n log n).

use curvecrust_geometry::{EdgeSet, PointSet};
use curvecrust_voronoi::{Delaunay, DualEdge};

use crate::algorithm::{AlgorithmInfo, Reconstructor};
use crate::delaunay_edge::{edge_of, filtered, sights};
use crate::sight::Sight;
use crate::skeleton::{Skeleton, SkeletonEdge};

/// What the one-step crust finds: each Delaunay edge is in the crust, or its dual in the skeleton.
#[derive(Clone, Debug, PartialEq)]
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
        .filter_map(|dual| SkeletonEdge::dual_of(points, dual));
    CrustAndSkeleton {
        crust: EdgeSet::new(points.len(), crust.iter().filter_map(edge_of)),
        skeleton: Skeleton::new(skeleton.collect()),
    }
}

/// Whether some disc through the ends of the edge holds neither end of its dual.
pub(crate) fn is_crust_edge(points: &PointSet, dual: &DualEdge) -> bool {
    let sights = sights(points, dual);
    sights.iter().flatten().all(Sight::is_acute)
        && match &sights {
            [Some(left), Some(right)] => left.sums_to_right_angle_at_most(right),
            _ => true,
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
        }
    }

    fn reconstruct(&self, points: &PointSet) -> EdgeSet {
        filtered(points, |dual| is_crust_edge(points, dual))
    }
}
