//! `cargo xtask compare`: which algorithm for which points, and where does each one break.
//!
//! The experiments stand in `benches/experiments/*.toml`. A run writes one row per trial and
//! algorithm, in an order that depends on neither threads nor time, and from the rows alone tables,
//! plots and a page.
//!
//! | module | what it gives |
//! |---|---|
//! | `experiment`, `plan` | what is asked, and the cells that answer it |
//! | `cell`, `trial`, `scale`, `run` | the measuring |
//! | [`rows`] | [`Row`]: what one algorithm made of one input |
//! | [`records`] | rows and means as lines of CSV, and back |
//! | [`cells`] | [`Cells`]: means over trials |
//! | [`results`] | what an experiment asks, and its answers over what it sweeps |
//! | [`tables`] | Markdown and JSON |
//! | [`axis`] | [`Axis`](axis::Axis): range, scale and format of a chart's axis |
//! | [`chart`] | [`Chart`](chart::Chart): lines with bands, as SVG |
//! | [`heat_map`] | algorithms against experiments, as SVG |
//! | [`page`] | all of it as one HTML file |
//! | [`published`] | the run that is committed |
//!
//! From the rows on, each step is a pure function of the one before it: the same rows give the same
//! bytes.

pub mod algorithms;
pub mod axis;
mod cell;
pub mod cells;
pub mod chart;
mod drawn;
mod experiment;
mod fourier;
pub mod heat_map;
mod jumps;
mod known;
mod memory;
mod outlines;
pub mod page;
mod plan;
mod progress;
pub mod published;
pub mod records;
pub mod results;
pub mod rows;
mod run;
pub mod scale;
mod seed;
mod shapes;
pub mod tables;
#[cfg(test)]
mod tests;
mod trial;
pub(crate) mod true_curves;
mod write;

use crate::repository::root;
use crate::repository::write_atomically;
use anyhow::Context;
use cells::Cells;
use rows::{Row, Timing};
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::atomic::AtomicBool;
use std::time::Instant;

pub use plan::Options;

/// What a run gave.
pub struct Outcome {
    /// Where its files are.
    pub folder: PathBuf,
    /// `None` if it was stopped before the end.
    pub results: Option<Results>,
}

/// What a whole run gave.
pub struct Results {
    /// One for each trial and algorithm.
    pub rows: Vec<Row>,
    /// The tables of each experiment by the values of its sweep, as Markdown.
    pub by_value: String,
    /// The table of all experiments, as Markdown.
    pub overview: String,
    /// Where answers differ from known ones: a line each.
    pub differing: Vec<String>,
    run: published::Run,
    cells: Cells,
    times: Vec<Timing>,
}

impl Results {
    /// Puts them among the published ones, in the place of earlier ones of their experiments.
    ///
    /// # Errors
    /// If what is published cannot be read or written.
    pub fn publish(self) -> anyhow::Result<()> {
        published::publish(self.run, &self.cells, &self.times)
    }
}

/// Runs the experiments until `stop` is set, and writes what came out.
///
/// # Errors
/// If there is no such experiment, a file cannot be read or written, or a measurement fails.
pub fn run(options: &Options, stop: &AtomicBool) -> anyhow::Result<Outcome> {
    let start = Instant::now();
    let experiments = plan::chosen(options)?;
    let plan = plan::plan(options, &experiments)?;
    let folder = match &options.output {
        Some(folder) => folder.clone(),
        None => root().join("target/compare"),
    };
    let done = if options.resume {
        run::resume(&plan, &folder)?
    } else {
        run::begin(&plan, &folder)?;
        0
    };
    let threads = match options.threads {
        Some(threads) => threads,
        None => std::thread::available_parallelism()?.get(),
    };
    let fixtures = plan::measured(&plan.jobs[done..])?;
    if !run::run(&plan, &fixtures, &folder, threads, done, stop)? {
        return Ok(Outcome {
            folder,
            results: None,
        });
    }

    let rows = records::read(&text_of(&folder.join("rows.csv"))?)?;
    let times = records::read(&text_of(&folder.join("times.csv"))?)?;
    let cells = Cells::of_rows(&rows);
    write_atomically(&folder.join("cells.csv"), cells.table().to_csv()?)?;
    let names = experiments.iter().map(|e| e.name.clone()).collect();
    // A resumed run knows the time of its last part only.
    let seconds = (!options.resume).then(|| start.elapsed().as_secs_f64().round());
    let run = published::Run::here(names, threads, seconds);
    let answered = write::answered(&experiments, &cells, &times);
    let texts = write::texts(&answered, &[run.facts()])?;
    write::write(&folder, &texts)?;
    let results = Results {
        by_value: tables::by_value(&answered.results),
        overview: tables::overview(&answered.results, &answered.algorithms),
        differing: known::differing(&experiments, &rows),
        rows,
        run,
        cells,
        times,
    };
    Ok(Outcome {
        folder,
        results: Some(results),
    })
}

fn text_of(path: &Path) -> anyhow::Result<String> {
    fs::read_to_string(path).with_context(|| format!("cannot read {}", path.display()))
}
