//! Theorem 2 for all smooth closed curves, up to a rho below the printed one: a proof by machine.
//!
//! The statement and the lemmas behind each condition are in `docs/theorem-2.md`. The prover
//! writes a certificate, a tree of halved boxes with a refutation at each leaf; the checker reads
//! it. S. Ohrhallinger, S. A. Mitchell, M. Wimmer, *Curve Reconstruction with Many Fewer
//! Samples*, SGP 2016, Theorem 2.

mod ball;
mod checker;
mod geometry;
mod interval;
mod prover;
mod statement;
#[cfg(test)]
mod tests;

pub use checker::accepts;
pub use prover::prove;
pub use statement::Node;
