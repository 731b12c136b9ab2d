//! How good samples are: the smallest epsilon, or rho, for which they satisfy the condition.
//!
//! Which samples count. Epsilon (SGP 2016, Definition 1) asks for the nearest sample of all. Below
//! 1, that is an end of the interval that the point is in: a disc about a curve point p with a
//! radius below lfs(p) meets the curve in one arc. On the way along this arc to any sample in the
//! disc lies an end of the interval, and it is no farther from p (Amenta, Bern, Eppstein 1998).
//! Values from 1 on are those of interval ends.
//!
//! Which points count. Two values enclose the answer. The lower one is the largest value found at
//! dense points, at samples, and where the nearer sample changes. The upper one bounds the value at
//! every point of the curve. lfs is taken as measured.

use std::ops::Range;

use curvecrust_geometry::{DVec2, Segment};
use curvecrust_medial_axis::MeasuredCurve;

use crate::arcs::Arcs;
use crate::condition::{Bound, Condition};
use crate::placed::PlacedSamples;

/// A piece of a component between two consecutive samples.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Interval {
    /// Index of the component.
    pub component: usize,
    /// Indices of the sample before and the one after. `None` before the first and after the last
    /// of an open component; the same twice on a closed component of one sample; none where there
    /// is none.
    pub samples: [Option<usize>; 2],
}

/// What the samples attain on an interval.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Attained {
    /// The interval.
    pub interval: Interval,
    /// The epsilon, or the rho: how far the worst point is from the nearer sample, divided by its
    /// lfs or the reach of the interval. Infinite without a sample.
    pub bound: f64,
    /// No point of the curve there exceeds this, lfs being as measured; infinite where the dense
    /// points are too far apart to tell.
    pub at_most: f64,
    /// The worst point.
    pub at: DVec2,
    /// Index of the dense point at it or before it.
    pub dense: usize,
    /// lfs at the worst point for epsilon, the reach of the interval for rho.
    pub lfs: f64,
    /// The largest distance of the curve to the chord, at dense points.
    pub deviation: f64,
    /// No point of the curve there is farther from the chord.
    pub deviation_at_most: f64,
}

/// The answer of [`check`].
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Verdict {
    /// Every interval that violates the condition, in the order of the curve.
    pub violations: Vec<Attained>,
    /// The interval with the largest bound; `None` for a curve without points.
    pub worst: Option<Attained>,
    /// Whether the condition is certain to hold at every point of the curve, as far as lfs is
    /// right. If it is not, and nothing violates it, a finer discretisation will tell.
    pub certain: bool,
}

impl Verdict {
    /// Whether nothing violates the condition.
    #[must_use]
    pub fn holds(&self) -> bool {
        self.violations.is_empty()
    }
}

/// The smallest epsilon for which samples are an epsilon-sample, with the interval that asks for
/// it; `None` for a curve without points.
///
/// ```
/// use curvecrust_curve::Curve;
/// use curvecrust_geometry::DVec2;
/// use curvecrust_medial_axis::measure;
/// use curvecrust_sampling::{PlacedSamples, effective_epsilon};
///
/// let circle = Curve::from_path_data("M 1 0 A 1 1 0 0 1 -1 0 A 1 1 0 0 1 1 0 Z")?;
/// let measured = measure(&circle)?;
/// let corners = [DVec2::X, DVec2::Y, -DVec2::X, -DVec2::Y];
/// let square = PlacedSamples::project(&measured, &corners, 1e-4)?.samples;
/// // The worst points are 45 degrees from the corners.
/// let worst = effective_epsilon(&measured, &square).unwrap();
/// assert!((worst.bound - 2.0 * 22.5f64.to_radians().sin()).abs() < 1e-4);
/// assert!(worst.bound < worst.at_most && worst.at_most < worst.bound + 0.02);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[must_use]
pub fn effective_epsilon(measured: &MeasuredCurve, samples: &PlacedSamples) -> Option<Attained> {
    attained(&Arcs::of(measured), samples, Bound::Epsilon(1.0))
}

/// The smallest rho for which samples are a rho-sample, with the interval that asks for it; `None`
/// for a curve without points.
#[must_use]
pub fn effective_rho(measured: &MeasuredCurve, samples: &PlacedSamples) -> Option<Attained> {
    attained(&Arcs::of(measured), samples, Bound::Rho(1.0))
}

/// Whether samples satisfy a condition, and every interval on which they do not.
///
/// Samples that were placed on another dense curve may count as none.
#[must_use]
pub fn check(measured: &MeasuredCurve, samples: &PlacedSamples, condition: Condition) -> Verdict {
    let found = intervals(&Arcs::of(measured), samples, condition.bound());
    let bound = condition.bound().value();
    let limit = condition.hausdorff_limit().unwrap_or(f64::INFINITY);
    let limited = condition.hausdorff_limit().is_some();
    let within =
        |bound_found: f64, deviation: f64| bound_found < bound && (!limited || deviation < limit);
    Verdict {
        worst: worst(&found),
        certain: found.iter().all(|a| within(a.at_most, a.deviation_at_most)),
        violations: found
            .into_iter()
            .filter(|a| !within(a.bound, a.deviation))
            .collect(),
    }
}

/// What samples attain; the value of the bound does not matter.
pub(crate) fn attained(all: &[Arcs], samples: &PlacedSamples, kind: Bound) -> Option<Attained> {
    worst(&intervals(all, samples, kind))
}

/// The first of the intervals with the largest bound.
fn worst(found: &[Attained]) -> Option<Attained> {
    let larger = |a: Attained, b: &Attained| if b.bound > a.bound { *b } else { a };
    let (first, rest) = found.split_first()?;
    Some(rest.iter().fold(*first, larger))
}

/// What samples attain on each interval, in the order of the curve; the value of the bound does not
/// matter.
fn intervals(all: &[Arcs], samples: &PlacedSamples, kind: Bound) -> Vec<Attained> {
    let mut found = Vec::with_capacity(samples.placements().len() + 1);
    for (index, arcs) in all.iter().enumerate() {
        // Samples of another dense curve are none of this one's.
        let here = |range: &Range<usize>| {
            let places = &samples.placements()[range.clone()];
            places
                .iter()
                .all(|p| arcs.component.range.contains(&p.dense))
        };
        let range = samples.components().get(index).cloned().filter(here);
        let range = range.unwrap_or(0..0);
        let place = |sample: usize| {
            let place = samples.placements()[sample];
            (place.dense - arcs.component.range.start, place.t)
        };
        let point = |sample: Option<usize>| sample.map(|i| samples.placements()[i].point);
        let mut measure = |samples: [Option<usize>; 2], from, to| {
            let interval = Interval {
                component: index,
                samples,
            };
            let walk = Walk::new(arcs, kind, samples.map(point));
            let mut attained = walk.attained(interval, from, to);
            attained.dense =
                arcs.component.range.start + attained.dense % arcs.component.range.len();
            found.push(attained);
        };
        let end = (arcs.len(), 0.0);
        let (Some(first), Some(last)) = (range.clone().next(), range.clone().next_back()) else {
            measure([None; 2], (0, 0.0), end);
            continue;
        };
        if !arcs.component.closed && place(first) > (0, 0.0) {
            measure([None, Some(first)], (0, 0.0), place(first));
        }
        for (before, after) in range.clone().zip(range.skip(1)) {
            let (from, to) = (place(before), place(after));
            measure(
                [Some(before), Some(after)],
                from,
                beyond(from, to, arcs.len()),
            );
        }
        if arcs.component.closed {
            let (from, to) = (place(last), place(first));
            measure(
                [Some(last), Some(first)],
                from,
                beyond(from, to, arcs.len()),
            );
        } else {
            measure([Some(last), None], place(last), end);
        }
    }
    found
}

/// A position, and how far along the gap after it.
type Place = (usize, f64);

/// The place in the next round, if it does not come after the other in this one.
fn beyond(from: Place, to: Place, round: usize) -> Place {
    if from < to { to } else { (to.0 + round, to.1) }
}

/// A point on the curve, or nearly.
#[derive(Clone, Copy)]
struct Stop {
    at: DVec2,
    lfs: f64,
    distances: [f64; 2],
}

impl Stop {
    fn nearer(&self) -> f64 {
        self.distances[0].min(self.distances[1])
    }

    /// Where the nearer sample changes between two stops.
    fn change(self, next: Self) -> Option<Self> {
        let by = |stop: Self| stop.distances[0] - stop.distances[1];
        let t = by(self) / (by(self) - by(next));
        let linear = |a: f64, b: f64| a + t * (b - a);
        (t > 0.0 && t < 1.0).then(|| Self {
            at: self.at.lerp(next.at, t),
            lfs: between(self.lfs, next.lfs, t),
            distances: [0, 1].map(|i| linear(self.distances[i], next.distances[i])),
        })
    }
}

/// The walk along an interval that finds the worst of its points.
struct Walk<'a> {
    arcs: &'a Arcs<'a>,
    kind: Bound,
    ends: [Option<DVec2>; 2],
    chord: Option<Segment>,
    /// The worst so far, with the position it is at: by ratio for epsilon, by distance for rho.
    worst: (f64, Stop, usize),
    at_most: f64,
    reach: f64,
    least_lfs: f64,
    deviation: f64,
    sagitta: f64,
}

impl<'a> Walk<'a> {
    fn new(arcs: &'a Arcs<'a>, kind: Bound, ends: [Option<DVec2>; 2]) -> Self {
        let nowhere = Stop {
            at: arcs.point(0),
            lfs: f64::INFINITY,
            distances: [f64::INFINITY; 2],
        };
        Self {
            arcs,
            kind,
            ends,
            chord: ends[0]
                .or(ends[1])
                .map(|a| Segment::new(a, ends[1].unwrap_or(a))),
            worst: (f64::NEG_INFINITY, nowhere, 0),
            at_most: 0.0,
            reach: f64::INFINITY,
            least_lfs: f64::INFINITY,
            deviation: 0.0,
            sagitta: 0.0,
        }
    }

    fn attained(mut self, interval: Interval, from: Place, to: Place) -> Attained {
        let mut last = self.stop(from);
        self.visit(last, from.0);
        let mut gap = from.0;
        while (gap, 0.0) < to {
            let end = if gap == to.0 { to } else { (gap + 1, 0.0) };
            let next = self.stop(end);
            self.visit(next, end.0);
            if let Some(change) = last.change(next) {
                self.visit(change, gap);
            }
            self.enclose(gap, last, next);
            (last, gap) = (next, gap + 1);
        }
        let (worst, stop, dense) = self.worst;
        let (bound, at_most, lfs) = match self.kind {
            Bound::Epsilon(_) => (worst, self.at_most, stop.lfs),
            Bound::Rho(_) => (
                ratio(worst, self.reach),
                ratio(self.at_most, self.least_lfs),
                self.reach,
            ),
        };
        Attained {
            interval,
            bound,
            at_most: at_most.max(bound),
            at: stop.at,
            dense,
            lfs,
            deviation: self.deviation,
            deviation_at_most: self.deviation + self.sagitta,
        }
    }

    fn stop(&self, (at, t): Place) -> Stop {
        let (mut p, mut lfs) = (self.arcs.point(at), self.arcs.lfs(at));
        if t > 0.0 {
            p = p.lerp(self.arcs.point(at + 1), t);
            lfs = between(lfs, self.arcs.lfs(at + 1), t);
        }
        let distance = |s: Option<DVec2>| s.map_or(f64::INFINITY, |s| s.distance(p));
        Stop {
            at: p,
            lfs,
            distances: self.ends.map(distance),
        }
    }

    fn visit(&mut self, stop: Stop, position: usize) {
        let badness = match self.kind {
            Bound::Epsilon(_) => ratio(stop.nearer(), stop.lfs),
            Bound::Rho(_) => stop.nearer(),
        };
        if badness > self.worst.0 {
            self.worst = (badness, stop, position);
        }
        self.reach = self.reach.min(stop.lfs);
        let deviation = self.chord.map_or(f64::INFINITY, |c| c.distance(stop.at));
        self.deviation = self.deviation.max(deviation);
    }

    /// Bounds what the curve does in a gap, or in the part of it between two stops: the distance to
    /// the nearer sample grows from either stop by no more than the length of the arc.
    fn enclose(&mut self, gap: usize, last: Stop, next: Stop) {
        let (length, arc) = (self.arcs.length(gap), self.arcs.arc(gap));
        let along_chord = |i: usize| last.distances[i].max(next.distances[i]) + arc.sagitta;
        let one_sample = along_chord(0).min(along_chord(1));
        let middle = (last.nearer() + next.nearer() + length) / 2.0;
        let farthest = one_sample.min(middle);
        let at_most = match self.kind {
            Bound::Rho(_) => farthest,
            Bound::Epsilon(_) => ratio(farthest, arc.lfs),
        };
        self.at_most = self.at_most.max(at_most);
        self.least_lfs = self.least_lfs.min(arc.lfs);
        self.sagitta = self.sagitta.max(arc.sagitta);
    }
}

/// The lfs a share of the way from one place to another; infinite where both are, as along a line.
fn between(before: f64, after: f64, t: f64) -> f64 {
    if before < f64::INFINITY && after < f64::INFINITY {
        before + t * (after - before)
    } else {
        before.min(after)
    }
}

/// How often a distance is as long as lfs; infinite unless both make sense.
fn ratio(distance: f64, lfs: f64) -> f64 {
    if distance < f64::INFINITY && lfs > 0.0 {
        distance / lfs
    } else {
        f64::INFINITY
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn infinite_lfs_is_infinite_only_between_two() {
        const FAR: f64 = f64::INFINITY;
        for (before, after, middle) in [
            (1.0, 3.0, 2.0),
            (1.0, FAR, 1.0),
            (FAR, 3.0, 3.0),
            (FAR, FAR, FAR),
        ] {
            let found = between(before, after, 0.5);
            assert!(found.total_cmp(&middle).is_eq());
            assert!(between(before, after, 0.0) >= before.min(after));
        }
    }
}
