//! The penalties of free ends: minus the logarithm of how likely a curve ends, or a point is left
//! alone.

use super::candidates::Candidates;
use super::certificates::Certificates;
use super::constants::{
    AHEAD_COSINE, ASIDE, CONTINUATION_NEIGHBOURS, END, ISOLATED, LAST_END, LEAST_ISOLATED, OUTLIER,
    POSSIBLE_DETOUR, RUN_END, SPARSE, STRAIGHT_COSINE, UNEVEN,
};
use super::hnn_graph::HnnGraph;
use super::measure::Measure;

/// What the free ends of a point cost.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Penalty {
    /// One free end: the point has one edge.
    pub(super) one: f64,
    /// Two free ends: the point is isolated. At most twice as much.
    pub(super) both: f64,
}

/// What the penalties of a point depend on.
pub(super) struct PenaltyModel<'a> {
    pub(super) measure: Measure<'a>,
    pub(super) candidates: &'a Candidates,
    pub(super) hnn: &'a HnnGraph<'a>,
    pub(super) log_spacings: &'a [f64],
    pub(super) certificates: &'a Certificates<'a>,
}

impl PenaltyModel<'_> {
    /// The penalties of every point; 0 at points that certified edges saturate.
    pub(super) fn penalties(&self) -> Vec<Penalty> {
        let points = (0u32..).take(self.log_spacings.len());
        let penalty = |v| {
            if self.certificates.saturate(v) {
                Penalty::default()
            } else {
                let one = self.end(v);
                Penalty {
                    one,
                    both: self.isolated(v).min(2.0 * one),
                }
            }
        };
        points.map(penalty).collect()
    }

    /// The penalty of one free end: less where a run ends, the less the more even it is. If the run
    /// can go on nowhere, it ends here also where HNN-Crust turns aside by an edge that is clearly
    /// longer than those of the run.
    fn end(&self, v: u32) -> f64 {
        let Some(run) = self.hnn.run_ending_at(v) else {
            return END;
        };
        let mut neighbours = self.hnn.neighbours(v);
        let aside = neighbours.find(|&w| w != run.previous);
        let is_short = |w| self.measure.log_length(v, w) < run.mean + ASIDE.ln();
        let least = if self.is_open_ahead(run.previous, v) && !aside.is_some_and(is_short) {
            LAST_END
        } else if aside.is_none() {
            RUN_END
        } else {
            return END;
        };
        END.min(least + UNEVEN * run.deviation)
    }

    /// Whether no point that may become a partner lies ahead.
    fn is_open_ahead(&self, previous: u32, v: u32) -> bool {
        let others = self.candidates.of(v).iter();
        let mut others = others.filter(|&&w| w != previous && !self.certificates.saturate(w));
        !others.any(|&w| self.measure.turns_less(AHEAD_COSINE, previous, v, w))
    }

    /// The penalty of an isolated point: less if no curve continues to it, and if points are
    /// sparser there than around it.
    fn isolated(&self, v: u32) -> f64 {
        let usual = if self.continues_a_neighbour(v) {
            ISOLATED
        } else {
            OUTLIER
        };
        (usual - SPARSE * self.excess_of_spacing(v)).max(LEAST_ISOLATED)
    }

    /// By how much the logarithm of the spacing exceeds the lower quartile of those of the
    /// candidates; 0 if it does not.
    fn excess_of_spacing(&self, v: u32) -> f64 {
        let candidates = self.candidates.of(v).iter();
        let mut around: Vec<f64> = candidates.map(|&w| self.log_spacings[w as usize]).collect();
        around.sort_unstable_by(f64::total_cmp);
        let Some(last) = around.len().checked_sub(1) else {
            return 0.0;
        };
        (self.log_spacings[v as usize] - around[last / 4]).max(0.0)
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
                next.any(|q| self.measure.turns_less(STRAIGHT_COSINE, p, w, q))
            });
            let leads_to_v = |u| self.is_possible(u, w, v);
            !is_passed_straight && (others().next().is_none() || others().any(leads_to_v))
        };
        let mut neighbours = self.candidates.of(v).iter().copied();
        neighbours.any(|w| !self.certificates.saturate(w) && continues_to_v(w))
    }

    /// Whether p, v and q may be consecutive in a rho-sample: the detour |pv| + |vq| - |pq|, which
    /// is twice the shorter edge where the curve turns back, is not too large.
    ///
    /// In a form whose error is relative to the shorter edge.
    fn is_possible(&self, p: u32, v: u32, q: u32) -> bool {
        let (a, b) = (self.measure.vector(v, p), self.measure.vector(v, q));
        let (a_length, b_length) = (a.length(), b.length());
        let around = a_length + b_length + a.distance(b);
        let detour = 2.0 * (a_length * b_length + a.dot(b)) / around;
        detour <= POSSIBLE_DETOUR * a_length.min(b_length)
    }
}
