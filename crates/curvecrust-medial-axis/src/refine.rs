//! Dense points that are refined until their gaps are short enough.

use curvecrust_curve::{Curve, DenseCurve};
use curvecrust_geometry::{DVec2, Progress};

use crate::axis::MedialAxis;
use crate::crossing::{self, chord};
use crate::curvature;
use crate::error::MedialAxisError;
use crate::facing::Facing;
use crate::gaps::GapLimits;
use crate::ladder::facing_points;
use crate::lfs::LocalFeatureSize;
use crate::measured_curve::MeasuredCurve;

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
/// Where the axis asks for more points than this, near strands get points that face each other, ...
const MANY: f64 = 20_000.0;
/// ... once their number has settled or so many rounds have passed, ...
const ROUNDS_TO_KNOW: usize = 2;
/// ... and if they are fewer by at least this factor.
const FEWER: f64 = 16.0;

/// Splits gaps until none is longer than what is allowed at its ends.
pub(crate) fn refine(
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
    let (mut axis, measured) = axis(curve, coarse, progress, more)?;
    let (_, allowed) = parts(curve, measured.dense(), measured.lfs(), coarse);
    axis.extend(curvature::centres_at_joins(
        curve,
        measured.dense(),
        allowed,
    ));
    Ok((axis, measured))
}

/// The medial axis of points with these gaps, and the points with their lfs. Long strands that are
/// near each other have points with longer gaps, which face each other. Progress counts `more`
/// points for each of them.
pub(crate) fn axis(
    curve: &Curve,
    gaps: GapLimits,
    progress: Progress<'_>,
    more: f64,
) -> Result<(MedialAxis, MeasuredCurve), MedialAxisError> {
    let mut points = Facing::none(start(curve)?);
    let (mut is_plain, mut asked_before) = (true, 0.0);
    let mut round = 0;
    loop {
        let dense = &points.dense;
        let (axis, spanning) = MedialAxis::with_spanning_gaps(dense)?;
        let lfs = LocalFeatureSize::new(dense, &axis);
        if let Some(error) = refusal(curve, dense, &lfs, &spanning, round) {
            return Err(error);
        }
        let (parts, allowed) = parts(curve, dense, &lfs, gaps);
        report(progress, &parts, more);
        let asked: f64 = parts.iter().sum();
        let is_known = asked < 2.0 * asked_before || round >= ROUNDS_TO_KNOW;
        asked_before = asked;
        if is_plain && is_known && asked > MANY && !has_tip(curve, dense) {
            is_plain = false;
            #[expect(
                clippy::cast_possible_truncation,
                clippy::cast_sign_loss,
                reason = "positive, and the cast saturates"
            )]
            let most = (asked / FEWER) as usize;
            if let Some(facing) = facing_points(curve, &start(curve)?, allowed, most)? {
                points = facing;
                continue;
            }
        }
        let mut pieces = pieces(&parts);
        for &gap in &spanning {
            pieces[gap] = pieces[gap].max(2);
        }
        points.keep(&mut pieces, &spanning, &lfs);
        if pieces.iter().all(|&n| n == 1) {
            return Ok((axis, MeasuredCurve::from_parts(points.dense, lfs)));
        }
        points = points.refined(curve, &pieces)?;
        round += 1;
    }
}

/// Why the curve has no medial axis, if dense points tell: some of their gaps may be spanned by
/// another part of the curve.
fn refusal(
    curve: &Curve,
    dense: &DenseCurve,
    lfs: &LocalFeatureSize,
    spanning: &[usize],
    round: usize,
) -> Option<MedialAxisError> {
    if let Some(crossing) = crossing::of_curve(curve, dense, spanning) {
        return Some(crossing);
    }
    let distance = TOUCHING * curve.extent();
    let touching = |i: usize| {
        let at = dense.points()[i];
        MedialAxisError::Touching { at, distance }
    };
    let overlapping = round >= OVERLAP_ROUNDS && 2 * spanning.len() > dense.len();
    let hopeless = |&i: &usize| overlapping || chord(dense, i).length() < distance;
    if let Some(gap) = spanning.iter().copied().find(hopeless) {
        return Some(crossing::find(dense, &[gap]).unwrap_or_else(|| touching(gap)));
    }
    let mut points = 0..dense.len();
    let near = points.find(|&i| spanning.is_empty() && lfs.at(i) < distance);
    near.map(touching)
}

/// Whether the curve bends so sharply somewhere that lfs will be too small there.
fn has_tip(curve: &Curve, dense: &DenseCurve) -> bool {
    let gaps = (0..dense.len()).filter_map(|i| Some((i, dense.next(i)?)));
    let mut radii = gaps.map(|gap| least_radius(curve, dense, gap));
    radii.any(|radius| radius < TOUCHING * curve.extent())
}

/// The least radius of curvature between two dense points.
fn least_radius(curve: &Curve, dense: &DenseCurve, (from, to): (usize, usize)) -> f64 {
    curvature::least_radius(curve, dense.params()[from], dense.params()[to])
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
        let radius = least_radius(curve, dense, (i, next));
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
