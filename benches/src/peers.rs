//! The same tasks by other crates, for comparison and as oracles.

use std::num::NonZero;

use curvecrust_geometry::point_set::by_coordinates;
use curvecrust_geometry::{Edge, EdgeSet, PointId, PointSet, Random};
use glam::DVec2;
use kiddo::{ImmutableKdTree, SquaredEuclidean};
use rstar::RTree;
use rstar::primitives::GeomWithData;

/// Points as curvecrust takes them: a set of their own. A set is made in the order that algorithms
/// need, and keeps it: to make one is part of the work that is measured.
#[must_use]
pub fn anew(points: &PointSet) -> PointSet {
    PointSet::new(points.points().to_vec()).unwrap_or_default()
}

/// Points as kiddo takes them.
#[must_use]
pub fn arrays(points: &PointSet) -> Vec<[f64; 2]> {
    points.points().iter().map(|p| [p.x, p.y]).collect()
}

/// Builds kiddo's k-d tree and sums the squared distances of the 3 points nearest to each, one of
/// which is the point itself.
#[must_use]
pub fn kiddo_nearest_three(points: &[[f64; 2]]) -> f64 {
    let tree: ImmutableKdTree<f64, 2> = ImmutableKdTree::new_from_slice(points);
    let three = NonZero::<usize>::MIN.saturating_add(2);
    let of = |p| tree.nearest_n::<SquaredEuclidean>(p, three);
    points.iter().flat_map(of).map(|n| n.distance).sum()
}

/// HNN-Crust on kiddo's k-d tree, without a cap: the number of neighbours asked for doubles until
/// the half neighbour is among them.
#[must_use]
pub fn kiddo_hnn_crust(points: &PointSet) -> EdgeSet {
    let arrays = arrays(points);
    let tree: ImmutableKdTree<f64, 2> = ImmutableKdTree::new_from_slice(&arrays);
    mutual_edges(points, |s, count| {
        let nearest = tree.nearest_n::<SquaredEuclidean>(&[s.x, s.y], count);
        let id = |item: u64| usize::try_from(item).ok().and_then(PointId::new);
        nearest.into_iter().filter_map(|n| id(n.item)).collect()
    })
}

/// HNN-Crust on rstar's R*-tree, in the same way.
#[must_use]
pub fn rstar_hnn_crust(points: &PointSet) -> EdgeSet {
    let entry = |id| GeomWithData::new([points[id].x, points[id].y], id);
    let tree = RTree::bulk_load(points.ids().map(entry).collect());
    mutual_edges(points, |s, count| {
        let nearest = tree.nearest_neighbor_iter([s.x, s.y]).map(|e| e.data);
        nearest.take(count.get()).collect()
    })
}

/// HNN-Crust by comparing every point with every other.
#[must_use]
pub fn brute_force_hnn_crust(points: &PointSet) -> EdgeSet {
    mutual_edges(points, |_, _| points.ids().collect())
}

/// Edges that both ends chose, given the points nearest to a point, itself included.
fn mutual_edges(
    points: &PointSet,
    nearest: impl Fn(DVec2, NonZero<usize>) -> Vec<PointId>,
) -> EdgeSet {
    let choose = |&s: &DVec2| {
        let mut count = NonZero::<usize>::MIN.saturating_add(3);
        loop {
            let found = nearest(s, count);
            let all = found.len() >= points.len();
            if let Some(choice) = choice(points, s, found, all) {
                return choice;
            }
            count = count.saturating_add(count.get());
        }
    };
    let chosen: Vec<[Option<PointId>; 2]> = points.points().iter().map(choose).collect();
    let edges = points.ids().flat_map(|s| {
        let partners = chosen[s.index()].into_iter().flatten();
        let mutual = partners.filter(|q| chosen[q.index()].contains(&Some(s)));
        mutual.filter_map(|q| Edge::new(s, q)).collect::<Vec<_>>()
    });
    EdgeSet::new(points.len(), edges)
}

/// Nearest and half neighbour of `s` among the points found, if they are certain: no point that was
/// not found is as close, or `all` were found.
fn choice(
    points: &PointSet,
    s: DVec2,
    mut found: Vec<PointId>,
    all: bool,
) -> Option<[Option<PointId>; 2]> {
    let squared = |&q: &PointId| (points[q] - s).length_squared();
    found.sort_by(|p, q| {
        let nearer = squared(p).total_cmp(&squared(q));
        nearer.then(by_coordinates(points[*p], points[*q]))
    });
    let last = found.last().map_or(0.0, squared);
    let mut others = found.into_iter().filter(|&q| points[q] != s);
    let certain = |q: Option<PointId>| all || q.is_some_and(|q| squared(&q) < last);
    let nearest = others.next();
    let half = nearest
        .and_then(|n0| others.find(|&q| squared(&q) < points[q].distance_squared(points[n0])));
    (certain(nearest) && certain(half)).then_some([nearest, half])
}

/// The Delaunay triangulation by delaunator: the number of triangles.
#[must_use]
pub fn delaunator_triangles(points: &[delaunator::Point]) -> usize {
    delaunator::triangulate(points).len()
}

/// Points as delaunator takes them.
#[must_use]
pub fn delaunator_points(points: &PointSet) -> Vec<delaunator::Point> {
    let point = |p: &DVec2| delaunator::Point { x: p.x, y: p.y };
    points.points().iter().map(point).collect()
}

/// Numbers in random order: what a sort of as many keys costs.
#[must_use]
pub fn keys(count: usize) -> Vec<u64> {
    let mut random = Random::new(1);
    (0..count).map(|_| random.bits()).collect()
}

/// Sorts a copy of the keys; the smallest.
#[must_use]
pub fn sorted(keys: &[u64]) -> Option<u64> {
    let mut keys = keys.to_vec();
    keys.sort_unstable();
    keys.first().copied()
}

#[cfg(test)]
mod tests {
    use super::*;
    use curvecrust_reconstruct::hnn_crust;
    use curvecrust_testing::planted::{many_curves, mixed_scale, one_curve, uniform};

    #[test]
    fn all_find_the_same_edges() {
        for count in [1, 2, 5, 2_000, 50_000] {
            let inputs = [
                many_curves(count, 2).unwrap().points,
                mixed_scale(count, 2).unwrap().points,
                one_curve(count).unwrap().points,
                uniform(count, 2).unwrap(),
            ];
            for points in inputs {
                let edges = hnn_crust(&points);
                assert_eq!(kiddo_hnn_crust(&points), edges);
                if count <= 2_000 {
                    assert_eq!(rstar_hnn_crust(&points), edges);
                    assert_eq!(brute_force_hnn_crust(&points), edges);
                }
            }
        }
    }
}
