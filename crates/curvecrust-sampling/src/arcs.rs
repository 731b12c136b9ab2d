//! Bounds on the arcs of a curve between its dense points, and whether a condition holds at every
//! point of them.
//!
//! Let p and q be consecutive dense points at distance c, and L the smaller lfs of the two. On the
//! arc between them the radius of curvature is at least lfs, hence at least r = L - 0.55 c, if the
//! arc is at most 1.1 c long. By Schur's theorem it is then no longer than 2 r asin(c / 2 r), which
//! for c < L / 2 is at most c (1 + (c / r)^2 / 16) and below 1.1 c indeed. That the arc is the
//! short one is what dense means: another arc from p to q would leave the disc about p of radius
//! lfs. From the length l of an arc follows where it can be: at most sqrt(l^2 - c^2) / 2 from its
//! chord; and since lfs is 1-Lipschitz, how small lfs can be on it: (lfs(p) + lfs(q) - l) / 2.
//!
//! Arcs over 2^k gaps carry the same two bounds, of lfs and of the sagitta: the largest distance
//! from the chord. So an interval is decided from few of them. The distance to a point or to a
//! segment is convex: along a chord it is largest at an end. Cost: O(n) to build, O(log n) for most
//! questions.

use curvecrust_geometry::{Component, DVec2, Segment};
use curvecrust_medial_axis::MeasuredCurve;

use crate::condition::{Bound, Condition, DeviationLimit};

/// What rounding could take from any of the lengths that are compared.
const SAFE: f64 = 1.0 - 1e-9;

/// The arcs between the dense points of one component, by position: that of its first point is 0.
///
/// Positions of a closed component go on behind its last point, for a second round.
#[derive(Debug)]
pub(crate) struct Arcs<'a> {
    /// The dense points.
    pub(crate) component: Component,
    points: &'a [DVec2],
    lfs: &'a [f64],
    /// Level k holds the arcs over 2^k gaps that start at multiples of 2^k.
    levels: Vec<Vec<Arc>>,
}

/// What is known of every point of the curve along one or more gaps in a row.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Arc {
    /// A lower bound of lfs.
    pub(crate) lfs: f64,
    /// An upper bound of the distance to the chord.
    pub(crate) sagitta: f64,
}

impl Arc {
    /// Two arcs, one after the other, from `start` over `middle` to `end`.
    fn joined(self, next: Self, [start, middle, end]: [DVec2; 3]) -> Self {
        Self {
            lfs: self.lfs.min(next.lfs),
            sagitta: self.sagitta.max(next.sagitta) + Segment::new(start, end).distance(middle),
        }
    }
}

/// An upper bound of the length of the curve between dense points at distance `chord`, the smaller
/// lfs of which is `lfs`; infinite if they are too far apart to tell.
fn arc_length(chord: f64, lfs: f64) -> f64 {
    if chord < lfs / 2.0 {
        let turn = chord / (lfs - 0.55 * chord);
        chord * (1.0 + turn * turn / 16.0)
    } else {
        f64::INFINITY
    }
}

impl<'a> Arcs<'a> {
    /// Those of every component.
    pub(crate) fn of(measured: &'a MeasuredCurve) -> Vec<Self> {
        let components = measured.dense().components();
        components.iter().map(|c| Self::new(measured, c)).collect()
    }

    fn new(measured: &'a MeasuredCurve, component: &Component) -> Self {
        let mut arcs = Self {
            points: &measured.dense().points()[component.range.clone()],
            lfs: &measured.lfs().values()[component.range.clone()],
            component: component.clone(),
            levels: Vec::new(),
        };
        let mut level: Vec<Arc> = (0..arcs.len()).map(|i| arcs.bounds(i)).collect();
        let mut width = 1;
        while level.len() > 1 {
            let joined = level.chunks_exact(2).enumerate().map(|(i, pair)| {
                let start = 2 * i * width;
                let stops = [start, start + width, start + 2 * width];
                pair[0].joined(pair[1], stops.map(|at| arcs.point(at)))
            });
            let joined = joined.collect();
            arcs.levels.push(std::mem::replace(&mut level, joined));
            width *= 2;
        }
        arcs.levels.push(level);
        arcs
    }

    /// The number of gaps: positions from 0 to this make up the component.
    pub(crate) fn len(&self) -> usize {
        self.component.pair_count()
    }

    pub(crate) fn point(&self, at: usize) -> DVec2 {
        self.points[self.in_first_round(at)]
    }

    pub(crate) fn lfs(&self, at: usize) -> f64 {
        self.lfs[self.in_first_round(at)]
    }

    fn in_first_round(&self, at: usize) -> usize {
        let count = self.points.len();
        if at < count { at } else { at % count }
    }

    /// An upper bound of the length of the curve in the gap after a position.
    pub(crate) fn length(&self, at: usize) -> f64 {
        // Between two points of a closed curve there are two gaps, and no telling which is short.
        if self.component.closed && self.points.len() < 3 {
            return f64::INFINITY;
        }
        let chord = self.point(at).distance(self.point(at + 1));
        arc_length(chord, self.lfs(at).min(self.lfs(at + 1)))
    }

    /// What is known of the gap after a position.
    pub(crate) fn arc(&self, at: usize) -> Arc {
        let count = self.len();
        self.levels[0][if at < count { at } else { at % count }]
    }

    fn bounds(&self, at: usize) -> Arc {
        let length = self.length(at);
        if length == f64::INFINITY {
            return Arc {
                lfs: f64::NEG_INFINITY,
                sagitta: f64::INFINITY,
            };
        }
        let (before, after) = (self.lfs(at), self.lfs(at + 1));
        let chord = self.point(at).distance(self.point(at + 1));
        Arc {
            lfs: before.min(after).min((before + after - length) / 2.0),
            sagitta: ((length - chord) * (length + chord)).max(0.0).sqrt() / 2.0,
        }
    }

    /// Whether the condition holds at every point of the curve from one position to a later one, no
    /// more than a round ahead, when these two are consecutive samples.
    pub(crate) fn holds(&self, condition: Condition, from: usize, to: usize) -> bool {
        let interval = Interval {
            condition,
            ends: [self.point(from), self.point(to)],
            reach: match condition.bound() {
                Bound::Epsilon(_) => 0.0,
                Bound::Rho(_) => self.least_lfs(from, to),
            },
        };
        let of_arc = |arc, ends| interval.holds_on(arc, ends);
        let of_gap = |at| interval.holds_where_the_nearer_changes(self, at);
        self.stretches(from, to)
            .into_iter()
            .all(|(start, end)| self.all_along(start, end, of_arc, of_gap))
    }

    /// Whether the curve from one position to a later one stays within a limit of the chord.
    pub(crate) fn keeps(&self, limit: DeviationLimit, from: usize, to: usize) -> bool {
        let chord = Segment::new(self.point(from), self.point(to));
        let keeps = |arc: Arc, ends| match limit {
            DeviationLimit::None => true,
            DeviationLimit::Length(limit) => within(limit, chord, arc, ends),
            DeviationLimit::OfLfs(fraction) => within(fraction * arc.lfs, chord, arc, ends),
        };
        let stretches = self.stretches(from, to).into_iter();
        stretches
            .into_iter()
            .all(|(start, end)| self.all_along(start, end, keeps, |_| false))
    }

    /// The last position, at most `end`, up to which the condition holds from `from` on; `None` if
    /// it does not even hold up to the next. Looks near a `guess` first.
    ///
    /// With a Hausdorff limit, whether an interval holds may change more than once as it grows:
    /// the result then holds, and either ends at the last point or fails when one point longer.
    pub(crate) fn farthest(
        &self,
        condition: Condition,
        from: usize,
        guess: usize,
        end: usize,
    ) -> Option<usize> {
        farthest(from + 1, guess, end, |to| self.holds(condition, from, to))
    }

    /// A lower bound of the reach.
    fn least_lfs(&self, from: usize, to: usize) -> f64 {
        let mut least = f64::INFINITY;
        for (mut at, end) in self.stretches(from, to) {
            while at < end {
                let level = widest(at, end);
                least = least.min(self.levels[level][at >> level].lfs);
                at += 1 << level;
            }
        }
        least
    }

    /// Whether something holds all along the curve between two positions of one round: it is asked
    /// of long arcs first, given with their ends, and of single gaps, by their position, at last.
    fn all_along(
        &self,
        start: usize,
        end: usize,
        of_arc: impl Fn(Arc, [DVec2; 2]) -> bool,
        of_gap: impl Fn(usize) -> bool,
    ) -> bool {
        let mut at = start;
        while at < end {
            let mut level = widest(at, end);
            loop {
                let width = 1 << level;
                let ends = [self.point(at), self.point(at + width)];
                if of_arc(self.levels[level][at >> level], ends) || (level == 0 && of_gap(at)) {
                    at += width;
                    break;
                }
                if level == 0 {
                    return false;
                }
                level -= 1;
            }
        }
        true
    }

    /// The gaps between two positions, in one round.
    fn stretches(&self, from: usize, to: usize) -> [(usize, usize); 2] {
        let len = self.len();
        if from >= len {
            [(from - len, to - len), (0, 0)]
        } else if to > len {
            [(from, len), (0, to - len)]
        } else {
            [(from, to), (0, 0)]
        }
    }
}

/// The last position from `first` to `end` that holds, or one that does and the next does not;
/// `None` if not even the first does. Looks near a `guess` first.
pub(crate) fn farthest(
    first: usize,
    guess: usize,
    end: usize,
    holds: impl Fn(usize) -> bool,
) -> Option<usize> {
    let guess = guess.min(end).max(first);
    let mut step = 1;
    let (mut good, mut bad) = if holds(guess) {
        let mut good = guess;
        loop {
            if good >= end {
                return Some(end);
            }
            let next = (good + step).min(end);
            if !holds(next) {
                break (good, next);
            }
            good = next;
            step *= 2;
        }
    } else {
        let mut bad = guess;
        loop {
            if bad == first {
                return None;
            }
            let next = bad.saturating_sub(step).max(first);
            if holds(next) {
                break (next, bad);
            }
            bad = next;
            step *= 2;
        }
    };
    while bad - good > 1 {
        let middle = good.midpoint(bad);
        if holds(middle) {
            good = middle;
        } else {
            bad = middle;
        }
    }
    Some(good)
}

/// The level of the longest arc that starts at `at` and ends at `end` or before.
fn widest(at: usize, end: usize) -> usize {
    at.trailing_zeros().min((end - at).ilog2()) as usize
}

/// The curve between two consecutive samples, and what is asked of it.
struct Interval {
    condition: Condition,
    ends: [DVec2; 2],
    reach: f64,
}

impl Interval {
    /// How far every point of an arc may be from the nearer sample.
    fn allowed(&self, arc: Arc) -> f64 {
        SAFE * match self.condition.bound() {
            Bound::Epsilon(epsilon) => epsilon * arc.lfs,
            Bound::Rho(rho) => rho * self.reach,
        }
    }

    /// Whether the condition holds along an arc, if one sample is the nearer one all along it.
    fn holds_on(&self, arc: Arc, [start, end]: [DVec2; 2]) -> bool {
        let allowed = self.allowed(arc) - arc.sagitta;
        let squared = allowed * allowed;
        let near =
            |s: DVec2| s.distance_squared(start) < squared && s.distance_squared(end) < squared;
        allowed > 0.0
            && (near(self.ends[0]) || near(self.ends[1]))
            && self.keeps_limit(arc, [start, end])
    }

    /// Whether the condition holds along a gap, whichever sample is nearer to its points: the
    /// distance to the nearer one grows from either end by no more than the length of the arc.
    fn holds_where_the_nearer_changes(&self, arcs: &Arcs, at: usize) -> bool {
        let [start, end] = [arcs.point(at), arcs.point(at + 1)];
        let nearer = |p: DVec2| p.distance(self.ends[0]).min(p.distance(self.ends[1]));
        let farthest = (nearer(start) + nearer(end) + arcs.length(at)) / 2.0;
        let arc = arcs.arc(at);
        farthest < self.allowed(arc) && self.keeps_limit(arc, [start, end])
    }

    fn keeps_limit(&self, arc: Arc, ends: [DVec2; 2]) -> bool {
        let chord = Segment::new(self.ends[0], self.ends[1]);
        let limit = self.condition.hausdorff_limit();
        limit.is_none_or(|limit| within(limit, chord, arc, ends))
    }
}

/// Whether an arc is within a limit of a chord.
fn within(limit: f64, chord: Segment, arc: Arc, ends: [DVec2; 2]) -> bool {
    let allowed = SAFE * limit - arc.sagitta;
    let squared = allowed * allowed;
    allowed > 0.0
        && ends
            .into_iter()
            .all(|p| chord.distance_squared(p) < squared)
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "a test may panic")]

    use super::*;

    /// A length that attains what is allowed does not hold, the next smaller double does.
    #[test]
    fn bounds_are_strict() {
        let arc = Arc {
            lfs: 1.0,
            sagitta: 0.0,
        };
        let attained = DVec2::new(0.0, SAFE * 0.5);
        let nearer = DVec2::new(0.0, attained.y.next_down());
        let chord = Segment::new(DVec2::ZERO, DVec2::X);
        for (ends, holds) in [([attained, nearer], false), ([nearer, nearer], true)] {
            assert_eq!(within(0.5, chord, arc, ends), holds);
            let [start, end] = ends;
            assert_eq!(within(0.5, chord, arc, [end, start]), holds);
            for condition in [
                Condition::epsilon(0.5).unwrap(),
                Condition::rho(0.5).unwrap(),
            ] {
                let interval = Interval {
                    condition,
                    ends: [DVec2::ZERO, DVec2::splat(9.0)],
                    reach: 1.0,
                };
                assert_eq!(interval.holds_on(arc, [start, end]), holds);
                assert_eq!(interval.holds_on(arc, [end, start]), holds);
            }
        }
    }
}
