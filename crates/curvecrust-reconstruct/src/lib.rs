//! Curve reconstruction from bare points: HNN-Crust, NN-Crust, Crust and their relatives.

pub mod algorithm;
pub mod error;
pub mod hnn_crust;
pub mod neighbours;

pub use algorithm::{ALGORITHMS, AlgorithmInfo, Condition, Guarantee, Reconstructor};
pub use error::ReconstructError;
pub use hnn_crust::{HnnCrust, hnn_crust};
