//! Sampling of curves with corners: every smooth piece by itself, with the corners as samples.
//!
//! The condition holds at every point of every piece, with the lfs that
//! [`measure_pieces`](curvecrust_medial_axis::pieces) defines. No theorem guarantees a
//! reconstruction from the samples of all pieces: run it to see. Two steps make it likely:
//!
//! - A corner c is a sample. HNN-Crust joins it to its neighbours s and t on both arms only if the
//!   angle there is wider than 60 degrees and both are nearer to c than to each other: |cs| < |st|
//!   and |ct| < |st|. Where they are not, the longer arm gets one more sample, as far from c as the
//!   neighbour on the other arm. Sharper corners are left to algorithms that find them, such as
//!   least detour ([`decoded`](crate::decoded)).
//! - A piece is sampled with the smallest bound that needs no more samples. So they are spread
//!   evenly, and none is left over close to the corner.

use curvecrust_curve::{DenseCurve, DenseError, SplitCurve};
use curvecrust_geometry::Progress;
use curvecrust_medial_axis::{
    MeasurePiecesOptions, MeasuredCurve, MedialAxisError, measure_pieces_with,
};

use crate::arcs::Arcs;
use crate::certified::{as_finely_as_needed, certified, walk};
use crate::check::Interval;
use crate::condition::Condition;
use crate::error::SamplingError;
use crate::fewest;
use crate::sampled_curve::{ClosingInterval, SampledCurve};
use crate::sampling::Sampling;

/// Options of [`sample_split_with`].
#[derive(Clone, Copy, Debug)]
pub struct SplitOptions<'a> {
    /// Whether a component without a corner begins at the best of all starts, as by default, or at
    /// its first dense point.
    pub every_start: bool,
    /// Hears how many dense points are done, of how many.
    pub progress: Progress<'a>,
}

impl Default for SplitOptions<'_> {
    fn default() -> Self {
        Self {
            every_start: true,
            progress: Progress::default(),
        }
    }
}

/// Distances from a corner below this ratio are the same: dense points allow no better.
const ALIKE: f64 = 1.02;
/// How often the range of bounds that need the same number of samples is halved.
const HALVINGS: usize = 8;

/// Discretises the pieces of a curve as finely as the condition asks for, and samples each from one
/// corner to the next; components without a corner from the best of all starts.
///
/// The components of the samples are those of the curve; a corner is a sample once, with the
/// parameter and the dense point that start the piece after it. The components of the measured
/// curve are the pieces, so that the last sample of a piece before a corner is not among its own
/// dense points. The value attained is the largest one on any piece.
///
/// # Errors
/// Those of [`sample_curve`](crate::sample_curve).
///
/// ```
/// use curvecrust_curve::SplitCurve;
/// use curvecrust_reconstruct::hnn_crust;
/// use curvecrust_sampling::{Condition, sample_split};
///
/// let half_disc = SplitCurve::from_path_data("M 0 0 A 1 1 0 0 1 2 0 Z")?;
/// let samples = sample_split(&half_disc, Condition::rho(0.9)?)?.samples;
/// for corner in half_disc.corners() {
///     assert!(samples.points().contains(&corner.at));
/// }
/// assert_eq!(hnn_crust(&samples.point_set()?), samples.manifold_boundary());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn sample_split(split: &SplitCurve, condition: Condition) -> Result<Sampling, SamplingError> {
    sample_split_with(split, condition, &SplitOptions::default())
}

/// [`sample_split`] by the given [options](SplitOptions). The progress is that of
/// [`measure_pieces_with`], once for every discretisation that is tried.
///
/// # Errors
/// Those of [`sample_split`].
pub fn sample_split_with(
    split: &SplitCurve,
    condition: Condition,
    options: &SplitOptions<'_>,
) -> Result<Sampling, SamplingError> {
    let progress = options.progress;
    let measured = |gap_to_lfs, gap_to_lfs_of_many| {
        let options = MeasurePiecesOptions {
            gap_to_lfs,
            gap_to_lfs_of_many,
            progress,
        };
        measure_pieces_with(split, &options)
    };
    as_finely_as_needed(condition, measured, |measured| {
        sample_pieces(split, measured, condition, options)
    })
}

/// [`sample_split_with`] of pieces that [were measured](curvecrust_medial_axis::measure_pieces)
/// already: to sample them by one condition after another. The progress is not heard.
///
/// ```
/// use curvecrust_curve::SplitCurve;
/// use curvecrust_medial_axis::measure_pieces;
/// use curvecrust_sampling::{Condition, SplitOptions, sample_pieces, sample_split};
///
/// let square = SplitCurve::from_path_data("M 0 0 H 4 V 4 H 0 Z")?;
/// let measured = measure_pieces(&square)?;
/// let rho = Condition::rho(0.9)?;
/// let samples = sample_pieces(&square, &measured, rho, &SplitOptions::default())?;
/// assert_eq!(samples, sample_split(&square, rho)?);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`Measure`](SamplingError::Measure) if these are not the pieces of the curve,
/// [`TooCoarse`](SamplingError::TooCoarse) and [`TooMany`](SamplingError::TooMany) as of
/// [`sample`](crate::sample).
pub fn sample_pieces(
    split: &SplitCurve,
    measured: &MeasuredCurve,
    condition: Condition,
    options: &SplitOptions<'_>,
) -> Result<Sampling, SamplingError> {
    are_pieces(split, measured.dense()).map_err(MedialAxisError::from)?;
    let of_pieces = sample_each(split, measured, condition, options.every_start)?;
    Ok(joined(split, of_pieces))
}

/// Whether dense points are of the pieces of a curve: from start to end of each.
fn are_pieces(split: &SplitCurve, dense: &DenseCurve) -> Result<(), DenseError> {
    let pieces = split.pieces().components();
    if dense.components().len() != pieces.len() {
        return Err(DenseError::Lengths {
            points: dense.len(),
            other: dense.components().len(),
            what: "components that are not the pieces of the curve",
        });
    }
    for (piece, component) in pieces.iter().zip(dense.components()) {
        let points = &dense.points()[component.range.clone()];
        let end = points.last().copied();
        let fits = component.closed == piece.is_closed()
            && points.len() >= 2
            && points.first() == piece.segments().first().map(|s| s.start()).as_ref()
            && (component.closed || end == piece.segments().last().map(|s| s.end()));
        if !fits {
            let index = component.range.start;
            return Err(DenseError::Param { index });
        }
    }
    Ok(())
}

/// The samples of all pieces.
fn sample_each(
    split: &SplitCurve,
    measured: &MeasuredCurve,
    condition: Condition,
    every_start: bool,
) -> Result<Sampling, SamplingError> {
    let all = Arcs::of(measured);
    let mut piece = 0..;
    // This fails where a piece cannot be sampled.
    let first = certified(measured, condition, |arcs| {
        let is_cut = piece
            .next()
            .is_some_and(|piece| split.meetings(piece) != [None; 2]);
        if is_cut {
            even(arcs, condition)
        } else if every_start {
            fewest::positions(arcs, condition, &|_| ())
        } else {
            walk(arcs, condition, 0)
        }
    })?;
    let places = first.samples.components().iter().zip(&all);
    let mut positions: Vec<Vec<usize>> = places
        .map(|(component, arcs)| {
            let here = &first.samples.dense_indices()[component.range.clone()];
            here.iter()
                .map(|dense| dense - arcs.component.range.start)
                .collect()
        })
        .collect();
    while balance(split, &all, condition, &mut positions) {}
    let mut positions = positions.into_iter();
    certified(measured, condition, |_| {
        Ok(positions.next().unwrap_or_default())
    })
}

/// Greedy samples of an open piece by the smallest bound that needs as many of them.
fn even(arcs: &Arcs, condition: Condition) -> Result<Vec<usize>, usize> {
    let mut best = walk(arcs, condition, 0)?;
    let (mut low, mut high) = (0.0, condition.bound().value());
    for _ in 0..HALVINGS {
        let middle = f64::midpoint(low, high);
        match walk(arcs, condition.with_value(middle), 0) {
            Ok(found) if found.len() <= best.len() => (best, high) = (found, middle),
            _ => low = middle,
        }
    }
    Ok(best)
}

/// Adds a sample beside the first corner that is nearer to a neighbour than its neighbours are to
/// each other; whether there was one.
fn balance(
    split: &SplitCurve,
    all: &[Arcs],
    condition: Condition,
    positions: &mut [Vec<usize>],
) -> bool {
    for before in 0..positions.len() {
        let Some((after, corner)) = split.meetings(before)[1] else {
            continue;
        };
        let (arm, other) = (&positions[before], &positions[after]);
        let [s, t] = [
            all[before].point(arm[arm.len() - 2]),
            all[after].point(other[1]),
        ];
        let (to_s, to_t) = (corner.distance(s), corner.distance(t));
        let (near, far) = (to_s.min(to_t), to_s.max(to_t));
        if far < s.distance(t) || far < ALIKE * near {
            continue;
        }
        let added = if to_s > to_t {
            let last = arm.len() - 1;
            let at = (arm[last - 1] + 1..arm[last])
                .find(|&at| all[before].point(at).distance(corner) <= to_t);
            at.map(|at| (before, last, at))
        } else {
            let at = (1..other[1]).rfind(|&at| all[after].point(at).distance(corner) <= to_s);
            at.map(|at| (after, 1, at))
        };
        // Without a place, or with arms that are too near to each other, a reconstruction fails.
        if let Some((piece, index, at)) = added
            && insert(&all[piece], condition, &mut positions[piece], index, at)
        {
            return true;
        }
    }
    false
}

/// Makes a position a sample before that of an index; whether it was far enough from both of its
/// neighbours to be new. With a Hausdorff limit, a part of what holds need not hold, and may get
/// more samples.
fn insert(
    arcs: &Arcs,
    condition: Condition,
    positions: &mut Vec<usize>,
    index: usize,
    at: usize,
) -> bool {
    let (from, to) = (positions[index - 1], positions[index]);
    let mut between = vec![from];
    for end in [at, to] {
        let mut last = between[between.len() - 1];
        while last < end {
            let Some(next) = arcs.farthest(condition, last, end, end) else {
                return false;
            };
            between.push(next);
            last = next;
        }
    }
    positions.splice(index - 1..=index, between);
    true
}

/// Samples of the pieces put together.
fn joined(split: &SplitCurve, of_pieces: Sampling) -> Sampling {
    let pieces = &of_pieces.samples;
    let mut samples = SampledCurve::default();
    let mut attained = of_pieces.attained;
    for (component, whole) in split.components().iter().enumerate() {
        let start = samples.len();
        let mut indices = Vec::new();
        // Where the worst interval begins: its component, and its first sample.
        let mut worst_from = None;
        for piece in whole.range.clone() {
            let range = pieces.components()[piece].range.clone();
            if let Some(worst) = of_pieces.attained
                && worst.interval.component == piece
            {
                worst_from = Some((range.start, start + indices.len()));
            }
            let here = &pieces.dense_indices()[range];
            // The end is the start of the piece that follows.
            let again = usize::from(split.meetings(piece)[1].is_some());
            indices.extend_from_slice(&here[..here.len() - again]);
        }
        let end = start + indices.len();
        if let (Some(worst), Some((of_piece, of_whole))) = (&mut attained, worst_from) {
            let index = |sample: usize| {
                let index = sample - of_piece + of_whole;
                if index < end { index } else { start }
            };
            worst.interval = Interval {
                component,
                samples: worst.interval.samples.map(|sample| sample.map(index)),
            };
        }
        let dense = of_pieces.measured.dense();
        samples.push_component(dense, indices.into_iter(), whole.closed);
        if whole.closed {
            samples.push_closing(ClosingInterval {
                component,
                holds: true,
            });
        }
    }
    Sampling {
        samples,
        attained,
        ..of_pieces
    }
}
