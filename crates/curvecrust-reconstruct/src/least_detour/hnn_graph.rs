//! What HNN-Crust finds: runs of edges, their statistics, gaps, and which edges are certified.

use curvecrust_geometry::{EdgeSet, PointSet};
use curvecrust_voronoi::{Delaunay, DualEdge};

use super::candidates::Candidates;
use super::certificates::{Certificates, NONE, add_partners};
use super::constants::{
    AHEAD_COSINE, CERTIFIED_COSINE, CLUSTER_EDGES, GAP, GAP_DEVIATIONS, GAP_EDGES, LAST_EDGE,
    LEAST_RUN_EDGES, PRIOR_DEVIATION, PRIOR_EDGES, RUN_EDGES, SPACING_EDGES, TIE,
};
use super::measure::Measure;
use crate::clusters::Clusters;
use crate::delaunay_edges::{has_length, is_crust_edge};

/// The edges that HNN-Crust finds, at most two at each point, without gaps.
pub(super) struct HnnGraph<'a> {
    points: &'a PointSet,
    measure: Measure<'a>,
    partners: Vec<[u32; 2]>,
    is_terminus: &'a [bool],
    /// Whether HNN-Crust leaves no free end in the cluster of the point.
    is_complete: Vec<bool>,
    /// Whether a gap was removed at the point.
    is_at_gap: Vec<bool>,
}

/// Consecutive edges of HNN-Crust that lead to a point and turn little.
#[derive(Clone, Copy, Debug)]
pub(super) struct Run {
    /// The last point before it.
    pub(super) previous: u32,
    /// The mean of the logarithms of the lengths.
    pub(super) mean: f64,
    /// Their deviation, and more if the last edge is longer than the others.
    pub(super) deviation: f64,
}

/// The logarithms of the lengths of consecutive edges.
#[derive(Clone, Copy, Debug, Default)]
struct Statistics {
    count: f64,
    sum: f64,
    squares: f64,
}

impl Statistics {
    fn add(&mut self, x: f64) {
        self.count += 1.0;
        self.sum += x;
        self.squares += x * x;
    }

    fn mean(&self) -> f64 {
        self.sum / self.count
    }

    /// The sum of squared differences from the mean.
    fn scatter(&self) -> f64 {
        (self.squares - self.sum * self.mean()).max(0.0)
    }
}

impl<'a> HnnGraph<'a> {
    pub(super) fn new(
        points: &'a PointSet,
        candidates: &Candidates,
        hnn: &EdgeSet,
        is_terminus: &'a [bool],
    ) -> Self {
        let mut partners = vec![[NONE; 2]; points.len()];
        for edge in hnn.edges() {
            let [v, w] = edge.ends().map(u32::from);
            add_partners(&mut partners, v, w);
        }
        let mut graph = Self {
            points,
            measure: Measure::new(points.points()),
            partners,
            is_terminus,
            is_complete: Vec::new(),
            is_at_gap: vec![false; points.len()],
        };
        graph.is_complete = graph.complete_clusters(candidates);
        graph.remove_gaps();
        graph
    }

    /// For every point whether HNN-Crust gives every point of its cluster as many edges as it may
    /// have, none of which could as well be another.
    fn complete_clusters(&self, candidates: &Candidates) -> Vec<bool> {
        let longest = |v: u32| {
            let lengths = self.neighbours(v).map(|w| self.measure.length(v, w));
            lengths.fold(0.0, f64::max)
        };
        let ids = || (0u32..).take(self.points.len());
        let reach: Vec<f64> = ids().map(|v| CLUSTER_EDGES * longest(v)).collect();
        let mut clusters = Clusters::new(self.points.len());
        for v in ids() {
            for &w in candidates.of(v).iter().filter(|&&w| v < w) {
                let near = reach[v as usize].max(reach[w as usize]);
                if self.measure.length(v, w) < near {
                    clusters.join(v, w);
                }
            }
        }
        let mut is_complete = vec![true; self.points.len()];
        for v in ids().filter(|&v| !self.is_full(v) || self.is_tied(candidates, v)) {
            is_complete[clusters.name(v) as usize] = false;
        }
        ids()
            .map(|v| is_complete[clusters.name(v) as usize])
            .collect()
    }

    /// Whether the point has as many edges as it may have.
    fn is_full(&self, v: u32) -> bool {
        self.neighbours(v).count() + usize::from(self.is_terminus[v as usize]) >= 2
    }

    /// Whether a candidate that HNN-Crust does not join to the point is as near as the nearest
    /// neighbour or as the half neighbour: only rounding has chosen between them.
    fn is_tied(&self, candidates: &Candidates, v: u32) -> bool {
        let length = |w: u32| self.measure.length(v, w);
        let Some(nearest) = self
            .neighbours(v)
            .min_by(|&p, &q| length(p).total_cmp(&length(q)))
        else {
            return false;
        };
        let farthest = self.neighbours(v).map(length).fold(0.0, f64::max);
        let near = candidates.of(v).iter().copied();
        let mut near = near.take_while(|&w| length(w) <= TIE * farthest);
        near.any(|w| {
            let may_be_half = || length(w) < TIE * self.measure.length(w, nearest);
            self.neighbours(v).all(|chosen| chosen != w)
                && (length(w) <= TIE * length(nearest) || may_be_half())
        })
    }

    fn remove_gaps(&mut self) {
        let pairs = (0u32..).zip(&self.partners);
        let edges = pairs.flat_map(|(v, partners)| partners.map(|w| [v, w]));
        let edges = edges.filter(|&[v, w]| w != NONE && v < w);
        let gaps: Vec<[u32; 2]> = edges.filter(|&[v, w]| self.is_gap(v, w)).collect();
        for [v, w] in gaps {
            for (from, to) in [(v, w), (w, v)] {
                let partners = &mut self.partners[from as usize];
                *partners = partners.map(|p| if p == to { NONE } else { p });
            }
            self.is_at_gap[v as usize] = true;
            self.is_at_gap[w as usize] = true;
        }
    }

    /// Whether an edge is much longer than the runs at both of its ends, which are long enough to
    /// tell.
    fn is_gap(&self, v: u32, w: u32) -> bool {
        let either = [(v, w), (w, v)];
        let sides = either.map(|(v, w)| self.run(v, w));
        if sides.iter().any(|side| side.count < LEAST_RUN_EDGES as f64) {
            return false;
        }
        let [a, b] = sides;
        let variance = (a.scatter() / a.count + b.scatter() / b.count) / 2.0;
        let excess = self.measure.log_length(v, w) - a.mean().max(b.mean());
        excess > GAP.ln() + GAP_DEVIATIONS * variance.sqrt()
            && either.iter().all(|&(v, w)| self.is_longest(v, w))
    }

    /// Whether the edge from `v` to `w` turns by more than a run does.
    fn turns_aside(&self, v: u32, w: u32) -> bool {
        let before = self.next(w, v);
        before.is_none_or(|u| !self.measure.turns_less(AHEAD_COSINE, u, v, w))
    }

    /// Whether the edge from `v` to `w` is longer than [`GAP`] times each of the next [`GAP_EDGES`]
    /// edges beyond `v`, but for those that turn aside at both ends: they may be gaps themselves.
    fn is_longest(&self, v: u32, w: u32) -> bool {
        let most = self.measure.length(v, w) / GAP;
        let (mut before, mut at) = (w, v);
        for _ in 0..GAP_EDGES {
            let Some(next) = self.next(before, at) else {
                break;
            };
            if next == v || next == w {
                break;
            }
            if self.measure.length(at, next) >= most
                && !(self.turns_aside(at, next) && self.turns_aside(next, at))
            {
                return false;
            }
            [before, at] = [at, next];
        }
        true
    }

    /// The run that leads to `v`, without the edge to `w`.
    fn run(&self, v: u32, w: u32) -> Statistics {
        let mut statistics = Statistics::default();
        let (mut before, mut at) = (w, v);
        for _ in 0..RUN_EDGES {
            let Some(next) = self.next(before, at) else {
                break;
            };
            statistics.add(self.measure.log_length(at, next));
            [before, at] = [at, next];
            if at == v || at == w {
                break;
            }
        }
        statistics
    }

    /// The other neighbour of a point.
    fn next(&self, before: u32, at: u32) -> Option<u32> {
        self.neighbours(at).find(|&w| w != before)
    }

    /// The certified edges: all of complete clusters, and those that HNN-Crust and the one-step
    /// crust find and that continue almost straight at both ends.
    pub(super) fn certified<'b>(
        &'b self,
        delaunay: &'b Delaunay,
    ) -> impl Iterator<Item = [u32; 2]> + 'b {
        let is_certified = |dual: &DualEdge| {
            let [v, w] = dual.ends.map(u32::from);
            self.neighbours(v).any(|p| p == w)
                && (self.is_complete[v as usize] && has_length(self.points, dual)
                    || self.continues(v, w)
                        && self.continues(w, v)
                        && is_crust_edge(self.points, dual))
        };
        let duals = delaunay.edges().filter(move |dual| is_certified(dual));
        duals.map(|dual| dual.ends.map(u32::from))
    }

    /// Whether another edge at `v` continues the edge to `w` almost straight; at a terminus and at
    /// a gap none has to.
    fn continues(&self, v: u32, w: u32) -> bool {
        let mut others = self.neighbours(v).filter(|&p| p != w);
        self.is_terminus[v as usize]
            || self.is_at_gap[v as usize]
            || others.any(|p| self.measure.turns_less(CERTIFIED_COSINE, w, v, p))
    }

    /// Those that HNN-Crust joins to the point.
    pub(super) fn neighbours(&self, v: u32) -> impl Iterator<Item = u32> + '_ {
        let partners = self.partners[v as usize].into_iter();
        partners.filter(|&w| w != NONE)
    }

    /// The logarithm of the spacing at every point: the mean of up to [`SPACING_EDGES`] edges of
    /// HNN-Crust on each side; where an edge is missing, that of the edges to the nearest and to
    /// the half neighbour.
    ///
    /// 0 where nothing depends on it: at points of which neither they nor a candidate may get
    /// another edge.
    pub(super) fn log_spacings(
        &self,
        candidates: &Candidates,
        certificates: &Certificates<'_>,
    ) -> Vec<f64> {
        let matters = |v: u32| {
            let mut around = candidates.of(v).iter();
            !certificates.saturate(v) || around.any(|&w| !certificates.saturate(w))
        };
        let spacing = |v: u32| {
            if !matters(v) {
                0.0
            } else if self.is_full(v) && self.neighbours(v).next().is_some() {
                self.mean_around(v)
            } else {
                self.mean_of_nearest(candidates, v)
            }
        };
        (0u32..).take(self.points.len()).map(spacing).collect()
    }

    fn mean_around(&self, v: u32) -> f64 {
        let side = |first: u32| {
            let mut statistics = Statistics::default();
            let mut edge = Some([v, first]);
            while let Some([before, at]) = edge {
                statistics.add(self.measure.log_length(before, at));
                let goes_on = statistics.count < SPACING_EDGES as f64 && at != v;
                edge = self
                    .next(before, at)
                    .filter(|_| goes_on)
                    .map(|next| [at, next]);
            }
            statistics
        };
        let mut sides = self.neighbours(v).map(side);
        let (a, b) = (
            sides.next().unwrap_or_default(),
            sides.next().unwrap_or_default(),
        );
        (a.sum + b.sum) / (a.count + b.count)
    }

    fn mean_of_nearest(&self, candidates: &Candidates, v: u32) -> f64 {
        let candidates = candidates.of(v);
        let Some(&nearest) = candidates.first() else {
            return 0.0;
        };
        let is_on_the_other_side =
            |&&p: &&u32| self.measure.length(v, p) < self.measure.length(p, nearest);
        let half_neighbour = candidates.iter().find(is_on_the_other_side);
        let second = half_neighbour.map_or(nearest, |&p| p);
        (self.measure.log_length(v, nearest) + self.measure.log_length(v, second)) / 2.0
    }

    /// The run that ends at a point: the only one that leads there by at least
    /// [`LEAST_RUN_EDGES`] edges.
    pub(super) fn run_ending_at(&self, v: u32) -> Option<Run> {
        let mut runs = self
            .neighbours(v)
            .filter_map(|previous| self.run_by(v, previous));
        runs.next().filter(|_| runs.next().is_none())
    }

    /// The run whose last edge leads from `previous` to `v`.
    fn run_by(&self, v: u32, previous: u32) -> Option<Run> {
        let last = self.measure.log_length(v, previous);
        let mut run = Statistics::default();
        run.add(last);
        let [mut to, mut at] = [v, previous];
        while run.count < RUN_EDGES as f64 {
            let turns_little = |&from: &u32| self.measure.turns_less(AHEAD_COSINE, to, at, from);
            let Some(from) = self.next(to, at).filter(turns_little) else {
                break;
            };
            run.add(self.measure.log_length(at, from));
            [to, at] = [at, from];
        }
        if run.count < LEAST_RUN_EDGES as f64 {
            return None;
        }
        let mean = run.mean();
        let scatter = run.scatter() + PRIOR_EDGES * PRIOR_DEVIATION * PRIOR_DEVIATION;
        let deviation = (scatter / (run.count + PRIOR_EDGES)).sqrt();
        Some(Run {
            previous,
            mean,
            deviation: deviation + LAST_EDGE * (last - mean).max(0.0),
        })
    }
}
