//! Whether a condition holds on the interval between two dense points, and by how much.

use std::ops::Range;

use curvecrust_geometry::DVec2;
use curvecrust_medial_axis::MeasuredCurve;

use crate::condition::{Bound, Condition};

/// The dense points of one component as a line of positions: a closed one is run through twice, so
/// that every interval, over the seam too, is a range.
#[derive(Debug)]
pub(crate) struct Unrolled {
    points: Vec<DVec2>,
    lfs: Vec<f64>,
    /// Length of the dense polygon up to each position.
    along: Vec<f64>,
}

/// How far an interval is from violating its condition. Nothing holds with a slack of 0 or less.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Slack {
    /// The smallest length by which a dense point inside is within its bound; infinite if none is.
    pub(crate) bound: f64,
    /// The smallest length by which a dense point inside is within the Hausdorff limit.
    pub(crate) limit: f64,
    /// The largest distance of a dense point inside to the first sample.
    farthest: f64,
}

impl Slack {
    pub(crate) fn holds(self) -> bool {
        self.bound > 0.0 && self.limit > 0.0
    }
}

impl Unrolled {
    pub(crate) fn new(measured: &MeasuredCurve, range: Range<usize>, closed: bool) -> Self {
        let rounds = if closed { 2 } else { 1 };
        let points = measured.dense().points()[range.clone()].repeat(rounds);
        let lfs = measured.lfs().values()[range].repeat(rounds);
        let mut along = Vec::with_capacity(points.len());
        let mut length = 0.0;
        for (i, p) in points.iter().enumerate() {
            length += p.distance(points[i.saturating_sub(1)]);
            along.push(length);
        }
        Self { points, lfs, along }
    }

    /// The slack of the interval from position `from` to position `to`, at the dense points inside.
    pub(crate) fn slack(&self, condition: Condition, from: usize, to: usize) -> Slack {
        let (s0, s1) = (self.points[from], self.points[to]);
        let inside = from + 1..to;
        let bound = match condition.bound() {
            Bound::Epsilon(epsilon) => inside
                .clone()
                .map(|j| {
                    let p = self.points[j];
                    epsilon * self.lfs[j] - p.distance(s0).min(p.distance(s1))
                })
                .fold(f64::INFINITY, f64::min),
            Bound::Rho(rho) => {
                // The authors' form: a dense point stands for the curve up to its neighbours.
                let allowed = rho * self.reach(from, to);
                let nearest = |j: usize| {
                    let (before, after) = (self.points[j - 1], self.points[j + 1]);
                    after.distance(s0).min(before.distance(s1))
                };
                allowed
                    - inside
                        .clone()
                        .map(nearest)
                        .fold(f64::NEG_INFINITY, f64::max)
            }
        };
        let mut slack = Slack {
            bound,
            limit: f64::INFINITY,
            farthest: 0.0,
        };
        if let Some(limit) = condition.hausdorff_limit() {
            let across = (s1 - s0).normalize_or_zero();
            for j in inside {
                let offset = self.points[j] - s0;
                slack.limit = slack.limit.min(limit - across.perp_dot(offset).abs());
                slack.farthest = slack.farthest.max(offset.length());
            }
        }
        slack
    }

    /// The first position after `to` at which the interval from `from` might fail, given its slack
    /// up to `to`; at most `end`.
    ///
    /// By the triangle inequality: while the second sample moves along by some length, no distance
    /// changes by more.
    pub(crate) fn next_uncertain(
        &self,
        condition: Condition,
        from: usize,
        to: usize,
        slack: Slack,
        end: usize,
    ) -> usize {
        // What rounding could add to any of the lengths below.
        const SAFE: f64 = 1.0 - 1e-9;
        let chord = self.points[from].distance(self.points[to]);
        let reach = self.reach(from, to);
        let mut nearby = self.lfs[to];
        for next in to + 1..end {
            let moved = self.along[next] - self.along[to];
            let bound_holds = match condition.bound() {
                Bound::Epsilon(epsilon) => {
                    let certain = moved < SAFE * slack.bound.min(epsilon * nearby);
                    nearby = nearby.min(self.lfs[next]);
                    certain
                }
                Bound::Rho(rho) => {
                    nearby = nearby.min(self.lfs[next]);
                    let lost = rho * (reach - reach.min(nearby));
                    let beside = self.along[next] - self.along[to - 1];
                    moved + if lost > 0.0 { lost } else { 0.0 } < SAFE * slack.bound
                        && beside < SAFE * rho * reach.min(nearby)
                }
            };
            let limit_holds = condition.hausdorff_limit().is_none_or(|limit| {
                // The line turns around the first sample by a sine of at most moved / (chord -
                // moved).
                moved < SAFE * limit
                    && slack.farthest * moved < SAFE * slack.limit * (chord - moved)
            });
            if !(bound_holds && limit_holds) {
                return next;
            }
        }
        end
    }

    fn reach(&self, from: usize, to: usize) -> f64 {
        self.lfs[from..=to]
            .iter()
            .copied()
            .fold(f64::INFINITY, f64::min)
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "a test may panic")]

    use super::*;

    /// Points 1 / 64 apart on a line.
    fn line(lfs: impl Fn(usize) -> f64) -> Unrolled {
        let along: Vec<f64> = (0..200u8).map(|i| f64::from(i) / 64.0).collect();
        Unrolled {
            points: along.iter().map(|&x| DVec2::new(x, 0.0)).collect(),
            lfs: (0..200).map(lfs).collect(),
            along,
        }
    }

    /// How far looking ahead gets, in closed form. Less would change no result, only the time.
    #[test]
    fn as_many_points_are_skipped_as_the_slack_allows() {
        let (epsilon, rho) = (
            Condition::epsilon(0.5).unwrap(),
            Condition::rho(0.5).unwrap(),
        );
        let limited = epsilon.with_hausdorff_limit(1.0 / 16.0).unwrap();
        let skips = |track: &Unrolled, condition, to| {
            let slack = track.slack(condition, 0, to);
            assert_eq!(
                track.next_uncertain(condition, 0, to, slack, to + 2),
                to + 2
            );
            track.next_uncertain(condition, 0, to, slack, 200) - to
        };
        let even = line(|_| 1.0);
        // In steps m of 1 / 64. Up to the eighth point: m < 32 - 4, m < 32 - 5, and 7 m < 4 (8 -
        // m).
        let found = [epsilon, rho, limited].map(|c| skips(&even, c, 8));
        assert_eq!(found, [28, 27, 3]);
        // With none inside: m < 32 and m + 1 < 32.
        assert_eq!([epsilon, rho].map(|c| skips(&even, c, 1)), [32, 31]);
        // With an lfs of 2 - i / 128: 2 m < 0.5 (256 - 8 - (m - 1)), and 2 m + 0.5 m < 0.5 (256 -
        // 8) - 10.
        let falling = line(|i| 2.0 - i as f64 / 128.0);
        assert_eq!([epsilon, rho].map(|c| skips(&falling, c, 8)), [50, 46]);
    }
}
