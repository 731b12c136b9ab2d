//! What the benchmarks share: inputs with known answers, the peers, and the table of medians.
//!
//! `cargo bench -p curvecrust-benches` measures stage by stage with criterion; the program
//! `summary` runs all comparisons interleaved and prints ratios beside the goals.

pub mod comparison;
pub mod curves;
pub mod growth;
pub mod least_detour;
pub mod machine;
pub mod peers;
pub mod stages;
