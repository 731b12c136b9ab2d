//! `cargo xtask compare`: the algorithms on the experiments of `benches/experiments`; see
//! `curvecrust_lab::compare`.

use anyhow::Context;
use curvecrust_lab::compare::{self, Options, Results, algorithms, published, scale};
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Instant;

/// What was typed.
#[derive(clap::Args)]
pub(crate) struct Args {
    /// These algorithms, separated by commas, instead of those of each experiment
    #[arg(long, value_delimiter = ',', value_name = "NAMES", value_parser = algorithms::names())]
    algorithms: Vec<String>,
    /// These experiments, separated by commas, instead of all but `scale` (and `outlines` without
    /// --outlines); their results are printed by the values of their sweep
    #[arg(long, value_delimiter = ',', value_name = "NAMES")]
    experiments: Vec<String>,
    /// So many trials a cell, instead of what each experiment says
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..))]
    trials: Option<u32>,
    /// Another seed than those of the experiments
    #[arg(long, value_name = "SEED")]
    seed: Option<u64>,
    /// So many threads, instead of one for each processor; they change run times only
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..))]
    threads: Option<u16>,
    /// Few trials, values and curves
    #[arg(long)]
    quick: bool,
    /// Go on where an interrupted run with the same options stopped
    #[arg(long)]
    resume: bool,
    /// Where to write, instead of target/compare
    #[arg(long, value_name = "DIR")]
    output: Option<PathBuf>,
    /// Where the files of the experiment `outlines` are: `*.ndjson`, a JSON object with `name` and
    /// `rings`, lists of pairs, on each line
    #[arg(long, value_name = "DIR")]
    outlines: Option<PathBuf>,
    /// Put the results into docs/results/compare too, in the place of earlier ones of the same
    /// experiments
    #[arg(long, conflicts_with_all = ["quick", "algorithms", "trials", "seed", "resume"])]
    publish: bool,
    /// Measure an algorithm on a number of points with a seed, alone in this process
    #[arg(long, hide = true, value_name = "NAME,N,SEED")]
    measure: Option<String>,
}

/// Status of a run that was interrupted, as shells have it.
const INTERRUPTED: u8 = 130;

/// Runs the experiments, writes what came out, and compares it with what is known.
pub(crate) fn run(args: &Args) -> anyhow::Result<ExitCode> {
    if let Some(what) = &args.measure {
        println!("{}", scale::measure(what)?);
        return Ok(ExitCode::SUCCESS);
    }
    let start = Instant::now();
    let stop: &'static AtomicBool = Box::leak(Box::new(AtomicBool::new(false)));
    ctrlc::set_handler(|| stop.store(true, Ordering::Relaxed))
        .context("cannot listen for interruptions")?;
    let outcome = compare::run(&options(args), stop)?;
    let Some(results) = outcome.results else {
        eprintln!(
            "stopped; complete cells are in {}: go on with --resume and the same options",
            outcome.folder.display()
        );
        return Ok(ExitCode::from(INTERRUPTED));
    };
    print(args, &results, &outcome.folder, start);
    let agree = results.differing.is_empty();
    if args.publish && agree {
        results.publish()?;
        eprintln!("published in {}", published::FOLDER);
    }
    Ok(ExitCode::from(u8::from(!agree)))
}

fn options(args: &Args) -> Options {
    Options {
        algorithms: args.algorithms.clone(),
        experiments: args.experiments.clone(),
        trials: args.trials,
        seed: args.seed,
        threads: args.threads.map(usize::from),
        quick: args.quick,
        resume: args.resume,
        output: args.output.clone(),
        outlines: args.outlines.clone(),
    }
}

fn print(args: &Args, results: &Results, folder: &Path, start: Instant) {
    if !args.experiments.is_empty() {
        print!("{}", results.by_value);
    }
    print!("{}", results.overview);
    eprintln!(
        "{} rows in {:.1} s; tables, plots and index.html are in {}",
        results.rows.len(),
        start.elapsed().as_secs_f64(),
        folder.display()
    );
    let failed = results.rows.iter().filter(|row| row.error.is_some());
    let failed = failed.count();
    if failed > 0 {
        eprintln!("{failed} of them without a result: their column `error` says why");
    }
    for answer in &results.differing {
        eprintln!("failed: {answer}");
    }
}
