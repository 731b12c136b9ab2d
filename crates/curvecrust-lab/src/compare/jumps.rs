//! Random samplings under a condition: how far a step may go from each dense point, found once for
//! all trials.
//!
//! The conditions of SGP 2016 (Definitions 1 and 3), here for bounds of any size: above 1 they bear
//! no theorem, which is why the library does not offer them. Each dense point stands for the curve
//! up to half of the gap to its neighbours, by which its distance may be larger and its local
//! feature size smaller.

use super::true_curves::Part;
use curvecrust::DVec2;
use curvecrust::geometry::Random;

/// A bound of a sampling condition.
#[derive(Clone, Copy, Debug)]
pub(super) enum Bound {
    Epsilon(f64),
    Rho(f64),
}

/// The longest steps along a part.
pub(super) struct Jumps {
    points: Vec<DVec2>,
    /// The least local feature size of the curve that each point stands for.
    lfs: Vec<f64>,
    /// Half of the larger gap beside each point.
    half_gap: Vec<f64>,
    bound: Bound,
    closed: bool,
    /// How many points on the farthest next sample is.
    longest: Vec<usize>,
}

impl Jumps {
    pub(super) fn new(part: &Part, bound: Bound) -> Self {
        let n = part.points.len();
        let gap = |i: usize| {
            let next = if i + 1 < n {
                i + 1
            } else if part.closed {
                0
            } else {
                i
            };
            part.points[i].distance(part.points[next])
        };
        let before = |i: usize| {
            if i > 0 {
                gap(i - 1)
            } else if part.closed {
                gap(n - 1)
            } else {
                0.0
            }
        };
        let half_gap: Vec<f64> = (0..n).map(|i| gap(i).max(before(i)) / 2.0).collect();
        let mut jumps = Self {
            points: part.points.clone(),
            lfs: part
                .lfs
                .iter()
                .zip(&half_gap)
                .map(|(lfs, h)| lfs - h)
                .collect(),
            half_gap,
            bound,
            closed: part.closed,
            longest: Vec::new(),
        };
        let mut guess = 1;
        for i in 0..n {
            guess = jumps.longest_from(i, guess);
            jumps.longest.push(guess);
        }
        jumps
    }

    /// No farther than a third of a closed part, so that its samples form a polygon, or the end of
    /// an open one.
    fn most(&self, from: usize) -> usize {
        let n = self.points.len();
        if self.closed {
            (n / 3).max(1)
        } else {
            n - 1 - from
        }
    }

    /// By doubling away from a guess, then halving.
    fn longest_from(&self, from: usize, guess: usize) -> usize {
        let most = self.most(from);
        let guess = guess.clamp(1, most.max(1));
        let mut stride = 1;
        let (mut good, mut bad);
        if guess == 1 || self.holds(from, guess) {
            good = guess;
            while good + stride <= most && self.holds(from, good + stride) {
                good += stride;
                stride *= 2;
            }
            bad = (good + stride).min(most + 1);
        } else {
            bad = guess;
            while bad > stride + 1 && !self.holds(from, bad - stride) {
                bad -= stride;
                stride *= 2;
            }
            good = bad.saturating_sub(stride).max(1);
        }
        while bad > good + 1 {
            let middle = usize::midpoint(good, bad);
            if self.holds(from, middle) {
                good = middle;
            } else {
                bad = middle;
            }
        }
        good
    }

    /// Whether the condition holds between a point and the one `step` further on.
    fn holds(&self, from: usize, step: usize) -> bool {
        let n = self.points.len();
        let (s0, s1) = (self.points[from], self.points[(from + step) % n]);
        let nearest = |k: usize| {
            let p = self.points[k];
            p.distance_squared(s0).min(p.distance_squared(s1)).sqrt() + self.half_gap[k]
        };
        let mut inside = (from + 1..from + step).map(|k| k % n);
        match self.bound {
            Bound::Epsilon(epsilon) => inside.all(|k| nearest(k) < epsilon * self.lfs[k]),
            Bound::Rho(rho) => {
                let (mut farthest, mut reach) =
                    (0.0f64, self.lfs[from].min(self.lfs[(from + step) % n]));
                inside.all(|k| {
                    farthest = farthest.max(nearest(k));
                    reach = reach.min(self.lfs[k]);
                    farthest < rho * reach
                })
            }
        }
    }

    /// Samples from a random start; each step is a random share, at least `thinning`, of the
    /// longest.
    pub(super) fn sample(&self, thinning: f64, random: &mut Random) -> Vec<DVec2> {
        let n = self.points.len();
        let start = if self.closed { random.below(n) } else { 0 };
        let end = if self.closed { n } else { n - 1 };
        let mut samples = vec![self.points[start]];
        let mut at = 0;
        loop {
            let from = (start + at) % n;
            let longest = self.longest[from];
            // The way back to the start is a step like others.
            let left = end - at;
            if left <= longest && (left == longest || self.holds(from, left)) {
                break;
            }
            let longest = longest.min(left - 1).max(1);
            let step = share(longest, random.between(thinning, 1.0));
            let step = if self.holds(from, step) {
                step
            } else {
                self.longest[from].min(longest)
            };
            at += step;
            samples.push(self.points[(start + at) % n]);
            if at >= end {
                break;
            }
        }
        if !self.closed {
            samples.push(self.points[n - 1]);
        }
        samples.dedup();
        samples
    }
}

/// A share of a count, at least 1.
#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "between 0 and the count"
)]
fn share(count: usize, share: f64) -> usize {
    ((count as f64 * share).round() as usize).clamp(1, count)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::compare::true_curves::{Named, TrueCurves};

    #[test]
    fn the_longest_steps_hold_and_longer_ones_do_not() {
        let curves = TrueCurves::named(&Named::Fixture("teaser".to_owned())).unwrap();
        for bound in [Bound::Epsilon(0.3), Bound::Rho(0.9), Bound::Rho(1.8)] {
            let jumps = Jumps::new(&curves.parts[0], bound);
            for (from, &longest) in jumps.longest.iter().enumerate().step_by(37) {
                assert!(longest == 1 || jumps.holds(from, longest));
                assert!(longest == jumps.most(from) || !jumps.holds(from, longest + 1));
            }
        }
    }

    #[test]
    fn samplings_satisfy_their_condition() {
        for name in ["teaser", "wave", "fish"] {
            let curves = TrueCurves::named(&Named::Fixture(name.to_owned())).unwrap();
            for part in &curves.parts {
                let jumps = Jumps::new(part, Bound::Epsilon(0.4));
                for seed in 0..5 {
                    let samples = jumps.sample(0.5, &mut Random::new(seed));
                    let place = |s: &DVec2| part.points.iter().position(|p| p == s).unwrap();
                    let mut places: Vec<usize> = samples.iter().map(place).collect();
                    if part.closed {
                        assert!(samples.len() >= 3);
                        places.push(places[0]);
                    } else {
                        assert_eq!(
                            (places[0], places[places.len() - 1]),
                            (0, part.points.len() - 1)
                        );
                    }
                    let n = part.points.len();
                    for pair in places.windows(2) {
                        assert!(
                            jumps.holds(pair[0], (pair[1] + n - pair[0]) % n),
                            "{name} {pair:?}"
                        );
                    }
                }
            }
        }
    }
}
