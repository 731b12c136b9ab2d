//! Runs all comparisons, prints the table of medians and ratios, and writes it to
//! `target/bench/summary.md` and `.json`; with the argument `quick`, at a tenth of the sizes.
//!
//! Built with the feature `portable`, only the neighbour kernel is measured, and the files are named
//! `summary-no-dispatch`.

#![allow(
    clippy::print_stdout,
    clippy::print_stderr,
    reason = "a program for a terminal"
)]

use std::error::Error;
use std::path::Path;

use curvecrust_benches::comparison::{Row, markdown};
use curvecrust_benches::stages::{self, Sizes};
use curvecrust_benches::{curves, machine};
use rayon::ThreadPoolBuilder;
use serde::Serialize;

#[derive(Serialize)]
struct Summary {
    processor: String,
    cores: usize,
    commit: String,
    rows: Vec<Row>,
}

fn main() -> Result<(), Box<dyn Error>> {
    let sizes = match std::env::args().nth(1).as_deref() {
        None => Sizes::FULL,
        Some("quick") => Sizes::QUICK,
        Some(other) => {
            return Err(format!("unknown argument {other}: say `quick` or nothing").into());
        }
    };
    let pool = |threads| ThreadPoolBuilder::new().num_threads(threads).build();
    let pools = [pool(1)?, pool(2)?];
    let [one, _] = &pools;
    let dispatch = !cfg!(feature = "portable");
    let mut rows = one.install(|| stages::against_kiddo(sizes))?;
    rows.extend(one.install(|| stages::alone(sizes))?);
    if dispatch {
        rows.extend(one.install(|| stages::growth(sizes))?);
        rows.extend(stages::two_threads(sizes, &pools)?);
        rows.extend(one.install(|| stages::delaunay(sizes))?);
        // The pool takes no boxed error over from its thread.
        let curves = one.install(|| curves::lfs_and_sampling(sizes).map_err(|e| e.to_string()));
        rows.extend(curves?);
    }
    let summary = Summary {
        processor: machine::processor(),
        cores: machine::cores(),
        commit: machine::commit(),
        rows,
    };
    let text = format!(
        "{}, {} cores, commit {}\n\n{}",
        summary.processor,
        summary.cores,
        summary.commit,
        markdown(&summary.rows)
    );
    let folder = Path::new("target/bench");
    let name = if dispatch {
        "summary"
    } else {
        "summary-no-dispatch"
    };
    std::fs::create_dir_all(folder)?;
    std::fs::write(folder.join(name).with_extension("md"), &text)?;
    let json = serde_json::to_string_pretty(&summary)?;
    std::fs::write(folder.join(name).with_extension("json"), json)?;
    println!("{text}");
    Ok(())
}
