//! Why a curve cannot be sampled, or samples not be judged.

use curvecrust_curve::DENSE_LIMIT;
use curvecrust_geometry::{DVec2, PointSetError};
use curvecrust_medial_axis::MedialAxisError;
use thiserror::Error;

/// The largest number of samples that are taken: samplers choose them from dense points.
pub const SAMPLE_LIMIT: u64 = DENSE_LIMIT as u64;

/// Why a curve cannot be sampled, or samples not be judged.
#[derive(Clone, Debug, Error, PartialEq)]
#[non_exhaustive]
pub enum SamplingError {
    /// Between two consecutive dense points the condition cannot be shown to hold, even if both
    /// were samples.
    #[error(
        "the gap of {gap:e} after dense point {index} at ({}, {}), where the local feature size is \
         {lfs:e}, is too long for the condition: discretise the curve more finely",
        at.x, at.y
    )]
    TooCoarse {
        /// Index of the dense point before the gap.
        index: usize,
        /// That point.
        at: DVec2,
        /// The distance to the next dense point.
        gap: f64,
        /// The smaller local feature size of the two.
        lfs: f64,
    },
    /// A bound, a limit or a step is so small that it asks for more samples than [`SAMPLE_LIMIT`],
    /// or for so many that they cannot be certified with [`DENSE_LIMIT`] dense points: each takes a
    /// few.
    #[error(
        "{what} is {value:e}, which asks for {} samples, too many for {DENSE_LIMIT} dense points, the most there \
         can be: take a larger one",
        about(*count)
    )]
    TooMany {
        /// What is too small.
        what: &'static str,
        /// How small it is.
        value: f64,
        /// About how many samples it asks for; `u64::MAX` stands for all that are more.
        count: u64,
    },
    /// A sample does not come after the one before it.
    #[error(
        "sample {index} does not come after sample {} on component {component}: give samples in the \
         order of the curve, component by component, and each once", index - 1
    )]
    OutOfOrder {
        /// Index of the sample.
        index: usize,
        /// Its component.
        component: usize,
    },
    /// Two samples have the same place on the curve.
    #[error(
        "samples {} and {} are at the same place of the curve, near ({}, {}): leave one of them out",
        samples[0], samples[1], at.x, at.y
    )]
    SamePlace {
        /// Their indices, ascending.
        samples: [usize; 2],
        /// The first of them.
        at: DVec2,
    },
    /// A sample names no place on the dense curve.
    #[error(
        "sample {index} is at no dense point and in no gap: its dense index is {dense}, t is {t}"
    )]
    NoSuchPlace {
        /// Index of the sample.
        index: usize,
        /// The dense index that it names.
        dense: usize,
        /// How far along the gap behind it.
        t: f64,
    },
    /// A sample is not on the curve.
    #[error(
        "sample {index} at ({}, {}) is {distance:e} from the curve, farther than the tolerance of {tolerance:e}",
        at.x, at.y
    )]
    OffCurve {
        /// Index of the sample.
        index: usize,
        /// The sample.
        at: DVec2,
        /// Its distance to the curve; NaN if it has a coordinate that is not finite.
        distance: f64,
        /// The largest distance that is taken.
        tolerance: f64,
    },
    /// The samples to begin with are not enough for the algorithm.
    #[error(
        "{algorithm} does not return the manifold boundary of the samples to begin with: take samples of a \
         condition that it is proven for"
    )]
    NotReconstructed {
        /// Its name.
        algorithm: &'static str,
    },
    /// The samples to begin with do not keep the limit of deviation.
    #[error(
        "after the sample at dense point {dense}, component {component} is too far from its chord: \
         begin with samples that keep the limit"
    )]
    LimitExceeded {
        /// Index of the component.
        component: usize,
        /// The dense point that is the sample before the interval.
        dense: usize,
    },
    /// A parameter is out of its range.
    #[error("{name} is {value}: it must be {range}")]
    Parameter {
        /// Which one.
        name: &'static str,
        /// What was given.
        value: f64,
        /// What is taken.
        range: &'static str,
    },
    /// Dots of a puzzle that the solver would not join as the curve does.
    #[error(
        "near ({}, {}) dots would be joined in another way than along the curve: give a larger margin \
         than {margin:e}",
        at.x, at.y
    )]
    NotSolved {
        /// One of the dots.
        at: DVec2,
        /// The margin that was asked for.
        margin: f64,
    },
    /// Samples that are no point set, such as two at one place where strokes touch.
    #[error(transparent)]
    Points(#[from] PointSetError),
    /// The curve has no local feature size that can be computed.
    #[error(transparent)]
    Measure(#[from] MedialAxisError),
}

impl SamplingError {
    /// Where curves cross or touch, if that is the error, as of
    /// [`MedialAxisError::touch`].
    #[must_use]
    pub fn touch(&self) -> Option<DVec2> {
        match self {
            Self::Measure(error) => error.touch(),
            _ => None,
        }
    }

    pub(crate) fn too_many(what: &'static str, value: f64, count: f64) -> Self {
        let count = count_of(count);
        Self::TooMany { what, value, count }
    }
}

/// How a count that may have been cut off is said.
fn about(count: u64) -> String {
    match count {
        u64::MAX => String::from("more than 10^19"),
        count => format!("about {count}"),
    }
}

/// A count that was computed as a double, which is not negative.
pub(crate) fn count_of(count: f64) -> u64 {
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "not negative, and the cast saturates"
    )]
    let count = count as u64;
    count
}
