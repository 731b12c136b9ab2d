//! How much more hard points cost than well-spread ones, by algorithm: a table of ratios, those
//! above 4 marked. The first argument is the number of points, 100,000 if there is none.

#![allow(clippy::print_stdout, reason = "a program for a terminal")]

#[path = "../../../crates/curvecrust/tests/adversarial/inputs.rs"]
#[allow(dead_code, reason = "shared with a test")]
mod inputs;

use std::hint::black_box;
use std::time::Instant;

use curvecrust_geometry::PointSet;
use curvecrust_reconstruct::ALGORITHMS;
use inputs::{CELLS, Cell, WELL_SPREAD};

fn main() {
    let size = std::env::args().nth(1).and_then(|n| n.parse().ok());
    let size = size.unwrap_or(100_000);
    let names: Vec<&str> = ALGORITHMS.iter().map(|a| a.info().name).collect();
    println!("{size} points, ratios to well spread ones, one run each");
    println!("{:>38} {:>8} {}", "", "set", names.join(" "));
    let spread = times(&WELL_SPREAD, size);
    row(WELL_SPREAD.name, &names, &spread, |t| format!("{:.3} s", t));
    for cell in CELLS {
        let found = times(cell, size);
        let ratios: Vec<f64> = found.iter().zip(&spread).map(|(a, b)| a / b).collect();
        row(cell.name, &names, &ratios, |r| {
            format!("{r:.2}{}", if r > 4.0 { "!" } else { "" })
        });
    }
}

/// The time to take the points, then that of each algorithm, for each point.
fn times(cell: &Cell, size: usize) -> Vec<f64> {
    let given = (cell.points)(size);
    let start = Instant::now();
    let points = match PointSet::merging_duplicates(given) {
        Ok(merged) => merged.points,
        Err(error) => {
            println!("{}: {error}", cell.name);
            return vec![f64::NAN; 1 + ALGORITHMS.len()];
        }
    };
    let mut times = vec![start.elapsed().as_secs_f64()];
    for algorithm in ALGORITHMS {
        let start = Instant::now();
        black_box(algorithm.reconstruct(&points));
        times.push(start.elapsed().as_secs_f64());
    }
    times
        .iter()
        .map(|t| t * size as f64 / points.len() as f64)
        .collect()
}

fn row(name: &str, names: &[&str], values: &[f64], shown: impl Fn(f64) -> String) {
    print!("{name:>38} {:>8}", shown(values[0]));
    for (name, &value) in names.iter().zip(&values[1..]) {
        print!(" {:>width$}", shown(value), width = name.len());
    }
    println!();
}
