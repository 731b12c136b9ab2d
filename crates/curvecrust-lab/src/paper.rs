//! `cargo xtask reproduce-paper`: Tables 1 to 3 of the paper, measured and set beside the printed
//! numbers, each sampling reconstructed; how few samples there can be; and its figures.
//!
//! | module | what it gives |
//! |---|---|
//! | `models` | the four curves of the tables |
//! | [`measure`], `fewest` | the rows of the tables |
//! | [`rows`] | what these rows hold |
//! | [`published`] | the numbers that the paper prints in its Tables 1 to 3 |
//! | [`agreement`] | whether measured rows agree with those |
//! | [`tables`] | tables of the rows, as Markdown, CSV and JSON |
//! | [`figures`] | Figures 1, 3, 4, 8, 9, 10 and 11 |
//! | [`page`] | tables and figures as one page |

pub mod agreement;
mod fewest;
pub mod figures;
pub mod measure;
pub(crate) mod models;
pub mod page;
pub mod published;
pub mod rows;
pub mod tables;
#[cfg(test)]
mod tests;

use crate::repository::root;
use crate::repository::write_atomically;
use anyhow::Context;
use measure::{CONVERGED, Run};
use models::Model;
use rows::PaperReport;
use std::path::PathBuf;

/// What is asked for.
pub struct Options {
    /// Only this table; 4 is the block of the fewest samples.
    pub table: Option<u8>,
    /// How often samples are shaken to find fewer that are verified.
    pub rounds: usize,
    /// A folder of the four curves, instead of fixtures/paper or the redrawn curves.
    pub curves: Option<PathBuf>,
    /// The settings of Tables 2 and 3.
    pub runs: Vec<Run>,
}

/// The tables, written.
pub struct Reproduction {
    /// Where its files are.
    pub folder: PathBuf,
    /// Their rows.
    pub report: PaperReport,
    /// The tables for reading on a terminal.
    pub markdown: String,
    /// The rows as JSON.
    pub json: String,
    models: Vec<Model>,
}

/// Measures the tables and writes them under target/paper.
///
/// # Errors
/// If a curve cannot be read or measured, or a file cannot be written.
pub fn reproduce(options: &Options) -> anyhow::Result<Reproduction> {
    let (origin, models) = models::load(options.curves.as_deref())?;
    let shows = |table: u8| options.table.is_none_or(|only| only == table);
    let runs = &options.runs;
    let report = PaperReport {
        curves: origin,
        table1: if shows(1) {
            measure::table_1()
        } else {
            Vec::new()
        },
        fewest: if shows(4) && runs.contains(&Run::Voronoi(CONVERGED)) {
            fewest::rows(&models, options.rounds)?
        } else {
            Vec::new()
        },
        ..measure::tables_2_and_3(&models, runs, [shows(2), shows(3)])?
    };

    let markdown = tables::markdown(&report);
    let json = tables::json(&report)?;
    let folder = root().join("target").join("paper");
    std::fs::create_dir_all(&folder)
        .with_context(|| format!("cannot make {}", folder.display()))?;
    write_atomically(&folder.join("tables.md"), &markdown)?;
    write_atomically(
        &folder.join("tables.csv"),
        &tables::numbers(&report).to_csv()?,
    )?;
    write_atomically(&folder.join("tables.json"), &json)?;
    Ok(Reproduction {
        folder,
        report,
        markdown,
        json,
        models,
    })
}

impl Reproduction {
    /// Draws the figures, and writes the page of figures and tables, beside the tables.
    ///
    /// # Errors
    /// If a curve cannot be measured, or a file cannot be written.
    pub fn draw(&self) -> anyhow::Result<()> {
        figures::write(&self.report, &self.models, &self.folder)
    }
}
