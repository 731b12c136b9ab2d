//! Curve reconstruction from bare points: HNN-Crust, NN-Crust, Crust and their relatives, and least
//! detour, which goes beyond them.
//!
//! An algorithm sees points and nothing else: neither the curve that they were sampled from nor
//! its medial axis. All of them keep one contract ([`Reconstructor`]) and stand in one list
//! ([`ALGORITHMS`]), from which this table is checked:
//!
//! | name | source | claimed correct for closed smooth curves with | cost | termini |
//! |---|---|---|---|---|
//! | [`least-detour`] | The curvecrust authors: docs/method.md of this project. 2026 | none known | O(n log n) | yes |
//! | [`hnn-crust`] | Ohrhallinger, Mitchell, Wimmer: Curve Reconstruction with Many Fewer Samples. SGP 2016 | rho < 0.9 (proven for rho < 0.678, false from rho = 0.895), epsilon < 0.47 (proven for epsilon < 0.404) | O(n log n) | yes |
//! | [`hnn-crust-union`] | Ohrhallinger, Mitchell, Wimmer: Curve Reconstruction with Many Fewer Samples. SGP 2016 | rho < 0.9 (proven for rho < 0.678, false from rho = 0.895), epsilon < 0.47 (proven for epsilon < 0.404) | O(n log n) | yes |
//! | [`nn-crust`] | Dey, Kumar: A Simple Provable Algorithm for Curve Reconstruction. SODA 1999 | epsilon < 0.333 | O(n log n) | no |
//! | [`crust`] | Amenta, Bern, Eppstein: The Crust and the beta-Skeleton: Combinatorial Curve Reconstruction. GMIP 1998 | epsilon < 0.252 | O(n log n) | no |
//! | [`one-step-crust`] | Gold, Snoeyink: A One-Step Crust and Skeleton Extraction Algorithm. Algorithmica 2001 | none known | O(n log n) | no |
//! | [`beta-skeleton`] | Kirkpatrick, Radke: A Framework for Computational Morphology. 1985 | epsilon < 0.297 | O(n log n) | no |
//! | [`gabriel`] | Gabriel, Sokal: A New Statistical Approach to Geographic Variation Analysis. Systematic Zoology 1969 | none known | O(n log n) | no |
//! | [`sphere-of-influence`] | Toussaint: A Graph-Theoretical Primal Sketch. 1988 | none known | O(n log n) | no |
//!
//! [`least-detour`]: mod@least_detour
//! [`hnn-crust`]: mod@hnn_crust
//! [`hnn-crust-union`]: mod@hnn_crust
//! [`nn-crust`]: mod@nn_crust
//! [`crust`]: mod@crust
//! [`one-step-crust`]: mod@one_step_crust
//! [`beta-skeleton`]: mod@beta_skeleton
//! [`gabriel`]: mod@beta_skeleton
//! [`sphere-of-influence`]: mod@sphere_of_influence
//!
//! Each algorithm is also a function of its own, such as [`hnn_crust()`] or [`one_step_crust()`],
//! which returns a [`Skeleton`] with an estimate of the local feature size. A [`Reconstruction`]
//! orders edges into curves and rings inside rings; a [`ViolationReport`] shows where the sampling
//! was too sparse.
//!
//! ```
//! use curvecrust_geometry::{DVec2, PointSet};
//! use curvecrust_reconstruct::{HnnCrust, Reconstruction};
//!
//! let wave = (0..50).map(|i| DVec2::new(f64::from(i), 5.0 * (f64::from(i) / 5.0).sin()));
//! let points = PointSet::new(wave.collect())?;
//! let found = Reconstruction::by(&HnnCrust::MUTUAL, &points);
//! assert_eq!(found.chains().len(), 1);
//! assert_eq!(found.chains()[0].chain.vertices().len(), 50);
//! # Ok::<(), curvecrust_geometry::PointSetError>(())
//! ```

pub mod algorithm;
pub mod algorithms;
pub mod beta_skeleton;
mod constrained;
pub mod crust;
mod delaunay_edges;
mod detour;
pub mod error;
mod exact;
pub mod explanation;
mod frame;
pub mod hnn_crust;
pub mod known;
pub mod least_detour;
pub mod neighbours;
pub mod nn_crust;
pub mod one_step_crust;
mod pencil;
pub mod reconstruction;
mod rings;
pub mod skeleton;
pub mod sphere_of_influence;
mod subtended_angle;
mod termini;
mod tour;
pub mod violations;
mod voronoi_vertex;
mod voronoi_vertices;

pub use algorithm::{AlgorithmInfo, Guarantee, Reconstructor, SamplingBound, Standing};
pub use algorithms::ALGORITHMS;
pub use beta_skeleton::{Beta, BetaSkeleton, beta_skeleton};
pub use crust::{Crust, crust};
pub use error::ReconstructError;
pub use explanation::{ExplainedEdge, Explanation, FreeEnd, Reason, Rejected};
pub use hnn_crust::{HnnCrust, hnn_crust};
pub use known::{Known, Shape};
pub use least_detour::{LeastDetour, least_detour};
pub use neighbours::Keep;
pub use nn_crust::{NnCrust, nn_crust};
pub use one_step_crust::{CrustAndSkeleton, OneStepCrust, one_step_crust};
pub use reconstruction::{NestedChain, Reconstruction};
pub use skeleton::{Skeleton, SkeletonEdge, SkeletonEnd};
pub use sphere_of_influence::{SphereOfInfluence, sphere_of_influence};
pub use violations::{Joint, ViolationReport};

/// The example of the README is a test too.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
