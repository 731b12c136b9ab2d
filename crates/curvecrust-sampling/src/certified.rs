//! Certified sampling: the condition holds at every point of the curve, not only at dense points.
//!
//! Greedy sampling: from each sample, the next one is the farthest dense point up to which the
//! condition holds, at dense points and on the arcs between them. Two facts bound what happens on
//! an arc: lfs is 1-Lipschitz, and the length of an arc is bounded by its chord and lfs (see
//! `arcs.rs`). The closing interval of a closed component and the last interval of an open one hold
//! like all others.
//!
//! The error of lfs as it was measured remains. At adaptive gaps of 0.02 it is below 0.5 % on every
//! curve of the fixtures. That is less than the bounds on arcs leave unused: with lfs measured anew
//! at gaps ten times finer, every sampling of the fixtures still holds.
//!
//! Cost: O(n) for n dense points.

use curvecrust_curve::{Curve, DENSE_LIMIT, DenseError};
use curvecrust_geometry::Interrupt;
use curvecrust_medial_axis::{
    Discretisation, MeasureOptions, MeasuredCurve, MedialAxisError, measure_with,
};

use crate::arcs::Arcs;
use crate::condition::{Bound, Condition};
use crate::error::{SAMPLE_LIMIT, SamplingError};
use crate::sampled_curve::{ClosingInterval, SampledCurve};
use crate::sampling::{SampleOptions, Sampling};

/// Samples every component of a curve greedily, from its first dense point, so that the condition
/// holds at every point of the curve, lfs being as measured: `at_most` of what the samples attain
/// is below its bound.
///
/// Both ends of an open component are samples. The finer the dense points, the fewer samples, up to
/// about (gap / lfs) / bound of them; [`sample_fewest`](crate::sample_fewest) looks for a better
/// start.
///
/// # Errors
/// [`TooCoarse`](SamplingError::TooCoarse) where dense points are too far apart,
/// [`TooMany`](SamplingError::TooMany) where the condition asks for too many samples.
///
/// ```
/// use curvecrust_curve::Curve;
/// use curvecrust_medial_axis::measure;
/// use curvecrust_sampling::{Condition, sample};
///
/// let d = "M 0 0 C 30 -20 50 20 80 0 S 120 40 80 60 S 30 30 0 60 S -30 20 0 0 Z";
/// let curve = Curve::from_path_data(d)?;
/// let measured = measure(&curve)?;
/// let sampling = sample(&measured, Condition::rho(0.9)?)?;
/// let attained = sampling.attained.unwrap();
/// assert!(0.85 < attained.bound && attained.at_most < 0.9);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn sample(measured: &MeasuredCurve, condition: Condition) -> Result<Sampling, SamplingError> {
    certified(measured, condition, |arcs| walk(arcs, condition, 0))
}

/// The fraction of lfs that gaps are to have at most, whatever the bound.
const GAP_TO_LFS: f64 = 0.02;
/// The fraction of the bound that gaps are to be of lfs.
const GAP_TO_BOUND: f64 = 0.05;
/// The same where there are many dense points: this costs up to 3 % more samples.
const GAP_TO_BOUND_OF_MANY: f64 = 0.1;
/// The same where that makes more dense points than are supported: this costs a sixth more samples.
const GAP_TO_BOUND_OF_MOST: f64 = 0.25;
/// Arcs that are to be smaller are tried at first, to see how many there would be.
const TRIED: f64 = 1e-3;

/// Discretises a curve as finely as the condition asks for, and [samples](sample) it.
///
/// # Errors
/// Those of [`measure`](curvecrust_medial_axis::measure()), in [`SamplingError::Measure`]; and
/// [`TooMany`](SamplingError::TooMany).
///
/// ```
/// use curvecrust_curve::Curve;
/// use curvecrust_sampling::{Condition, sample_curve};
///
/// let circle = Curve::from_path_data("M 1 0 A 1 1 0 0 1 -1 0 A 1 1 0 0 1 1 0 Z")?;
/// assert_eq!(sample_curve(&circle, Condition::rho(0.9)?)?.samples.len(), 4);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn sample_curve(curve: &Curve, condition: Condition) -> Result<Sampling, SamplingError> {
    sample_curve_with(curve, condition, &SampleOptions::default())
}

/// [`sample_curve`] by the given [options](SampleOptions). The progress is that of
/// [`measure_with`], once for every discretisation that is tried.
///
/// # Errors
/// Those of [`sample_curve`].
pub fn sample_curve_with(
    curve: &Curve,
    condition: Condition,
    options: &SampleOptions<'_>,
) -> Result<Sampling, SamplingError> {
    let measured = |gap_to_lfs, gap_to_lfs_of_many| {
        let options = MeasureOptions {
            discretisation: Discretisation::Adaptive { gap_to_lfs },
            gap_to_lfs_of_many,
            progress: options.progress,
            ..MeasureOptions::default()
        };
        measure_with(curve, &options)
    };
    as_finely_as_needed(condition, measured, |measured| sample(measured, condition))
}

/// Samples what is measured at gaps that are small enough: the fraction of lfs that they are, and
/// the one that they may be where there are many.
pub(crate) fn as_finely_as_needed(
    condition: Condition,
    measured: impl Fn(f64, f64) -> Result<MeasuredCurve, MedialAxisError>,
    sample: impl Fn(&MeasuredCurve) -> Result<Sampling, SamplingError>,
) -> Result<Sampling, SamplingError> {
    let bound = condition.bound().value();
    let wanted = GAP_TO_LFS.min(GAP_TO_BOUND * bound);
    // Gaps that proved too long for the bound do not grow.
    let of_many = |gap_to_lfs, of_bound| {
        if gap_to_lfs < wanted {
            gap_to_lfs
        } else {
            of_bound * bound
        }
    };
    let mut of_bound = GAP_TO_BOUND_OF_MANY;
    let mut gap_to_lfs = wanted.max(TRIED);
    let mut too_many = None;
    loop {
        let found = measured(gap_to_lfs, of_many(gap_to_lfs, of_bound));
        if let Err(MedialAxisError::Dense(DenseError::TooMany { .. })) = found {
            if gap_to_lfs >= wanted && of_bound < GAP_TO_BOUND_OF_MOST {
                of_bound = GAP_TO_BOUND_OF_MOST;
                continue;
            }
            if let Some(asked) = too_many {
                return Err(asked);
            }
        }
        let measured = found?;
        let finer = if gap_to_lfs > wanted {
            wanted
        } else {
            match sample(&measured) {
                Ok(sampling) => return Ok(sampling),
                Err(SamplingError::TooCoarse { .. }) if gap_to_lfs > f64::EPSILON => {
                    gap_to_lfs / 4.0
                }
                Err(error) => return Err(error),
            }
        };
        let asked = asked_for(&measured, condition).0;
        let longest = finer.max(of_many(finer, of_bound));
        if steps(&measured, |lfs| longest * lfs) > DENSE_LIMIT as f64 {
            return Err(asked);
        }
        (gap_to_lfs, too_many) = (finer, Some(asked));
    }
}

/// The sampling of all components, each by the positions of its samples, ascending, or else by the
/// position of a gap that is too long.
pub(crate) fn certified(
    measured: &MeasuredCurve,
    condition: Condition,
    mut positions: impl FnMut(&Arcs) -> Result<Vec<usize>, usize>,
) -> Result<Sampling, SamplingError> {
    let all = Arcs::of(measured);
    let mut samples = SampledCurve::default();
    for (component, arcs) in all.iter().enumerate() {
        let positions = positions(arcs)
            .map_err(|gap| too_coarse(measured, condition, arcs.component.range.start + gap))?;
        let indices = positions.iter().map(|at| arcs.component.range.start + at);
        samples.push_component(measured.dense(), indices, arcs.component.closed);
        if arcs.component.closed {
            samples.push_closing(ClosingInterval {
                component,
                holds: true,
            });
        }
    }
    Ok(Sampling::new(measured, &all, samples, Some(condition)))
}

/// The positions of greedy samples from `start`, over a round or to the end of an open component;
/// or the position of a gap that is too long.
pub(crate) fn walk(arcs: &Arcs, condition: Condition, start: usize) -> Result<Vec<usize>, usize> {
    let end = start + arcs.len();
    let interrupt = Interrupt::current();
    let mut positions = vec![start];
    let (mut from, mut guess) = (start, start);
    while from < end {
        interrupt.check();
        // Positions below a round, as far as `arcs` is concerned.
        let round = if from >= arcs.len() { arcs.len() } else { 0 };
        let to = arcs.farthest(condition, from - round, guess - round, end - round);
        let to = to.ok_or(from - round)? + round;
        positions.push(to);
        guess = to + (to - from);
        from = to;
    }
    if arcs.component.closed {
        positions.pop();
    }
    Ok(positions)
}

/// The error of a gap that is too long: too many samples asked for, or too coarse dense points.
pub(crate) fn too_coarse(
    measured: &MeasuredCurve,
    condition: Condition,
    index: usize,
) -> SamplingError {
    let (asked, count) = asked_for(measured, condition);
    if count > SAMPLE_LIMIT as f64 {
        return asked;
    }
    let (dense, lfs) = (measured.dense(), measured.lfs());
    let next = dense.next(index).unwrap_or(index);
    let (p, q) = (dense.points()[index], dense.points()[next]);
    SamplingError::TooCoarse {
        index,
        at: p,
        gap: p.distance(q),
        lfs: lfs.at(index).min(lfs.at(next)),
    }
}

/// About how many samples a condition asks for, and the error if these are too many.
fn asked_for(measured: &MeasuredCurve, condition: Condition) -> (SamplingError, f64) {
    let (name, bound) = match condition.bound() {
        Bound::Epsilon(epsilon) => ("epsilon", epsilon),
        Bound::Rho(rho) => ("rho", rho),
    };
    // Both samples of an interval are as far as the bound from its middle.
    let for_bound = steps(measured, |lfs| 2.0 * bound * lfs);
    // From a chord of length c, a curve that turns with lfs as its radius is c^2 / 8 lfs away.
    let limit = condition.hausdorff_limit().unwrap_or(f64::INFINITY);
    let for_limit = steps(measured, |lfs| (8.0 * limit * lfs).sqrt());
    let (what, value, count) = if for_limit > for_bound {
        ("the Hausdorff limit", limit, for_limit)
    } else {
        (name, bound, for_bound)
    };
    (SamplingError::too_many(what, value, count), count)
}

/// How many steps go along all components, each as long as it may be where lfs is what it is.
fn steps(measured: &MeasuredCurve, step: impl Fn(f64) -> f64) -> f64 {
    let (dense, lfs) = (measured.dense(), measured.lfs());
    let of_gap = |i: usize| {
        let next = dense.next(i)?;
        let gap = dense.points()[i].distance(dense.points()[next]);
        Some(gap / step(lfs.at(i)))
    };
    (0..dense.len()).filter_map(of_gap).sum()
}
