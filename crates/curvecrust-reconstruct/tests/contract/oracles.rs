//! The algorithms from their definitions, by brute force and with integers.

use std::cmp::Ordering;

use curvecrust_geometry::point_set::by_coordinates;
use curvecrust_geometry::{Edge, EdgeSet, PointId, PointSet, in_circle, orient2d};
use num_bigint::{BigInt, Sign};

use super::exact::{Exact, Pencil, Ratio2, cross, dot, integer, sub};

/// n0 = NN(s), and the closest q != s with |qs| < |q n0|, or with an angle n0-s-q of 90 degrees or
/// more.
fn choices(points: &PointSet, right_angle: bool) -> Vec<Vec<PointId>> {
    let exact = Exact::new(points);
    let closest = |s: PointId, wanted: &dyn Fn(PointId) -> bool| {
        let distance = |q: PointId| points[q].distance_squared(points[s]);
        points
            .ids()
            .filter(|&q| q != s && wanted(q))
            .min_by(|&p, &q| {
                let by_distance = distance(p).total_cmp(&distance(q));
                by_distance.then(by_coordinates(points[p], points[q]))
            })
    };
    let of = |s: PointId| {
        let Some(n0) = closest(s, &|_| true) else {
            return vec![];
        };
        let half = closest(s, &|q| {
            if right_angle {
                exact.dot(s, n0, q).sign() != Sign::Plus
            } else {
                exact.distance_squared(q, s) < exact.distance_squared(q, n0)
            }
        });
        [Some(n0), half].into_iter().flatten().collect()
    };
    points.ids().map(of).collect()
}

pub(crate) fn joined(points: &PointSet, wanted: impl Fn(PointId, PointId) -> bool) -> EdgeSet {
    let pairs = points
        .ids()
        .flat_map(|p| points.ids().map(move |q| (p, q)))
        .filter(|&(p, q)| p < q && wanted(p, q));
    EdgeSet::new(points.len(), pairs.filter_map(|(p, q)| Edge::new(p, q)))
}

pub(crate) fn hnn_crust(points: &PointSet) -> EdgeSet {
    let chosen = choices(points, false);
    let chose = |p: PointId, q: PointId| chosen[p.index()].contains(&q);
    joined(points, |p, q| chose(p, q) && chose(q, p))
}

pub(crate) fn hnn_crust_union(points: &PointSet) -> EdgeSet {
    let chosen = choices(points, false);
    let chose = |p: PointId, q: PointId| chosen[p.index()].contains(&q);
    joined(points, |p, q| chose(p, q) || chose(q, p))
}

pub(crate) fn nn_crust(points: &PointSet) -> EdgeSet {
    let chosen = choices(points, true);
    let chose = |p: PointId, q: PointId| chosen[p.index()].contains(&q);
    joined(points, |p, q| chose(p, q) || chose(q, p))
}

/// No other point within the discs of radius beta |pq| / 2 through p and q: at every other point pq
/// subtends less than asin(1/beta).
pub(crate) fn beta_skeleton(points: &PointSet, beta: f64) -> EdgeSet {
    let exact = Exact::new(points);
    let beta = integer(beta);
    let one = integer(1.0);
    let subtends_less = |from: PointId, p: PointId, q: PointId| {
        let u = sub(exact.at(p), exact.at(from));
        let v = sub(exact.at(q), exact.at(from));
        let sine = &beta * cross(&u, &v);
        let lengths = dot(&u, &u) * dot(&v, &v) * &one * &one;
        dot(&u, &v).sign() == Sign::Plus && &sine * &sine < lengths
    };
    joined(points, |p, q| {
        let mut others = points.ids().filter(|&r| r != p && r != q);
        others.all(|r| subtends_less(r, p, q))
    })
}

/// The Voronoi edge of p and q: the farthest offsets of its points to the right and to the left of
/// pq, as apexes; `None` if it is empty or a point.
pub(crate) struct VoronoiEdge {
    pub(crate) right: Option<PointId>,
    pub(crate) left: Option<PointId>,
}

pub(crate) fn voronoi_edge(points: &PointSet, p: PointId, q: PointId) -> Option<VoronoiEdge> {
    let [mut left, mut right] = [None, None];
    let (a, b) = (points[p], points[q]);
    for r in points.ids().filter(|&r| r != p && r != q) {
        let side = orient2d(a, b, points[r]);
        if side > 0.0 {
            let nearer = |old: PointId| in_circle(a, b, points[old], points[r]) > 0.0;
            if left.is_none_or(nearer) {
                left = Some(r);
            }
        } else if side < 0.0 {
            let nearer = |old: PointId| in_circle(b, a, points[old], points[r]) > 0.0;
            if right.is_none_or(nearer) {
                right = Some(r);
            }
        } else if (points[r] - a).dot(points[r] - b) < 0.0 {
            return None;
        }
    }
    if let (Some(left), Some(right)) = (left, right)
        && in_circle(a, b, points[left], points[right]) >= 0.0
    {
        return None;
    }
    Some(VoronoiEdge { right, left })
}

/// Delaunay edges with |pq| <= r(p) + r(q).
pub(crate) fn sphere_of_influence(points: &PointSet) -> EdgeSet {
    let nearest = |p: PointId| {
        let others = points.ids().filter(|&q| q != p);
        others
            .map(|q| points[p].distance(points[q]))
            .fold(f64::INFINITY, f64::min)
    };
    joined(points, |p, q| {
        voronoi_edge(points, p, q).is_some()
            && points[p].distance(points[q]) <= nearest(p) + nearest(q)
    })
}

/// t1 < 0 < t2 and |t1| t2 >= h^2.
pub(crate) fn one_step_crust(points: &PointSet) -> EdgeSet {
    by_offsets(points, Ordering::is_ge)
}

/// t1 < 0 < t2 and h^2 + t1 t2 < 0.
pub(crate) fn normalised_mesh(points: &PointSet) -> EdgeSet {
    by_offsets(points, Ordering::is_gt)
}

/// t1 < 0 < t2, and how |t1| t2 compares to h^2.
fn by_offsets(points: &PointSet, wanted: fn(Ordering) -> bool) -> EdgeSet {
    let exact = Exact::new(points);
    joined(points, |p, q| {
        let Some(dual) = voronoi_edge(points, p, q) else {
            return false;
        };
        let across = sub(exact.at(q), exact.at(p));
        let normal = [-&across[1], across[0].clone()];
        // Offsets from the midpoint times 2 w |pq|, and w.
        let offset = |apex: PointId| {
            let centre = exact.circumcentre([p, q, apex]);
            let twice: BigInt =
                dot(&centre.from(exact.at(p)), &normal) + dot(&centre.from(exact.at(q)), &normal);
            (twice, centre.w)
        };
        let (right, left) = (dual.right.map(offset), dual.left.map(offset));
        let beyond =
            |t: &Option<(BigInt, BigInt)>, sign| t.as_ref().is_none_or(|t| t.0.sign() == sign);
        if !(beyond(&right, Sign::Minus) && beyond(&left, Sign::Plus)) {
            return false;
        }
        match (right, left) {
            (Some((t1, w1)), Some((t2, w2))) => {
                // |t1| t2 / (4 w1 w2 |pq|^2) >= |pq|^2 / 4
                let squared = dot(&across, &across);
                wanted((-t1 * t2).cmp(&(w1 * w2 * &squared * &squared)))
            }
            _ => true,
        }
    })
}

/// Edges with a disc that no sample and no Voronoi vertex lies strictly inside of; `close` are
/// those for which no two such discs exist, or almost none.
pub(crate) fn crust(points: &PointSet) -> EdgeSet {
    let exact = Exact::new(points);
    let vertices = voronoi_vertices(points, &exact);
    joined(points, |p, q| {
        let mut pencil = Pencil::new(exact.at(p), exact.at(q));
        for r in points.ids().filter(|&r| r != p && r != q) {
            pencil.avoid(&exact.ratio(r));
        }
        vertices.iter().for_each(|v| pencil.avoid(v));
        pencil.room() != Ordering::Less
    })
}

/// The circumcentres of all triangles whose circle is empty.
pub(crate) fn voronoi_vertices(points: &PointSet, exact: &Exact) -> Vec<Ratio2> {
    let mut vertices = Vec::new();
    for a in points.ids() {
        for b in points.ids().filter(|&b| b > a) {
            for c in points.ids().filter(|&c| c > b) {
                let side = orient2d(points[a], points[b], points[c]);
                let is_inside = |d: PointId| {
                    side.signum() * in_circle(points[a], points[b], points[c], points[d]) > 0.0
                };
                if side != 0.0 && !points.ids().any(is_inside) {
                    vertices.push(exact.circumcentre([a, b, c]));
                }
            }
        }
    }
    vertices
}
