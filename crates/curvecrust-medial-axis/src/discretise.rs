//! How a curve is made into dense points, and all that is measured on them.

use curvecrust_curve::{Curve, DenseCurve};

use crate::axis::MedialAxis;
use crate::crossing::{self, chord};
use crate::curvature;
use crate::error::MedialAxisError;
use crate::lfs::LocalFeatureSize;
use crate::shrinking_ball;

/// How dense points are chosen on a smooth curve.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Discretisation {
    /// As many points on every cubic segment, at equal steps of its parameter; 300 in the paper.
    PerSegment(u32),
    /// As many points as needed: the gap between neighbours is at most this fraction of the lfs at
    /// both of them, and of the radius of curvature. With the Voronoi estimator, the axis itself
    /// comes from points that may be a few times farther apart, which costs it little precision.
    Adaptive {
        /// The fraction, above 0 and at most 1.
        gap_to_lfs: f64,
    },
}

/// How lfs is estimated from dense points.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Estimator {
    /// The distance to the medial axis by the Voronoi diagram: see [`axis`](crate::axis).
    Voronoi,
    /// The distance to the authors' medial points: see [`shrinking_ball`].
    ShrinkingBall,
}

/// A discretised curve and the local feature size at each of its dense points.
#[derive(Clone, Debug)]
pub struct Measured {
    dense: DenseCurve,
    lfs: LocalFeatureSize,
}

impl Measured {
    /// Estimates the lfs of points that are dense already.
    ///
    /// # Errors
    /// With [`Estimator::Voronoi`], those of [`MedialAxis::new`], and
    /// [`TooCoarse`](MedialAxisError::TooCoarse) where a gap is not below twice the lfs found at its
    /// ends: then the points are no epsilon-sample for any epsilon < 1, and what was found is no lfs.
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
        Ok(Self { dense, lfs })
    }

    pub(crate) fn from_parts(dense: DenseCurve, lfs: LocalFeatureSize) -> Self {
        Self { dense, lfs }
    }

    fn by_shrinking_balls(dense: DenseCurve) -> Self {
        let lfs = shrinking_ball::lfs(&dense);
        Self { dense, lfs }
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

/// The number of points a segment that refinement starts from.
const START: u32 = 16;
/// A gap is split into at most so many parts at once: lfs on a coarse discretisation is a guess.
const SPLIT: f64 = 8.0;
/// The axis is computed from points up to so many times farther apart than those that lfs is wanted
/// at, ...
const AXIS_GAPS: f64 = 4.0;
/// ... but at most this fraction of their lfs: its error falls with the square of their gap.
const AXIS_RATIO: f64 = 0.05;
/// Curves nearer than this fraction of their extent count as touching.
pub(crate) const TOUCHING: f64 = 1e-7;
/// Rounds in which gaps that another part of the curve spans may remain most of all: curves that
/// lie on each other would be refined without end.
const OVERLAP_ROUNDS: usize = 6;

/// Discretises a curve and estimates its lfs. `progress` is told how many dense points there are, of about how many
/// that will be.
///
/// # Errors
/// [`GapToLfs`](MedialAxisError::GapToLfs), [`Dense`](MedialAxisError::Dense) for more points than
/// the limit, and where the curve crosses or touches itself or another, or is discretised too
/// coarsely to tell.
pub fn measure(
    curve: &Curve,
    discretisation: Discretisation,
    estimator: Estimator,
    progress: &dyn Fn(usize, usize),
) -> Result<Measured, MedialAxisError> {
    match discretisation {
        Discretisation::PerSegment(n) => {
            let dense = DenseCurve::per_segment(curve, n)?;
            progress(dense.len(), dense.len());
            Measured::new(dense, estimator)
        }
        Discretisation::Adaptive { gap_to_lfs } => {
            let refined = refine(curve, gap_to_lfs, progress)?;
            match estimator {
                Estimator::Voronoi => Ok(refined),
                Estimator::ShrinkingBall => Ok(Measured::by_shrinking_balls(refined.dense)),
            }
        }
    }
}

/// Splits gaps until none is longer than `ratio` of the lfs at its ends.
fn refine(
    curve: &Curve,
    ratio: f64,
    progress: &dyn Fn(usize, usize),
) -> Result<Measured, MedialAxisError> {
    let (axis, dense) = refine_axis(curve, ratio, progress)?;
    settle(curve, dense, ratio, progress, |dense| {
        Ok(LocalFeatureSize::new(dense, &axis))
    })
}

/// Splits gaps until none is longer than `ratio` of what `lfs` finds at its ends.
pub(crate) fn settle(
    curve: &Curve,
    mut dense: DenseCurve,
    ratio: f64,
    progress: &dyn Fn(usize, usize),
    lfs: impl Fn(&DenseCurve) -> Result<LocalFeatureSize, MedialAxisError>,
) -> Result<Measured, MedialAxisError> {
    loop {
        let found = lfs(&dense)?;
        let wanted = wanted(curve, &dense, &found, ratio);
        tell(progress, &wanted, 1.0);
        let pieces = pieces(&wanted);
        if pieces.iter().all(|&n| n == 1) {
            return Ok(Measured { dense, lfs: found });
        }
        dense = dense.refined(curve, &pieces)?;
    }
}

/// The medial axis, precise enough for points whose gaps are `ratio` of lfs, and the points that it is of.
pub(crate) fn refine_axis(
    curve: &Curve,
    ratio: f64,
    progress: &dyn Fn(usize, usize),
) -> Result<(MedialAxis, DenseCurve), MedialAxisError> {
    if !(ratio > 0.0 && ratio <= 1.0) {
        return Err(MedialAxisError::GapToLfs(ratio));
    }
    let coarse = ratio.max((AXIS_GAPS * ratio).min(AXIS_RATIO));
    let tell = |wanted: &[f64]| tell(progress, wanted, coarse / ratio);
    let (mut axis, dense) = coarse_axis(curve, coarse, &tell)?;
    axis.extend(curvature::centres_at_joins(curve, &dense, coarse));
    Ok((axis, dense))
}

/// The medial axis of points at most `ratio` of their lfs apart, and these.
fn coarse_axis(
    curve: &Curve,
    ratio: f64,
    tell: &dyn Fn(&[f64]),
) -> Result<(MedialAxis, DenseCurve), MedialAxisError> {
    let distance = TOUCHING * curve.extent();
    let mut dense = DenseCurve::per_segment(curve, START)?;
    let mut round = 0;
    loop {
        let (axis, spanning) = MedialAxis::with_spanning_gaps(&dense)?;
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
        let wanted = wanted(curve, &dense, &lfs, ratio);
        tell(&wanted);
        let mut pieces = pieces(&wanted);
        for gap in spanning {
            pieces[gap] = pieces[gap].max(2);
        }
        if pieces.iter().all(|&n| n == 1) {
            return Ok((axis, dense));
        }
        dense = dense.refined(curve, &pieces)?;
        round += 1;
    }
}

/// Into how many parts, 1 or more, the gap after each point would be split at once.
fn wanted(curve: &Curve, dense: &DenseCurve, lfs: &LocalFeatureSize, ratio: f64) -> Vec<f64> {
    (0..dense.len())
        .map(|i| {
            let Some(next) = dense.next(i) else {
                return 1.0;
            };
            let radius = curvature::least_radius(curve, dense.params()[i], dense.params()[next]);
            let allowed = ratio * lfs.at(i).min(lfs.at(next)).min(radius);
            (chord(dense, i).length() / allowed).ceil().max(1.0)
        })
        .collect()
}

/// Into how many parts each gap is to be split next.
fn pieces(wanted: &[f64]) -> Vec<u32> {
    let next = |&wanted: &f64| {
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "from 1 to a few"
        )]
        let next = wanted.min(SPLIT) as u32;
        next
    };
    wanted.iter().map(next).collect()
}

/// Tells how many points there are, of about how many: those wanted now, and `more` for each.
fn tell(progress: &dyn Fn(usize, usize), wanted: &[f64], more: f64) {
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "positive, and the cast saturates"
    )]
    let about = (wanted.iter().sum::<f64>() * more) as usize;
    progress(wanted.len(), about.max(wanted.len()));
}
