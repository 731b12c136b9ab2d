//! Closed curves alone, of a known number or not.

use curvecrust_geometry::{EdgeSet, PointId, PointSet};
use curvecrust_voronoi::Delaunay;

use super::edges;
use super::rings::{Partners, make_polygon};
use crate::error::ReconstructError;
use crate::known::Shape;
use crate::tour::{Goal, Near, Task, short_tour};

/// Closed curves through all points, which are not on one line: those among the edges stay, as long
/// as their number is right, and open ones are closed.
///
/// # Errors
/// [`CurvesNotFound`](ReconstructError::CurvesNotFound) if points on lines leave no way to have so
/// many.
pub(super) fn closed(
    points: &PointSet,
    found: &EdgeSet,
    asked: Option<usize>,
) -> Result<EdgeSet, ReconstructError> {
    let (sorted, ids) = points.in_hilbert_order();
    let mut rings = Rings::new(&sorted, &ids, found);
    rings.close();
    if let Some(asked) = asked {
        rings.join_until(asked);
        rings.part_until(asked);
        let found = rings.partners.curves().len();
        if found != asked {
            return Err(ReconstructError::CurvesNotFound { asked, found });
        }
    }
    let all = rings.simple();
    let edges = all.iter().flat_map(|ring| edges(ring, Shape::Closed, &ids));
    Ok(EdgeSet::new(points.len(), edges.collect::<Vec<_>>()))
}

struct Rings<'a> {
    points: &'a PointSet,
    near: Near,
    partners: Partners,
    /// Points at edges that were not found by the algorithm.
    is_changed: Vec<bool>,
}

impl<'a> Rings<'a> {
    fn new(points: &'a PointSet, ids: &[PointId], found: &EdgeSet) -> Self {
        let mut named = vec![0; points.len()];
        for (new, old) in (0u32..).zip(ids) {
            named[old.index()] = new;
        }
        let mut partners = Partners::new(points.len());
        let mut edges: Vec<[u32; 2]> = found
            .edges()
            .iter()
            .map(|edge| edge.ends().map(|v| named[v.index()]))
            .collect();
        for edge in &mut edges {
            edge.sort_unstable();
        }
        edges.sort_unstable();
        for [v, w] in edges {
            partners.join(v, w);
        }
        Self {
            points,
            near: Near::new(points, &Delaunay::new(points)),
            partners,
            is_changed: vec![false; points.len()],
        }
    }

    fn length(&self, v: u32, w: u32) -> f64 {
        self.points[PointId::from(v)].distance(self.points[PointId::from(w)])
    }

    fn join(&mut self, v: u32, w: u32) {
        self.partners.join(v, w);
        self.change([v, w]);
    }

    fn exchange(&mut self, e: [u32; 2], f: [u32; 2]) {
        self.partners.exchange(e, f);
        self.change([e[0], e[1]]);
        self.change([f[0], f[1]]);
    }

    fn change(&mut self, edge: [u32; 2]) {
        for v in edge {
            self.is_changed[v as usize] = true;
        }
    }

    /// Leaves no open slot: joins ends to those of other curves or of their own, the nearest first,
    /// in rounds on the triangulation of the ends that are left.
    fn close(&mut self) {
        loop {
            let mut open = self.partners.curves();
            open.retain(|curve| self.partners.open_slots(curve[0]) > 0);
            match &open[..] {
                [] => return,
                [last] if !make_polygon(self.points, last) => {
                    self.insert(last);
                    return;
                }
                [_] | [_, _, ..] => {}
            }
            if !self.join_ends(&open) {
                return;
            }
        }
    }

    /// Whether there was something to join.
    fn join_ends(&mut self, open: &[Vec<u32>]) -> bool {
        let mut ends: Vec<u32> = open.iter().flat_map(|c| [c[0], c[c.len() - 1]]).collect();
        ends.sort_unstable();
        ends.dedup();
        let places = ends
            .iter()
            .map(|&v| self.points[PointId::from(v)])
            .collect();
        // They are valid, as they are points of a set.
        let delaunay = Delaunay::new(&PointSet::new(places).unwrap_or_default());
        let edges = delaunay
            .edges()
            .map(|dual| dual.ends.map(|v| ends[v.index()]));
        let own = open.iter().map(|c| [c[0], c[c.len() - 1]]);
        let mut edges: Vec<[u32; 2]> = edges.chain(own).filter(|[v, w]| v != w).collect();
        for edge in &mut edges {
            edge.sort_unstable();
        }
        edges.sort_unstable_by(|e, f| {
            let [d, g] = [e, f].map(|&[v, w]| self.length(v, w));
            d.total_cmp(&g).then(e.cmp(f))
        });
        edges.dedup();
        let mut paths = Paths::new(open, self.points.len());
        let mut is_any = false;
        for [v, w] in edges {
            let is_open = [v, w].into_iter().all(|v| self.partners.open_slots(v) > 0);
            if !is_open || self.partners.are_joined(v, w) {
                continue;
            }
            let [p, q] = [v, w].map(|v| paths.of(v));
            if p == q && !make_polygon(self.points, &paths.points[p]) {
                continue;
            }
            self.join(v, w);
            paths.unite(p, q);
            is_any = true;
        }
        is_any
    }

    /// Puts a path that is no polygon into the edge of a ring where that costs least.
    fn insert(&mut self, path: &[u32]) {
        let (first, last) = (path[0], path[path.len() - 1]);
        let mut best: Option<(f64, [u32; 2])> = None;
        for v in (0u32..)
            .take(self.points.len())
            .filter(|&v| self.partners.open_slots(v) == 0)
        {
            for w in self.partners.of(v) {
                if path.contains(&v) || path.contains(&w) {
                    continue;
                }
                let added = self.length(v, first) + self.length(last, w) - self.length(v, w);
                if best.is_none_or(|(least, _)| added < least) {
                    best = Some((added, [v, w]));
                }
            }
        }
        let Some((_, [v, w])) = best else { return };
        if path.len() > 1 {
            // As if the path were a ring, cut between its ends.
            self.join(first, last);
            self.exchange([v, w], [first, last]);
        } else {
            self.partners.insert(first, [v, w]);
            self.change([v, w]);
        }
    }

    /// Joins rings by exchanges of two edges, the cheapest first, until there are as many as asked.
    fn join_until(&mut self, asked: usize) {
        let mut rings = self.partners.curves();
        while rings.len() > asked {
            let mut paths = Paths::new(&rings, self.points.len());
            let mut left = rings.len() - asked;
            for [a, b, c, d] in
                self.exchanges(|v, w| paths.ring[v as usize] != paths.ring[w as usize])
            {
                let [p, q] = [paths.of(a), paths.of(c)];
                let are_edges = self.partners.are_joined(a, b) && self.partners.are_joined(c, d);
                if left > 0 && p != q && are_edges {
                    self.exchange([a, b], [c, d]);
                    paths.unite(p, q);
                    left -= 1;
                }
            }
            let before = rings.len();
            rings = self.partners.curves();
            if rings.len() == before {
                return;
            }
        }
    }

    /// Exchanges of the edges a b and c d for a c and b d, where a is near c, the cheapest first.
    fn exchanges(&self, is_wanted: impl Fn(u32, u32) -> bool) -> Vec<[u32; 4]> {
        let mut all = Vec::new();
        for a in (0u32..).take(self.points.len()) {
            for &c in self.near.of(a).iter().filter(|&&c| is_wanted(a, c)) {
                for (b, d) in self
                    .partners
                    .of(a)
                    .into_iter()
                    .flat_map(|b| self.partners.of(c).map(|d| (b, d)))
                {
                    let all_apart = a != d && b != c && b != d;
                    if all_apart {
                        let new = self.length(a, c) + self.length(b, d);
                        all.push((new - self.length(a, b) - self.length(c, d), [a, b, c, d]));
                    }
                }
            }
        }
        all.sort_unstable_by(|(x, e), (y, f)| x.total_cmp(y).then(e.cmp(f)));
        all.into_iter().map(|(_, exchange)| exchange).collect()
    }

    /// Parts rings by exchanges of two edges, the cheapest first, until there are as many as asked.
    fn part_until(&mut self, asked: usize) {
        let mut rings = self.partners.curves();
        while rings.len() < asked {
            let mut place = vec![(0, 0); self.points.len()];
            for (r, ring) in rings.iter().enumerate() {
                for (i, &v) in ring.iter().enumerate() {
                    place[v as usize] = (r, i);
                }
            }
            let mut left = asked - rings.len();
            let mut is_parted = vec![false; rings.len()];
            let ring_of = |v: u32| place[v as usize].0;
            for [a, b, c, d] in self.exchanges(|v, w| ring_of(v) == ring_of(w)) {
                let (r, i) = place[a as usize];
                let ring = &rings[r];
                let steps = |v: u32| (place[v as usize].1 + ring.len() - i) % ring.len();
                // From a on to b or back from it: only if c and d follow the other way round.
                let is_on = steps(b) == 1;
                let length = if is_on {
                    steps(d)
                } else {
                    ring.len() - steps(d)
                };
                let ends = if is_on {
                    steps(d) + 1 == steps(c)
                } else {
                    steps(c) + 1 == steps(d)
                };
                if left == 0 || is_parted[r] || !ends {
                    continue;
                }
                let mut turned = ring.clone();
                turned.rotate_left(i);
                if !is_on {
                    turned[1..].reverse();
                }
                let (part, rest) = turned[1..].split_at(length);
                let rest: Vec<u32> = rest.iter().copied().chain([a]).collect();
                if make_polygon(self.points, part) && make_polygon(self.points, &rest) {
                    self.exchange([a, b], [c, d]);
                    is_parted[r] = true;
                    left -= 1;
                }
            }
            let before = rings.len();
            rings = self.partners.curves();
            if rings.len() == before {
                return;
            }
        }
    }

    /// The rings, each of which that is not as the algorithm found it made a simple polygon.
    fn simple(&self) -> Vec<Vec<u32>> {
        let simple = |ring: Vec<u32>| {
            if !ring.iter().any(|&v| self.is_changed[v as usize]) || ring.len() < 4 {
                return ring;
            }
            let mut ring = ring;
            ring.sort_unstable();
            let places = ring
                .iter()
                .map(|&v| self.points[PointId::from(v)])
                .collect();
            let places = PointSet::new(places).unwrap_or_default();
            let tours = short_tour(&places, &Task::closed(Goal::LengthAndDetours))
                .into_iter()
                .flatten();
            tours.map(|v| ring[v as usize]).collect()
        };
        self.partners.curves().into_iter().map(simple).collect()
    }
}

/// Which curve each point is on, while curves are joined.
struct Paths {
    ring: Vec<usize>,
    towards: Vec<usize>,
    points: Vec<Vec<u32>>,
}

impl Paths {
    fn new(curves: &[Vec<u32>], count: usize) -> Self {
        let mut ring = vec![0; count];
        for (r, curve) in curves.iter().enumerate() {
            for &v in curve {
                ring[v as usize] = r;
            }
        }
        Self {
            ring,
            towards: (0..curves.len()).collect(),
            points: curves.to_vec(),
        }
    }

    fn of(&self, v: u32) -> usize {
        let mut ring = self.ring[v as usize];
        while self.towards[ring] != ring {
            ring = self.towards[ring];
        }
        ring
    }

    /// The smaller goes to the larger.
    fn unite(&mut self, p: usize, q: usize) {
        if p == q {
            return;
        }
        let [small, large] = if self.points[p].len() < self.points[q].len() {
            [p, q]
        } else {
            [q, p]
        };
        let mut moved = std::mem::take(&mut self.points[small]);
        self.points[large].append(&mut moved);
        self.towards[small] = large;
    }
}
