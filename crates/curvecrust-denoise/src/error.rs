//! Why no curves can be fitted as asked.

use curvecrust_reconstruct::ReconstructError;
use thiserror::Error;

/// What is known about the curves contradicts the points, or itself.
#[derive(Clone, Debug, Error, PartialEq)]
#[non_exhaustive]
pub enum DenoiseError {
    /// The given deviation is no length.
    #[error("sigma is {sigma}: give a finite length of 0 or more, or none")]
    Sigma {
        /// The value given.
        sigma: f64,
    },
    /// Points that are clean have no curves as they are known to be.
    #[error(transparent)]
    Reconstruct(#[from] ReconstructError),
}
