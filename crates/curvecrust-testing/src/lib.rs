//! What tests, benches, fuzz targets and the laboratory share. It is not published: other crates
//! name it among their dev-dependencies, by its path and without a version, so that their packages
//! leave it out.
//!
//! | module | what it gives |
//! |---|---|
//! | [`fixtures`] | the drawings and point sets of the folder `fixtures`, and its list |
//! | [`planted`] | points of any number, with the edges that a reconstruction has to find |
//! | [`hard_points`] | points that are hard on an algorithm, of any number, by name |
//! | [`scattered`] | uniform points, noise, lattices, borders of pixels, of any number, by name |
//! | [`strategies`] | nearly degenerate points for proptest, which integers can check |
//! | [`moves`] | the same points elsewhere, larger or in another order, and their edges |
//! | [`curves`] | random smooth curves |
//! | [`drawings`] | waves, combs, gears, spirals, text: drawings of any number of cubics, by name |
//!
//! A unit test inside a crate is compiled against that crate as a test, this one against it as a
//! library: their types differ. There, use what speaks `DVec2`, or write an integration test.

#![allow(
    clippy::panic,
    clippy::unwrap_used,
    clippy::missing_panics_doc,
    reason = "what serves tests fails as they do"
)]

pub mod curves;
pub mod drawings;
pub mod fixtures;
pub mod hard_points;
pub mod moves;
pub mod planted;
pub mod scattered;
pub mod strategies;
