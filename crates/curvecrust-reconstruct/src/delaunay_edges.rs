//! Which Delaunay edges an algorithm keeps, by the angles that they subtend.

use curvecrust_geometry::{Edge, EdgeSet, PointSet, in_circle};
use curvecrust_voronoi::{Delaunay, DualEdge};

use crate::subtended_angle::SubtendedAngle;

/// The angles that a Delaunay edge subtends at the apexes of its triangles, left and right; `None`
/// where there is no triangle, an angle of zero.
pub(crate) fn apex_angles(points: &PointSet, dual: &DualEdge) -> [Option<SubtendedAngle>; 2] {
    let [p, q] = dual.ends.map(|id| points[id]);
    let [left, right] = dual.apexes.map(|apex| apex.map(|id| points[id]));
    [
        left.map(|apex| SubtendedAngle::new(p, q, apex)),
        right.map(|apex| SubtendedAngle::new(q, p, apex)),
    ]
}

/// Whether the one-step crust has the edge: some disc through its ends holds neither end of its
/// dual.
pub(crate) fn is_crust_edge(points: &PointSet, dual: &DualEdge) -> bool {
    let angles = apex_angles(points, dual);
    angles.iter().flatten().all(SubtendedAngle::is_acute)
        && match &angles {
            [Some(left), Some(right)] => left.sums_to_right_angle_at_most(right),
            _ => true,
        }
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
