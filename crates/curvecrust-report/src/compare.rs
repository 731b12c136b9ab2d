//! Comparisons of reconstruction algorithms: from the rows of experiments to tables, plots and a page.
//!
//! | module | what it gives |
//! |---|---|
//! | [`rows`] | [`Row`]: what one algorithm made of one input, as a line of CSV |
//! | [`cells`] | [`Cells`]: means over trials |
//! | [`sheet`] | [`Sheet`]: what an experiment asks, and its curves against what it sweeps |
//! | [`tables`] | Markdown and JSON |
//! | [`axis`] | [`Axis`](axis::Axis): range, scale and format of a chart's axis |
//! | [`chart`] | [`Chart`](chart::Chart): lines with bands, as SVG |
//! | [`heat_map`] | algorithms against experiments, as SVG |
//! | [`page`] | all of it as one HTML file |
//!
//! Each step is a pure function of the one before it: the same rows give the same bytes. Whoever has
//! curves and algorithms makes rows of their [`Evaluation`](curvecrust_evaluate::Evaluation)s; the
//! crate doc of `curvecrust` shows all of it.

pub mod axis;
pub mod cells;
pub mod chart;
pub mod heat_map;
pub mod page;
pub mod rows;
pub mod sheet;
mod style;
pub mod tables;

pub use cells::{Cell, Cells};
pub use rows::{Row, RowError, Timing};
pub use sheet::{Experiment, Sheet};
