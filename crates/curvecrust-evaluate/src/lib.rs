//! How good a reconstruction is, where the true curve is known.
//!
//! | module | what it gives |
//! |---|---|
//! | [`edges`] | [`EdgeComparison`]: edges correct, missing and wrong against the manifold boundary |
//! | [`topology`] | [`Topology`]: closed, open and branching components, degrees |
//! | [`mod@hausdorff`] | [`Hausdorff`]: two-sided distance of a polygon and the smooth curve, between bounds |
//! | [`rms`] | [`RootMeanSquare`]: the same on average |
//! | [`distances`] | [`Distances`]: both of these |
//! | [`mod@reference`] | [`Reference`]: the true curve, prepared for the distances of many reconstructions |
//! | [`evaluation`] | [`Evaluation`]: all of these at once |
//! | [`metric`] | [`METRICS`]: the numbers in it |
//!
//! The metrics, from the list that tables and plots iterate; lengths are in extents of the curve:
//!
//! | name | what it is | unit | better | known |
//! |---|---|---|---|---|
//! | `exact` | 1 if exactly the edges of the manifold boundary were found, else 0 | share | higher | exact |
//! | `edge_precision` | how many of the edges found are true; 1 if none was found | share | higher | exact |
//! | `edge_recall` | how many of the true edges were found; 1 if there is none | share | higher | exact |
//! | `topology` | 1 if there are as many closed, open and branching components as there should be, else 0 | share | higher | exact |
//! | `closed_off` | closed components too many or too few | components | lower | exact |
//! | `open_off` | open components too many or too few | components | lower | exact |
//! | `degree_0` | vertices without an edge | vertices |  | exact |
//! | `degree_1` | vertices with one edge: ends | vertices |  | exact |
//! | `degree_2` | vertices with two edges | vertices |  | exact |
//! | `degree_3` | vertices with three edges or more: junctions | vertices |  | exact |
//! | `hausdorff` | the larger of the next two | extents | lower | between bounds |
//! | `hausdorff_curve` | the largest distance of a point of the curve to the output: what was missed | extents | lower | between bounds |
//! | `hausdorff_output` | the largest distance of a point of the output to the curve: what was made up | extents | lower | between bounds |
//! | `rms_curve` | the root mean square distance of the curve to the output | extents | lower | between bounds |
//! | `rms_output` | the root mean square distance of the output to the curve | extents | lower | between bounds |
//! | `min_angle` | the least angle between two edges at a vertex | degrees |  | exact |
//! | `run_time` | the time that the reconstruction took | s | lower | by a clock |
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

pub mod bounds;
pub mod distances;
pub mod edges;
pub mod evaluation;
pub mod hausdorff;
pub mod metric;
pub mod reference;
pub mod rms;
pub mod topology;

pub use bounds::Bounds;
pub use distances::Distances;
pub use edges::EdgeComparison;
pub use evaluation::{Evaluation, Kind, Output, Truth};
pub use hausdorff::{Hausdorff, hausdorff};
pub use metric::{Better, METRICS, Metric, Precision};
pub use reference::Reference;
pub use rms::RootMeanSquare;
pub use topology::Topology;

/// The example of the README is a test too.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
