//! Samples of curves with corners that an algorithm is seen to return.
//!
//! No theorem covers corners. But an algorithm can be run: where it does not return exactly the
//! manifold boundary, the bound is tightened, and all pieces get more samples.

use curvecrust_curve::SplitCurve;
use curvecrust_geometry::{Component, EdgeSet, PointSet};
use curvecrust_reconstruct::{LeastDetour, Reconstructor};

use crate::condition::Condition;
use crate::error::SamplingError;
use crate::pieces::sample_split_with;
use crate::sampling::{SampleOptions, Sampling};

/// What the bound is multiplied by, as long as the samples are not returned.
const TIGHTER: f64 = 0.8;
/// The bound does not fall below this share of the one that was asked for.
const LEAST_SHARE: f64 = 0.1;

/// Samples, and whether an algorithm returns exactly their manifold boundary.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Decoded {
    /// The samples. They keep the condition that was asked for, and perhaps a tighter one.
    pub sampling: Sampling,
    /// Whether the algorithm returns exactly their manifold boundary. If not, the samples are those
    /// of the condition that was asked for.
    pub is_exact: bool,
    /// How many more samples these are than the condition asks for.
    pub added: usize,
}

/// Options of [`sample_decoded_with`].
#[derive(Clone, Copy, Debug)]
pub struct DecodeOptions<'a> {
    /// The algorithm that has to return the manifold boundary; least detour by default.
    pub decoder: &'a dyn Reconstructor,
    /// Those of each sampling.
    pub sampling: SampleOptions<'a>,
}

impl Default for DecodeOptions<'_> {
    fn default() -> Self {
        Self {
            decoder: &LeastDetour,
            sampling: SampleOptions::default(),
        }
    }
}

/// Samples the pieces of a curve as [`sample_split`](crate::sample_split) does, by the largest
/// bound with which least detour returns exactly the manifold boundary of the samples: that of the
/// condition, else 0.8 times it, and so on down to a tenth.
///
/// Where components are [apart](SplitCurve::apart), they may touch and cross, where no algorithm
/// for curves returns all of them together: each is looked at by itself.
///
/// ```
/// use curvecrust_curve::SplitCurve;
/// use curvecrust_sampling::{Condition, sample_decoded};
///
/// // Angles of 45, 90 and 45 degrees.
/// let triangle = SplitCurve::from_path_data("M 0 0 H 4 V 4 Z")?;
/// let found = sample_decoded(&triangle, Condition::rho(0.9)?)?;
/// assert!(found.is_exact);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// Those of [`sample_split`](crate::sample_split).
pub fn sample_decoded(split: &SplitCurve, condition: Condition) -> Result<Decoded, SamplingError> {
    sample_decoded_with(split, condition, &DecodeOptions::default())
}

/// [`sample_decoded`] by the given [options](DecodeOptions), by their algorithm.
///
/// # Errors
/// Those of [`sample_decoded`].
pub fn sample_decoded_with(
    split: &SplitCurve,
    condition: Condition,
    options: &DecodeOptions<'_>,
) -> Result<Decoded, SamplingError> {
    let asked = sample_split_with(split, condition, &options.sampling)?;
    let is_returned = |sampling: &Sampling| {
        if split.is_apart() {
            each_is_returned(sampling, options.decoder)
        } else {
            is_returned(sampling, options.decoder)
        }
    };
    if is_returned(&asked) {
        return Ok(Decoded {
            sampling: asked,
            is_exact: true,
            added: 0,
        });
    }
    let mut share = TIGHTER;
    while share >= LEAST_SHARE {
        let tighter = condition.with_value(share * condition.bound().value());
        // It may ask for too many samples, where the first did not.
        let Ok(sampling) = sample_split_with(split, tighter, &options.sampling) else {
            break;
        };
        if is_returned(&sampling) {
            return Ok(Decoded {
                added: sampling.samples.len().saturating_sub(asked.samples.len()),
                sampling: Sampling {
                    condition: Some(condition),
                    ..sampling
                },
                is_exact: true,
            });
        }
        share *= TIGHTER;
    }
    Ok(Decoded {
        sampling: asked,
        is_exact: false,
        added: 0,
    })
}

/// Whether the algorithm returns the manifold boundary; not where samples of two pieces are at one
/// place.
fn is_returned(sampling: &Sampling, decoder: &dyn Reconstructor) -> bool {
    let samples = &sampling.samples;
    let points = samples.point_set();
    points.is_ok_and(|points| decoder.reconstruct(&points) == samples.manifold_boundary())
}

/// Whether the algorithm returns the polygon of each component from its samples alone.
fn each_is_returned(sampling: &Sampling, decoder: &dyn Reconstructor) -> bool {
    let samples = &sampling.samples;
    samples.components().iter().all(|component| {
        let here = samples.points()[component.range.clone()].to_vec();
        let count = here.len();
        let Ok(points) = PointSet::new(here) else {
            return false;
        };
        let range = 0..count;
        let closed = component.closed;
        let polygon = EdgeSet::new(count, Component { range, closed }.edges());
        decoder.reconstruct(&points) == polygon
    })
}
