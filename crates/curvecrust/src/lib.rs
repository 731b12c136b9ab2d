//! Curve reconstruction with many fewer samples.
//!
//! From a smooth curve to samples as sparse as a theorem allows, and from bare points back to the
//! curve: an implementation of S. Ohrhallinger, S. A. Mitchell, M. Wimmer, *Curve Reconstruction
//! with Many Fewer Samples*, SGP 2016. This crate re-exports the others; depend on one of them alone
//! if it is all you need.
//!
//! | module | what for |
//! |---|---|
//! | [`geometry`] | point sets, edge sets, chains, exact predicates |
//! | [`curve`] | smooth curves, from SVG or analytic, and their dense points |
//! | [`voronoi`] | Delaunay triangulation and Voronoi diagram |
//! | [`medial_axis`] | medial axis, local feature size, reach |
//! | [`sampling`] | samples under the epsilon and the rho condition |
//! | [`reconstruct`] | HNN-Crust, NN-Crust, Crust and their relatives |
//! | [`evaluate`] | edges against the truth, Hausdorff distance |
//!
//! From a curve to samples, and back:
//!
//! ```
//! use curvecrust::curve::Curve;
//! use curvecrust::evaluate::EdgeComparison;
//! use curvecrust::reconstruct::hnn_crust;
//! use curvecrust::sampling::{Condition, sample_curve};
//!
//! let d = "M 0 0 C 30 -20 50 20 80 0 S 120 40 80 60 S 30 30 0 60 S -30 20 0 0 Z";
//! let curve = Curve::from_path_data(d)?;
//! let samples = sample_curve(&curve, Condition::rho(0.9)?)?.samples;
//!
//! // What the reconstruction sees is bare points.
//! let edges = hnn_crust(&samples.point_set()?);
//! assert!(EdgeComparison::new(&samples.manifold_boundary(), &edges).is_exact());
//! assert!(edges.chains()[0].is_closed());
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

pub use curvecrust_curve as curve;
pub use curvecrust_evaluate as evaluate;
pub use curvecrust_geometry as geometry;
pub use curvecrust_medial_axis as medial_axis;
pub use curvecrust_reconstruct as reconstruct;
pub use curvecrust_sampling as sampling;
pub use curvecrust_voronoi as voronoi;

pub use glam::DVec2;
