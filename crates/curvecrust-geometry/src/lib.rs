//! The types that all crates of curvecrust share: points, edges, chains, and exact predicates.
//!
//! | module | types | what they promise |
//! |---|---|---|
//! | [`point_set`] | [`PointSet`] | finite, distinct points that exact predicates can carry |
//! | [`merged_points`] | [`MergedPoints`] | points of which several may stand for one |
//! | [`point_id`] | [`PointId`] | the index of a point in its set |
//! | [`edge_set`] | [`EdgeSet`], [`Edge`] | sorted, unique, undirected edges |
//! | [`component`] | [`Component`] | points in order along a curve that is open or closed |
//! | [`chains`] | [`Chain`] | maximal paths and rings that cover every edge once |
//! | [`segment`] | [`Segment`] | closest point and distance |
//! | [`segment_tree`] | [`SegmentTree`] | the nearest of many segments |
//! | [`predicates`] | [`orient2d`], [`in_circle`] | signs without rounding error |
//! | [`progress`] | [`Progress`] | a listener to long tasks |
//! | [`similarity`] | [`Similarity`] | to the unit box and back |
//! | [`random`] | [`Random`] | seeded numbers, the same on every machine |
//!
//! Points are [`glam::DVec2`]; [`glam`] is re-exported, so that a user has the same version of it.
//!
//! # Features
//! Both are off by default: `serde` reads and writes the types as data, and checks what it reads;
//! `mint` lets glam take points and vectors of mint 0.5, and [`PointSet::from_points`] with it.

pub mod chains;
pub mod component;
#[cfg(feature = "serde")]
mod data;
pub mod edge_set;
mod hilbert;
pub mod interrupt;
pub mod merged_points;
#[doc(hidden)]
pub mod parallel;
pub mod point_id;
pub mod point_set;
pub mod predicates;
pub mod progress;
mod radix;
pub mod random;
pub mod segment;
pub mod segment_tree;
pub mod similarity;
mod spatial_order;

pub use chains::Chain;
pub use component::Component;
pub use edge_set::{Edge, EdgeSet};
pub use glam::{self, DVec2};
pub use interrupt::{Interrupt, Interrupted};
pub use merged_points::MergedPoints;
pub use point_id::PointId;
pub use point_set::{PointSet, PointSetError};
pub use predicates::{in_circle, orient2d};
pub use progress::Progress;
pub use random::Random;
pub use segment::Segment;
pub use segment_tree::SegmentTree;
pub use similarity::Similarity;

/// The example of the README is a test too.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
