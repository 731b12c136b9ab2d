//! What it costs to leave slots of a point open: some multiple of the length of edge that is to be
//! expected there.

use std::f64::consts::FRAC_1_SQRT_2;

use curvecrust_geometry::{DVec2, PointSet};

use super::candidates::Candidates;
use super::certificates::{Certificates, Crust};
use super::joins::{Joins, Price, detour};

/// What an open slot costs, in lengths to be expected.
const OPEN: f64 = 2.25;

/// What it costs where an even run of points stops, in lengths of its edges.
const STOP: f64 = 1.3;

/// How many edges make a run. With turns of less than 45 degrees, all of them turn by less than half a
/// circle: the run does not come back to where it began.
const RUN: usize = 5;

/// How many times as long as another edge one of an even run may be.
const EVEN: f64 = 2.0;

/// How many times as long as its spacing a trusted edge at the end of a run may be. A longer one says
/// that the samples are uneven, and the run no hint of what follows.
const UNEVEN: f64 = 3.0;

/// The cosine of the turn up to which a point lies ahead: 45 degrees.
const AHEAD: f64 = FRAC_1_SQRT_2;

/// The cosine of the turn up to which points go straight on: 25.8 degrees.
const STRAIGHT_ON: f64 = 0.9;

/// The largest detour between trusted edges, in lengths of the shorter one. Consecutive edges of
/// equal length of a rho-sample turn by 4 asin(rho / 2) at most (SGP 2016, Lemma 8): for rho < 0.9
/// by 107 degrees, a detour of 0.81.
const TRUSTED: f64 = 0.82;

/// What the prices of a point depend on.
pub(super) struct Surroundings<'a> {
    pub(super) points: &'a PointSet,
    pub(super) candidates: &'a Candidates,
    pub(super) hnn: &'a Certificates<'a>,
    pub(super) crust: &'a Crust,
    /// Those that are certified.
    pub(super) joins: &'a Joins<'a>,
}

/// Edges of HNN-Crust, one after another, that lead to a point.
struct Run {
    /// The last point before it.
    behind: u32,
    /// The mean length of the edges, or the last if it is longer.
    spacing: f64,
}

impl Surroundings<'_> {
    /// Of every point; nothing for those that are settled.
    pub(super) fn prices(&self) -> Vec<Price> {
        let price = |v| {
            if self.joins.is_settled(v) {
                Price::default()
            } else {
                self.price(v)
            }
        };
        (0u32..).take(self.points.len()).map(price).collect()
    }

    /// The length to be expected is the longest of the spacings of the two closest candidates and of
    /// the trusted edges at the point. A slot costs [`OPEN`] times as much, or as the distance to the
    /// nearest neighbour if that is longer; where an even run stops, [`STOP`] times the spacing of the
    /// run. Both slots cost twice as much, but no more than one at a point that nobody wants.
    fn price(&self, v: u32) -> Price {
        let closest = self.candidates.of(v).iter().take(2);
        let around = closest.map(|&w| self.spacing(w)).fold(0.0, f64::max);
        let expected = around.max(self.longest_trusted(v));
        let one = OPEN * expected.max(self.to_nearest(v));
        let both = if self.is_wanted(v) {
            one.max(2.0 * OPEN * expected)
        } else {
            one
        };
        let slot = self
            .stopping(v)
            .map_or(one, |run| one.min(STOP * run.spacing));
        Price {
            slot,
            both: both.min(2.0 * slot),
        }
    }

    /// The length of edge to be expected at a point without regard to others: the distance to its
    /// nearest neighbour, or its longest trusted edge.
    fn spacing(&self, v: u32) -> f64 {
        self.to_nearest(v).max(self.longest_trusted(v))
    }

    fn to_nearest(&self, v: u32) -> f64 {
        let nearest = self.candidates.of(v).first();
        nearest.map_or(0.0, |&w| self.distance(v, w))
    }

    /// The length of the longest edge at a point that may be long: HNN-Crust finds it, or the one-step
    /// crust between points that are not settled, and it goes on at both ends, by edges of the same
    /// graph, with turns of a rho-sample; 0 if there is none.
    fn longest_trusted(&self, v: u32) -> f64 {
        let by_hnn = self.longest_going_on(v, |v| self.hnn.partners_of(v));
        by_hnn.max(self.longest_going_on(v, |v| self.crust.of(v)))
    }

    fn longest_going_on<N: Iterator<Item = u32>>(
        &self,
        v: u32,
        neighbours: impl Fn(u32) -> N + Copy,
    ) -> f64 {
        let edges = neighbours(v).filter(|&w| self.hnn.goes_on([v, w], neighbours, may_follow));
        edges.map(|w| self.distance(v, w)).fold(0.0, f64::max)
    }

    /// The even run that stops at a point: it is the only one that leads there, no point that may be
    /// joined lies ahead, and no trusted edge is much longer.
    fn stopping(&self, v: u32) -> Option<Run> {
        let mut runs = self.hnn.partners_of(v).filter_map(|w| self.run(v, w));
        let run = runs.next().filter(|_| runs.next().is_none())?;
        let others = self.candidates.of(v).iter();
        let mut others = others.filter(|&&w| w != run.behind && !self.joins.is_settled(w));
        let goes_on = others.any(|&w| self.turns_less(AHEAD, run.behind, v, w));
        let is_uneven = self.longest_trusted(v) > UNEVEN * run.spacing;
        (!goes_on && !is_uneven).then_some(run)
    }

    /// The even run that leads to a point by way of another.
    fn run(&self, v: u32, behind: u32) -> Option<Run> {
        let [mut to, mut at] = [v, behind];
        let last = self.distance(v, behind);
        let (mut least, mut most, mut sum) = (last, last, last);
        for _ in 1..RUN {
            let from = self.hnn.partners_of(at).find(|&w| w != to)?;
            if !self.turns_less(AHEAD, to, at, from) {
                return None;
            }
            [to, at] = [at, from];
            let length = self.distance(to, at);
            least = least.min(length);
            most = most.max(length);
            sum += length;
        }
        let spacing = last.max(sum / RUN as f64);
        (most <= EVEN * least).then_some(Run { behind, spacing })
    }

    /// Whether some candidate that is not settled would go on to the point: its three closest others
    /// do not go straight on without it, and the edge may follow one to them; or it has no others.
    fn is_wanted(&self, v: u32) -> bool {
        let wants = |w: u32| {
            let others = || {
                let others = self.candidates.of(w).iter().copied();
                others.filter(|&u| u != v).take(3)
            };
            let goes_on = others().any(|p| {
                let mut onward = others().filter(|&q| q != p);
                onward.any(|q| self.turns_less(STRAIGHT_ON, p, w, q))
            });
            let may_follow = |u| may_follow(self.way(w, u), self.way(w, v));
            !goes_on && (others().next().is_none() || others().any(may_follow))
        };
        let mut open = self.candidates.of(v).iter().copied();
        open.any(|w| !self.joins.is_settled(w) && wants(w))
    }

    /// Whether the way from `p` by `v` to `q` turns by no more than the angle with this cosine.
    fn turns_less(&self, cosine: f64, p: u32, v: u32, q: u32) -> bool {
        let (a, b) = (self.way(p, v), self.way(v, q));
        a.dot(b) >= cosine * a.length() * b.length()
    }

    fn way(&self, v: u32, w: u32) -> DVec2 {
        let [v, w] = [v, w].map(|id| self.points.points()[id as usize]);
        w - v
    }

    fn distance(&self, v: u32, w: u32) -> f64 {
        self.way(v, w).length()
    }
}

/// Whether edges that go these ways from a point may be consecutive in a rho-sample.
fn may_follow(a: DVec2, b: DVec2) -> bool {
    detour(DVec2::ZERO, a, b) <= TRUSTED * a.length().min(b.length())
}
