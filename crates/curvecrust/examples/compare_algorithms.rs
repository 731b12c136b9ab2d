//! What each algorithm makes of one's own points.
//!
//!     cargo run --release --example compare_algorithms [FILE]
//!
//! FILE holds two numbers a line; without one, a spiral of uneven points is taken.

#![allow(clippy::print_stdout, reason = "a program for a terminal")]

mod support;

use curvecrust::reconstruct::ALGORITHMS;
use curvecrust::{ReconstructOptions, reconstruct_with};
use std::error::Error;
use std::time::Instant;

fn main() -> Result<(), Box<dyn Error>> {
    let points = support::points_of_argument()?.unwrap_or_else(spiral);
    println!(
        "{:20} closed   open  alone  junctions  length       ms",
        "algorithm"
    );
    for &algorithm in ALGORITHMS {
        let options = ReconstructOptions {
            algorithm,
            ..Default::default()
        };
        let start = Instant::now();
        let curves = reconstruct_with(&points, &options)?;
        let time = start.elapsed().as_secs_f64() * 1000.0;
        let length: f64 = curves
            .edges()
            .iter()
            .map(|&[a, b]| distance(points[a], points[b]))
            .sum();
        let closed = curves.iter().filter(|curve| curve.is_closed()).count();
        println!(
            "{:20} {closed:6} {:6} {:6} {:10} {length:7.2} {time:8.2}",
            algorithm.info().name,
            curves.len() - closed,
            curves.isolated().len(),
            curves.junctions().len(),
        );
    }
    Ok(())
}

fn distance([px, py]: [f64; 2], [qx, qy]: [f64; 2]) -> f64 {
    (px - qx).hypot(py - qy)
}

fn spiral() -> Vec<[f64; 2]> {
    let at = |i: u32| {
        let turn = f64::from(i) / 8.0;
        let uneven = turn + 0.04 * (7.0 * turn).sin();
        [uneven * uneven.cos(), uneven * uneven.sin()]
    };
    (0..160).map(at).collect()
}
