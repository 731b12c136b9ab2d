//! How much more hard points cost than well-spread ones, by algorithm: a table of ratios, those
//! above 4 marked. The first argument is the number of points, 100,000 if there is none; the
//! second and third, if any, parts of the names of the algorithms and of the sets to run.

#![allow(clippy::print_stdout, reason = "a program for a terminal")]

use std::hint::black_box;
use std::time::Instant;

use curvecrust_geometry::PointSet;
use curvecrust_reconstruct::{ALGORITHMS, Reconstructor};
use curvecrust_testing::hard_points::{HARD_POINTS, HardPoints, WELL_SPREAD};

/// Of each algorithm on each set.
const RUNS: usize = 3;

/// Seconds after which a run is not repeated.
const LONG: f64 = 0.1;

fn main() {
    let size = std::env::args().nth(1).and_then(|n| n.parse().ok());
    let size = size.unwrap_or(100_000);
    let [wanted, sets] = [2, 3].map(|i| std::env::args().nth(i).unwrap_or_default());
    let algorithms: Vec<&dyn Reconstructor> = ALGORITHMS
        .iter()
        .copied()
        .filter(|a| a.info().name.contains(&wanted))
        .collect();
    let names: Vec<&str> = algorithms.iter().map(|a| a.info().name).collect();
    println!("{size} points, ratios to well spread ones, the fastest of up to {RUNS} runs each");
    println!("{:>38} {:>8} {}", "", "set", names.join(" "));
    let spread = times(&WELL_SPREAD, size, &algorithms);
    row(WELL_SPREAD.name, &names, &spread, |t| format!("{t:.4} s"));
    for hard in HARD_POINTS.iter().filter(|hard| hard.name.contains(&sets)) {
        let found = times(hard, size, &algorithms);
        let ratios: Vec<f64> = found.iter().zip(&spread).map(|(a, b)| a / b).collect();
        row(hard.name, &names, &ratios, |r| {
            format!("{r:.2}{}", if r > 4.0 { "!" } else { "" })
        });
    }
}

/// The time to take the points, then that of each algorithm, for each of `size` points.
fn times(hard: &HardPoints, size: usize, algorithms: &[&dyn Reconstructor]) -> Vec<f64> {
    let given = (hard.points)(size);
    let points = match PointSet::merging_duplicates(given.clone()) {
        Ok(merged) => merged.points,
        Err(error) => {
            println!("{}: {error}", hard.name);
            return vec![f64::NAN; 1 + algorithms.len()];
        }
    };
    let mut times = vec![fastest(|| {
        PointSet::merging_duplicates(given.clone()).is_ok()
    })];
    times.extend(
        algorithms
            .iter()
            .map(|a| fastest(|| a.reconstruct(&points))),
    );
    times
        .iter()
        .map(|t| t * size as f64 / points.len() as f64)
        .collect()
}

/// The least time of [`RUNS`] runs, in seconds; a long one is not repeated.
fn fastest<T>(run: impl Fn() -> T) -> f64 {
    let mut least = f64::INFINITY;
    for _ in 0..RUNS {
        let start = Instant::now();
        black_box(run());
        least = least.min(start.elapsed().as_secs_f64());
        if least > LONG {
            break;
        }
    }
    least
}

fn row(name: &str, names: &[&str], values: &[f64], shown: impl Fn(f64) -> String) {
    print!("{name:>38} {:>8}", shown(values[0]));
    for (name, &value) in names.iter().zip(&values[1..]) {
        print!(" {:>width$}", shown(value), width = name.len());
    }
    println!();
}
