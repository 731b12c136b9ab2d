//! Curve reconstruction from bare points: HNN-Crust, NN-Crust, Crust and their relatives, and least
//! detour, which goes beyond them.
//!
//! An algorithm sees points and nothing else: neither the curve that they were sampled from nor
//! its medial axis. All of them keep one contract ([`Reconstructor`]) and stand in one list
//! ([`ALGORITHMS`]), from which this table is checked:
//!
//! | name | source | claimed correct for closed smooth curves with | made for curves | cost | can use |
//! |---|---|---|---|---|---|
//! | [`least-detour`] | The curvecrust authors: docs/method.md of this project. 2026 | none known | closed, open, several, corners | O(n log n) | shape, number, termini |
//! | [`hnn-crust`] | Ohrhallinger, Mitchell, Wimmer: Curve Reconstruction with Many Fewer Samples. SGP 2016 | rho < 0.9 (proven for rho < 0.888, false from rho = 0.895), epsilon < 0.47 | closed, open, several, corners | O(n log n) | termini |
//! | [`hnn-crust-union`] | Ohrhallinger, Mitchell, Wimmer: Curve Reconstruction with Many Fewer Samples. SGP 2016 | rho < 0.9 (proven for rho < 0.888, false from rho = 0.895), epsilon < 0.47 | closed, open, several, corners | O(n log n) | termini |
//! | [`nn-crust`] | Dey, Kumar: A Simple Provable Algorithm for Curve Reconstruction. SODA 1999 | epsilon < 0.333 | closed, several | O(n log n) | nothing |
//! | [`crust`] | Amenta, Bern, Eppstein: The Crust and the beta-Skeleton: Combinatorial Curve Reconstruction. GMIP 1998 | epsilon < 0.252 | closed, several | O(n log n) | nothing |
//! | [`one-step-crust`] | Gold, Snoeyink: A One-Step Crust and Skeleton Extraction Algorithm. Algorithmica 2001 | none known | closed, several | O(n log n) | nothing |
//! | [`beta-skeleton`] | Kirkpatrick, Radke: A Framework for Computational Morphology. 1985 | epsilon < 0.297 | closed, several | O(n log n) | nothing |
//! | [`gabriel`] | Gabriel, Sokal: A New Statistical Approach to Geographic Variation Analysis. Systematic Zoology 1969 | none known | closed, several | O(n log n) | nothing |
//! | [`normalised-mesh`] | Attali: r-Regular Shape Reconstruction from Unorganized Points. SoCG 1997 | none known | closed, several | O(n log n) | nothing |
//! | [`alpha-shape`] | Edelsbrunner, Kirkpatrick, Seidel: On the Shape of a Set of Points in the Plane. 1983 | none known | closed, several | O(n log n) | nothing |
//! | [`sphere-of-influence`] | Toussaint: A Graph-Theoretical Primal Sketch. 1988 | none known | closed, several | O(n log n) | nothing |
//! | [`spanning-tree`] | Figueiredo, Gomes: Computational Morphology of Curves. The Visual Computer 1994 | none known | open, corners | O(n log n) | shape, number |
//! | [`conservative-crust`] | Dey, Mehlhorn, Ramos: Curve Reconstruction: Connecting Dots with Good Reason. SoCG 1999 (argued) | none known | closed, open, several | O(n log n) | nothing |
//! | [`gathan-like`] | after Dey, Wenger: Reconstructing Curves with Sharp Corners. Computational Geometry 2001 (argued) | none known | closed, several, corners | O(n log n) | nothing |
//! | [`gathan-g-like`] | after Dey, Wenger: Fast Reconstruction of Curves with Sharp Corners. IJCGA 2002 (argued) | none known | closed, several, corners | O(n log n) | nothing |
//! | [`lenz-like`] | after Lenz: How to Sample and Reconstruct Curves with Unusual Features. EuroCG 2006 (argued) | none known | closed, open, several, crossings | O(n log n) | nothing |
//! | [`discur`] | Zeng, Nguyen, Yan, Li: A Distance-Based Parameter Free Algorithm for Curve Reconstruction. CAD 2008 | none known | closed, open, several, corners | O(n log n) | nothing |
//! | [`vicur-like`] | after Nguyen, Zeng: VICUR. Robotics and Computer-Integrated Manufacturing 2008 (argued) | none known | closed, open, several | O(n log n) | nothing |
//! | [`crawl`] | Parakkat, Muthuganapathy: Crawl through Neighbors. SGP 2016 (argued) | none known | closed, open, several, corners | O(n log n) | nothing |
//! | [`peel`] | Parakkat, Methirumangalath, Muthuganapathy: Peeling the Longest. Computers & Graphics 2018 (argued) | none known | closed, several, corners | O(n log n) | nothing |
//! | [`connect2d`] | Ohrhallinger, Mudur: An Efficient Algorithm for Determining an Aesthetic Shape Connecting Unorganized 2D Points. CGF 2013 (argued) | none known | closed, corners | O(n log n) | nothing |
//! | [`sig-connect2d`] | Marin, Ohrhallinger, Wimmer: SIGDT: 2D Curve Reconstruction. Pacific Graphics 2022 (argued) | none known | closed, several, corners | O(n log n) | nothing |
//! | [`shortest-tour`] | Giesen: Curve Reconstruction, the Traveling Salesman Problem and Menger's Theorem on Length. SoCG 1999 | none known | closed, corners | O(n log n) and a search | shape, number |
//!
//! Argued: the publication was not available, and the definition follows what others wrote of it.
//! Each module says what is sure of it.
//!
//! [`least-detour`]: mod@least_detour
//! [`hnn-crust`]: mod@hnn_crust
//! [`hnn-crust-union`]: mod@hnn_crust
//! [`nn-crust`]: mod@nn_crust
//! [`crust`]: mod@crust
//! [`one-step-crust`]: mod@one_step_crust
//! [`beta-skeleton`]: mod@beta_skeleton
//! [`gabriel`]: mod@beta_skeleton
//! [`normalised-mesh`]: mod@normalised_mesh
//! [`alpha-shape`]: mod@alpha_shape
//! [`sphere-of-influence`]: mod@sphere_of_influence
//! [`spanning-tree`]: mod@spanning_tree
//! [`conservative-crust`]: mod@conservative_crust
//! [`gathan-like`]: mod@gathan
//! [`gathan-g-like`]: mod@gathan_g
//! [`lenz-like`]: mod@lenz
//! [`discur`]: mod@discur
//! [`vicur-like`]: mod@vicur
//! [`crawl`]: mod@crawl
//! [`peel`]: mod@peel
//! [`connect2d`]: mod@connect2d
//! [`sig-connect2d`]: mod@sig_connect2d
//! [`shortest-tour`]: mod@shortest_tour
//!
//! Each algorithm is also a function of its own, such as [`hnn_crust()`] or [`one_step_crust()`],
//! which returns a [`Skeleton`] with an estimate of the local feature size. Dots in colours, as of
//! puzzles, are joined by [`closest_dot()`]. A [`Reconstruction`] orders edges into curves and
//! rings inside rings; a [`ViolationReport`] shows where the sampling was too sparse.
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

mod adjacency;
pub mod algorithm;
pub mod algorithms;
pub mod alpha_shape;
pub mod beta_skeleton;
pub mod closest_dot;
mod clusters;
pub mod connect2d;
pub mod conservative_crust;
mod constrained;
pub mod crawl;
pub mod crust;
mod delaunay_edges;
mod delaunay_graph;
mod detour;
mod disc;
pub mod discur;
pub mod error;
mod exact;
pub mod explanation;
mod frame;
pub mod gathan;
pub mod gathan_g;
mod held_karp;
pub mod hnn_crust;
pub mod known;
pub mod least_detour;
pub mod lenz;
pub mod neighbours;
pub mod nn_crust;
pub mod normalised_mesh;
pub mod one_step_crust;
mod parameter;
pub mod partial_crust;
mod paths;
pub mod peel;
mod pencil;
pub mod reconstruction;
mod region;
mod rings;
pub mod shortest_tour;
pub mod sig_connect2d;
pub mod skeleton;
mod spacing;
pub mod spanning_tree;
pub mod sphere_of_influence;
mod subtended_angle;
mod termini;
mod tour;
pub mod vicur;
pub mod violations;
mod voronoi_vertex;
mod voronoi_vertices;

pub use algorithm::{
    AlgorithmInfo, Basis, Guarantee, Reconstructor, SamplingBound, Scope, Standing,
};
pub use algorithms::ALGORITHMS;
pub use alpha_shape::{Alpha, AlphaShape, alpha_shape};
pub use beta_skeleton::{Beta, BetaSkeleton, beta_skeleton};
pub use closest_dot::{Colour, Dots, closest_dot};
pub use connect2d::{Connect2d, connect2d};
pub use conservative_crust::{ConservativeCrust, ConservativeRho, conservative_crust};
pub use crawl::{Crawl, crawl};
pub use crust::{Crust, crust};
pub use discur::{Discur, discur};
pub use error::ReconstructError;
pub use explanation::{ExplainedEdge, Explanation, FreeEnd, Reason, Rejected};
pub use gathan::{Gathan, gathan};
pub use gathan_g::{GathanG, gathan_g};
pub use hnn_crust::{HnnCrust, hnn_crust};
pub use known::{Known, Shape};
pub use least_detour::{LeastDetour, least_detour};
pub use lenz::{Lenz, lenz};
pub use neighbours::Keep;
pub use nn_crust::{NnCrust, nn_crust};
pub use normalised_mesh::{NormalisedMesh, normalised_mesh};
pub use one_step_crust::{CrustAndSkeleton, OneStepCrust, one_step_crust};
pub use peel::{Peel, peel};
pub use reconstruction::{NestedChain, Reconstruction};
pub use shortest_tour::{ShortestTour, is_shortest_tour, shortest_tour};
pub use sig_connect2d::{SigConnect2d, sig_connect2d};
pub use skeleton::{Skeleton, SkeletonEdge, SkeletonEnd};
pub use spanning_tree::{SpanningTree, spanning_tree};
pub use sphere_of_influence::{SphereOfInfluence, sphere_of_influence};
pub use vicur::{Vicur, vicur};
pub use violations::{Joint, ViolationReport};

/// The example of the README is a test too.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
