//! What the page shows where a request has no result.

use curvecrust::curve::CurveError;
use curvecrust::medial_axis::MedialAxisError;
use curvecrust::reconstruct::ReconstructError;
use curvecrust::sampling::{ConditionError, SamplingError};
use thiserror::Error;

/// Why a request has no result, in words for the reader of the page.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum Error {
    /// The bytes are no message.
    #[error("the page sent a message that is none: reload it")]
    Message,
    /// The header is no request.
    #[error("the page sent a request that is none ({0}): reload it")]
    Request(#[from] serde_json::Error),
    /// No algorithm has this name.
    #[error("no algorithm is called {0}")]
    Algorithm(String),
    /// Samples were asked for before a curve.
    #[error("there is no curve yet: choose a drawing or draw one")]
    NoCurve,
    /// More points than the page takes.
    #[error("{0} points are more than the {1} that this page takes: use the program")]
    TooMany(usize, usize),
    /// A file that holds no points, and why.
    #[error("{0}")]
    File(String),
    /// What the libraries refuse.
    #[error(transparent)]
    Library(#[from] curvecrust::Error),
}

macro_rules! from_library {
    ($($error:ty),*) => {$(
        impl From<$error> for Error {
            fn from(error: $error) -> Self {
                Self::Library(error.into())
            }
        }
    )*};
}

from_library!(
    CurveError,
    MedialAxisError,
    ReconstructError,
    ConditionError,
    SamplingError,
    curvecrust::geometry::PointSetError
);
