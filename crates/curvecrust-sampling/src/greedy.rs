//! The greedy sampler.
//!
//! S. Ohrhallinger, S. A. Mitchell, M. Wimmer, *Curve Reconstruction with Many Fewer Samples*, SGP
//! 2016, Section 8.2, in the form of the authors' program, so that counts can be compared: from
//! sample s0 the end of the interval advances one dense point at a time; where the condition first
//! fails at a dense point inside, the interval ends one point before, at the next sample. A closed
//! curve starts at its first dense point; its closing interval, back to the start, adds no sample.
//!
//! Cost: near-linear. An interval that holds with some slack holds until its end has moved by as
//! much, so only a few of the candidate ends are looked at.

use curvecrust_curve::DenseComponent;
use curvecrust_medial_axis::Measured;

use crate::condition::Condition;
use crate::interval::Track;
use crate::sampled_curve::{ClosingInterval, SampledCurve};

/// Samples every component of a curve greedily, from its first dense point.
///
/// Both ends of an open component are samples. The condition holds at every dense point inside every
/// interval, but for the [closing interval](SampledCurve::closing_intervals) of closed components,
/// which is tested and reported.
#[must_use]
pub fn sample_greedy(measured: &Measured, condition: Condition) -> SampledCurve {
    let mut sampled = SampledCurve::default();
    for (index, component) in measured.dense().components().iter().enumerate() {
        let DenseComponent { range, closed } = component;
        let track = Track::new(measured, range.clone(), *closed);
        let positions = walk(&track, condition, range.len(), *closed);
        if let (Some(&last), true) = (positions.last(), *closed) {
            let slack = track.slack(condition, last, range.len());
            sampled.push_closing(ClosingInterval {
                component: index,
                holds: slack.holds(),
            });
        }
        let samples = positions.iter().map(|&position| range.start + position);
        sampled.push_component(measured.dense(), samples, *closed);
    }
    sampled
}

/// The positions of the samples on a track of `count` dense points.
fn walk(track: &Track, condition: Condition, count: usize, closed: bool) -> Vec<usize> {
    let mut positions = vec![0];
    let mut from = 0;
    let mut to = 1;
    while to < count {
        let slack = track.slack(condition, from, to);
        if slack.holds() {
            to = track.next_uncertain(condition, from, to, slack, count);
        } else {
            from = to - 1;
            positions.push(from);
        }
    }
    if !closed && count > 1 {
        positions.push(count - 1);
    }
    positions
}

#[cfg(test)]
mod tests {
    use super::*;
    use curvecrust_curve::Curve;
    use curvecrust_medial_axis::{Discretisation, Estimator, measure};
    use proptest::prelude::*;

    /// The definition: one dense point at a time.
    fn walk_naively(track: &Track, condition: Condition, count: usize) -> Vec<usize> {
        let mut positions = vec![0];
        let mut from = 0;
        for to in 1..count {
            if !track.slack(condition, from, to).holds() {
                from = to - 1;
                positions.push(from);
            }
        }
        positions
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
            let discretisation = Discretisation::PerSegment(per_segment);
            let measured = measure(&curve, discretisation, Estimator::ShrinkingBall).unwrap();
            let range = measured.dense().components()[0].range.clone();
            let track = Track::new(&measured, range.clone(), true);
            for condition in [Condition::epsilon(bound).unwrap(), Condition::rho(bound).unwrap()] {
                for condition in [condition, condition.with_hausdorff_limit(limit).unwrap()] {
                    prop_assert_eq!(
                        walk(&track, condition, range.len(), true),
                        walk_naively(&track, condition, range.len())
                    );
                }
            }
        }
    }
}
