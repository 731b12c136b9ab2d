//! The same points elsewhere, larger or in another order: what an algorithm finds may depend on
//! none of that.

use curvecrust_geometry::{DVec2, Edge, EdgeSet, PointId, PointSet};

/// The same points through `map`; `None` if it makes two of them equal or leaves the range.
#[must_use]
pub fn mapped(points: &PointSet, map: impl Fn(DVec2) -> DVec2) -> Option<PointSet> {
    PointSet::new(points.points().iter().map(|&p| map(p)).collect()).ok()
}

/// The points shifted without rounding; `None` if some coordinate would be rounded.
#[must_use]
pub fn shifted(points: &PointSet, by: DVec2) -> Option<PointSet> {
    let is_exact = |x: f64, by: f64| {
        let sum = x + by;
        (sum - by).to_bits() == x.to_bits() && (sum - x).to_bits() == by.to_bits()
    };
    points
        .points()
        .iter()
        .all(|p| is_exact(p.x, by.x) && is_exact(p.y, by.y))
        .then(|| mapped(points, |p| p + by))?
}

/// The points in another order: `order[new]` is the old id.
#[must_use]
pub fn permuted(points: &PointSet, order: &[PointId]) -> PointSet {
    PointSet::new(order.iter().map(|&id| points[id]).collect()).unwrap()
}

/// The edges of [`permuted`] points with the old ids.
#[must_use]
pub fn relabelled(edges: &EdgeSet, order: &[PointId]) -> EdgeSet {
    let old = |e: &Edge| Edge::new(order[e.a().index()], order[e.b().index()]);
    EdgeSet::new(edges.vertex_count(), edges.edges().iter().filter_map(old))
}

/// Whether no two pairs of points have the same distance: nothing is a tie, however the points are
/// turned.
#[must_use]
pub fn distances_differ(points: &PointSet) -> bool {
    let points = points.points();
    let mut squares: Vec<f64> = (0..points.len())
        .flat_map(|i| (0..i).map(move |j| points[i].distance_squared(points[j])))
        .collect();
    squares.sort_unstable_by(f64::total_cmp);
    squares.windows(2).all(|pair| pair[0] < pair[1])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::hard_points::{grid, polygon};

    #[test]
    fn what_would_be_rounded_is_not_shifted() {
        let points = PointSet::new(vec![DVec2::new(0.1, 0.0), DVec2::new(3.0, 1.0)]).unwrap();
        assert_eq!(shifted(&points, DVec2::new(1e6, 0.0)), None);
        let whole = PointSet::new(grid(9)).unwrap();
        let there = shifted(&whole, DVec2::new(1e6, 0.5)).unwrap();
        assert_eq!(shifted(&there, DVec2::new(-1e6, -0.5)), Some(whole));
    }

    #[test]
    fn permuted_edges_are_the_same_between_places() {
        let points = PointSet::new(polygon(5)).unwrap();
        let order: Vec<PointId> = [3, 0, 4, 1, 2].map(PointId::from).to_vec();
        let edges = crate::planted::consecutive_edges(5, true);
        let mixed = permuted(&points, &order);
        let old = relabelled(&edges, &order);
        let places = |points: &PointSet, edges: &EdgeSet| {
            let ends = edges.edges().iter().map(|e| {
                let mut ends = e.ends().map(|id| points[id].to_array());
                ends.sort_by(|a, b| a.partial_cmp(b).unwrap());
                ends
            });
            let mut ends: Vec<_> = ends.collect();
            ends.sort_by(|a, b| a.partial_cmp(b).unwrap());
            ends
        };
        assert_eq!(places(&mixed, &edges), places(&points, &old));
        assert!(!distances_differ(&points));
    }
}
