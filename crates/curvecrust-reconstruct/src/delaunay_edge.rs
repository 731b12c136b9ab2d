//! A Delaunay edge as the algorithms see it: its two ends and the angles at its apexes.

use curvecrust_geometry::{Edge, EdgeSet, PointSet};
use curvecrust_voronoi::{Delaunay, DualEdge};

use crate::sight::Sight;

/// How a Delaunay edge is seen from the apexes of its triangles, left and right; `None` where the
/// hull leaves none, an angle of zero.
pub(crate) type Sights = [Option<Sight>; 2];

pub(crate) fn sights(points: &PointSet, dual: &DualEdge) -> Sights {
    let [p, q] = dual.ends.map(|id| points[id]);
    let [left, right] = dual.apexes.map(|apex| apex.map(|id| points[id]));
    [
        left.map(|from| Sight::new(p, q, from)),
        right.map(|from| Sight::new(q, p, from)),
    ]
}

/// The Delaunay edges that `keep` wants.
pub(crate) fn filtered(points: &PointSet, keep: impl Fn(&DualEdge) -> bool) -> EdgeSet {
    let delaunay = Delaunay::new(points);
    let kept = delaunay.edges().filter(keep);
    EdgeSet::new(points.len(), kept.filter_map(|dual| edge_of(&dual)))
}

pub(crate) fn edge_of(dual: &DualEdge) -> Option<Edge> {
    let [p, q] = dual.ends;
    Edge::new(p, q)
}
