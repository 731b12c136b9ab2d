//! Sphere-of-influence graph: G. T. Toussaint, "A Graph-Theoretical Primal Sketch", Computational
//! Morphology, 1988; here restricted to Delaunay edges.
//!
//! Around every point p lies a circle through its nearest neighbour, of radius r(p). Delaunay
//! neighbours p and q are joined if their circles meet: |pq| <= r(p) + r(q). The graph adapts to
//! the local density without a parameter, but keeps the short chords of dense clusters, so vertices
//! branch where samples are uneven.
//!
//! No sampling condition makes it exact. Cost: that of neighbours and of the Delaunay
//! triangulation, O(n log n).

use curvecrust_geometry::{EdgeSet, PointId, PointSet};

use crate::algorithm::{AlgorithmInfo, Basis, Reconstructor, Scope};
use crate::delaunay_edges::{filtered, has_length};
use crate::neighbours::{HalfRule, neighbours};

/// The sphere-of-influence graph among Delaunay edges; circles that touch meet.
///
/// The diagonals of cocircular points, of which a triangulation may take any, are left out: the
/// Voronoi cells of their ends share no more than a point. Distances are compared in floating
/// point.
///
/// ```
/// use curvecrust_geometry::{DVec2, PointSet};
/// use curvecrust_reconstruct::sphere_of_influence;
///
/// let on_a_line = [0.0, 1.0, 2.0, 4.5].map(|x| DVec2::new(x, 0.0));
/// let edges = sphere_of_influence(&PointSet::new(on_a_line.to_vec())?);
/// assert_eq!(edges.len(), 3);
/// # Ok::<(), curvecrust_geometry::PointSetError>(())
/// ```
#[must_use]
pub fn sphere_of_influence(points: &PointSet) -> EdgeSet {
    let radius = nearest_distances(points);
    filtered(points, |dual| {
        circles_meet(points, &radius, dual.ends) && has_length(points, dual)
    })
}

/// Whether the circles around two points meet, given the radii of all.
pub(crate) fn circles_meet(points: &PointSet, radius: &[f64], [p, q]: [PointId; 2]) -> bool {
    points[p].distance(points[q]) <= radius[p.index()] + radius[q.index()]
}

/// The distance of every point to its nearest neighbour; infinite if it is alone.
pub(crate) fn nearest_distances(points: &PointSet) -> Vec<f64> {
    let found = neighbours(points, HalfRule::Bisector);
    let distance = |(p, nearest): (PointId, Option<PointId>)| {
        nearest.map_or(f64::INFINITY, |q| points[p].distance(points[q]))
    };
    points
        .ids()
        .zip(found.iter().map(|n| n.nearest))
        .map(distance)
        .collect()
}

/// The sphere-of-influence graph behind the common contract.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SphereOfInfluence;

impl Reconstructor for SphereOfInfluence {
    fn info(&self) -> AlgorithmInfo {
        AlgorithmInfo {
            name: "sphere-of-influence",
            citation: "Toussaint: A Graph-Theoretical Primal Sketch. 1988",
            guarantees: &[],
            cost: "O(n log n)",
            honours_termini: false,
            honours_known: false,
            scope: Scope::CLOSED,
            basis: Basis::Published,
        }
    }

    fn reconstruct(&self, points: &PointSet) -> EdgeSet {
        sphere_of_influence(points)
    }
}
