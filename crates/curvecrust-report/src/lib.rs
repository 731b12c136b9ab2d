//! From the rows of an experiment to what people read: pure functions, no measuring.
//!
//! | module | what it gives |
//! |---|---|
//! | [`published`] | the numbers that the paper prints in its Tables 1 to 3 |
//! | [`paper`] | rows of those tables as measured, and their [agreement](paper::PaperReport::agreement) with the paper |
//! | [`fewest`] | rows of how few samples there can be, beside the paper's counts |
//! | [`figure`] | panels of curves, points and edges, as SVG |
//! | [`compare`] | comparisons of algorithms: rows, means, tables, plots, a page |
//! | [`render`] | tables as Markdown, CSV and JSON |
//! | [`html`] | tables and figures as one page |

mod agreement;
pub mod compare;
pub mod fewest;
pub mod figure;
pub mod html;
pub mod paper;
pub mod published;
pub mod render;

pub use fewest::{FewestRow, VerifiedCounts};
pub use figure::{Figure, Layer, Panel};
pub use html::Exhibit;
pub use paper::{Counts, CurveOrigin, PaperReport, Setting, Table1Row, Table2Row, Table3Row};
