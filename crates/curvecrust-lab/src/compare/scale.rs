//! Run time and memory: each measurement is a process of its own, and nothing else of ours runs.

use super::algorithms;
use super::cell::Job;
use super::memory::Before;
use super::seed::seed_of;
use super::trial::{self, Done};
use crate::compare::rows::Row;
use anyhow::{Context, bail, ensure};
use curvecrust::DVec2;
use curvecrust::evaluate::Bounds;
use curvecrust::geometry::{Edge, EdgeSet, PointId, PointSet, Random};
use std::f64::consts::TAU;
use std::process::Command;
use std::time::Instant;

/// Before what a process gets: the algorithm, the number of points and the seed.
pub(super) const ARGUMENT: &str = "--measure";

/// Points on each curve.
const PER_CURVE: usize = 250;

/// Runs a cell in processes of their own, on a number of threads; `None` if it was stopped.
pub(super) fn run(
    job: &Job,
    seed: u64,
    algorithms: &[String],
    threads: usize,
    goes_on: &dyn Fn() -> bool,
) -> anyhow::Result<Option<Done>> {
    let series = job.series();
    let mut done = Done::default();
    for trial in 0..job.trials {
        let seed = seed_of(seed, &job.experiment.name, &series, job.x, trial);
        for name in algorithms {
            let mut row = Row {
                experiment: job.experiment.name.clone(),
                series: series.clone(),
                x: job.x,
                trial,
                seed,
                algorithm: name.clone(),
                points: points_of(job.x),
                values: Vec::new(),
                error: None,
                version: env!("CARGO_PKG_VERSION").to_owned(),
            };
            let outcome = in_a_process(name, row.points, seed, threads);
            // An interruption ends that process too, which is no outcome.
            if !goes_on() {
                return Ok(None);
            }
            match outcome {
                Ok(measured) => {
                    let exact = f64::from(u8::from(measured.exact));
                    row.values = vec![Some(Bounds::exactly(exact))];
                    let mut timing = trial::timing(&row, measured.seconds);
                    timing.memory = measured.memory;
                    done.times.push(timing);
                }
                Err(error) => row.error = Some(format!("{error:#}")),
            }
            done.rows.push(row);
        }
    }
    Ok(Some(done))
}

struct MeasuredCurve {
    seconds: f64,
    /// In bytes.
    memory: Option<u64>,
    exact: bool,
}

fn in_a_process(
    name: &str,
    points: usize,
    seed: u64,
    threads: usize,
) -> anyhow::Result<MeasuredCurve> {
    let program = std::env::current_exe().context("cannot find this program")?;
    let output = Command::new(program)
        .args(["compare", ARGUMENT, &format!("{name},{points},{seed}")])
        .env("RAYON_NUM_THREADS", threads.to_string())
        .output()
        .context("cannot start a process")?;
    ensure!(
        output.status.success(),
        "the process ended with {}",
        output.status
    );
    let text = String::from_utf8_lossy(&output.stdout);
    let fields: Vec<&str> = text.split_whitespace().collect();
    let &[seconds, memory, exact] = fields.as_slice() else {
        bail!("the process said {text:?}");
    };
    Ok(MeasuredCurve {
        seconds: seconds.parse()?,
        memory: memory.parse().ok(),
        exact: exact.parse()?,
    })
}

/// What such a process does, as it has to print it: seconds, bytes or `-`, and whether the edges
/// are exactly the planted ones.
///
/// # Errors
/// If `what` does not name an algorithm, a number of points and a seed, separated by commas.
pub fn measure(what: &str) -> anyhow::Result<String> {
    let fields: Vec<&str> = what.split(',').collect();
    let &[name, points, seed] = fields.as_slice() else {
        bail!("{ARGUMENT} takes an algorithm, a number of points and a seed");
    };
    let algorithm = algorithms::named(name)?;
    let (points, boundary) = planted(points.parse()?, seed.parse()?)?;
    let before = Before::now();
    let start = Instant::now();
    let edges = algorithm.reconstruct(&points);
    let seconds = start.elapsed().as_secs_f64();
    let memory = before.and_then(|before| before.beyond());
    let memory = memory.map_or("-".to_owned(), |bytes| bytes.to_string());
    Ok(format!("{seconds} {memory} {}", edges == boundary))
}

/// Wavy closed curves in the cells of a grid, and the edges between consecutive points; the points
/// in random order.
fn planted(count: usize, seed: u64) -> anyhow::Result<(PointSet, EdgeSet)> {
    let mut random = Random::new(seed);
    let mut order: Vec<usize> = (0..count).collect();
    for last in (1..count).rev() {
        order.swap(last, random.below(last + 1));
    }
    let curves = count.div_ceil(PER_CURVE);
    let side = (1..).find(|side| side * side >= curves).unwrap_or(1);
    let mut points = vec![DVec2::ZERO; count];
    let mut edges = Vec::with_capacity(count);
    for curve in 0..curves {
        let places = &order[curve * count / curves..(curve + 1) * count / curves];
        let centre = DVec2::new((curve % side) as f64, (curve / side) as f64);
        let radius = random.between(0.3, 0.35);
        let (depth, phase) = (random.between(0.05, 0.15), TAU * random.unit());
        for (i, &place) in places.iter().enumerate() {
            let jitter = random.between(-0.15, 0.15);
            let angle = TAU * (i as f64 + jitter) / places.len() as f64;
            let wave = 1.0 + depth * (3.0 * angle + phase).cos();
            points[place] = centre + radius * wave * DVec2::from_angle(angle);
            let next = places[(i + 1) % places.len()];
            let ends = PointId::new(place).zip(PointId::new(next));
            edges.extend(ends.and_then(|(p, q)| Edge::new(p, q)));
        }
    }
    Ok((PointSet::new(points)?, EdgeSet::new(count, edges)))
}

#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "a count of points"
)]
fn points_of(x: f64) -> usize {
    x as usize
}

#[cfg(test)]
mod tests {
    use super::*;
    use curvecrust::reconstruct::hnn_crust;

    #[test]
    fn planted_edges_are_found() {
        for count in [100, 1_000, 10_000] {
            let (points, edges) = planted(count, 1).unwrap();
            assert_eq!((points.len(), edges.len()), (count, count));
            assert_eq!(hnn_crust(&points), edges);
        }
    }
}
