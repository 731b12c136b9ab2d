//! One cell run: every trial by every algorithm, as rows and their times.

use super::algorithms;
use super::cell::Job;
use super::drawn::{Drawn, Sampled};
use super::seed::seed_of;
use super::true_curves::TrueCurves;
use crate::compare::rows::{Row, Timing};
use curvecrust::evaluate::{Bounds, Evaluation, Kind, Output, Truth};
use curvecrust::geometry::EdgeSet;
use curvecrust::reconstruct::Reconstructor;
use std::time::Instant;

/// How far apart the bounds of distances are, in extents.
const TOLERANCE: f64 = 1e-3;

/// What a cell gave.
#[derive(Default)]
pub(super) struct Done {
    pub(super) rows: Vec<Row>,
    pub(super) times: Vec<Timing>,
}

/// Runs a cell, whose points are drawn by the number of the trial and its seed; `None` if it was
/// stopped.
pub(super) fn run(
    job: &Job,
    seed: u64,
    algorithms: &[String],
    draw: &dyn Fn(u32, u64) -> anyhow::Result<Drawn>,
    goes_on: &dyn Fn() -> bool,
) -> anyhow::Result<Option<Done>> {
    let algorithms = algorithms.iter().map(|name| algorithms::named(name));
    let algorithms: Vec<_> = algorithms.collect::<anyhow::Result<_>>()?;
    let series = job.series();
    let mut done = Done::default();
    for trial in 0..job.trials {
        if !goes_on() {
            return Ok(None);
        }
        let seed = seed_of(seed, &job.experiment.name, &series, job.x, trial);
        let drawn = draw(trial, seed);
        let mut known: Vec<(EdgeSet, Vec<Option<Bounds>>)> = Vec::new();
        for algorithm in &algorithms {
            let name = algorithm.info().name;
            let mut row = Row {
                experiment: job.experiment.name.clone(),
                series: series.clone(),
                x: job.x,
                trial,
                seed,
                algorithm: name.to_owned(),
                points: 0,
                values: Vec::new(),
                error: None,
                version: env!("CARGO_PKG_VERSION").to_owned(),
            };
            match &drawn {
                Ok(Drawn { sampled, curves }) => {
                    row.points = sampled.points.len();
                    let start = Instant::now();
                    let edges = reconstructed(*algorithm, sampled);
                    let seconds = start.elapsed().as_secs_f64();
                    match edges {
                        Ok(edges) => {
                            row.values = values(sampled, curves, edges, &mut known);
                            done.times.push(timing(&row, seconds));
                        }
                        Err(error) => row.error = Some(error.to_string()),
                    }
                }
                Err(error) => row.error = Some(format!("{error:#}")),
            }
            done.rows.push(row);
        }
    }
    Ok(Some(done))
}

/// Algorithms that can use the ends get them.
fn reconstructed(algorithm: &dyn Reconstructor, sampled: &Sampled) -> anyhow::Result<EdgeSet> {
    if algorithm.info().honours_termini {
        Ok(algorithm.reconstruct_open(&sampled.points, &sampled.termini)?)
    } else {
        Ok(algorithm.reconstruct(&sampled.points))
    }
}

/// The values of all metrics; edges that another algorithm found too are not measured twice.
fn values(
    sampled: &Sampled,
    curves: &TrueCurves,
    edges: EdgeSet,
    known: &mut Vec<(EdgeSet, Vec<Option<Bounds>>)>,
) -> Vec<Option<Bounds>> {
    if let Some((_, values)) = known.iter().find(|(found, _)| *found == edges) {
        return values.clone();
    }
    let truth = Truth {
        curve: &curves.reference,
        boundary: &sampled.boundary,
    };
    let output = Output {
        vertices: &sampled.points,
        edges: &edges,
        kind: Kind::Interpolating,
        seconds: None,
    };
    let values = Row::values_of(&Evaluation::new(truth, output, TOLERANCE));
    known.push((edges, values.clone()));
    values
}

pub(super) fn timing(row: &Row, seconds: f64) -> Timing {
    Timing {
        experiment: row.experiment.clone(),
        series: row.series.clone(),
        x: row.x,
        trial: row.trial,
        algorithm: row.algorithm.clone(),
        points: row.points,
        seconds,
        memory: None,
    }
}
