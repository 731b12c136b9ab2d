//! Inputs and peers that the benchmarks share.

pub mod generators;
pub mod random;
