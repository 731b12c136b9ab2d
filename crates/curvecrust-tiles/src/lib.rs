//! HNN-Crust, NN-Crust and Crust on points that no machine holds at once: exactly the same edges.
//!
//! The first two are local: a sample is joined to its nearest and its half neighbour, and both
//! are certain as soon as everything nearby is known. So the plane is cut into tiles, each tile
//! is solved by itself, and what its border leaves open is asked of other tiles. This crate has the
//! steps as pure functions; it reads no files, moves no data and starts no workers. The program
//! `curvecrust reconstruct --tiles` runs them on one machine.
//!
//! | step | by | what it does |
//! |---|---|---|
//! | cut | [`Partition`] | makes cells with about equally many of some points |
//! | solve | [`solve_tile`] | finds edges, claims and open samples, from [`Samples`] and a halo |
//! | ask | [`resolve`] | takes each [`Query`] to where an [`Atlas`] says; finds claims |
//! | join | [`joined`] | makes the edges that no tile could decide alone from the claims of all |
//! | contract | [`pieces`] | makes [`Piece`]s of the edges of a tile: chains, cut at the border |
//! | link | [`join_pieces`] | makes whole [`Curve`]s, and finds the [`Place`] of each piece |
//! | nest | [`surrounding`] | finds the rings around a ring from the sides of all, in any order |
//!
//! The edges of all tiles and the joined ones are, together and sorted, those of
//! [`hnn_crust`](curvecrust_reconstruct::hnn_crust()) or
//! [`nn_crust`](curvecrust_reconstruct::nn_crust()) for all points at once, bit for bit, whatever
//! the tiles, their halos and the order of the steps; so are the chains. Ids are u64, so there may
//! be more samples than a point set holds.
//!
//! Delaunay edges and Crust take two steps instead of the first ones: a tile finds the [`Stars`] of
//! its samples by [`solve_delaunay_tile`] or [`solve_crust_tile`], and [`close_stars`] those that
//! are open, with samples of other tiles. The edges of all tiles together are those of
//! [`crust`](curvecrust_reconstruct::crust()), or all that every Delaunay triangulation has.
//!
//! ```
//! use curvecrust_geometry::{DVec2, Progress};
//! use curvecrust_tiles::*;
//!
//! let at = |i: u64| DVec2::from_angle(i as f64 / 100.0 * std::f64::consts::TAU);
//! let all: Vec<Sample> = (0..100).map(|id| Sample { id, point: at(id) }).collect();
//! let method = Method::HNN_CRUST;
//!
//! let partition = Partition::of(all.iter().map(|s| s.point).collect(), 4);
//! let (mut edges, mut claims, mut queries, mut runs) = (vec![], vec![], vec![], vec![]);
//! for (number, &cell) in partition.cells().iter().enumerate() {
//!     let inside = |s: &&Sample| partition.cell_of(s.point) == number;
//!     let owned = Samples::new(all.iter().filter(inside).copied().collect())?;
//!     let solved = solve_tile(&owned, &[], cell, method)?;
//!     let decided = solved.decided();
//!     edges.extend(decided.edges);
//!     claims.extend(decided.claims);
//!     let open = solved.open().iter();
//!     queries.extend(open.map(|&open| Query::new(open, cell, method.rule)));
//!     runs.push((owned.run_areas(owned.len())[0], owned.iter().collect::<Vec<_>>()));
//! }
//! let atlas = Atlas::new(runs.iter().map(|(area, _)| *area).collect());
//! let read = |run: usize| Ok::<_, TilesError>(runs[run].1.clone());
//! claims.extend(resolve(queries, &atlas, Progress::default(), read)?);
//! edges.extend(joined(claims, method.keep));
//! edges.sort();
//! assert!(edges.len() == 100 && edges[..3] == [[0, 1], [0, 99], [1, 2]]);
//! # Ok::<(), TilesError>(())
//! ```

mod area;
mod atlas;
mod claim;
mod close;
mod contract;
mod crust_reach;
mod curves;
mod elsewhere;
mod error;
mod exact_sum;
mod ids;
mod method;
mod open_sample;
mod partition;
mod piece;
mod query;
mod region;
mod resolve;
mod sample;
mod stars;
mod surroundings;
mod tile;

pub use area::Area;
pub use atlas::Atlas;
pub use claim::{Claim, joined};
pub use close::{SolveStars, close_stars};
pub use contract::pieces;
pub use curves::{Curve, CurveId, JoinedCurves, Place, join_pieces};
pub use elsewhere::Elsewhere;
pub use error::TilesError;
pub use exact_sum::ExactSum;
pub use ids::Ids;
pub use method::Method;
pub use open_sample::{Lack, OpenSample};
pub use partition::{Axis, Cut, Partition};
pub use piece::{Least, Piece, PieceSummary};
pub use query::Query;
pub use resolve::resolve;
pub use sample::{Sample, Samples};
pub use stars::{OpenStar, Stars, solve_crust_tile, solve_delaunay_tile};
pub use surroundings::{Crossings, surrounding};
pub use tile::{Choice, Decided, Solved, solve_tile};

/// The example of the README is a test too.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
