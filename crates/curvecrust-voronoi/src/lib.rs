//! Delaunay triangulation and Voronoi diagram of a [`PointSet`], through
//! [spade](https://docs.rs/spade).
//!
//! The only crate that names spade: others see [`Delaunay`], its triangles, and its edges with
//! their duals ([`DualEdge`]), in [`PointId`]s of the set. Points are inserted in biased randomised
//! order ([`brio_order`]), which keeps the cost near-linear even for dense points along one
//! curve, where other orders go near-quadratic.
//!
//! [`PointSet`]: curvecrust_geometry::PointSet
//! [`PointId`]: curvecrust_geometry::PointId

pub mod delaunay;
pub mod order;

pub use delaunay::{Delaunay, DualEdge};
pub use order::brio_order;

/// The example of the README is a test too.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
