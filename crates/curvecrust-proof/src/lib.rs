//! The part of the proof of Theorem 2 that needs a machine.
//!
//! S. Ohrhallinger, S. A. Mitchell, M. Wimmer, *Curve Reconstruction with Many Fewer Samples*, SGP
//! 2016, Theorem 2. `docs/theorem-2.md` reduces it to the statement that four unknowns never
//! satisfy ten conditions. On arcs of constant curvature there are three unknowns.
//!
//! [`prove`] writes a [`Certificate`], [`check`] accepts it or says what is wrong.

mod arcs;
mod ball;
mod centers;
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

pub use certificate::{Axis, Certificate, Curves, FormatError, Leaf, Node, Reason, Refusal};
pub use checker::check;
pub use configuration::Unknowns;
pub use interval::Interval;
pub use prover::{Resisting, prove};
pub use sampling::{SampledSplines, SamplingCondition, Undecided};
pub use spline::ClosedSpline;
