//! Which Delaunay edges an algorithm keeps, by the angles that they subtend.
//!
//! Let an edge be 2 h long, and its Voronoi edge reach from t1 to t2 >= t1 along the bisector, seen
//! from the midpoint, with t2 to the left; infinite where it is unbounded. The edge subtends an
//! angle with the cotangent t2 / h at its left apex and -t1 / h at its right apex. So the angles
//! tell everything that an algorithm asks of h, t1 and t2, and their signs are exact.

use std::cmp::Ordering;

use curvecrust_geometry::{Edge, EdgeSet, PointSet, in_circle};
use curvecrust_voronoi::{Delaunay, DualEdge};

use crate::subtended_angle::SubtendedAngle;

/// The angles that a Delaunay edge subtends at the apexes of its triangles, left and right; `None`
/// where there is no triangle, an angle of zero.
fn apex_angles(points: &PointSet, dual: &DualEdge) -> [Option<SubtendedAngle>; 2] {
    let [p, q] = dual.ends.map(|id| points[id]);
    let [left, right] = dual.apexes.map(|apex| apex.map(|id| points[id]));
    [
        left.map(|apex| SubtendedAngle::new(p, q, apex)),
        right.map(|apex| SubtendedAngle::new(q, p, apex)),
    ]
}

/// Whether the Gabriel graph has the edge: no other point lies in the closed disc that it is a
/// diameter of, so t1 < 0 < t2.
pub(crate) fn is_gabriel_edge(points: &PointSet, dual: &DualEdge) -> bool {
    let angles = apex_angles(points, dual);
    angles.iter().flatten().all(SubtendedAngle::is_acute)
}

/// Whether the beta-skeleton has the edge: -t1 and t2 exceed h sqrt(beta^2 - 1).
pub(crate) fn is_skeleton_edge(points: &PointSet, dual: &DualEdge, beta: f64) -> bool {
    let angles = apex_angles(points, dual);
    angles
        .iter()
        .flatten()
        .all(|a| a.is_acute() && (beta <= 1.0 || a.is_below(beta)))
}

/// Whether the one-step crust has the edge: some disc through its ends holds neither end of its
/// dual, so t1 < 0 < t2 and -t1 t2 >= h^2.
pub(crate) fn is_crust_edge(points: &PointSet, dual: &DualEdge) -> bool {
    sum_of_angles(points, dual).is_some_and(Ordering::is_le)
}

/// Whether the normalised mesh has the edge: the circles around its two triangles meet at less
/// than 90 degrees, so h^2 + t1 t2 < 0.
pub(crate) fn is_mesh_edge(points: &PointSet, dual: &DualEdge) -> bool {
    sum_of_angles(points, dual).is_some_and(Ordering::is_lt)
}

/// How the angles at both apexes compare to 90 degrees in sum; less where one of them is missing,
/// `None` where one is not acute.
fn sum_of_angles(points: &PointSet, dual: &DualEdge) -> Option<Ordering> {
    let angles = apex_angles(points, dual);
    let acute = angles.iter().flatten().all(SubtendedAngle::is_acute);
    acute.then(|| match &angles {
        [Some(left), Some(right)] => left.sum_to_right_angle(right),
        _ => Ordering::Less,
    })
}

/// Whether the Voronoi edge is longer than a point: no four points are cocircular here.
pub(crate) fn has_length(points: &PointSet, dual: &DualEdge) -> bool {
    let [p, q] = dual.ends.map(|id| points[id]);
    match dual.apexes {
        [Some(left), Some(right)] => in_circle(p, q, points[left], points[right]) < 0.0,
        _ => true,
    }
}

/// The Delaunay edges that `keep` accepts.
pub(crate) fn filtered(points: &PointSet, keep: impl Fn(&DualEdge) -> bool) -> EdgeSet {
    let delaunay = Delaunay::new(points);
    let kept = delaunay.edges().filter(keep);
    EdgeSet::new(points.len(), kept.filter_map(|dual| edge_of(&dual)))
}

pub(crate) fn edge_of(dual: &DualEdge) -> Option<Edge> {
    let [p, q] = dual.ends;
    Edge::new(p, q)
}
