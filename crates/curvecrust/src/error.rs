//! One error for all crates.

use crate::curve::{AnalyticError, CurveError, DenseError};
use crate::denoise::DenoiseError;
use crate::geometry::PointSetError;
use crate::medial_axis::MedialAxisError;
use crate::reconstruct::ReconstructError;
use crate::sampling::{ConditionError, SamplingError};
use crate::tiles::TilesError;
use thiserror::Error;

/// Any error of the libraries, to return from a function that calls several of them.
///
/// Its message is that of the error inside: the place, the value, and what to do.
///
/// ```
/// use curvecrust::curve::Curve;
///
/// fn count(d: &str) -> Result<usize, curvecrust::Error> {
///     let samples = curvecrust::sample(&Curve::from_path_data(d)?, 0.9)?;
///     Ok(curvecrust::reconstruct(samples.points())?.len())
/// }
/// assert_eq!(count("M 0 0 H 4 A 1 1 0 0 1 4 2 H 0 A 1 1 0 0 1 0 0 Z")?, 1);
/// assert_eq!(count("M 0 0 H 4 V 2 Z").unwrap_err().to_string().lines().count(), 1);
/// # Ok::<(), curvecrust::Error>(())
/// ```
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum Error {
    /// Points that are not finite, equal, or out of range.
    #[error(transparent)]
    Points(#[from] PointSetError),
    /// A drawing that is no smooth curve.
    #[error(transparent)]
    Curve(#[from] CurveError),
    /// Parameters that make no analytic curve.
    #[error(transparent)]
    Analytic(#[from] AnalyticError),
    /// A curve that asks for too many dense points.
    #[error(transparent)]
    Dense(#[from] DenseError),
    /// A curve whose local feature size cannot be measured.
    #[error(transparent)]
    MedialAxis(#[from] MedialAxisError),
    /// A bound or a limit that is out of range.
    #[error(transparent)]
    Condition(#[from] ConditionError),
    /// A curve that cannot be sampled as was asked.
    #[error(transparent)]
    Sampling(#[from] SamplingError),
    /// An index that is not that of a point.
    #[error("index {index} names no point: there are {count}")]
    NoSuchPoint {
        /// The index.
        index: usize,
        /// The number of points given.
        count: usize,
    },
    /// Knowledge about the curves that an algorithm cannot use, or that the points contradict.
    #[error(transparent)]
    Reconstruct(#[from] ReconstructError),
    /// Knowledge about noisy points that cannot be used.
    #[error(transparent)]
    Denoise(#[from] DenoiseError),
    /// Samples that make no tile.
    #[error(transparent)]
    Tiles(#[from] TilesError),
}
