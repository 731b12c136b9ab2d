//! How good a reconstruction is, when the truth is known.
//!
//! | module | what it gives |
//! |---|---|
//! | [`edges`] | [`EdgeComparison`]: edges correct, missing and wrong against the manifold boundary |
//! | [`mod@hausdorff`] | [`Hausdorff`]: two-sided distance of a polygon and the smooth curve, between bounds |
//!
//! ```
//! use curvecrust_evaluate::EdgeComparison;
//! use curvecrust_geometry::{Edge, EdgeSet, PointId};
//!
//! let edge = |a, b| Edge::new(PointId::from(a), PointId::from(b)).unwrap();
//! let truth = EdgeSet::new(3, [edge(0, 1), edge(1, 2), edge(0, 2)]);
//! let found = EdgeSet::new(3, [edge(0, 1), edge(1, 2)]);
//! let comparison = EdgeComparison::new(&truth, &found);
//! assert_eq!(comparison.missing, [edge(0, 2)]);
//! assert!(comparison.wrong.is_empty() && !comparison.is_exact());
//! ```

pub mod edges;
pub mod hausdorff;

pub use edges::EdgeComparison;
pub use hausdorff::{Bounds, Hausdorff, hausdorff};
