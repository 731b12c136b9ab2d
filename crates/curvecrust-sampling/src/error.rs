//! Why a curve cannot be sampled, or samples not be judged.

use curvecrust_curve::Corner;
use curvecrust_geometry::DVec2;
use curvecrust_medial_axis::MedialAxisError;
use thiserror::Error;

/// The largest number of samples that are taken.
pub const SAMPLE_LIMIT: u64 = 10_000_000;

/// Why a curve cannot be sampled, or samples not be judged.
#[derive(Clone, Debug, Error, PartialEq)]
#[non_exhaustive]
pub enum SamplingError {
    /// Between two consecutive dense points the condition cannot be shown to hold, even if both were
    /// samples.
    #[error(
        "the gap of {gap:e} after dense point {index} at ({}, {}), where the local feature size is \
         {lfs:e}, is too long for the condition: measure with a smaller gap_to_lfs",
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
    /// The condition asks for more samples than [`SAMPLE_LIMIT`].
    #[error(
        "the Hausdorff limit asks for about {count} samples, and {SAMPLE_LIMIT} is the most: take a \
         larger limit"
    )]
    TooMany {
        /// About how many.
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
        "sample {index} is {distance:e} from the curve, farther than the tolerance of {tolerance:e}"
    )]
    OffCurve {
        /// Index of the sample.
        index: usize,
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
    /// Arms of corners meet at 60 degrees or less, which no sampling helps; every such corner is named.
    #[error(
        "{}: arms that meet at 60 degrees or less are not found by HNN-Crust from any samples, so round \
         these corners off",
        Corner::list(.0)
    )]
    SharpCorners(Vec<Corner>),
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
    /// The curve has no local feature size that can be computed.
    #[error(transparent)]
    Measure(#[from] MedialAxisError),
}
