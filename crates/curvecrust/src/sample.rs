//! From a smooth curve to samples.

use crate::curve::Curve;
use crate::error::Error;
use crate::sampling::{Condition, SampledCurve, sample_curve};

/// Samples a smooth curve as sparsely as the rho condition allows.
///
/// Every point of the curve between two consecutive samples is nearer to one of them than rho times
/// the smallest local feature size between them (SGP 2016, Definition 3). This is certified for the
/// whole curve, not only for some of its points. The samples are in order along each component;
/// both ends of an open component are samples.
///
/// From the samples of closed curves, [HNN-Crust] returns exactly the polygon in curve order. This
/// project proves it for rho below 0.888; the paper claims it for rho below 0.9, but there are
/// curves on which it fails from 0.8950 on. For the epsilon condition and other ways to sample, see
/// [`sampling`](crate::sampling).
///
/// [HNN-Crust]: crate::reconstruct::hnn_crust()
///
/// ```
/// use curvecrust::curve::Curve;
///
/// // A stadium: two half circles of radius 1 joined by lines of length 4.
/// let curve = Curve::from_path_data("M 0 0 H 4 A 1 1 0 0 1 4 2 H 0 A 1 1 0 0 1 0 0 Z")?;
/// let samples = curvecrust::sample(&curve, 0.895)?;
/// assert!(samples.len() < 12);
/// # Ok::<(), curvecrust::Error>(())
/// ```
///
/// # Errors
/// [`Error::Condition`] for a rho that is not above 0 and at most 1; [`Error::Sampling`] for a
/// curve that crosses or touches itself, and where the bound asks for too many samples.
pub fn sample(curve: &Curve, rho: f64) -> Result<SampledCurve, Error> {
    Ok(sample_curve(curve, Condition::rho(rho)?)?.samples)
}
