//! Smooth plane curves as chains of cubic Béziers, from SVG or analytic, and their discretisation.
//!
//! These curves are the ground truth: samples are taken from them, and reconstructions are compared
//! with them.
//!
//! | module | types | what they promise |
//! |---|---|---|
//! | [`curve`] | [`Curve`], [`CurveParam`] | smooth, finite, every join exactly tangent |
//! | [`split`] | [`SplitCurve`] | curves with corners, as smooth pieces |
//! | [`strands`](mod@strands) | [`Strands`] | strokes that touch or cross, cut apart there |
//! | [`bezier_path`] | [`BezierPath`] | one open or closed path |
//! | [`bezier`] | [`CubicBezier`] | points, derivatives, tangents |
//! | [`dense`] | [`DenseCurve`] | dense points with their parameters, in curve order |
//! | [`svg`] | | what is read from documents, and what is refused |
//! | [`analytic`] | [`analytic::Ellipse`], ... | dense points and local feature size in closed form |
//! | [`error`] | [`CurveError`], [`Corner`], [`DenseError`], [`AnalyticError`] | the place, and what to do |
//!
//! Points are [`glam::DVec2`].

pub mod analytic;
pub mod bezier;
pub mod bezier_path;
pub mod curve;
pub mod dense;
pub mod error;
mod path_data;
mod smooth;
pub mod split;
pub mod strands;
pub mod svg;

pub use bezier::CubicBezier;
pub use bezier_path::BezierPath;
pub use curve::{Curve, CurveParam};
pub use dense::DenseCurve;
pub use error::{AnalyticError, Corner, CurveError, DENSE_LIMIT, DenseError};
pub use split::SplitCurve;
pub use strands::{Strands, strands};

/// The example of the README is a test too.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
