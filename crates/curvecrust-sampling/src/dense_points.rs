//! Sampling by conditions that are tested at dense points only, as the paper's authors do it.
//!
//! S. Ohrhallinger, S. A. Mitchell, M. Wimmer, *Curve Reconstruction with Many Fewer Samples*, SGP
//! 2016: Section 8.2 reports what a sampling algorithm gave and does not describe it. This is what
//! the program of the authors does. The end of the interval from sample s0 advances one dense point
//! at a time, and the condition is tested at the dense points inside. Where it first fails, the
//! program takes the failing point as the next sample. So does [`sample_as_published`], so that
//! counts can be compared; [`sample_at_dense_points`] takes the point before, the last for which
//! the condition held. A closed curve starts at its first dense point. Its closing interval, back
//! to the start, adds no sample.
//!
//! Let gaps between dense points be at most g times the lfs of their ends. A rho that holds at
//! dense points also holds between them, because the authors let a dense point stand for the curve
//! up to its neighbours. An epsilon may be exceeded, by less than (1 + epsilon) g / (2 - g): the
//! worst place is half-way between two dense points that just hold, where the sample is farther by
//! half of the gap, and lfs smaller by as much. [`sample`](crate::sample()) has no such excess.
//!
//! Cost: near-linear. An interval that holds with some slack holds until its end has moved by as
//! much, so only a few of the candidate ends are looked at.

use curvecrust_geometry::Component;
use curvecrust_medial_axis::MeasuredCurve;

use crate::arcs::Arcs;
use crate::condition::Condition;
use crate::sampled_curve::{ClosingInterval, SampledCurve};
use crate::sampling::Sampling;
use crate::slack::Unrolled;

/// Samples every component of a curve greedily, from its first dense point.
///
/// Both ends of an open component are samples. The condition holds at every dense point inside
/// every interval, but for the [closing interval](SampledCurve::closing_intervals) of closed
/// components, which is tested and reported. [This module](self) bounds by how much it may fail
/// between them.
#[must_use]
pub fn sample_at_dense_points(measured: &MeasuredCurve, condition: Condition) -> Sampling {
    sample(measured, condition, Next::LastHolding)
}

/// Samples like the authors' program: each interval ends one dense point later than that of
/// [`sample_at_dense_points`], at the first for which the condition does not hold.
///
/// For comparing counts with the published ones; the finer the discretisation, the less it matters.
#[must_use]
pub fn sample_as_published(measured: &MeasuredCurve, condition: Condition) -> Sampling {
    sample(measured, condition, Next::FirstFailing)
}

/// Which dense point is the next sample, once the interval to one of them fails.
#[derive(Clone, Copy, Debug)]
enum Next {
    LastHolding,
    FirstFailing,
}

fn sample(measured: &MeasuredCurve, condition: Condition, next: Next) -> Sampling {
    let mut sampled = SampledCurve::default();
    for (index, component) in measured.dense().components().iter().enumerate() {
        let Component { range, closed } = component;
        let track = Unrolled::new(measured, range.clone(), *closed);
        let mut positions = walk(&track, condition, range.len(), next);
        let last = positions[positions.len() - 1];
        if *closed {
            sampled.push_closing(ClosingInterval {
                component: index,
                holds: track.slack(condition, last, range.len()).holds(),
            });
        } else if last + 1 < range.len() {
            positions.push(range.len() - 1);
        }
        let samples = positions.iter().map(|&position| range.start + position);
        sampled.push_component(measured.dense(), samples, *closed);
    }
    Sampling::new(measured, &Arcs::of(measured), sampled, Some(condition))
}

/// The positions of the samples, the first of which is 0, on the first `count` of a track.
fn walk(track: &Unrolled, condition: Condition, count: usize, next: Next) -> Vec<usize> {
    let mut positions = vec![0];
    let (mut from, mut to) = (0, 1);
    while to < count {
        let slack = track.slack(condition, from, to);
        if slack.holds() {
            to = track.next_uncertain(condition, from, to, slack, count);
        } else {
            from = match next {
                Next::LastHolding => to - 1,
                Next::FirstFailing => to,
            };
            to = from + 1;
            positions.push(from);
        }
    }
    positions
}

#[cfg(test)]
mod tests {
    use super::*;
    use curvecrust_curve::Curve;
    use curvecrust_medial_axis::{Discretisation, Estimator, MeasureOptions, measure_with};
    use proptest::prelude::*;

    /// The definition: one dense point at a time.
    fn walk_naively(
        track: &Unrolled,
        condition: Condition,
        count: usize,
        next: Next,
    ) -> Vec<usize> {
        let mut positions = vec![0];
        let mut from = 0;
        for to in 1..count {
            if !track.slack(condition, from, to).holds() {
                from = match next {
                    Next::LastHolding => to - 1,
                    Next::FirstFailing => to,
                };
                positions.push(from);
            }
        }
        positions
    }

    fn per_segment(curve: &Curve, points: u32) -> MeasuredCurve {
        let options = MeasureOptions {
            discretisation: Discretisation::PerSegment(points),
            estimator: Estimator::ShrinkingBall,
            ..MeasureOptions::default()
        };
        measure_with(curve, &options).unwrap()
    }

    /// A smooth closed curve through points at wavy distances from the origin.
    fn wavy(radii: &[f64]) -> Curve {
        let n = radii.len();
        let at = |i: usize| {
            let angle = std::f64::consts::TAU * i as f64 / n as f64;
            curvecrust_geometry::DVec2::from_angle(angle) * radii[i % n]
        };
        let mut d = format!("M {} {}", at(0).x, at(0).y);
        for i in 0..n {
            let (before, start, end, after) = (at(i + n - 1), at(i), at(i + 1), at(i + 2));
            let (c1, c2) = (start + (end - before) / 6.0, end - (after - start) / 6.0);
            d += &format!(" C {} {} {} {} {} {}", c1.x, c1.y, c2.x, c2.y, end.x, end.y);
        }
        Curve::from_path_data(&(d + " Z")).unwrap()
    }

    /// Each point of an open curve is a sample, or every other one and the end, once.
    #[test]
    fn a_tiny_bound_takes_every_point_or_every_other() {
        let arch = Curve::from_path_data("M 0 0 C 0 4 6 4 6 0").unwrap();
        for gaps in [2, 3, 20, 21] {
            let measured = per_segment(&arch, gaps);
            let last = measured.dense().len() - 1;
            for condition in [
                Condition::epsilon(1e-9).unwrap(),
                Condition::rho(1e-9).unwrap(),
            ] {
                let sampling = sample_at_dense_points(&measured, condition);
                assert_eq!(
                    sampling.samples.dense_indices(),
                    (0..=last).collect::<Vec<_>>()
                );
                let mut expected: Vec<usize> = (0..=last).step_by(2).collect();
                expected.extend((last % 2 == 1).then_some(last));
                let published = sample_as_published(&measured, condition);
                assert_eq!(published.samples.dense_indices(), expected);
            }
        }
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(32))]
        #[test]
        fn looking_ahead_changes_nothing(
            radii in prop::collection::vec(0.4..1.6f64, 5..12),
            per_segment in 20u32..120,
            bound in 0.1..0.95f64,
            limit in 0.001..0.05f64,
        ) {
            let curve = wavy(&radii);
            let measured = self::per_segment(&curve, per_segment);
            let range = measured.dense().components()[0].range.clone();
            let track = Unrolled::new(&measured, range.clone(), true);
            for condition in [Condition::epsilon(bound).unwrap(), Condition::rho(bound).unwrap()] {
                for condition in [condition, condition.with_hausdorff_limit(limit).unwrap()] {
                    for next in [Next::LastHolding, Next::FirstFailing] {
                        prop_assert_eq!(
                            walk(&track, condition, range.len(), next),
                            walk_naively(&track, condition, range.len(), next)
                        );
                    }
                }
            }
        }
    }
}
