//! Samples of smooth pieces as samples of the strokes that the pieces are cut from.

use curvecrust_curve::SplitCurve;
use curvecrust_medial_axis::strokes_of;

use crate::arcs::Arcs;
use crate::error::SamplingError;
use crate::sampled_curve::SampledCurve;
use crate::sampling::Sampling;

/// The samples that [`sample_split`](crate::sample_split) or
/// [`sample_decoded`](crate::sample_decoded) took of a curve with corners, on its
/// [whole strokes](strokes_of): the measured curve has a component for each stroke, and a corner is
/// one dense point. The value attained is that of intervals of strokes, over corners too.
///
/// # Errors
/// [`Measure`](SamplingError::Measure) if the samples are not of this curve.
///
/// ```
/// use curvecrust_curve::SplitCurve;
/// use curvecrust_sampling::{Condition, VerifyOptions, on_strokes, sample_split};
/// use curvecrust_sampling::sample_verified_with;
///
/// let square = SplitCurve::from_path_data("M 0 0 H 4 V 4 H 0 Z")?;
/// let samples = on_strokes(&square, &sample_split(&square, Condition::rho(0.5)?)?)?;
/// assert_eq!(samples.measured.dense().components().len(), 1);
///
/// // HNN-Crust needs no more than the corners.
/// let corners: Vec<_> = square.corners().iter().map(|corner| corner.at).collect();
/// let options = VerifyOptions { fixed: &corners, ..VerifyOptions::default() };
/// assert_eq!(sample_verified_with(&samples, &options)?.samples.len(), 4);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn on_strokes(split: &SplitCurve, sampling: &Sampling) -> Result<Sampling, SamplingError> {
    let measured = strokes_of(split, &sampling.measured)?;
    let dense = sampling.measured.dense();
    // For each piece its dense points, and where these begin among those of the strokes.
    let mut pieces = Vec::with_capacity(dense.components().len());
    let mut start = 0;
    for (piece, component) in dense.components().iter().enumerate() {
        pieces.push((component.range.clone(), start));
        // The end of a piece is the start of the one that follows.
        let again = usize::from(split.meetings(piece)[1].is_some());
        start += component.range.len() - again;
    }
    let on_stroke = |index: usize| {
        let (range, start) = &pieces[dense.component_of(index)];
        start + index - range.start
    };
    let mut samples = SampledCurve::default();
    for component in sampling.samples.components() {
        let here = &sampling.samples.dense_indices()[component.range.clone()];
        let here = here.iter().map(|&index| on_stroke(index));
        samples.push_component(measured.dense(), here, component.closed);
    }
    for &interval in sampling.samples.closing_intervals() {
        samples.push_closing(interval);
    }
    let arcs = Arcs::of(&measured);
    Ok(Sampling::new(&measured, &arcs, samples, sampling.condition))
}
