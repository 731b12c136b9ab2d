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
//! | [`report`] | the paper's tables |
//!
//! From a curve to samples, and back:
//!
//! ```
//! use curvecrust::curve::Curve;
//! use curvecrust::evaluate::EdgeComparison;
//! use curvecrust::medial_axis::{Discretisation, Estimator, measure};
//! use curvecrust::reconstruct::hnn_crust;
//! use curvecrust::sampling::{Condition, sample_greedy};
//!
//! let d = "M 0 0 C 30 -20 50 20 80 0 S 120 40 80 60 S 30 30 0 60 S -30 20 0 0 Z";
//! let curve = Curve::from_path_data(d)?;
//! let measured = measure(&curve, Discretisation::Adaptive { gap_to_lfs: 0.02 }, Estimator::Voronoi, &|_, _| {})?;
//! let samples = sample_greedy(&measured, Condition::rho(0.9)?);
//!
//! // What the reconstruction sees is bare points.
//! let edges = hnn_crust(&samples.point_set()?);
//! assert!(EdgeComparison::new(&samples.manifold_boundary(), &edges).is_exact());
//! assert!(edges.chains()[0].is_closed());
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! Which algorithm for samples of a curve like mine? What `cargo xtask compare` of the repository does
//! with its experiments, for a curve of your own:
//!
//! ```
//! use curvecrust::curve::Curve;
//! use curvecrust::evaluate::{Evaluation, Kind, Output, Reference, Truth};
//! use curvecrust::medial_axis::{Discretisation, Estimator, measure};
//! use curvecrust::reconstruct::ALGORITHMS;
//! use curvecrust::report::compare::{Cells, Experiment, Row, Sheet, page, tables};
//! use curvecrust::sampling::{Condition, sample_unevenly};
//!
//! let curve = Curve::from_path_data("M 0 0 C 30 -20 50 20 80 0 S 120 40 80 60 S 30 30 0 60 S -30 20 0 0 Z")?;
//! let measured = measure(&curve, Discretisation::Adaptive { gap_to_lfs: 0.02 }, Estimator::Voronoi, &|_, _| {})?;
//! let reference = Reference::of_curve(&curve, 1e-4 * curve.extent());
//! let mut rows = Vec::new();
//! for rho in [0.5, 0.7, 0.9] {
//!     for trial in 0..5 {
//!         let seed = u64::from(trial);
//!         let samples = sample_unevenly(&measured, Condition::rho(rho)?, 0.5, seed)?.samples;
//!         let (points, boundary) = (samples.point_set()?, samples.manifold_boundary());
//!         for algorithm in ALGORITHMS {
//!             let edges = algorithm.reconstruct(&points);
//!             let truth = Truth { curve: &reference, boundary: &boundary };
//!             let kind = Kind::Interpolating;
//!             let output = Output { vertices: &points, edges: &edges, kind, seconds: None };
//!             rows.push(Row {
//!                 experiment: "mine".to_owned(),
//!                 series: "my curve".to_owned(),
//!                 x: rho,
//!                 trial,
//!                 seed,
//!                 algorithm: algorithm.info().name.to_owned(),
//!                 points: points.len(),
//!                 values: Row::values_of(&Evaluation::new(truth, output, 1e-3)),
//!                 error: None,
//!                 version: env!("CARGO_PKG_VERSION").to_owned(),
//!             });
//!         }
//!     }
//! }
//! let asked = Experiment {
//!     name: "mine".to_owned(),
//!     title: "How dense must samples be?".to_owned(),
//!     question: "Uneven samples of my curve.".to_owned(),
//!     sweep: "rho".to_owned(),
//!     plots: vec!["exact".to_owned(), "hausdorff".to_owned()],
//! };
//! let names: Vec<&str> = ALGORITHMS.iter().map(|algorithm| algorithm.info().name).collect();
//! let sheets = [Sheet::new(asked, &Cells::of_rows(&rows), &[], &names)];
//! println!("{}", tables::markdown(&sheets, &names));
//! let whole_page = page::html(&sheets, &names, &[]);
//! # assert!(rows.iter().all(|row| row.algorithm != "hnn-crust" || row.values[0].is_some_and(|v| v.lower == 1.0)));
//! # assert!(whole_page.contains("How dense must samples be?"));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

pub use curvecrust_curve as curve;
pub use curvecrust_evaluate as evaluate;
pub use curvecrust_geometry as geometry;
pub use curvecrust_medial_axis as medial_axis;
pub use curvecrust_reconstruct as reconstruct;
pub use curvecrust_report as report;
pub use curvecrust_sampling as sampling;
pub use curvecrust_voronoi as voronoi;

pub use glam::DVec2;
