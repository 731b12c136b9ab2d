//! Least detour by its definition, with brute force.

use curvecrust_geometry::point_set::by_coordinates;
use curvecrust_geometry::{DVec2, Edge, EdgeSet, PointId, PointSet};

use super::super::oracles;
use super::constants::{
    AHEAD_COSINE, ASIDE, CERTIFIED_COSINE, CLUSTER_EDGES, CONTINUATION_NEIGHBOURS, END, GAP,
    GAP_DEVIATIONS, GAP_EDGES, ISOLATED, LAST_EDGE, LAST_END, LEAST_ISOLATED, LEAST_RUN_EDGES,
    OUTLIER, POSSIBLE_DETOUR, PRIOR_DEVIATION, PRIOR_EDGES, RATIO_SCALE, RATIO_WEIGHT, RUN_EDGES,
    RUN_END, SPACING_EDGES, SPARSE, STRAIGHT_COSINE, TIE, TURN_SCALE, TURN_WEIGHT, UNEVEN,
};

/// The cost of edges as the module's doc defines it, with brute force for what it depends on.
pub(crate) struct Definition<'a> {
    pub(crate) points: &'a PointSet,
    /// Delaunay edges whose dual is longer than a point.
    pub(crate) candidates: EdgeSet,
    /// HNN-Crust without gaps.
    graph: EdgeSet,
    crust: EdgeSet,
    /// Whether HNN-Crust leaves no free end in the cluster, and only rounding chooses none of its
    /// edges.
    is_complete: Vec<bool>,
    is_at_gap: Vec<bool>,
    log_spacings: Vec<f64>,
    /// Of one free end of each point, and of both.
    pub(crate) penalties: Vec<[f64; 2]>,
}

pub(crate) fn partners(edges: &EdgeSet, v: PointId) -> Vec<PointId> {
    let at = edges.edges().iter().filter(|e| e.ends().contains(&v));
    at.map(|e| if e.a() == v { e.b() } else { e.a() }).collect()
}

/// The points of a path that begins with `v` and `next`, with so many edges at most; it ends early
/// where it comes back to one of `ends`.
fn path(edges: &EdgeSet, [v, next]: [PointId; 2], most: usize, ends: &[PointId]) -> Vec<PointId> {
    let mut path = vec![v, next];
    while path.len() <= most && !ends.contains(&path[path.len() - 1]) {
        let [before, at] = [path[path.len() - 2], path[path.len() - 1]];
        let Some(next) = partners(edges, at).into_iter().find(|&w| w != before) else {
            break;
        };
        path.push(next);
    }
    path
}

fn mean(values: &[f64]) -> f64 {
    values.iter().sum::<f64>() / values.len() as f64
}

fn variance(values: &[f64]) -> f64 {
    let mean = mean(values);
    values.iter().map(|x| (x - mean) * (x - mean)).sum::<f64>() / values.len() as f64
}

/// |vp| + |vq| - |pq|, where p is the nearer: |vq| - |pq| is nothing but rounding when vp is tiny.
fn detour(v: DVec2, p: DVec2, q: DVec2) -> f64 {
    let (a, b) = (p - v, q - v);
    let [a, b] = if a.length() <= b.length() {
        [a, b]
    } else {
        [b, a]
    };
    let difference = a.dot(2.0 * b - a) / (b.length() + p.distance(q));
    a.length() + difference
}

/// Whether the path p, v, q is possible in a rho-sample.
fn may_be_consecutive(v: DVec2, p: DVec2, q: DVec2) -> bool {
    detour(v, p, q) <= POSSIBLE_DETOUR * v.distance(p).min(v.distance(q))
}

/// What it costs to go from p to q by v.
fn bend(v: DVec2, p: DVec2, q: DVec2) -> f64 {
    let turn = (v - p).angle_to(q - v).abs();
    let ratio = (v.distance(p) / v.distance(q)).ln();
    TURN_WEIGHT * (1.0 + 16.0 * (turn / 4.0).sin().powi(2) / TURN_SCALE).ln()
        + RATIO_WEIGHT * (1.0 + ratio * ratio / RATIO_SCALE).ln()
}

impl<'a> Definition<'a> {
    pub(crate) fn new(points: &'a PointSet) -> Self {
        let pairs = points.ids().flat_map(|p| points.ids().map(move |q| (p, q)));
        let candidates =
            pairs.filter(|&(p, q)| p < q && oracles::voronoi_edge(points, p, q).is_some());
        let candidates = candidates.filter_map(|(p, q)| Edge::new(p, q));
        let mut definition = Self {
            points,
            candidates: EdgeSet::new(points.len(), candidates),
            graph: oracles::hnn_crust(points),
            crust: oracles::one_step_crust(points),
            is_complete: Vec::new(),
            is_at_gap: vec![false; points.len()],
            log_spacings: Vec::new(),
            penalties: Vec::new(),
        };
        definition.is_complete = definition.complete_clusters();
        definition.remove_gaps();
        definition.log_spacings = points.ids().map(|v| definition.log_spacing(v)).collect();
        definition.penalties = points.ids().map(|v| definition.penalty(v)).collect();
        definition
    }

    fn length(&self, v: PointId, w: PointId) -> f64 {
        self.points[v].distance(self.points[w])
    }

    fn log_lengths(&self, path: &[PointId]) -> Vec<f64> {
        let lengths = path.windows(2).map(|w| self.length(w[0], w[1]).ln());
        lengths.collect()
    }

    fn complete_clusters(&self) -> Vec<bool> {
        let reach = |v: PointId| {
            let lengths = partners(&self.graph, v);
            let lengths = lengths.into_iter().map(|w| self.length(v, w));
            CLUSTER_EDGES * lengths.fold(0.0, f64::max)
        };
        let near = self.candidates.edges().iter().filter(|e| {
            let [v, w] = e.ends();
            self.length(v, w) < reach(v).max(reach(w))
        });
        let near: Vec<Edge> = near.copied().collect();
        // What is incomplete spreads to all of its cluster.
        let is_full = |v: PointId| partners(&self.graph, v).len() == 2 && !self.is_tied(v);
        let mut is_complete: Vec<bool> = self.points.ids().map(is_full).collect();
        for _ in self.points.ids() {
            for e in &near {
                let [v, w] = e.ends().map(PointId::index);
                let both = is_complete[v] && is_complete[w];
                [is_complete[v], is_complete[w]] = [both, both];
            }
        }
        is_complete
    }

    /// Whether a candidate without an edge to the point is as near as the nearer partner, or near
    /// enough to be the half neighbour.
    fn is_tied(&self, v: PointId) -> bool {
        let mut joined = partners(&self.graph, v);
        joined.sort_by(|&p, &q| self.length(v, p).total_cmp(&self.length(v, q)));
        let (Some(&nearest), Some(&farthest)) = (joined.first(), joined.last()) else {
            return false;
        };
        let others = partners(&self.candidates, v).into_iter();
        let mut others = others.filter(|w| !joined.contains(w));
        others.any(|w| {
            let is_as_near = self.length(v, w) <= TIE * self.length(v, nearest);
            let may_be_half = self.length(v, w) <= TIE * self.length(v, farthest)
                && self.length(v, w) < TIE * self.length(w, nearest);
            is_as_near || may_be_half
        })
    }

    fn remove_gaps(&mut self) {
        let all = self.graph.edges().to_vec();
        let (gaps, rest): (Vec<Edge>, Vec<Edge>) = all.into_iter().partition(|e| self.is_gap(e));
        for v in gaps.iter().flat_map(|e| e.ends()) {
            self.is_at_gap[v.index()] = true;
        }
        self.graph = EdgeSet::new(self.points.len(), rest);
    }

    fn is_gap(&self, edge: &Edge) -> bool {
        let [v, w] = edge.ends();
        let run = |v: PointId, w: PointId| {
            let next = partners(&self.graph, v).into_iter().find(|&p| p != w);
            let run = next.map(|next| path(&self.graph, [v, next], RUN_EDGES, &[v, w]));
            run.map_or(Vec::new(), |run| self.log_lengths(&run))
        };
        let [a, b] = [run(v, w), run(w, v)];
        let deviation = f64::midpoint(variance(&a), variance(&b)).sqrt();
        let excess = self.length(v, w).ln() - mean(&a).max(mean(&b));
        a.len().min(b.len()) >= LEAST_RUN_EDGES
            && excess > GAP.ln() + GAP_DEVIATIONS * deviation
            && self.is_longest(v, w)
            && self.is_longest(w, v)
    }

    /// Whether the edge is longer than the next ones beyond `v`, but for those that turn aside at
    /// both ends.
    fn is_longest(&self, v: PointId, w: PointId) -> bool {
        let Some(next) = partners(&self.graph, v).into_iter().find(|&p| p != w) else {
            return true;
        };
        let turns_aside = |v: PointId, w: PointId| {
            let mut others = partners(&self.graph, v).into_iter().filter(|&p| p != w);
            !others.any(|p| self.turns_less(AHEAD_COSINE, [p, v, w]))
        };
        let beyond = path(&self.graph, [v, next], GAP_EDGES, &[v, w]);
        let mut long = beyond.windows(2).filter(|e| {
            ![v, w].contains(&e[1]) && self.length(e[0], e[1]) >= self.length(v, w) / GAP
        });
        long.all(|e| turns_aside(e[0], e[1]) && turns_aside(e[1], e[0]))
    }

    fn log_spacing(&self, v: PointId) -> f64 {
        let neighbours = partners(&self.graph, v);
        if neighbours.len() == 2 {
            let sides = neighbours
                .iter()
                .flat_map(|&w| self.log_lengths(&path(&self.graph, [v, w], SPACING_EDGES, &[v])));
            return mean(&sides.collect::<Vec<_>>());
        }
        let closest = self.closest(v);
        let Some(&nearest) = closest.first() else {
            return 0.0;
        };
        let mut others = closest.iter().copied();
        let half = others.find(|&p| self.length(v, p) < self.length(p, nearest));
        let second = half.unwrap_or(nearest);
        f64::midpoint(self.length(v, nearest).ln(), self.length(v, second).ln())
    }

    fn closest(&self, v: PointId) -> Vec<PointId> {
        let mut closest = partners(&self.candidates, v);
        closest.sort_by(|&p, &q| {
            let distance = |p: PointId| self.points[v].distance_squared(self.points[p]);
            distance(p)
                .total_cmp(&distance(q))
                .then(by_coordinates(self.points[p], self.points[q]))
        });
        closest
    }

    fn is_saturated(&self, v: PointId) -> bool {
        let certified = partners(&self.graph, v).into_iter();
        certified.filter(|&w| self.is_certified(v, w)).count() == 2
    }

    /// Of one free end of a point that certified edges do not saturate, and of both.
    fn penalty(&self, v: PointId) -> [f64; 2] {
        let one = self.end(v);
        let usual = if self.continues_a_neighbour(v) {
            ISOLATED
        } else {
            OUTLIER
        };
        let spacing = |v: PointId| self.log_spacings[v.index()];
        let mut around: Vec<f64> = self.closest(v).into_iter().map(spacing).collect();
        around.sort_by(f64::total_cmp);
        let excess = match around.len() {
            0 => 0.0,
            n => (spacing(v) - around[(n - 1) / 4]).max(0.0),
        };
        let both = (usual - SPARSE * excess).max(LEAST_ISOLATED);
        [one, both.min(2.0 * one)]
    }

    fn end(&self, v: PointId) -> f64 {
        let neighbours = partners(&self.graph, v);
        let runs = neighbours
            .iter()
            .filter_map(|&w| Some((w, self.run(v, w)?)));
        let [(previous, [mean, deviation])] = runs.collect::<Vec<_>>()[..] else {
            return END;
        };
        let ahead = self.closest(v).into_iter().filter(|&w| {
            w != previous
                && !self.is_saturated(w)
                && self.turns_less(AHEAD_COSINE, [previous, v, w])
        });
        let is_long = |w: &PointId| self.length(v, *w).ln() >= mean + ASIDE.ln();
        let least = if ahead.count() == 0 && neighbours.iter().all(|w| *w == previous || is_long(w))
        {
            LAST_END
        } else if neighbours.len() == 1 {
            RUN_END
        } else {
            return END;
        };
        END.min(least + UNEVEN * deviation)
    }

    /// Whether a run ends at a point, and no other.
    pub(crate) fn has_run(&self, v: PointId) -> bool {
        let neighbours = partners(&self.graph, v).into_iter();
        neighbours.filter(|&w| self.run(v, w).is_some()).count() == 1
    }

    /// The mean logarithm of the run whose last edge leads from `previous` to `v`, and how uneven
    /// it is.
    fn run(&self, v: PointId, previous: PointId) -> Option<[f64; 2]> {
        let mut run = path(&self.graph, [v, previous], RUN_EDGES, &[]);
        let turns_less = |w: &[PointId]| self.turns_less(AHEAD_COSINE, [w[0], w[1], w[2]]);
        if let Some(turn) = run.windows(3).position(|w| !turns_less(w)) {
            run.truncate(turn + 2);
        }
        let lengths = self.log_lengths(&run);
        let (n, mean) = (lengths.len() as f64, mean(&lengths));
        let scatter = n * variance(&lengths) + PRIOR_EDGES * PRIOR_DEVIATION.powi(2);
        let deviation = (scatter / (n + PRIOR_EDGES)).sqrt();
        let longer = (lengths[0] - mean).max(0.0);
        (lengths.len() >= LEAST_RUN_EDGES).then_some([mean, deviation + LAST_EDGE * longer])
    }

    /// Whether the path p, v, q turns by no more than the angle with this cosine.
    fn turns_less(&self, cosine: f64, [p, v, q]: [PointId; 3]) -> bool {
        let [p, v, q] = [p, v, q].map(|id| self.points[id]);
        // By its cosine: the angle itself is not exact where points of a lattice turn by as much.
        let (a, b) = (v - p, q - v);
        a.dot(b) >= cosine * a.length() * b.length()
    }

    /// Whether the curve through a candidate that is not saturated may continue to the point.
    fn continues_a_neighbour(&self, v: PointId) -> bool {
        self.closest(v).into_iter().any(|w| {
            let mut others = self.closest(w);
            others.retain(|&u| u != v);
            others.truncate(CONTINUATION_NEIGHBOURS);
            let pairs = || {
                others
                    .iter()
                    .flat_map(|&p| others.iter().map(move |&q| (p, q)))
            };
            let mut straight_on =
                pairs().filter(|&(p, q)| self.turns_less(STRAIGHT_COSINE, [p, w, q]));
            !self.is_saturated(w)
                && straight_on.next().is_none()
                && (others.is_empty()
                    || others.iter().any(|&u| {
                        may_be_consecutive(self.points[w], self.points[u], self.points[v])
                    }))
        })
    }

    fn is_certified(&self, v: PointId, w: PointId) -> bool {
        let continues = |v: PointId, w: PointId| {
            let mut others = partners(&self.graph, v).into_iter().filter(|&p| p != w);
            self.is_at_gap[v.index()]
                || others.any(|p| {
                    let [a, b] = [w, p].map(|id| self.points[id] - self.points[v]);
                    -a.dot(b) >= CERTIFIED_COSINE * a.length() * b.length()
                })
        };
        let is_in = |edges: &EdgeSet| Edge::new(v, w).is_some_and(|e| edges.contains(e));
        is_in(&self.graph)
            && is_in(&self.candidates)
            && (self.is_complete[v.index()]
                || is_in(&self.crust) && continues(v, w) && continues(w, v))
    }

    pub(crate) fn certified(&self) -> impl Iterator<Item = Edge> + '_ {
        let edges = self.graph.edges().iter().copied();
        edges.filter(|e| self.is_certified(e.a(), e.b()))
    }

    pub(crate) fn cost(&self, edges: &EdgeSet) -> f64 {
        let at = |v: PointId| self.cost_at(v, &partners(edges, v));
        self.points.ids().map(at).sum()
    }

    fn edge_cost(&self, v: PointId, w: PointId) -> f64 {
        let spacings = [v, w].map(|id| self.log_spacings[id.index()]);
        self.length(v, w).ln() - mean(&spacings)
    }

    /// What a point with these partners costs: half of its edges, and its bend or its free ends.
    pub(crate) fn cost_at(&self, v: PointId, partners: &[PointId]) -> f64 {
        let edges = partners.iter().map(|&p| 0.5 * self.edge_cost(v, p));
        let point = |id: PointId| self.points[id];
        let at_v = match *partners {
            [p, q] => bend(point(v), point(p), point(q)),
            [_] => self.penalties[v.index()][0],
            _ => self.penalties[v.index()][1],
        };
        edges.sum::<f64>() + at_v
    }

    pub(crate) fn has_triangle(edges: &EdgeSet) -> bool {
        let rings = edges.chains();
        rings
            .iter()
            .any(|c| c.is_closed() && c.vertices().len() == 3)
    }
}
