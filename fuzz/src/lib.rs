//! Structured input: points and curves as they are hard for algorithms. They print as Rust that a
//! test can be made of by paste.

pub mod chains;
pub mod points;

pub use chains::Chains;
pub use points::NearlyDegenerate;
