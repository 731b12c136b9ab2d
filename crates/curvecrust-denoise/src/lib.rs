//! From noisy points to the smooth curves they scatter about.
//!
//! Points that people measure scatter about their curve, and some belong to none. [`denoise`] finds
//! how far they scatter, which of them belong to a curve, and splines through the middle of these,
//! each with its standard error. Nothing has to be known: neither the noise nor a distance, nor how
//! many curves there are. [`Options`] take what is known.
//!
//! ```
//! use curvecrust_denoise::denoise;
//! use curvecrust_geometry::{DVec2, PointSet, Random};
//!
//! let mut random = Random::new(1);
//! let points = (0..300).map(|i| {
//!     let x = f64::from(i) / 50.0;
//!     DVec2::new(x, x.sin() + 0.05 * random.normal())
//! });
//! let fitted = denoise(&PointSet::new(points.collect())?);
//! assert_eq!(fitted.curves.len(), 1);
//! assert!(!fitted.curves[0].closed);
//! # Ok::<(), curvecrust_geometry::PointSetError>(())
//! ```
//!
//! # The steps
//! 1. The scale of each point: its smallest neighbourhood that is not round, by an exact test.
//! 2. The band: points that enough of the windows about them support, denser than the background.
//! 3. Their places on robust local parabolas, thinned; least detour joins them into chains.
//! 4. A penalised spline to each chain, smoothed by cross validation, with robust weights and a
//!    deviation that may vary along the curve.
//! 5. Curves are cut where points do not carry them and joined where they do, as long as the
//!    likelihood, less the degrees of freedom and ends times log n, grows.
//! 6. All this at several scales, as curves of any number and as one closed curve, and once from an
//!    ellipse; the same score chooses.
//! 7. Curves that explain the points no better than points spread evenly do are none.
//! 8. If points lie on the curves of least detour as they are, they are clean: the result is that.

mod area;
mod band;
mod candidates;
mod chain;
mod clean;
mod convert;
mod corners;
mod denoise;
mod ellipse;
mod error;
mod evidence;
mod fitted;
mod known;
mod model;
mod options;
mod refine;
mod robust;
mod scale;
mod spline;
mod tree;
mod window;

pub use denoise::{denoise, denoise_with};
pub use error::DenoiseError;
pub use fitted::{Fitted, FittedCurve, Place, polyline};
pub use options::Options;

/// The example of the README is a test too.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
