//! Samples of curves with corners, placed on their smooth pieces: a corner is on two of them.

use super::super::curve_source::MeasuredStrokes;
use curvecrust::DVec2;
use curvecrust::medial_axis::{MeasuredCurve, without_lfs_at};
use curvecrust::sampling::{PlacedSamples, Placement, SamplingError};

/// Samples on pieces.
pub(super) struct OnPieces {
    /// The pieces; at corners without a sample their local feature size is 0.
    pub(super) measured: MeasuredCurve,
    pub(super) samples: PlacedSamples,
    /// For each sample the index of the point that it was.
    pub(super) indices: Vec<usize>,
    /// The corners without a sample.
    pub(super) missed: Vec<DVec2>,
}

/// Projects points to pieces. The point nearest to a corner, if it is within the tolerance, is the
/// sample there.
pub(super) fn place(
    strokes: &MeasuredStrokes,
    points: &[DVec2],
    tolerance: f64,
) -> Result<OnPieces, SamplingError> {
    let projected = PlacedSamples::project(&strokes.pieces, points, tolerance)?;
    let placements = projected.samples.placements().iter().copied();
    let mut placed: Vec<(Placement, usize)> = placements.zip(projected.indices).collect();
    let mut missed = Vec::new();
    let dense = strokes.pieces.dense();
    for (piece, component) in dense.components().iter().enumerate() {
        let Some((after, corner)) = strokes.split.meetings(piece)[1] else {
            continue;
        };
        let nearest = points.iter().enumerate();
        let nearest = nearest.min_by(|(_, p), (_, q)| {
            p.distance_squared(corner)
                .total_cmp(&q.distance_squared(corner))
        });
        match nearest.filter(|(_, p)| p.distance(corner) <= tolerance) {
            None => missed.push(corner),
            Some((index, &point)) => {
                placed.retain(|&(_, of)| of != index);
                let start = dense.components().get(after).map(|c| c.range.start);
                for dense in [Some(component.range.end - 1), start].into_iter().flatten() {
                    let t = 0.0;
                    placed.push((Placement { point, dense, t }, index));
                }
            }
        }
    }
    placed.sort_by(|(a, _), (b, _)| {
        (a.dense, a.t)
            .partial_cmp(&(b.dense, b.t))
            .unwrap_or(std::cmp::Ordering::Equal)
    });
    let measured = without_lfs_at(&strokes.pieces, &missed);
    let (placements, indices) = placed.into_iter().unzip();
    Ok(OnPieces {
        samples: PlacedSamples::new(&measured, placements)?,
        measured,
        indices,
        missed,
    })
}
