//! Runs comparisons, prints the table of medians and ratios, and writes it to
//! `target/bench/summary.md` and `.json`.
//!
//! Arguments are stages to run, all if none is named; and `quick`, for a tenth of the sizes. Built
//! with the feature `portable`, there are only the stages of the neighbour kernel, and the files
//! are named `summary-no-dispatch`.

#![allow(
    clippy::print_stdout,
    clippy::print_stderr,
    reason = "a program for a terminal"
)]

use std::error::Error;
use std::path::Path;

use curvecrust_benches::comparison::{Row, markdown};
use curvecrust_benches::stages::{self, Sizes};
use curvecrust_benches::{curves, least_detour, machine};
use rayon::{ThreadPool, ThreadPoolBuilder};
use serde::Serialize;

#[derive(Serialize)]
struct Summary {
    processor: String,
    cores: usize,
    commit: String,
    rows: Vec<Row>,
}

/// One thread and two.
type Pools = [ThreadPool; 2];
type Rows = Result<Vec<Row>, String>;
/// A name, and what measures it.
type Stage = (&'static str, fn(Sizes, &Pools) -> Rows);

/// In the order of the table; the first two are those of the neighbour kernel.
const STAGES: [Stage; 8] = [
    ("kiddo", |sizes, pools| {
        on_one(pools, || stages::against_kiddo(sizes))
    }),
    ("neighbours", |sizes, pools| {
        on_one(pools, || stages::alone(sizes))
    }),
    ("growth", |sizes, pools| {
        on_one(pools, || stages::growth(sizes))
    }),
    ("threads", |sizes, pools| {
        stages::two_threads(sizes, pools).map_err(|e| e.to_string())
    }),
    ("delaunay", |sizes, pools| {
        on_one(pools, || stages::delaunay(sizes))
    }),
    ("least-detour", |sizes, pools| {
        on_one(pools, || least_detour::rows(sizes))
    }),
    ("lfs", |sizes, pools| on_one(pools, || curves::lfs(sizes))),
    ("sampling", |sizes, pools| {
        on_one(pools, || curves::sampling(sizes))
    }),
];

/// Runs a stage on one thread; the pool takes no boxed error over from it.
fn on_one<E: ToString>(
    [one, _]: &Pools,
    stage: impl FnOnce() -> Result<Vec<Row>, E> + Send,
) -> Rows {
    one.install(|| stage().map_err(|e| e.to_string()))
}

fn main() -> Result<(), Box<dyn Error>> {
    let dispatch = !cfg!(feature = "portable");
    let stages = if dispatch { &STAGES[..] } else { &STAGES[..2] };
    let mut sizes = Sizes::FULL;
    let mut wanted = Vec::new();
    for argument in std::env::args().skip(1) {
        if argument == "quick" {
            sizes = Sizes::QUICK;
        } else if stages.iter().any(|(name, _)| *name == argument) {
            wanted.push(argument);
        } else {
            let names: Vec<&str> = stages.iter().map(|(name, _)| *name).collect();
            return Err(format!(
                "unknown argument {argument}: say `quick` or some of {}",
                names.join(", ")
            )
            .into());
        }
    }
    let pool = |threads| ThreadPoolBuilder::new().num_threads(threads).build();
    let pools = [pool(1)?, pool(2)?];
    let mut rows = Vec::new();
    for (name, run) in stages {
        if wanted.is_empty() || wanted.iter().any(|w| w == name) {
            rows.extend(run(sizes, &pools)?);
        }
    }
    write(&Summary {
        processor: machine::processor(),
        cores: machine::cores(),
        commit: machine::commit(),
        rows,
    })
}

fn write(summary: &Summary) -> Result<(), Box<dyn Error>> {
    let text = format!(
        "{}, {} cores, commit {}\n\n{}",
        summary.processor,
        summary.cores,
        summary.commit,
        markdown(&summary.rows)
    );
    let folder = Path::new("target/bench");
    let name = if cfg!(feature = "portable") {
        "summary-no-dispatch"
    } else {
        "summary"
    };
    std::fs::create_dir_all(folder)?;
    std::fs::write(folder.join(name).with_extension("md"), &text)?;
    let json = serde_json::to_string_pretty(&summary)?;
    std::fs::write(folder.join(name).with_extension("json"), json)?;
    println!("{text}");
    Ok(())
}
