//! The pairs of points that may be joined: Delaunay edges.

use std::cmp::Ordering;

use curvecrust_geometry::PointSet;
use curvecrust_geometry::parallel::*;
use curvecrust_geometry::point_set::by_coordinates;
use curvecrust_voronoi::Delaunay;

use crate::delaunay_edges::has_length;

/// Points that make a task.
const TASK: usize = 1 << 12;

/// For every point the others that it may be joined to, the closest first.
pub(super) struct Candidates {
    /// Those of `v` are `targets[first[v]..first[v + 1]]`.
    first: Vec<usize>,
    targets: Vec<u32>,
}

impl Candidates {
    /// The Delaunay edges whose dual is longer than a point: they are the same for every
    /// triangulation of cocircular points.
    pub(super) fn new(points: &PointSet, delaunay: &Delaunay) -> Self {
        let duals = delaunay.edges().filter(|dual| has_length(points, dual));
        let edges: Vec<[u32; 2]> = duals.map(|dual| dual.ends.map(u32::from)).collect();
        let both_ways = || edges.iter().flat_map(|&[a, b]| [(a, b), (b, a)]);
        let mut first = vec![0; points.len() + 1];
        for (from, _) in both_ways() {
            first[from as usize + 1] += 1;
        }
        for v in 1..first.len() {
            first[v] += first[v - 1];
        }
        let mut free = first.clone();
        let mut targets = vec![0; 2 * edges.len()];
        for (from, to) in both_ways() {
            let slot = &mut free[from as usize];
            targets[*slot] = to;
            *slot += 1;
        }
        let mut candidates = Self { first, targets };
        candidates.sort(points);
        candidates
    }

    fn sort(&mut self, points: &PointSet) {
        let mut rest = &mut self.targets[..];
        let mut lists = Vec::with_capacity(points.len());
        for (v, bounds) in self.first.windows(2).enumerate() {
            let (list, others) = rest.split_at_mut(bounds[1] - bounds[0]);
            lists.push((v, list));
            rest = others;
        }
        let points = points.points();
        lists
            .into_par_iter()
            .with_min_len(TASK)
            .for_each(|(v, list)| {
                list.sort_unstable_by(|&p, &q| {
                    let [p, q] = [p, q].map(|id| points[id as usize]);
                    let distance = |q| points[v].distance_squared(q);
                    distance(p)
                        .total_cmp(&distance(q))
                        .then(by_coordinates(p, q))
                });
            });
    }

    pub(super) fn of(&self, v: u32) -> &[u32] {
        let v = v as usize;
        &self.targets[self.first[v]..self.first[v + 1]]
    }

    /// By the distances of their candidates, and by coordinates where those are equal: an order
    /// that turning or mirroring the points does not change, as long as all distances differ.
    pub(super) fn compare(&self, points: &PointSet, v: u32, w: u32) -> Ordering {
        let points = points.points();
        let distances = |v: u32| {
            let to = move |&q: &u32| points[v as usize].distance_squared(points[q as usize]);
            self.of(v).iter().map(to)
        };
        let by_distances = distances(v)
            .zip(distances(w))
            .map(|(a, b)| a.total_cmp(&b))
            .find(|order| order.is_ne());
        by_distances
            .unwrap_or_else(|| self.of(v).len().cmp(&self.of(w).len()))
            .then_with(|| by_coordinates(points[v as usize], points[w as usize]))
    }
}
