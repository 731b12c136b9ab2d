//! Graphs and greedy algorithms from their definitions, step by step and with nothing kept between
//! steps.

use std::cmp::Ordering;

use curvecrust_geometry::point_set::by_coordinates;
use curvecrust_geometry::{DVec2, Edge, EdgeSet, PointId, PointSet, Random};
use curvecrust_reconstruct::{Alpha, AlphaShape, Reconstructor, alpha_shape};
use num_bigint::{BigInt, Sign};

use super::chains::way;
use super::exact::{Exact, Ratio2, dot, integer};
use super::oracles::{beta_skeleton, joined, voronoi_edge, voronoi_vertices};

pub(crate) type Pair = [PointId; 2];

/// What floating point cannot tell apart, relatively.
pub(crate) const CLOSE: f64 = 1e-9;

fn place(points: &PointSet, [p, q]: Pair) -> [DVec2; 2] {
    let [p, q] = [points[p], points[q]];
    if by_coordinates(p, q).is_le() {
        [p, q]
    } else {
        [q, p]
    }
}

/// By length, then by the coordinates of the ends.
pub(crate) fn by_length(points: &PointSet, e: Pair, f: Pair) -> Ordering {
    let squared = |[p, q]: Pair| points[p].distance_squared(points[q]);
    let ([a, b], [c, d]) = (place(points, e), place(points, f));
    squared(e)
        .total_cmp(&squared(f))
        .then(by_coordinates(a, c))
        .then(by_coordinates(b, d))
}

/// The edges whose Voronoi edges are longer than a point, the shortest first.
pub(crate) fn delaunay_pairs(points: &PointSet) -> Vec<Pair> {
    let all = joined(points, |p, q| voronoi_edge(points, p, q).is_some());
    let mut pairs: Vec<Pair> = all.edges().iter().map(|edge| edge.ends()).collect();
    pairs.sort_by(|&e, &f| by_length(points, e, f));
    pairs
}

pub(crate) fn edge_set(points: &PointSet, pairs: &[Pair]) -> EdgeSet {
    let edges = pairs.iter().filter_map(|&[p, q]| Edge::new(p, q));
    EdgeSet::new(points.len(), edges)
}

pub(crate) fn degree(pairs: &[Pair], v: PointId) -> usize {
    pairs.iter().filter(|pair| pair.contains(&v)).count()
}

fn other([p, q]: Pair, v: PointId) -> PointId {
    if p == v { q } else { p }
}

/// The pairs at a point, in their order, each from it.
pub(crate) fn around(pairs: &[Pair], v: PointId) -> impl Iterator<Item = PointId> + '_ {
    let at = pairs.iter().filter(move |pair| pair.contains(&v));
    at.map(move |&pair| other(pair, v))
}

/// The vertices of the component of a point.
pub(crate) fn component(pairs: &[Pair], v: PointId) -> Vec<PointId> {
    let mut found = vec![v];
    let mut next = 0;
    while let Some(&at) = found.get(next) {
        for w in around(pairs, at) {
            if !found.contains(&w) {
                found.push(w);
            }
        }
        next += 1;
    }
    found
}

/// Prim's algorithm on the edges of the Delaunay triangulation: rounding may make others as short.
pub(crate) fn spanning_tree(points: &PointSet) -> EdgeSet {
    let pairs = delaunay_pairs(points);
    let mut inside: Vec<PointId> = points.ids().take(1).collect();
    let mut tree = Vec::new();
    while inside.len() < points.len() {
        let leaves = |&&[p, q]: &&Pair| inside.contains(&p) != inside.contains(&q);
        let &shortest = pairs.iter().find(leaves).unwrap();
        inside.extend(shortest);
        inside.sort_unstable();
        inside.dedup();
        tree.push(shortest);
    }
    edge_set(points, &tree)
}

/// How long a spanning tree is, by Prim's algorithm on all pairs.
pub(crate) fn least_tree(points: &PointSet) -> f64 {
    let mut away: Vec<f64> = points.ids().map(|_| f64::INFINITY).collect();
    let (mut outside, mut sum): (Vec<PointId>, f64) = (points.ids().collect(), 0.0);
    let mut last = outside.pop();
    while let Some(v) = last {
        for &w in &outside {
            away[w.index()] = away[w.index()].min(points[v].distance(points[w]));
        }
        let nearest = (0..outside.len()).min_by(|&i, &j| {
            let [i, j] = [i, j].map(|place| away[outside[place].index()]);
            i.total_cmp(&j)
        });
        last = nearest.map(|place| outside.swap_remove(place));
        sum += last.map_or(0.0, |v| away[v.index()]);
    }
    sum
}

/// With integers, all offenders of a round together.
pub(crate) fn conservative_crust(points: &PointSet, rho: f64) -> EdgeSet {
    let exact = Exact::new(points);
    let vertices = voronoi_vertices(points, &exact);
    // rho^2, in units of that of an integer.
    let (rho, one) = (integer(rho), integer(1.0));
    let holds = |[p, q]: Pair, at: &Ratio2| {
        let [from_p, from_q] = [p, q].map(|end| at.from(exact.at(end)));
        let twice = [&from_p[0] + &from_q[0], &from_p[1] + &from_q[1]];
        let across: BigInt = exact.distance_squared(p, q) * &at.w * &at.w;
        dot(&twice, &twice) * &one * &one < across * &rho * &rho
    };
    let gabriel = beta_skeleton(points, 1.0);
    let mut kept: Vec<Pair> = gabriel.edges().iter().map(|edge| edge.ends()).collect();
    kept.retain(|&pair| !vertices.iter().any(|vertex| holds(pair, vertex)));
    loop {
        let leaves: Vec<PointId> = points.ids().filter(|&v| degree(&kept, v) == 1).collect();
        let before = kept.len();
        kept.retain(|&pair| {
            let mut others = leaves.iter().filter(|leaf| !pair.contains(leaf));
            !others.any(|&leaf| holds(pair, &exact.ratio(leaf)))
        });
        if kept.len() == before {
            return edge_set(points, &kept);
        }
    }
}

/// The radii of the empty discs through p and q, from the Voronoi vertices beside them.
fn radii(points: &PointSet, exact: &Exact, [p, q]: Pair) -> Option<[f64; 2]> {
    let dual = voronoi_edge(points, p, q)?;
    let half = points[p].distance(points[q]) / 2.0;
    let radius = |apex: PointId| {
        let centre = exact.circumcentre([p, q, apex]);
        way(exact, &centre, p).length()
    };
    let is_acute = |apex: PointId| exact.dot(apex, p, q).sign() == Sign::Plus;
    let apexes = [dual.left, dual.right];
    let ends = apexes.map(|apex| apex.map_or(f64::INFINITY, radius));
    let least = if apexes.into_iter().flatten().all(is_acute) {
        half
    } else {
        ends[0].min(ends[1])
    };
    Some([least, ends[0].max(ends[1])])
}

/// Whether the edges are those of the alpha that leaves the fewest points with other than two.
pub(crate) fn alpha_shape_fault(points: &PointSet, edges: &EdgeSet) -> Option<String> {
    let Some(alpha) = Alpha::of(points) else {
        return (!edges.is_empty()).then(|| String::from("edges without an alpha"));
    };
    let (at, exact) = (alpha.get(), Exact::new(points));
    for p in points.ids() {
        for q in points.ids().filter(|&q| p < q) {
            let [least, largest] = radii(points, &exact, [p, q]).unwrap_or([f64::INFINITY; 2]);
            let has = edges.contains(Edge::new(p, q)?);
            let surely = least * (1.0 + CLOSE) < at && at < largest * (1.0 - CLOSE);
            let never = at < least * (1.0 - CLOSE) || largest * (1.0 + CLOSE) < at;
            if surely && !has || never && has {
                return Some(format!("{p} {q} at {at}: {least} to {largest}"));
            }
        }
    }
    if *edges != AlphaShape::OWN.reconstruct(points) || *edges != alpha_shape(points, alpha) {
        return Some(String::from("two ways to the same shape differ"));
    }
    None
}

/// At no radius at which an edge appears, fewer points have other than two edges.
#[test]
fn no_alpha_is_better() {
    let mut random = Random::new(11);
    let wrong = |edges: &EdgeSet| edges.degrees().iter().filter(|&&d| d != 2).count();
    for count in [3, 5, 12, 30] {
        for _ in 0..20 {
            let places = (0..count).map(|_| DVec2::new(random.unit(), random.unit()));
            let points = PointSet::new(places.collect()).unwrap();
            let (own, exact) = (Alpha::of(&points).unwrap(), Exact::new(&points));
            let least = wrong(&alpha_shape(&points, own));
            for p in points.ids() {
                for q in points.ids().filter(|&q| p < q) {
                    let Some([radius, _]) = radii(&points, &exact, [p, q]) else {
                        continue;
                    };
                    let other = Alpha::new(radius * (1.0 + CLOSE)).unwrap();
                    let found = wrong(&alpha_shape(&points, other));
                    assert!(found >= least, "{own} {other} {points:?}");
                    let before = other.get() < own.get() * (1.0 - CLOSE);
                    assert!(found > least || !before, "{own} {other} {points:?}");
                }
            }
        }
    }
}

/// Whether the Voronoi vertex belongs to the cell of a point: none is nearer to it.
pub(crate) fn touches(exact: &Exact, points: &PointSet, vertex: &Ratio2, v: PointId) -> bool {
    let squared = |w: PointId| {
        let way = vertex.from(exact.at(w));
        dot(&way, &way)
    };
    points.ids().all(|w| squared(v) <= squared(w))
}

pub(crate) fn crawl(points: &PointSet) -> EdgeSet {
    let pairs = delaunay_pairs(points);
    let mut kept: Vec<Pair> = Vec::new();
    let is_free = |kept: &[Pair], v: PointId| degree(kept, v) == 0;
    while let Some(&seed) = pairs
        .iter()
        .find(|pair| pair.iter().all(|&v| is_free(&kept, v)))
    {
        kept.push(seed);
        loop {
            let chain = component(&kept, seed[0]);
            let ends: Vec<PointId> = chain
                .into_iter()
                .filter(|&v| degree(&kept, v) == 1)
                .collect();
            let next = pairs.iter().find(|&&[p, q]| {
                let (from_p, from_q) = (ends.contains(&p), ends.contains(&q));
                from_p && from_q && !kept.contains(&[p, q])
                    || from_p && is_free(&kept, q)
                    || from_q && is_free(&kept, p)
            });
            let Some(&next) = next else { break };
            kept.push(next);
        }
    }
    edge_set(points, &kept)
}

pub(crate) fn peel(points: &PointSet) -> EdgeSet {
    let exact = Exact::new(points);
    let vertices = voronoi_vertices(points, &exact);
    let squared = |p: PointId, q: PointId| points[p].distance_squared(points[q]);
    // Points on an empty circle, any three of which some triangulation joins.
    let circles: Vec<Vec<PointId>> = vertices
        .iter()
        .map(|vertex| {
            let on_it = points.ids().filter(|&v| touches(&exact, points, vertex, v));
            on_it.collect()
        })
        .collect();
    let is_longest = |[p, q]: Pair| {
        let beside = circles
            .iter()
            .filter(|circle| circle.contains(&p) && circle.contains(&q));
        let mut others = beside.flatten().filter(|&&r| r != p && r != q);
        others.any(|&r| squared(p, r).max(squared(q, r)) < squared(p, q))
    };
    let mut left = delaunay_pairs(points);
    left.retain(|&pair| !is_longest(pair));
    let is_short = |pair: Pair, v: PointId| {
        let mut at = left.iter().filter(|other| other.contains(&v)).take(2);
        at.any(|&other| other == pair)
    };
    let kept: Vec<Pair> = left
        .iter()
        .copied()
        .filter(|&[p, q]| is_short([p, q], p) && is_short([p, q], q))
        .collect();
    edge_set(points, &kept)
}
