//! What HNN-Crust and the one-step crust say of the edges: which are certain, and how long those at a
//! point may be.

use curvecrust_geometry::{DVec2, EdgeSet, PointSet};
use curvecrust_voronoi::{Delaunay, DualEdge};

use super::candidates::Candidates;
use super::joins::{NONE, Price, detour, put};
use crate::one_step_crust::is_crust_edge;

/// The least cosine of the turn between certain edges: a turn of 49.5 degrees. Consecutive edges of
/// an epsilon-sample turn by 4 asin(epsilon / (2 - 2 epsilon)) at most (SGP 2016, Lemma 9), which is
/// less than that for epsilon < 0.3.
const STRAIGHT: f64 = 0.65;

/// The largest detour between trusted edges, in lengths of the shorter one. Consecutive edges of
/// equal length of a rho-sample turn by 4 asin(rho / 2) at most (SGP 2016, Lemma 8): for rho < 0.9
/// by 107 degrees, a detour of 0.81.
const TRUSTED: f64 = 0.82;

/// A point that is farther from its nearest neighbour than this many times what the points around are
/// from theirs is taken for an outlier: to leave it alone costs no more than if it were that far, but
/// no less than one open slot.
const OUTLIER: f64 = 3.0;

/// What it costs to leave a slot open, in longest edges that are to be expected there.
const OPEN: f64 = 2.25;

/// The edges that HNN-Crust finds: at most two at each point.
pub(super) struct Certificates<'a> {
    points: &'a PointSet,
    partners: Vec<[u32; 2]>,
    is_terminus: &'a [bool],
}

impl<'a> Certificates<'a> {
    pub(super) fn new(points: &'a PointSet, hnn: &EdgeSet, is_terminus: &'a [bool]) -> Self {
        let mut partners = vec![[NONE; 2]; points.len()];
        for edge in hnn.edges() {
            let [v, w] = edge.ends().map(u32::from);
            put(&mut partners, v, w);
        }
        Self {
            points,
            partners,
            is_terminus,
        }
    }

    /// The edges that are certain: HNN-Crust and the one-step crust find them, and they go on
    /// almost straight at both ends.
    pub(super) fn certain<'b>(
        &'b self,
        delaunay: &'b Delaunay,
    ) -> impl Iterator<Item = [u32; 2]> + 'b {
        let is_certain = |dual: &DualEdge| {
            let ends = dual.ends.map(u32::from);
            let is_straight = |a: DVec2, b: DVec2| -a.dot(b) >= STRAIGHT * a.length() * b.length();
            self.partners_of(ends[0]).any(|w| w == ends[1])
                && self.goes_on(ends, |v| self.partners_of(v), is_straight)
                && is_crust_edge(self.points, dual)
        };
        let duals = delaunay.edges().filter(move |dual| is_certain(dual));
        duals.map(|dual| dual.ends.map(u32::from))
    }

    /// For every point what it costs to leave one of its slots open, or both.
    ///
    /// A slot costs [`OPEN`] times the length to be expected there: the longest distance to a nearest
    /// neighbour of the two closest candidates and of the point itself, or of an edge at the point
    /// that may be long: HNN-Crust finds it, or the one-step crust between points that are not
    /// settled, and it goes on at both ends, by edges of the same graph, with turns of a rho-sample.
    /// Both slots cost twice as much, but for an [`OUTLIER`], and never less than one.
    pub(super) fn prices(&self, candidates: &Candidates, crust: &Crust) -> Vec<Price> {
        let to_nearest = |v: u32| {
            let nearest = candidates.of(v).first();
            nearest.map_or(0.0, |&w| self.distance(v, w))
        };
        let price = |v: u32| {
            let closest = candidates.of(v).iter().take(2);
            let around = closest.map(|&w| to_nearest(w)).fold(0.0, f64::max);
            let own = to_nearest(v);
            let trusted = f64::max(
                self.longest_trusted(v, |v| self.partners_of(v)),
                self.longest_trusted(v, |v| crust.of(v)),
            );
            let expected = around.max(trusted);
            let slot = OPEN * expected.max(own);
            let both = 2.0 * OPEN * expected.max(own.min(OUTLIER * around));
            Price {
                slot,
                both: both.max(slot),
            }
        };
        (0u32..).take(self.partners.len()).map(price).collect()
    }

    /// The length of the longest edge at a point, in a graph, with turns of a rho-sample; 0 if there
    /// is none.
    fn longest_trusted<N: Iterator<Item = u32>>(
        &self,
        v: u32,
        neighbours: impl Fn(u32) -> N + Copy,
    ) -> f64 {
        let is_possible =
            |a: DVec2, b: DVec2| detour(DVec2::ZERO, a, b) <= TRUSTED * a.length().min(b.length());
        let trusted = neighbours(v).filter(|&w| self.goes_on([v, w], neighbours, is_possible));
        trusted.map(|w| self.distance(v, w)).fold(0.0, f64::max)
    }

    /// Whether an edge of a graph goes on at both ends, to another neighbour, by edges that are
    /// `well` together. A terminus has nowhere to go on to.
    fn goes_on<N: Iterator<Item = u32>>(
        &self,
        ends: [u32; 2],
        neighbours: impl Fn(u32) -> N,
        well: impl Fn(DVec2, DVec2) -> bool,
    ) -> bool {
        let point = |v: u32| self.points.points()[v as usize];
        let from = |v: u32, to: u32| {
            let mut onward = neighbours(v).filter(|&w| w != to);
            self.is_terminus[v as usize]
                || onward.any(|w| well(point(to) - point(v), point(w) - point(v)))
        };
        let [v, w] = ends;
        from(v, w) && from(w, v)
    }

    /// Those that HNN-Crust joins to the point.
    fn partners_of(&self, v: u32) -> impl Iterator<Item = u32> + '_ {
        let partners = self.partners[v as usize].into_iter();
        partners.filter(|&w| w != NONE)
    }

    fn distance(&self, v: u32, w: u32) -> f64 {
        let [v, w] = [v, w].map(|id| self.points.points()[id as usize]);
        v.distance(w)
    }
}

/// The edges of the one-step crust at points that are not settled.
pub(super) struct Crust {
    /// Once from every such point, ascending.
    edges: Vec<[u32; 2]>,
}

impl Crust {
    pub(super) fn new(
        points: &PointSet,
        delaunay: &Delaunay,
        is_settled: impl Fn(u32) -> bool,
    ) -> Self {
        let is_left = |v: &u32| !is_settled(*v);
        let wanted = delaunay.edges().filter(|dual| {
            dual.ends.map(u32::from).iter().any(is_left) && is_crust_edge(points, dual)
        });
        let both_ways = wanted.flat_map(|dual| {
            let [v, w] = dual.ends.map(u32::from);
            [[v, w], [w, v]]
        });
        let mut edges: Vec<_> = both_ways.filter(|[from, _]| is_left(from)).collect();
        edges.sort_unstable();
        Self { edges }
    }

    /// Whom it joins to the point; nobody if the point is settled.
    fn of(&self, v: u32) -> impl Iterator<Item = u32> + '_ {
        let first = self.edges.partition_point(|&[from, _]| from < v);
        let at_v = self.edges[first..]
            .iter()
            .take_while(move |[from, _]| *from == v);
        at_v.map(|&[_, to]| to)
    }
}
