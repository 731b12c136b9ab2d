//! The penalties of free ends: a multiple of the expected length of an edge.

use curvecrust_geometry::{DVec2, PointSet};

use super::candidates::Candidates;
use super::certificates::{CrustGraph, HnnGraph};
use super::constants::{
    AHEAD_COSINE, CONTINUATION_NEIGHBOURS, EVEN_RATIO, PENALTY, RUN_EDGES, RUN_PENALTY,
    SPACING_NEIGHBOURS, STRAIGHT_COSINE, TRUSTED_DETOUR, UNEVEN_RATIO,
};
use super::matching::{Matching, Penalty};
use crate::detour::detour;

/// What the penalties of a point depend on.
pub(super) struct PenaltyModel<'a> {
    pub(super) points: &'a PointSet,
    pub(super) candidates: &'a Candidates,
    pub(super) hnn: &'a HnnGraph<'a>,
    pub(super) crust: &'a CrustGraph,
    /// The certified edges.
    pub(super) matching: &'a Matching<'a>,
}

/// Consecutive edges of HNN-Crust that end at a point.
struct Run {
    /// The last point before it.
    previous: u32,
    /// The mean length of the edges, or the length of the last one if it is longer.
    spacing: f64,
}

impl PenaltyModel<'_> {
    /// The penalties of every point; 0 at points that certified edges saturate.
    pub(super) fn penalties(&self) -> Vec<Penalty> {
        let penalty = |v| {
            if self.matching.is_saturated(v) {
                Penalty::default()
            } else {
                self.penalty(v)
            }
        };
        (0u32..).take(self.points.len()).map(penalty).collect()
    }

    /// The expected length of an edge is the longest of the spacings of the two closest candidates
    /// and of the trusted edges at the point. The penalty of a free end is [`PENALTY`] times that,
    /// or times the distance to the nearest neighbour if that is longer. At the end of an even run
    /// it is at most [`RUN_PENALTY`] times the spacing of the run. Two free ends cost twice as
    /// much, but no more than one at a point that continues no neighbour.
    fn penalty(&self, v: u32) -> Penalty {
        let closest = self.candidates.of(v).iter().take(SPACING_NEIGHBOURS);
        let around = closest.map(|&w| self.spacing(w)).fold(0.0, f64::max);
        let expected = around.max(self.longest_trusted(v));
        let usual = PENALTY * expected.max(self.to_nearest(v));
        let both = if self.continues_a_neighbour(v) {
            usual.max(2.0 * PENALTY * expected)
        } else {
            usual
        };
        let one = self
            .run_ending_at(v)
            .map_or(usual, |run| usual.min(RUN_PENALTY * run.spacing));
        Penalty {
            one,
            both: both.min(2.0 * one),
        }
    }

    /// The length of an edge at a point as far as the point alone shows it: the distance to its
    /// nearest neighbour, or its longest trusted edge.
    fn spacing(&self, v: u32) -> f64 {
        self.to_nearest(v).max(self.longest_trusted(v))
    }

    fn to_nearest(&self, v: u32) -> f64 {
        let nearest = self.candidates.of(v).first();
        nearest.map_or(0.0, |&w| self.distance(v, w))
    }

    /// The length of the longest trusted edge at a point; 0 if there is none. HNN-Crust finds a
    /// trusted edge, or the one-step crust between points that are not saturated; and it continues
    /// at both ends, by edges of the same graph, with turns of a rho-sample.
    fn longest_trusted(&self, v: u32) -> f64 {
        let by_hnn = self.longest_continuing(v, |v| self.hnn.neighbours(v));
        by_hnn.max(self.longest_continuing(v, |v| self.crust.neighbours(v)))
    }

    fn longest_continuing<N: Iterator<Item = u32>>(
        &self,
        v: u32,
        neighbours: impl Fn(u32) -> N + Copy,
    ) -> f64 {
        let edges = neighbours(v).filter(|&w| {
            self.hnn
                .continues_at_both_ends([v, w], neighbours, may_be_consecutive)
        });
        edges.map(|w| self.distance(v, w)).fold(0.0, f64::max)
    }

    /// The even run that ends at a point: it is the only one that leads there, no point that may
    /// become a partner lies ahead, and no trusted edge is much longer.
    fn run_ending_at(&self, v: u32) -> Option<Run> {
        let mut runs = self.hnn.neighbours(v).filter_map(|w| self.run(v, w));
        let run = runs.next().filter(|_| runs.next().is_none())?;
        let others = self.candidates.of(v).iter();
        let mut others = others.filter(|&&w| w != run.previous && !self.matching.is_saturated(w));
        let continues = others.any(|&w| self.turns_less(AHEAD_COSINE, run.previous, v, w));
        let is_uneven = self.longest_trusted(v) > UNEVEN_RATIO * run.spacing;
        (!continues && !is_uneven).then_some(run)
    }

    /// The even run whose last edge leads from `previous` to `v`.
    fn run(&self, v: u32, previous: u32) -> Option<Run> {
        let [mut to, mut at] = [v, previous];
        let last = self.distance(v, previous);
        let (mut least, mut most, mut sum) = (last, last, last);
        for _ in 1..RUN_EDGES {
            let from = self.hnn.neighbours(at).find(|&w| w != to)?;
            if !self.turns_less(AHEAD_COSINE, to, at, from) {
                return None;
            }
            [to, at] = [at, from];
            let length = self.distance(to, at);
            least = least.min(length);
            most = most.max(length);
            sum += length;
        }
        let spacing = last.max(sum / RUN_EDGES as f64);
        (most <= EVEN_RATIO * least).then_some(Run { previous, spacing })
    }

    /// Whether the curve through some neighbour may continue to this point. The neighbour is a
    /// candidate that is not saturated; its three closest other candidates have no pair between
    /// which a curve goes straight on; and from one of them the turn to this point is possible, or
    /// there are no others.
    fn continues_a_neighbour(&self, v: u32) -> bool {
        let continues_to_v = |w: u32| {
            let others = || {
                let others = self.candidates.of(w).iter().copied();
                others.filter(|&u| u != v).take(CONTINUATION_NEIGHBOURS)
            };
            let is_passed_straight = others().any(|p| {
                let mut next = others().filter(|&q| q != p);
                next.any(|q| self.turns_less(STRAIGHT_COSINE, p, w, q))
            });
            let leads_to_v = |u| may_be_consecutive(self.vector(w, u), self.vector(w, v));
            !is_passed_straight && (others().next().is_none() || others().any(leads_to_v))
        };
        let mut neighbours = self.candidates.of(v).iter().copied();
        neighbours.any(|w| !self.matching.is_saturated(w) && continues_to_v(w))
    }

    /// Whether the path p, v, q turns by no more than the angle with this cosine.
    fn turns_less(&self, cosine: f64, p: u32, v: u32, q: u32) -> bool {
        let (a, b) = (self.vector(p, v), self.vector(v, q));
        a.dot(b) >= cosine * a.length() * b.length()
    }

    fn vector(&self, v: u32, w: u32) -> DVec2 {
        let [v, w] = [v, w].map(|id| self.points.points()[id as usize]);
        w - v
    }

    fn distance(&self, v: u32, w: u32) -> f64 {
        self.vector(v, w).length()
    }
}

/// Whether two edges with these vectors from their common point may be consecutive in a rho-sample.
fn may_be_consecutive(a: DVec2, b: DVec2) -> bool {
    detour(DVec2::ZERO, a, b) <= TRUSTED_DETOUR * a.length().min(b.length())
}
