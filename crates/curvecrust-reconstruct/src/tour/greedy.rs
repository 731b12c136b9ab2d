//! The tour that a search starts from: edges taken greedily, the shortest first.

use curvecrust_geometry::{PointId, PointSet};
use curvecrust_voronoi::Delaunay;

use super::cost::Cost;
use super::near::Near;
use crate::paths::Paths;

/// All vertices once. What must not be is not in it.
///
/// Edges between near points are taken, the shortest first, as long as paths result; then edges of
/// the Delaunay triangulation of the ends of these paths, and so on until there is one path. Each
/// round leaves a fraction of the paths. The gaps, with the termini at them, go where they cost
/// least.
pub(super) fn tour(points: &PointSet, near: &Near, cost: &Cost<'_>) -> Vec<u32> {
    let mut paths = Paths::new(points.len());
    let ids = || points.ids().map(u32::from);
    let is_inner = |v: u32| !cost.is_terminus(v);
    let inner = || ids().filter(|&v| is_inner(v));
    let from = |v: u32| near.of(v).iter().map(move |&w| [v, w]);
    let edges = inner()
        .flat_map(from)
        .filter(|&[v, w]| v < w && is_inner(w));
    join(&mut paths, points, edges.collect());
    loop {
        let ends: Vec<u32> = inner().filter(|&v| paths.is_end(v)).collect();
        let places = ends.iter().map(|&v| points[PointId::from(v)]).collect();
        // They are valid, as they are points of a set.
        let places = PointSet::new(places).unwrap_or_default();
        let delaunay = Delaunay::new(&places);
        let edges = delaunay
            .edges()
            .map(|dual| dual.ends.map(|v| ends[v.index()]));
        if !join(&mut paths, points, edges.collect()) {
            break;
        }
    }
    let termini: Vec<u32> = ids().filter(|&v| !is_inner(v)).collect();
    with_gaps(in_order(&paths, inner()), &termini, cost)
}

/// Takes the edges that join ends of different paths, the shortest first; whether there was one.
fn join(paths: &mut Paths, points: &PointSet, mut edges: Vec<[u32; 2]>) -> bool {
    let squared = |&[v, w]: &[u32; 2]| {
        let [v, w] = [v, w].map(|v| points[PointId::from(v)]);
        v.distance_squared(w)
    };
    for edge in &mut edges {
        edge.sort_unstable();
    }
    edges.sort_unstable_by(|e, f| squared(e).total_cmp(&squared(f)).then(e.cmp(f)));
    let mut is_any = false;
    for [v, w] in edges {
        if paths.is_end(v) && paths.is_end(w) && paths.far_end(v) != w {
            paths.join(v, w);
            is_any = true;
        }
    }
    is_any
}

/// The points path by path, each from one end to the other.
fn in_order(paths: &Paths, points: impl Iterator<Item = u32>) -> Vec<u32> {
    let mut order = Vec::new();
    let mut is_done = vec![false; paths.len()];
    for end in points.filter(|&v| paths.is_end(v)) {
        let mut next = Some(end).filter(|&v| !is_done[v as usize]);
        while let Some(v) = next {
            is_done[v as usize] = true;
            order.push(v);
            next = paths.partners(v).find(|&w| !is_done[w as usize]);
        }
    }
    order
}

/// Puts gaps and termini into a tour of the other points, such that each curve has two points and
/// each terminus a gap beside it.
fn with_gaps(mut inner: Vec<u32>, termini: &[u32], cost: &Cost<'_>) -> Vec<u32> {
    let gaps: Vec<u32> = cost.gaps().collect();
    if let [gap] = gaps[..] {
        return with_gap(inner, gap, termini, cost);
    }
    rotate_to_longest(&mut inner, cost);
    let mut inner = inner.into_iter();
    let mut termini = termini.iter().copied();
    let mut tour = Vec::new();
    for &gap in &gaps {
        let [start, end] = [termini.next(), termini.next()];
        let missing = usize::from(start.is_none()) + usize::from(end.is_none());
        tour.extend(start);
        tour.extend(inner.by_ref().take(missing));
        let is_last = Some(&gap) == gaps.last();
        tour.extend(inner.by_ref().take(if is_last { usize::MAX } else { 0 }));
        tour.extend(end);
        tour.push(gap);
    }
    tour.extend(inner);
    tour
}

/// The longest edge leads from the last to the first.
fn rotate_to_longest(tour: &mut [u32], cost: &Cost<'_>) {
    let next = tour.iter().cycle().skip(1);
    let lengths = tour.iter().zip(next).map(|(&v, &w)| cost.edge(v, w));
    let longest = lengths.enumerate().max_by(|(_, d), (_, e)| d.total_cmp(e));
    if let Some((at, _)) = longest {
        tour.rotate_left(at + 1);
    }
}

/// Puts a gap, with up to two termini beside it, where that costs least.
fn with_gap(mut inner: Vec<u32>, gap: u32, termini: &[u32], cost: &Cost<'_>) -> Vec<u32> {
    let ends = |from: u32, to: u32, ends: &[u32]| match *ends {
        [s, t] => cost.edge(from, s) + cost.edge(t, to),
        [s] => cost.edge(from, s),
        _ => 0.0,
    };
    let mut there = termini.to_vec();
    let mut best: Option<(f64, usize, bool)> = None;
    for is_back in [false, true] {
        for (i, &v) in inner.iter().enumerate() {
            let w = inner[(i + 1) % inner.len()];
            let added = if is_back {
                ends(w, v, &there)
            } else {
                ends(v, w, &there)
            } - cost.edge(v, w);
            if best.is_none_or(|(least, _, _)| added < least) {
                best = Some((added, i, is_back));
            }
        }
    }
    if let Some((_, at, is_back)) = best {
        inner.rotate_left(at + 1);
        if is_back {
            inner.reverse();
        }
    }
    let second = if there.len() > 1 { there.pop() } else { None };
    inner.extend(there);
    inner.push(gap);
    inner.extend(second);
    inner
}
