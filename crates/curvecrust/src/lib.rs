//! Points in, ordered curves out; and smooth curves sampled as sparsely as a theorem allows.
//!
//! ```
//! let points = [[0.0, 0.0], [1.0, 1.0], [1.0, 0.0], [0.0, 1.0]];
//! for curve in curvecrust::reconstruct(points)? {
//!     println!("{} {:?}", curve.is_closed(), curve.points());
//! }
//! # Ok::<(), curvecrust::Error>(())
//! ```
//!
//! [`reconstruct`](fn@reconstruct) takes anything that iterates over points and returns [`Curves`]:
//! each an open or closed [`Polyline`] with its points in order, their indices in the input, and
//! how closed ones lie inside each other. [`reconstruct_with`] takes [`ReconstructOptions`]:
//! another algorithm, what is known about the curves, equal points.
//!
//! [`sample`] goes the other way: it takes a smooth curve and returns samples that are enough to
//! reconstruct it. For closed curves and rho < 0.888, HNN-Crust is proven to do so:
//!
//! ```
//! use curvecrust::curve::Curve;
//!
//! let curve = Curve::from_path_data("M 0 0 C 30 -20 50 20 80 0 S 120 40 80 60 S -30 20 0 0 Z")?;
//! let samples = curvecrust::sample(&curve, 0.888)?;
//! let curves = curvecrust::reconstruct(samples.points())?;
//! assert!(curves.polylines()[0].is_closed());
//! # Ok::<(), curvecrust::Error>(())
//! ```
//!
//! This crate implements S. Ohrhallinger, S. A. Mitchell, M. Wimmer, *Curve Reconstruction with
//! Many Fewer Samples*, SGP 2016, and goes beyond it. It re-exports the crates that do the work;
//! depend on one of them alone if it is all you need:
//!
//! | module | what for |
//! |---|---|
//! | [`geometry`] | point sets, edge sets, chains, exact predicates |
//! | [`curve`] | smooth curves, from SVG or analytic, and their dense points |
//! | [`voronoi`] | Delaunay triangulation and Voronoi diagram |
//! | [`medial_axis`] | medial axis, local feature size, reach |
//! | [`sampling`] | samples under the epsilon and the rho condition, and how good given samples are |
//! | [`mod@reconstruct`] | least detour, HNN-Crust, NN-Crust, Crust and their relatives |
//! | [`denoise`] | smooth curves through points that scatter about them, outliers aside |
//! | [`tiles`] | HNN-Crust and NN-Crust on more points than memory holds |
//! | [`evaluate`] | edges against the truth, Hausdorff distance |
//!
//! # Features
//! All are off by default: `geo-types` (its points in, polygons with holes and lines out), `mint`
//! (its points in) and `serde` (results as data).

mod curves;
mod error;
#[cfg(feature = "geo-types")]
mod geo;
mod points;
mod sample;

pub use curvecrust_curve as curve;
pub use curvecrust_denoise as denoise;
pub use curvecrust_evaluate as evaluate;
pub use curvecrust_geometry as geometry;
pub use curvecrust_medial_axis as medial_axis;
pub use curvecrust_reconstruct as reconstruct;
pub use curvecrust_sampling as sampling;
pub use curvecrust_tiles as tiles;
pub use curvecrust_voronoi as voronoi;
pub use glam;

pub use curves::{Curves, Polyline, ReconstructOptions, reconstruct, reconstruct_with};
pub use error::Error;
pub use glam::DVec2;
pub use points::IntoPoint;
pub use sample::sample;

/// The example of the README is a test too.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
