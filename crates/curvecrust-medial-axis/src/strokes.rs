//! Curves with corners as whole strokes, for those who look at points of any origin.

use curvecrust_curve::{BezierPath, CurveParam, DenseCurve, SplitCurve};
use curvecrust_geometry::{Component, DVec2};

use crate::error::MedialAxisError;
use crate::lfs::LocalFeatureSize;
use crate::measured_curve::MeasuredCurve;

/// The strokes of a curve, of which each smooth piece [was measured](crate::measure_pieces): the
/// components of the dense curve are those of the [strokes](SplitCurve::components), and a corner
/// is one point.
///
/// With respect to a whole stroke lfs is 0 at a corner. Here it is what the pieces have: at the
/// corner the smaller value of both. So a condition can hold on the intervals beside a corner, if
/// it is a sample.
///
/// # Errors
/// [`MedialAxisError::Dense`] if the measured curve is not that of these pieces.
///
/// ```
/// use curvecrust_curve::SplitCurve;
/// use curvecrust_medial_axis::{measure_pieces, strokes_of};
///
/// let bar = SplitCurve::from_path_data("M 0 0 H 10 V 1 H 0 Z")?;
/// let strokes = strokes_of(&bar, &measure_pieces(&bar)?)?;
/// assert_eq!(strokes.dense().components().len(), 1);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn strokes_of(
    split: &SplitCurve,
    measured: &MeasuredCurve,
) -> Result<MeasuredCurve, MedialAxisError> {
    let (mut points, mut params, mut values) = (Vec::new(), Vec::<CurveParam>::new(), Vec::new());
    let mut components = Vec::with_capacity(split.components().len());
    let dense = measured.dense();
    for (component, stroke) in (0u32..).zip(split.components()) {
        let start = points.len();
        let mut segments = 0;
        for piece in stroke.range.clone() {
            let range = dense
                .components()
                .get(piece)
                .map_or(0..0, |c| c.range.clone());
            // The last point of a piece is the first of the one that follows.
            let is_open = stroke.len() > 1 && (stroke.closed || piece + 1 < stroke.range.end);
            for i in range.start..range.end - usize::from(is_open && !range.is_empty()) {
                let at = dense.params()[i];
                points.push(dense.points()[i]);
                params.push(CurveParam {
                    component,
                    segment: at.segment + segments,
                    t: at.t,
                });
                let mut lfs = measured.lfs().at(i);
                if i == range.start
                    && let Some((before, _)) = split.meetings(piece)[0]
                    && let Some(before) = dense.components().get(before)
                {
                    lfs = lfs.min(measured.lfs().at(before.range.end - 1));
                }
                values.push(lfs);
            }
            let path = split.pieces().components().get(piece);
            segments += path.map_or(0, segment_count);
        }
        components.push(Component {
            range: start..points.len(),
            closed: stroke.closed,
        });
    }
    let dense = DenseCurve::new(points, params, components)?;
    Ok(MeasuredCurve::from_parts(
        dense,
        LocalFeatureSize::from_values(values),
    ))
}

/// The same curves with lfs 0 at the dense points that are at some corners: those that are no
/// samples, so that no condition holds beside them.
#[must_use]
pub fn without_lfs_at(measured: &MeasuredCurve, corners: &[DVec2]) -> MeasuredCurve {
    if corners.is_empty() {
        return measured.clone();
    }
    let points = measured.dense().points().iter();
    let values = points
        .zip(measured.lfs().values())
        .map(|(p, &lfs)| if corners.contains(p) { 0.0 } else { lfs });
    MeasuredCurve::from_parts(
        measured.dense().clone(),
        LocalFeatureSize::from_values(values.collect()),
    )
}

fn segment_count(path: &BezierPath) -> u32 {
    u32::try_from(path.segments().len()).unwrap_or(u32::MAX)
}
