//! Samples of curves with corners that an algorithm is seen to return.
//!
//! No theorem covers corners and open ends. But an algorithm can be run. Where it does not return
//! exactly the manifold boundary, each interval beside a sample of a wrong or a missing edge gets
//! one more sample, and so on until it does. If that does not end, the bound is tightened, and all
//! pieces get more samples. More samples keep the condition.

use std::collections::BTreeSet;

use curvecrust_curve::{DenseCurve, SplitCurve};
use curvecrust_geometry::{Component, EdgeSet, PointId, PointSet};
use curvecrust_reconstruct::{LeastDetour, Reconstructor};

use crate::condition::Condition;
use crate::error::SamplingError;
use crate::pieces::{SplitOptions, sample_pieces, sample_split_with};
use crate::sampled_curve::SampledCurve;
use crate::sampling::Sampling;

/// What the bound is multiplied by, as long as the samples are not returned.
const TIGHTER: f64 = 0.64;
/// The bound does not fall below this share of the one that was asked for.
const LEAST_SHARE: f64 = 0.25;

/// Rounds in which samples are added.
const ROUNDS: usize = 30;
/// So many times as many samples as the condition asks for are not exceeded, ...
const MOST: usize = 3;
/// ... but for this number.
const FEW: usize = 50;

/// Samples, and whether an algorithm returns exactly their manifold boundary.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Decoded {
    /// The samples. They keep the condition that was asked for, and perhaps a tighter one.
    pub sampling: Sampling,
    /// Whether the algorithm returns exactly their manifold boundary. If not, the samples are those
    /// of the condition that was asked for.
    pub is_exact: bool,
    /// How many more samples these are than the condition asks for.
    pub added: usize,
}

/// Options of [`sample_decoded_with`].
#[derive(Clone, Copy, Debug)]
pub struct DecodeOptions<'a> {
    /// The algorithm that has to return the manifold boundary; least detour by default.
    pub decoder: &'a dyn Reconstructor,
    /// Those of each sampling.
    pub sampling: SplitOptions<'a>,
}

impl Default for DecodeOptions<'_> {
    fn default() -> Self {
        Self {
            decoder: &LeastDetour,
            sampling: SplitOptions::default(),
        }
    }
}

/// Samples the pieces of a curve as [`sample_split`](crate::sample_split) does, and adds samples
/// near wrong edges until least detour returns exactly the manifold boundary; if that does not
/// help, by 0.64 times the bound, and so on down to a quarter.
///
/// Where components are [apart](SplitCurve::apart), they may touch and cross, where no algorithm
/// for curves returns all of them together: each is looked at by itself.
///
/// ```
/// use curvecrust_curve::SplitCurve;
/// use curvecrust_sampling::{Condition, sample_decoded};
///
/// // Angles of 45, 90 and 45 degrees.
/// let triangle = SplitCurve::from_path_data("M 0 0 H 4 V 4 Z")?;
/// let found = sample_decoded(&triangle, Condition::rho(0.9)?)?;
/// assert!(found.is_exact);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// Those of [`sample_split`](crate::sample_split).
pub fn sample_decoded(split: &SplitCurve, condition: Condition) -> Result<Decoded, SamplingError> {
    sample_decoded_with(split, condition, &DecodeOptions::default())
}

/// [`sample_decoded`] by the given [options](DecodeOptions), by their algorithm.
///
/// # Errors
/// Those of [`sample_decoded`].
pub fn sample_decoded_with(
    split: &SplitCurve,
    condition: Condition,
    options: &DecodeOptions<'_>,
) -> Result<Decoded, SamplingError> {
    let asked = sample_split_with(split, condition, &options.sampling)?;
    let count = asked.samples.len();
    let alone = split.is_apart();
    let mut share = TIGHTER;
    let mut sampling = asked.clone();
    loop {
        if let Some(found) = with_more(sampling, options.decoder, alone, count) {
            return Ok(Decoded {
                added: found.samples.len().saturating_sub(count),
                sampling: Sampling {
                    condition: Some(condition),
                    ..found
                },
                is_exact: true,
            });
        }
        if share < LEAST_SHARE {
            break;
        }
        let tighter = condition.with_value(share * condition.bound().value());
        // What was measured is fine enough, or else it would be for too many samples.
        match sample_pieces(split, &asked.measured, tighter, &options.sampling) {
            Ok(finer) => sampling = finer,
            Err(_) => break,
        }
        share *= TIGHTER;
    }
    Ok(Decoded {
        sampling: asked,
        is_exact: false,
        added: 0,
    })
}

/// Adds samples near wrong edges until an algorithm returns exactly the manifold boundary of the
/// samples: at most three times as many as there are, and 50.
///
/// What is [attained](Sampling::attained) stays that of the given samples; more do not exceed it.
///
/// ```
/// use curvecrust_curve::Curve;
/// use curvecrust_reconstruct::LeastDetour;
/// use curvecrust_sampling::{Condition, decode, sample_curve};
///
/// // The ends of two open strokes are nearer to each other than samples have to be.
/// let curve = Curve::from_path_data("M 0 0 H 10 M 0 1 H 10")?;
/// let samples = sample_curve(&curve, Condition::rho(0.5)?)?;
/// let found = decode(samples, &LeastDetour);
/// assert!(found.is_exact);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[must_use]
pub fn decode(sampling: Sampling, decoder: &dyn Reconstructor) -> Decoded {
    let count = sampling.samples.len();
    match with_more(sampling.clone(), decoder, false, count) {
        Some(found) => Decoded {
            added: found.samples.len() - count,
            sampling: found,
            is_exact: true,
        },
        None => Decoded {
            sampling,
            is_exact: false,
            added: 0,
        },
    }
}

/// The samples with as many more as make an algorithm return them; `None` if none do.
fn with_more(
    mut sampling: Sampling,
    decoder: &dyn Reconstructor,
    alone: bool,
    asked: usize,
) -> Option<Sampling> {
    for _ in 0..ROUNDS {
        let wrong = if alone {
            wrong_alone(&sampling.samples, decoder)?
        } else {
            wrong_in(&sampling.samples, decoder)?
        };
        if wrong.is_empty() {
            return Some(sampling);
        }
        sampling = halved(sampling, &wrong)?;
        if sampling.samples.len() > MOST * asked + FEW {
            break;
        }
    }
    None
}

/// The samples at the ends of edges that the algorithm does not return, or that it returns and are
/// none; `None` where two samples are at one place.
fn wrong_in(samples: &SampledCurve, decoder: &dyn Reconstructor) -> Option<BTreeSet<usize>> {
    let found = decoder.reconstruct(&samples.point_set().ok()?);
    Some(ends_of_difference(&found, &samples.manifold_boundary()))
}

/// The same, with each component by itself.
fn wrong_alone(samples: &SampledCurve, decoder: &dyn Reconstructor) -> Option<BTreeSet<usize>> {
    let mut wrong = BTreeSet::new();
    for component in samples.components() {
        let here = samples.points()[component.range.clone()].to_vec();
        let count = here.len();
        let found = decoder.reconstruct(&PointSet::new(here).ok()?);
        let polygon = Component {
            range: 0..count,
            closed: component.closed,
        };
        let ends = ends_of_difference(&found, &EdgeSet::new(count, polygon.edges()));
        wrong.extend(ends.into_iter().map(|i| i + component.range.start));
    }
    Some(wrong)
}

fn ends_of_difference(found: &EdgeSet, truth: &EdgeSet) -> BTreeSet<usize> {
    let found: BTreeSet<[PointId; 2]> = found.edges().iter().map(|e| e.ends()).collect();
    let truth: BTreeSet<[PointId; 2]> = truth.edges().iter().map(|e| e.ends()).collect();
    let ends = found.symmetric_difference(&truth).flatten();
    ends.map(|id| id.index()).collect()
}

/// The samples with one more in each interval beside those that are wrong; `None` if no interval
/// has a dense point inside.
fn halved(sampling: Sampling, wrong: &BTreeSet<usize>) -> Option<Sampling> {
    let dense = sampling.measured.dense();
    let old = &sampling.samples;
    let mut samples = SampledCurve::default();
    // Where each sample is now.
    let mut moved = Vec::with_capacity(old.len());
    for component in old.components() {
        let start = samples.len();
        let mut indices = Vec::new();
        for i in component.range.clone() {
            let here = old.dense_indices()[i];
            moved.push(start + indices.len());
            indices.push(here);
            let Some(next) = component.next(i) else {
                continue;
            };
            if wrong.contains(&i) || wrong.contains(&next) {
                let after = old.dense_indices()[next];
                let piece = &dense.components()[dense.component_of(here)].range;
                // At a corner, the next sample is of the next piece.
                let end = match piece.contains(&after) && after > here {
                    true => after,
                    false => piece.end - usize::from(!is_closed(dense, here)),
                };
                if end > here + 1 {
                    indices.push(usize::midpoint(here, end));
                }
            }
        }
        samples.push_component(dense, indices.into_iter(), component.closed);
    }
    if samples.len() == old.len() {
        return None;
    }
    for &interval in old.closing_intervals() {
        samples.push_closing(interval);
    }
    let mut attained = sampling.attained;
    if let Some(attained) = &mut attained {
        let interval = &mut attained.interval;
        interval.samples = interval.samples.map(|sample| moved.get(sample?).copied());
    }
    Some(Sampling {
        samples,
        attained,
        ..sampling
    })
}

/// Whether the piece of a dense point is closed.
fn is_closed(dense: &DenseCurve, i: usize) -> bool {
    dense.components()[dense.component_of(i)].closed
}
