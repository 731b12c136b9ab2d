//! From what was asked for to the cells that a run computes, in the order of their rows.

use super::cell::{Fixtures, Job};
use super::experiment::{self, Choice, Experiment, Input, Kind, Over};
use super::outlines;
use super::true_curves::{self, Named, TrueCurves};
use anyhow::{Context, ensure};
use curvecrust_testing::fixtures::{CurveEntry, Manifest};
use rayon::prelude::*;
use std::collections::BTreeSet;
use std::path::PathBuf;
use std::sync::Arc;

/// What is asked for.
#[derive(Clone, Debug, Default)]
pub struct Options {
    /// Algorithms instead of those of each experiment; none for those.
    pub algorithms: Vec<String>,
    /// Experiments instead of all but `scale`, and but `outlines` without files; none for those.
    pub experiments: Vec<String>,
    /// So many trials a cell, instead of what each experiment says.
    pub trials: Option<u32>,
    /// Another seed than those of the experiments.
    pub seed: Option<u64>,
    /// So many threads, instead of one for each processor; they change run times only.
    pub threads: Option<usize>,
    /// Few trials, values and curves.
    pub quick: bool,
    /// Go on where an interrupted run with the same options stopped.
    pub resume: bool,
    /// Where to write, instead of target/compare.
    pub output: Option<PathBuf>,
    /// Where the files of outlines are; without it, experiments of outlines are left out.
    pub outlines: Option<PathBuf>,
}

/// Everything that decides the rows.
pub(super) struct Plan {
    pub(super) jobs: Vec<Job>,
    /// One that replaces those of the experiments.
    pub(super) seed: Option<u64>,
    /// Those that replace the ones of the experiments, if any.
    pub(super) algorithms: Vec<String>,
}

impl Plan {
    pub(super) fn algorithms_of<'a>(&'a self, job: &'a Job) -> &'a [String] {
        if self.algorithms.is_empty() {
            &job.experiment.algorithms
        } else {
            &self.algorithms
        }
    }

    pub(super) fn rows_of(&self, job: &Job) -> usize {
        self.algorithms_of(job).len() * job.trials as usize
    }

    /// What two runs must have in common for one to go on where the other stopped.
    pub(super) fn fingerprint(&self) -> String {
        let mut text = format!(
            "version {}\nseed {:?}\nalgorithms {:?}\n",
            env!("CARGO_PKG_VERSION"),
            self.seed,
            self.algorithms
        );
        for job in &self.jobs {
            let experiment = &job.experiment;
            text += &format!(
                "{} seed {} algorithms {:?} sweep {:?}: {} at {}, {} trials of {:?}\n",
                experiment.name,
                experiment.seed,
                experiment.algorithms,
                experiment.sweep.over,
                job.series(),
                job.x,
                job.trials,
                job.input
            );
        }
        text
    }
}

/// The experiments that were asked for.
pub(super) fn chosen(options: &Options) -> anyhow::Result<Vec<Experiment>> {
    let all = experiment::all()?;
    for (i, name) in options.algorithms.iter().enumerate() {
        ensure!(
            !options.algorithms[..i].contains(name),
            "{name:?} is among the algorithms twice"
        );
    }
    for name in &options.experiments {
        let names: Vec<&str> = all.iter().map(|e| e.name.as_str()).collect();
        ensure!(
            names.contains(&name.as_str()),
            "there is no experiment {name:?}: choose from {}",
            names.join(", ")
        );
    }
    let wanted = |e: &Experiment| {
        if options.experiments.is_empty() {
            e.sweep.over != Over::Points
                && (e.sweep.over != Over::Every || options.outlines.is_some())
        } else {
            options.experiments.contains(&e.name)
        }
    };
    Ok(all.into_iter().filter(wanted).collect())
}

/// All cells, in the order of the rows.
pub(super) fn plan(options: &Options, experiments: &[Experiment]) -> anyhow::Result<Plan> {
    let manifest = Manifest::read()?;
    let mut jobs = Vec::new();
    for experiment in experiments {
        let experiment = Arc::new(experiment.clone());
        let usual = if options.quick {
            experiment.quick_trials
        } else {
            experiment.trials
        };
        let values = if options.quick {
            &experiment.sweep.quick
        } else {
            &experiment.sweep.values
        };
        for input in &experiment.input {
            let job = Job {
                experiment: Arc::clone(&experiment),
                input: input.clone(),
                curve: None,
                outlines: None,
                x: 0.0,
                trials: options.trials.unwrap_or(usual),
            };
            let series: Vec<Job> = match input {
                Input::Curves { curves, quick, .. } => {
                    let chosen = if options.quick { quick } else { curves };
                    let curves = named(&manifest, chosen).into_iter().map(Some);
                    curves
                        .map(|curve| Job {
                            curve,
                            ..job.clone()
                        })
                        .collect()
                }
                Input::Outlines { .. } => of_outlines(&job, options)?,
                _ => vec![job],
            };
            for job in series {
                jobs.extend(values.iter().map(|&x| Job { x, ..job.clone() }));
            }
        }
    }
    Ok(Plan {
        jobs,
        seed: options.seed,
        algorithms: options.algorithms.clone(),
    })
}

/// One for each file, with a trial for each outline, or for as many as there are to be at most.
fn of_outlines(job: &Job, options: &Options) -> anyhow::Result<Vec<Job>> {
    let folder = options.outlines.as_ref();
    let folder = folder.context("no outlines: give --outlines DIR, a folder of .ndjson files")?;
    let files = outlines::of_folder(folder)?.into_iter().map(|outlines| {
        let count = u32::try_from(outlines.len()).unwrap_or(u32::MAX);
        Job {
            trials: count.min(job.trials),
            outlines: Some(Arc::new(outlines)),
            ..job.clone()
        }
    });
    Ok(files.collect())
}

/// The curves that an input wants, sorted if it names a kind.
pub(super) fn named(manifest: &Manifest, curves: &Choice) -> Vec<Named> {
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
        let fetched = models
            .iter()
            .filter(|_| true_curves::authors_curves().is_dir());
        return fetched
            .map(|&name| Named::Authors(name.to_owned()))
            .collect();
    }
    let found = manifest.curves.iter().filter(is_meant);
    let mut names: Vec<Named> = found
        .map(|entry| Named::Fixture(entry.name.clone()))
        .collect();
    names.sort();
    names
}

/// The curves that jobs need, each measured once.
pub(super) fn measured(jobs: &[Job]) -> anyhow::Result<Fixtures> {
    let names: BTreeSet<&Named> = jobs.iter().filter_map(|job| job.curve.as_ref()).collect();
    let names: Vec<&Named> = names.into_iter().collect();
    let all = names.into_par_iter().map(|name| {
        let curves = TrueCurves::named(name).with_context(|| format!("curve {name}"))?;
        Ok((name.clone(), Arc::new(curves)))
    });
    all.collect()
}
