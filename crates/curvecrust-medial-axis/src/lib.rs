//! Medial axis, local feature size (lfs) and reach of smooth plane curves, and the discretisation
//! that they are computed on.
//!
//! | module | what it gives | source |
//! |---|---|---|
//! | [`axis`] | [`MedialAxis`] of a discretised curve, from the Voronoi diagram of its points | Amenta, Bern, Eppstein 1998 |
//! | [`lfs`] | [`LocalFeatureSize`] of every dense point, and the [reach](LocalFeatureSize::reach) of intervals | SGP 2016, Section 4 and Definition 2 |
//! | [`shrinking_ball`] | the estimator of the paper's authors: one medial point for each dense point | Ma, Bae, Choi 2012 |
//! | [`measured_curve`] | [`MeasuredCurve`]: dense points and the lfs at each | |
//! | [`discretise`] | [`measure`]: as many dense points as the lfs asks for, and [`measure_axis`]: as few as the axis does | |
//! | [`pieces`] | [`measure_pieces`]: the lfs of smooth pieces that meet in corners, and [`strokes_of`] them | |
//!
//! ```
//! use curvecrust_curve::Curve;
//! use curvecrust_medial_axis::measure;
//!
//! // A stadium: two half circles of radius 1 joined by lines of length 4.
//! let d = "M 0 0 H 4 A 1 1 0 0 1 4 2 H 0 A 1 1 0 0 1 0 0 Z";
//! let curve = Curve::from_path_data(d)?;
//! let measured = measure(&curve)?;
//! // Its medial axis is the core segment: lfs is 1 everywhere.
//! assert!((measured.lfs().at(0) - 1.0).abs() < 1e-3);
//! assert!((measured.lfs().minimum() - 1.0).abs() < 1e-3);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

pub mod axis;
mod crossing;
mod curvature;
pub mod discretise;
pub mod error;
mod facing;
mod gaps;
mod ladder;
pub mod lfs;
mod maximal_disc;
pub mod measured_curve;
pub mod pieces;
mod refine;
pub mod shrinking_ball;
mod span;
mod strokes;

pub use axis::{AxisEdge, MedialAxis};
pub use discretise::{Discretisation, MeasureOptions, measure, measure_axis, measure_with};
pub use error::MedialAxisError;
pub use lfs::LocalFeatureSize;
pub use measured_curve::{Estimator, MeasuredCurve};
pub use pieces::{MeasurePiecesOptions, measure_pieces, measure_pieces_with};
pub use strokes::{strokes_of, without_lfs_at};

/// The example of the README is a test too.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
