//! The part of the proof of Theorem 2 that needs a machine.
//!
//! S. Ohrhallinger, S. A. Mitchell, M. Wimmer, *Curve Reconstruction with Many Fewer Samples*, SGP
//! 2016, Theorem 2. `docs/theorem-2.md` reduces it to the statement that four unknowns never
//! satisfy ten conditions.
//!
//! [`prove`] writes a [`Certificate`], [`check`] accepts it or says what is wrong.

mod ball;
mod certificate;
mod checker;
mod configuration;
mod interval;
mod midpoint;
mod prover;
mod sampling;
mod spline;
mod splines_text;
#[cfg(test)]
mod tests;
mod vector;

pub use certificate::{Axis, Certificate, FormatError, Leaf, Node, Reason, Refusal};
pub use checker::{check, refutes};
pub use configuration::Unknowns;
pub use interval::Interval;
pub use prover::{Resisting, prove};
pub use sampling::{SampledSplines, SamplingCondition, Undecided};
pub use spline::ClosedSpline;
