//! Dense points of a curve, and the local feature size at each of them.

use std::sync::Arc;

use curvecrust_curve::{Curve, DenseCurve};
use curvecrust_geometry::{DVec2, Progress};

use crate::axis::MedialAxis;
use crate::crossing::{self, chord};
use crate::curvature;
use crate::error::MedialAxisError;
use crate::gaps::GapLimits;
use crate::lfs::LocalFeatureSize;
use crate::shrinking_ball;

/// How dense points are chosen on a smooth curve.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Discretisation {
    /// The same number of points on every cubic segment, at equal steps of its parameter. The
    /// program of the paper's authors takes 300; the paper itself names no number.
    PerSegment(u32),
    /// As many points as needed: the gap between neighbours is at most this fraction of the lfs at
    /// both of them, and of the radius of curvature. With the Voronoi estimator, the axis itself
    /// comes from points that may be a few times farther apart, which costs it little precision.
    Adaptive {
        /// The fraction, above 0 and at most 1.
        gap_to_lfs: f64,
    },
}

/// Gaps of at most 0.02 of the lfs.
impl Default for Discretisation {
    fn default() -> Self {
        Self::Adaptive {
            gap_to_lfs: GAP_TO_LFS,
        }
    }
}

/// The largest gap between dense points as a fraction of lfs, where none is given.
pub(crate) const GAP_TO_LFS: f64 = 0.02;

/// How lfs is estimated from dense points.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Estimator {
    /// The distance to the medial axis by the Voronoi diagram: see [`axis`](crate::axis).
    #[default]
    Voronoi,
    /// The distance to the authors' medial points: see [`shrinking_ball`].
    ShrinkingBall,
}

/// A discretised curve and the local feature size at each of its dense points. Clones share both.
#[derive(Clone, Debug, PartialEq)]
pub struct MeasuredCurve {
    dense: Arc<DenseCurve>,
    lfs: Arc<LocalFeatureSize>,
}

/// How [`measure_with`] goes about it.
#[derive(Clone, Copy, Debug, Default)]
pub struct MeasureOptions<'a> {
    /// How dense points are chosen; adaptively, with gaps of at most 0.02 of lfs, by default.
    pub discretisation: Discretisation,
    /// Where adaptive gaps would make more than 250,000 dense points, gaps grow up to this
    /// fraction of lfs, if it is the larger one; 0 by default, which keeps them.
    pub gap_to_lfs_of_many: f64,
    /// How lfs is estimated; from the Voronoi diagram by default.
    pub estimator: Estimator,
    /// Hears how many dense points there are, of about how many that will be.
    pub progress: Progress<'a>,
}

impl MeasuredCurve {
    /// Estimates the lfs of points that are dense already.
    ///
    /// # Errors
    /// With [`Estimator::Voronoi`], those of [`MedialAxis::new`], and
    /// [`TooCoarse`](MedialAxisError::TooCoarse) where a gap is not below twice the lfs found at
    /// its ends: then the points are no epsilon-sample for any epsilon < 1, and what was found is
    /// no lfs.
    pub fn new(dense: DenseCurve, estimator: Estimator) -> Result<Self, MedialAxisError> {
        let lfs = match estimator {
            Estimator::Voronoi => LocalFeatureSize::new(&dense, &MedialAxis::new(&dense)?),
            Estimator::ShrinkingBall => return Ok(Self::by_shrinking_balls(dense)),
        };
        for i in 0..dense.len() {
            let Some(next) = dense.next(i) else { continue };
            let gap = chord(&dense, i);
            if gap.length() >= 2.0 * lfs.at(i).min(lfs.at(next)) {
                return Err(MedialAxisError::too_coarse(gap));
            }
        }
        Ok(Self::from_parts(dense, lfs))
    }

    pub(crate) fn from_parts(dense: DenseCurve, lfs: LocalFeatureSize) -> Self {
        Self {
            dense: Arc::new(dense),
            lfs: Arc::new(lfs),
        }
    }

    fn by_shrinking_balls(dense: DenseCurve) -> Self {
        let lfs = shrinking_ball::lfs(&dense);
        Self::from_parts(dense, lfs)
    }

    /// The dense points.
    #[must_use]
    pub fn dense(&self) -> &DenseCurve {
        &self.dense
    }

    /// The lfs at each of them.
    #[must_use]
    pub fn lfs(&self) -> &LocalFeatureSize {
        &self.lfs
    }
}

/// The number of points a segment that refinement starts from, ...
const START: u32 = 16;
/// ... and of one that is straight and short: an arc is many of them.
const LEAST_START: u32 = 2;
/// A segment that turns by this angle, in radians, is not straight, ...
const TURN: f64 = 0.5;
/// ... and one of this share of the extent of the curve is not short.
const LENGTH: f64 = 0.125;
/// The most parts that a gap is split into at once: lfs on a coarse discretisation is a guess.
const SPLIT: f64 = 8.0;
/// Curves nearer than this fraction of their extent count as touching.
pub(crate) const TOUCHING: f64 = 1e-7;
/// Rounds in which gaps that another part of the curve spans may remain most of all: curves that
/// lie on each other would be refined without end.
const OVERLAP_ROUNDS: usize = 6;

/// Discretises a curve with gaps of at most 0.02 of its lfs, which it estimates from the Voronoi
/// diagram.
///
/// # Errors
/// Those of [`measure_with`].
///
/// ```
/// use curvecrust_curve::Curve;
/// use curvecrust_medial_axis::measure;
///
/// let circle = Curve::from_path_data("M 2 0 A 2 2 0 0 1 -2 0 A 2 2 0 0 1 2 0 Z")?;
/// let measured = measure(&circle)?;
/// assert!((measured.lfs().minimum() - 2.0).abs() < 1e-3);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn measure(curve: &Curve) -> Result<MeasuredCurve, MedialAxisError> {
    measure_with(curve, &MeasureOptions::default())
}

/// Discretises a curve and estimates its lfs, by the given [options](MeasureOptions).
///
/// # Errors
/// [`GapToLfs`](MedialAxisError::GapToLfs), [`Dense`](MedialAxisError::Dense) for more points than
/// the limit, and where the curve crosses or touches itself or another, or is discretised too
/// coarsely to tell.
///
/// ```
/// use curvecrust_curve::Curve;
/// use curvecrust_medial_axis::{Discretisation, MeasureOptions, measure_with};
///
/// let arch = Curve::from_path_data("M 0 0 C 0 4 6 4 6 0")?;
/// let discretisation = Discretisation::PerSegment(300);
/// let options = MeasureOptions { discretisation, ..MeasureOptions::default() };
/// assert_eq!(measure_with(&arch, &options)?.dense().len(), 301);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn measure_with(
    curve: &Curve,
    options: &MeasureOptions<'_>,
) -> Result<MeasuredCurve, MedialAxisError> {
    let MeasureOptions {
        discretisation,
        gap_to_lfs_of_many,
        estimator,
        progress,
    } = *options;
    match discretisation {
        Discretisation::PerSegment(n) => {
            let dense = DenseCurve::per_segment(curve, n)?;
            progress.report(dense.len(), dense.len());
            MeasuredCurve::new(dense, estimator)
        }
        Discretisation::Adaptive { gap_to_lfs } => {
            let refined = refine(
                curve,
                GapLimits::new(gap_to_lfs, gap_to_lfs_of_many)?,
                progress,
            )?;
            match estimator {
                Estimator::Voronoi => Ok(refined),
                Estimator::ShrinkingBall => {
                    let dense = Arc::unwrap_or_clone(refined.dense);
                    Ok(MeasuredCurve::by_shrinking_balls(dense))
                }
            }
        }
    }
}

/// Splits gaps until none is longer than what is allowed at its ends.
fn refine(
    curve: &Curve,
    gaps: GapLimits,
    progress: Progress<'_>,
) -> Result<MeasuredCurve, MedialAxisError> {
    let (axis, coarse) = refine_axis(curve, gaps, progress)?;
    // What lfs was found to be decides at once on most of the points.
    let (wanted, _) = parts(curve, coarse.dense(), coarse.lfs(), gaps);
    let dense = coarse.dense().refined(curve, &pieces(&wanted))?;
    settle(curve, dense, gaps, progress, |dense| {
        Ok(LocalFeatureSize::new(dense, &axis))
    })
}

/// Splits gaps until none is longer than what is allowed by what `lfs` finds at its ends.
pub(crate) fn settle(
    curve: &Curve,
    mut dense: DenseCurve,
    gaps: GapLimits,
    progress: Progress<'_>,
    lfs: impl Fn(&DenseCurve) -> Result<LocalFeatureSize, MedialAxisError>,
) -> Result<MeasuredCurve, MedialAxisError> {
    loop {
        let found = lfs(&dense)?;
        let (parts, _) = parts(curve, &dense, &found, gaps);
        report(progress, &parts, 1.0);
        let pieces = pieces(&parts);
        if pieces.iter().all(|&n| n == 1) {
            return Ok(MeasuredCurve::from_parts(dense, found));
        }
        dense = dense.refined(curve, &pieces)?;
    }
}

/// The medial axis, precise enough for points with these gaps, and the points that it is of, with
/// an lfs that takes no account yet of the centres of curvature at joins.
pub(crate) fn refine_axis(
    curve: &Curve,
    gaps: GapLimits,
    progress: Progress<'_>,
) -> Result<(MedialAxis, MeasuredCurve), MedialAxisError> {
    let coarse = gaps.of_axis();
    let more = gaps.times_more_than(coarse);
    coarse_axis(curve, coarse, &|parts| report(progress, parts, more))
}

/// The medial axis of points with these gaps, and the points with their lfs.
fn coarse_axis(
    curve: &Curve,
    gaps: GapLimits,
    report: &dyn Fn(&[f64]),
) -> Result<(MedialAxis, MeasuredCurve), MedialAxisError> {
    let distance = TOUCHING * curve.extent();
    let mut dense = start(curve)?;
    let mut round = 0;
    loop {
        let (mut axis, spanning) = MedialAxis::with_spanning_gaps(&dense)?;
        if let Some(crossing) = crossing::of_curve(curve, &dense, &spanning) {
            return Err(crossing);
        }
        let lfs = LocalFeatureSize::new(&dense, &axis);
        let overlapping = round >= OVERLAP_ROUNDS && 2 * spanning.len() > dense.len();
        let hopeless = |&i: &usize| overlapping || chord(&dense, i).length() < distance;
        if let Some(gap) = spanning.iter().copied().find(hopeless) {
            let touching = MedialAxisError::Touching {
                at: dense.points()[gap],
                distance,
            };
            return Err(crossing::find(&dense, &[gap]).unwrap_or(touching));
        }
        if spanning.is_empty()
            && let Some(i) = (0..dense.len()).find(|&i| lfs.at(i) < distance)
        {
            let at = dense.points()[i];
            return Err(MedialAxisError::Touching { at, distance });
        }
        let (parts, allowed) = parts(curve, &dense, &lfs, gaps);
        report(&parts);
        let mut pieces = pieces(&parts);
        for gap in spanning {
            pieces[gap] = pieces[gap].max(2);
        }
        if pieces.iter().all(|&n| n == 1) {
            axis.extend(curvature::centres_at_joins(curve, &dense, allowed));
            return Ok((axis, MeasuredCurve::from_parts(dense, lfs)));
        }
        dense = dense.refined(curve, &pieces)?;
        round += 1;
    }
}

/// The points that refinement starts from.
fn start(curve: &Curve) -> Result<DenseCurve, MedialAxisError> {
    let ends = DenseCurve::per_segment(curve, 1)?;
    let long = LENGTH * curve.extent();
    let pieces = ends.params().iter().map(|at| {
        let path = &curve.components()[at.component as usize];
        let [a, b, c, d] = path.segments()[at.segment as usize].control_points();
        let arms = [b - a, c - b, d - c];
        let length: f64 = arms.iter().map(|arm| arm.length()).sum();
        let turns = arms.windows(2).map(|pair| match pair {
            // An arm without length turns with the next one.
            &[a, b] if a != DVec2::ZERO && b != DVec2::ZERO => a.angle_to(b).abs(),
            _ => TURN,
        });
        let share = (turns.sum::<f64>() / TURN).max(length / long).min(1.0);
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "from 0 to 16"
        )]
        let pieces = (share * f64::from(START)).ceil() as u32;
        pieces.max(LEAST_START)
    });
    let pieces: Vec<u32> = pieces.collect();
    Ok(ends.refined(curve, &pieces)?)
}

/// Into how many parts, 1 or more, the gap after each point would be split at once, and the
/// fraction of lfs that is allowed.
fn parts(
    curve: &Curve,
    dense: &DenseCurve,
    lfs: &LocalFeatureSize,
    gaps: GapLimits,
) -> (Vec<f64>, f64) {
    let gap_to_lfs = |i| {
        let Some(next) = dense.next(i) else {
            return 0.0;
        };
        let radius = curvature::least_radius(curve, dense.params()[i], dense.params()[next]);
        chord(dense, i).length() / lfs.at(i).min(lfs.at(next)).min(radius)
    };
    let mut parts: Vec<f64> = (0..dense.len()).map(gap_to_lfs).collect();
    let allowed = gaps.allowed(parts.iter().sum());
    for part in &mut parts {
        *part = (*part / allowed).ceil().max(1.0);
    }
    (parts, allowed)
}

/// Into how many parts each gap is to be split next.
fn pieces(parts: &[f64]) -> Vec<u32> {
    let next = |&parts: &f64| {
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "from 1 to a few"
        )]
        let next = parts.min(SPLIT) as u32;
        next
    };
    parts.iter().map(next).collect()
}

/// Reports how many points there are, of about how many: the parts of their gaps, and `more` for
/// each.
fn report(progress: Progress<'_>, parts: &[f64], more: f64) {
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "positive, and the cast saturates"
    )]
    let about = (parts.iter().sum::<f64>() * more) as usize;
    progress.report(parts.len(), about.max(parts.len()));
}
