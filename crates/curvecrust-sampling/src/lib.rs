//! Sampling of smooth plane curves, as sparsely as a reconstruction theorem allows.
//!
//! The epsilon-samples of N. Amenta, M. Bern, D. Eppstein, GMIP 1998, and the reach-based
//! rho-samples of S. Ohrhallinger, S. A. Mitchell, M. Wimmer, *Curve Reconstruction with Many Fewer
//! Samples*, SGP 2016.
//!
//! | module | what it gives | source |
//! |---|---|---|
//! | [`condition`] | [`Condition`]: epsilon or rho, with an optional Hausdorff limit | Definitions 1 and 3 |
//! | [`certified`] | [`sample`]: the default; the condition holds at every point of the curve | |
//! | [`fewest`] | [`sample_fewest`]: certified, from the best of all starts | |
//! | [`pieces`] | [`sample_split`]: certified on each smooth piece of a curve with corners | |
//! | [`decoded`] | [`sample_decoded`]: the same, as many as an algorithm needs to return them | |
//! | [`verified`] | [`sample_verified`]: as few as an algorithm still reconstructs, without guarantee | |
//! | [`closest_dot`] | [`sample_puzzle`]: dots in colours by which each finds the next | Löffler et al. 2014 |
//! | [`mod@check`] | [`check()`], [`effective_epsilon`], [`effective_rho`]: how good given samples are | Definitions 1 and 3 |
//! | [`uneven`] | [`sample_uniformly`]: equal lengths of arc; [`sample_unevenly`]: shorter steps at random | |
//! | [`noise`] | [`with_noise`], [`with_outliers`]: samples with errors | |
//! | [`placed`] | [`PlacedSamples`]: samples of any origin, by their places on a curve | |
//! | [`dense_points`] | [`sample_at_dense_points`], and [`sample_as_published`] as the authors' program does it: tested at dense points only | Section 8.2 |
//! | [`sampling`] | [`Sampling`]: what every sampler returns | |
//! | [`sampled_curve`] | [`SampledCurve`]: samples in curve order, and the [manifold boundary](SampledCurve::manifold_boundary) | Section 4 |
//! | [`error`] | [`SamplingError`]: the place, and what to do | |
//! | [`theory`] | what the bounds imply: angles, sample counts, distances | Lemmas 8 to 10, Theorem 1, Table 1 |
//!
//! ```
//! use curvecrust_curve::Curve;
//! use curvecrust_medial_axis::measure;
//! use curvecrust_sampling::{Condition, sample};
//!
//! let d = "M 0 0 H 4 A 1 1 0 0 1 4 2 H 0 A 1 1 0 0 1 0 0 Z";
//! let curve = Curve::from_path_data(d)?;
//! let measured = measure(&curve)?;
//! let sparse = sample(&measured, Condition::rho(0.9)?)?.samples;
//! let dense = sample(&measured, Condition::epsilon(1.0 / 3.0)?)?.samples;
//! assert!(2 * sparse.len() < dense.len());
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod arcs;
pub mod certified;
pub mod check;
pub mod closest_dot;
pub mod condition;
pub mod decoded;
pub mod dense_points;
pub mod error;
pub mod fewest;

pub mod noise;
pub mod on_pieces;
pub mod pieces;
pub mod placed;
pub mod sampled_curve;
pub mod sampling;
mod slack;
pub mod strokes;
pub mod theory;
pub mod uneven;
pub mod verified;

pub use certified::{sample, sample_curve, sample_curve_with};
pub use check::{Attained, Interval, Verdict, check, effective_epsilon, effective_rho};
pub use closest_dot::{Puzzle, PuzzleOptions, sample_puzzle};
pub use condition::{Bound, Condition, ConditionError, DeviationLimit};
pub use decoded::{DecodeOptions, Decoded, decode, sample_decoded, sample_decoded_with};
pub use dense_points::{sample_as_published, sample_at_dense_points};
pub use error::{SAMPLE_LIMIT, SamplingError};
pub use fewest::{sample_fewest, sample_fewest_with};
pub use noise::{Noise, NoiseShape, NoiseSize, Outliers, with_noise, with_outliers};
pub use on_pieces::{OnPieces, project_on_pieces};
pub use pieces::{SplitOptions, sample_pieces, sample_split, sample_split_with};
pub use placed::{PlacedSamples, Placement, Projected};
pub use sampled_curve::{ClosingInterval, SampledCurve};
pub use sampling::{SampleOptions, Sampling};
pub use strokes::on_strokes;
pub use uneven::{UnevenOptions, sample_unevenly, sample_unevenly_with, sample_uniformly};
pub use verified::{VerifyOptions, sample_verified, sample_verified_with};

/// The example of the README is a test too.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
