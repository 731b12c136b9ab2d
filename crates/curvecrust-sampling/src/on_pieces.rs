//! Samples of curves with corners, placed on their smooth pieces: a corner is on two of them.

use curvecrust_curve::SplitCurve;
use curvecrust_geometry::DVec2;
use curvecrust_medial_axis::{MeasuredCurve, without_lfs_at};

use crate::error::SamplingError;
use crate::placed::{PlacedSamples, Placement};

/// Samples on the smooth pieces of a curve, by [`project_on_pieces`].
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct OnPieces {
    /// The pieces; at corners without a sample their local feature size is 0.
    pub measured: MeasuredCurve,
    /// The samples in the order of the pieces; one at a corner is there twice.
    pub samples: PlacedSamples,
    /// For each of these the index of the point that it was.
    pub indices: Vec<usize>,
    /// The corners without a sample.
    pub missed: Vec<DVec2>,
}

/// Projects bare points, in any order, to the nearest places of the measured pieces of a curve. The
/// point nearest to a corner, if it is within the tolerance, is the sample there, on both pieces
/// that meet in it.
///
/// So [`check`](crate::check()) finds the condition violated beside a corner without a sample, and
/// looks at both of its arms with respect to the pieces beside one with a sample.
///
/// # Errors
/// Those of [`PlacedSamples::project`].
///
/// ```
/// use curvecrust_curve::SplitCurve;
/// use curvecrust_geometry::DVec2;
/// use curvecrust_medial_axis::measure_pieces;
/// use curvecrust_sampling::project_on_pieces;
///
/// let square = SplitCurve::from_path_data("M 0 0 H 4 V 4 H 0 Z")?;
/// let corners = [[4.0, 4.0], [0.0, 0.0], [4.0, 0.0]].map(DVec2::from);
/// let found = project_on_pieces(&square, &measure_pieces(&square)?, &corners, 1e-3)?;
/// assert_eq!(found.missed, [DVec2::new(0.0, 4.0)]);
/// assert_eq!(found.indices, [1, 2, 2, 0, 0, 1]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn project_on_pieces(
    split: &SplitCurve,
    pieces: &MeasuredCurve,
    points: &[DVec2],
    tolerance: f64,
) -> Result<OnPieces, SamplingError> {
    let projected = PlacedSamples::project(pieces, points, tolerance)?;
    let placements = projected.samples.placements().iter().copied();
    let mut placed: Vec<(Placement, usize)> = placements.zip(projected.indices).collect();
    let mut missed = Vec::new();
    let dense = pieces.dense();
    for (piece, component) in dense.components().iter().enumerate() {
        let Some((after, corner)) = split.meetings(piece)[1] else {
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
    placed.sort_by(|(a, _), (b, _)| a.dense.cmp(&b.dense).then(a.t.total_cmp(&b.t)));
    let measured = without_lfs_at(pieces, &missed);
    let (placements, indices) = placed.into_iter().unzip();
    Ok(OnPieces {
        samples: PlacedSamples::new(&measured, placements)?,
        measured,
        indices,
        missed,
    })
}
