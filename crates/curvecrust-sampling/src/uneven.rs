//! Samplings for comparison: at equal lengths of arc, and with random steps.

use curvecrust_geometry::{Component, Random};
use curvecrust_medial_axis::MeasuredCurve;

use crate::arcs::Arcs;
use crate::certified::certified;
use crate::condition::Condition;
use crate::error::{SAMPLE_LIMIT, SamplingError, count_of};
use crate::sampled_curve::SampledCurve;
use crate::sampling::Sampling;

/// Samples every component at equal lengths of arc, as near to `step` as goes, whatever its lfs.
///
/// Each sample is the dense point nearest to its place along the dense polygon. Closed components
/// begin at their first dense point and have three samples at least, open ones have both ends; none
/// has more than dense points. There is no condition that the samples are to hold; what rho they
/// attain is in the result.
///
/// # Errors
/// [`Parameter`](SamplingError::Parameter) if the step is no length above 0,
/// [`TooMany`](SamplingError::TooMany) if it asks for more than [`SAMPLE_LIMIT`] samples.
pub fn sample_uniformly(measured: &MeasuredCurve, step: f64) -> Result<Sampling, SamplingError> {
    if !(step > 0.0 && step.is_finite()) {
        return Err(SamplingError::Parameter {
            name: "step",
            value: step,
            range: "a length above 0",
        });
    }
    let points = measured.dense().points();
    let along = |component: &Component| -> Vec<f64> {
        let start = component.range.start;
        let closing = component.closed.then_some(start);
        let mut length = 0.0;
        let mut last = points[start];
        let stops = component.range.clone().chain(closing);
        stops
            .map(|i| {
                length += last.distance(points[i]);
                last = points[i];
                length
            })
            .collect()
    };
    let mut sampled = SampledCurve::default();
    let components = measured.dense().components();
    let lengths: Vec<Vec<f64>> = components.iter().map(along).collect();
    let wanted: f64 = lengths
        .iter()
        .filter_map(|l| l.last())
        .map(|l| l / step)
        .sum();
    if wanted > SAMPLE_LIMIT as f64 {
        return Err(SamplingError::too_many("the step", step, wanted));
    }
    for (component, along) in components.iter().zip(&lengths) {
        let length = along.last().copied().unwrap_or(0.0);
        let least = if component.closed { 3 } else { 1 };
        let parts = count_of((length / step).round()).max(least);
        let at_end = if component.closed { 0 } else { 1 };
        let place = |k: u64| nearest(along, length * k as f64 / parts as f64);
        let mut places: Vec<usize> = (0..parts + at_end).map(place).collect();
        // The last place of a closed polygon is its first.
        places.retain(|&at| at < component.range.len());
        places.dedup();
        let indices = places.iter().map(|at| component.range.start + at);
        sampled.push_component(measured.dense(), indices, component.closed);
    }
    Ok(Sampling::new(measured, &Arcs::of(measured), sampled, None))
}

/// The position of the value nearest to one, in ascending values.
fn nearest(ascending: &[f64], value: f64) -> usize {
    let after = ascending.partition_point(|&v| v < value);
    let before = after.saturating_sub(1);
    let last = ascending.len().saturating_sub(1);
    if after > last || value - ascending[before] <= ascending[after] - value {
        before
    } else {
        after
    }
}

/// How [`sample_unevenly_with`] goes about it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct UnevenOptions {
    /// The shortest step as a fraction of the greedy one, above 0 and at most 1; a half by default.
    /// With 1 all steps are greedy, as in [`sample`](crate::sample).
    pub fraction: f64,
    /// Where the random numbers begin: the same seed gives the same samples. 0 by default.
    pub seed: u64,
}

impl Default for UnevenOptions {
    fn default() -> Self {
        Self {
            fraction: 0.5,
            seed: 0,
        }
    }
}

/// Samples that satisfy a condition, unevenly: each next one is anywhere between half of the greedy
/// step and all of it, at random but always the same.
///
/// # Errors
/// Those of [`sample`](crate::sample).
pub fn sample_unevenly(
    measured: &MeasuredCurve,
    condition: Condition,
) -> Result<Sampling, SamplingError> {
    sample_unevenly_with(measured, condition, &UnevenOptions::default())
}

/// [`sample_unevenly`] by the given [options](UnevenOptions).
///
/// # Errors
/// [`Parameter`](SamplingError::Parameter) for a fraction out of range, and those of
/// [`sample`](crate::sample).
pub fn sample_unevenly_with(
    measured: &MeasuredCurve,
    condition: Condition,
    options: &UnevenOptions,
) -> Result<Sampling, SamplingError> {
    let UnevenOptions { fraction, seed } = *options;
    if !(fraction > 0.0 && fraction <= 1.0) {
        return Err(SamplingError::Parameter {
            name: "fraction",
            value: fraction,
            range: "above 0 and at most 1",
        });
    }
    let mut random = Random::new(seed);
    certified(measured, condition, |arcs| {
        let (mut positions, mut guess) = (vec![0], 1);
        let (mut from, end) = (0, arcs.len());
        while from < end {
            let farthest = arcs.farthest(condition, from, guess, end).ok_or(from)?;
            let share = random.fine_between(fraction, 1.0) * (farthest - from) as f64;
            let step = usize::try_from(count_of(share.ceil())).unwrap_or(usize::MAX);
            let to = from.saturating_add(step).min(farthest);
            // With a Hausdorff limit, a part of what holds need not hold.
            let to = if arcs.holds(condition, from, to) {
                to
            } else {
                farthest
            };
            guess = farthest + (farthest - from);
            positions.push(to);
            from = to;
        }
        if arcs.component.closed {
            positions.pop();
        }
        Ok(positions)
    })
}
