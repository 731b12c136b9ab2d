//! `cargo xtask compare`: which algorithm for which points, and where does each one break.
//!
//! The experiments stand in `benches/experiments/*.toml`. A run writes one row per trial and
//! algorithm, in an order that depends on neither threads nor time, and from the rows alone tables,
//! plots and a page.

mod algorithms;
mod cell;
mod experiment;
mod fourier;
mod jumps;
mod known;
mod manifest;
mod memory;
mod progress;
pub(crate) mod published;
mod random;
mod run;
mod scale;
pub(crate) mod scene;
mod shortest_tour;
#[cfg(test)]
mod tests;
mod trial;
mod write;

use crate::root::root;
use crate::whole::write_whole;
use anyhow::{Context, ensure};
use cell::{Fixtures, Job};
use curvecrust::report::compare::{Cells, Row, Timing, tables};
use experiment::{Choice, Experiment, Input, Kind, Over};
use manifest::{CurveEntry, Manifest};
use rayon::prelude::*;
use run::Plan;
use scene::{Named, Scene};
use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Instant;

/// What was typed.
#[derive(clap::Args, Clone, Default)]
pub(crate) struct Args {
    /// These algorithms, separated by commas, instead of those of each experiment
    #[arg(long, value_delimiter = ',', value_name = "NAMES", value_parser = algorithms::names())]
    algorithms: Vec<String>,
    /// These experiments, separated by commas, instead of all but `scale`; their results are printed by the values of their sweep
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
    /// Put the results into docs/results/compare too, in the place of earlier ones of the same experiments
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
        return scale::measure(what).map(|()| ExitCode::SUCCESS);
    }
    let stop: &'static AtomicBool = Box::leak(Box::new(AtomicBool::new(false)));
    ctrlc::set_handler(|| stop.store(true, Ordering::Relaxed))
        .context("cannot listen for interruptions")?;
    run_until(args, stop)
}

fn run_until(args: &Args, stop: &AtomicBool) -> anyhow::Result<ExitCode> {
    let start = Instant::now();
    let experiments = chosen(args)?;
    let plan = plan(args, &experiments)?;
    let folder = match &args.output {
        Some(folder) => folder.clone(),
        None => root().join("target/compare"),
    };
    let done = if args.resume {
        run::resume(&plan, &folder)?
    } else {
        run::begin(&plan, &folder)?;
        0
    };
    let threads = match args.threads {
        Some(threads) => usize::from(threads),
        None => std::thread::available_parallelism()?.get(),
    };
    let fixtures = measured(&plan.jobs[done..])?;
    if !run::run(&plan, &fixtures, &folder, threads, done, stop)? {
        eprintln!(
            "stopped; complete cells are in {}: go on with --resume and the same options",
            folder.display()
        );
        return Ok(ExitCode::from(INTERRUPTED));
    }

    let rows = Row::read(&text_of(&folder.join("rows.csv"))?)?;
    let times = Timing::read(&text_of(&folder.join("times.csv"))?)?;
    let cells = Cells::of_rows(&rows);
    write_whole(&folder.join("cells.csv"), cells.to_csv())?;
    let names = experiments.iter().map(|e| e.name.clone()).collect();
    // A resumed run knows the time of its last part only.
    let seconds = (!args.resume).then(|| start.elapsed().as_secs_f64().round());
    let run = published::Run::here(names, threads, seconds);
    let answered = write::answered(&experiments, &cells, &times);
    let texts = write::texts(&answered, &[run.facts()])?;
    write::write(&folder, &texts)?;
    if !args.experiments.is_empty() {
        print!("{}", tables::by_value(&answered.sheets));
    }
    print!(
        "{}",
        tables::overview(&answered.sheets, &answered.algorithms)
    );
    eprintln!(
        "{} rows in {:.1} s; tables, plots and index.html are in {}",
        rows.len(),
        start.elapsed().as_secs_f64(),
        folder.display()
    );
    let failed = rows.iter().filter(|row| row.error.is_some()).count();
    if failed > 0 {
        eprintln!("{failed} of them without a result: their column `error` says why");
    }
    let differing = known::differing(&experiments, &rows);
    for answer in &differing {
        eprintln!("failed: {answer}");
    }
    if args.publish && differing.is_empty() {
        published::publish(run, &cells, &times)?;
        eprintln!("published in {}", published::FOLDER);
    }
    Ok(ExitCode::from(u8::from(!differing.is_empty())))
}

fn text_of(path: &Path) -> anyhow::Result<String> {
    fs::read_to_string(path).with_context(|| format!("cannot read {}", path.display()))
}

/// The experiments that were asked for.
fn chosen(args: &Args) -> anyhow::Result<Vec<Experiment>> {
    let all = experiment::all()?;
    for (i, name) in args.algorithms.iter().enumerate() {
        ensure!(
            !args.algorithms[..i].contains(name),
            "{name:?} is among the algorithms twice"
        );
    }
    for name in &args.experiments {
        let names: Vec<&str> = all.iter().map(|e| e.name.as_str()).collect();
        ensure!(
            names.contains(&name.as_str()),
            "there is no experiment {name:?}: choose from {}",
            names.join(", ")
        );
    }
    let wanted = |e: &Experiment| {
        if args.experiments.is_empty() {
            e.sweep.over != Over::Points
        } else {
            args.experiments.contains(&e.name)
        }
    };
    Ok(all.into_iter().filter(wanted).collect())
}

/// All cells, in the order of the rows.
fn plan(args: &Args, experiments: &[Experiment]) -> anyhow::Result<Plan> {
    let manifest = manifest::read()?;
    let mut jobs = Vec::new();
    for experiment in experiments {
        let experiment = Arc::new(experiment.clone());
        let usual = if args.quick {
            experiment.quick_trials
        } else {
            experiment.trials
        };
        let values = if args.quick {
            &experiment.sweep.quick
        } else {
            &experiment.sweep.values
        };
        for input in &experiment.input {
            let curves: Vec<Option<Named>> = match input {
                Input::Curves { curves, quick, .. } => {
                    let chosen = if args.quick { quick } else { curves };
                    named(&manifest, chosen).into_iter().map(Some).collect()
                }
                _ => vec![None],
            };
            for (curve, &x) in curves
                .iter()
                .flat_map(|c| values.iter().map(move |x| (c, x)))
            {
                jobs.push(Job {
                    experiment: Arc::clone(&experiment),
                    input: input.clone(),
                    curve: curve.clone(),
                    x,
                    trials: args.trials.unwrap_or(usual),
                });
            }
        }
    }
    Ok(Plan {
        jobs,
        seed: args.seed,
        algorithms: args.algorithms.clone(),
    })
}

/// The curves that an input wants, sorted if it names a kind.
fn named(manifest: &Manifest, curves: &Choice) -> Vec<Named> {
    let kind = match curves {
        Choice::Names(names) => return names.iter().cloned().map(Named::Fixture).collect(),
        Choice::Random(random) => {
            let terms = random.terms;
            let seeds = random.seed..random.seed.saturating_add(random.count);
            return seeds.map(|seed| Named::Random { terms, seed }).collect();
        }
        Choice::Kind(kind) => *kind,
    };
    let is_meant = |entry: &&CurveEntry| match kind {
        Kind::Closed => entry.closed,
        Kind::OneClosed => entry.closed && entry.components == 1,
        Kind::SeveralClosed => entry.closed && entry.components > 1,
        Kind::Open => !entry.closed,
        Kind::Authors => false,
    };
    if kind == Kind::Authors {
        let models = ["parallel", "teaser", "bunny", "cat"];
        let fetched = models.iter().filter(|_| scene::authors_curves().is_dir());
        return fetched
            .map(|&name| Named::Authors(name.to_owned()))
            .collect();
    }
    let found = manifest.curve.iter().filter(is_meant);
    let mut names: Vec<Named> = found
        .map(|entry| Named::Fixture(entry.name.clone()))
        .collect();
    names.sort();
    names
}

/// The curves that jobs need, each measured once.
fn measured(jobs: &[Job]) -> anyhow::Result<Fixtures> {
    let names: BTreeSet<&Named> = jobs.iter().filter_map(|job| job.curve.as_ref()).collect();
    let names: Vec<&Named> = names.into_iter().collect();
    let scenes = names.into_par_iter().map(|name| {
        let scene = Scene::named(name).with_context(|| format!("curve {name}"))?;
        Ok((name.clone(), Arc::new(scene)))
    });
    scenes.collect()
}
