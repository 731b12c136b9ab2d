//! The laboratory: experiments with the libraries, and the tables, figures and pages made of them.
//!
//! It is not published, and no library depends on it. `cargo xtask` runs what is here.
//!
//! | module | what it gives |
//! |---|---|
//! | [`paper`] | the paper's tables and figures, measured and drawn |
//! | [`compare`] | comparisons of algorithms: experiments, rows, means, tables, plots, a page |
//! | [`counterexamples`] | samples on which algorithms fail, and their search |
//! | [`noise`] | curves fitted to points that scatter about known ones |
//! | [`figure`] | panels of curves, points and edges, as SVG |
//! | [`table`] | tables as values, written as Markdown, CSV and HTML |
//! | [`docs`] | the files under docs that are made, not written |

mod claims;
pub mod compare;
pub mod counterexamples;
mod digest;
pub mod docs;
pub mod drawing;
mod family;
pub mod figure;
mod method;
pub mod noise;
mod page;
pub mod paper;
mod png;
mod puzzles;
mod repository;
pub mod table;

pub use repository::{output_of, root, write_atomically};
