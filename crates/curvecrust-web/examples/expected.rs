//! What the native library finds on all fixtures, as JSON for the browser test: edges by every
//! algorithm, and samples for rho < 0.9; and the time of 100,000 points.

#![allow(clippy::print_stdout, reason = "its output is what it is for")]

use curvecrust::medial_axis::measure;
use curvecrust::reconstruct::{ALGORITHMS, HnnCrust};
use curvecrust::sampling::{Condition, sample};
use curvecrust::{DVec2, ReconstructOptions, reconstruct_with};
use curvecrust_testing::fixtures;
use serde_json::{Map, Value, json};
use std::error::Error;
use std::time::Instant;

fn main() -> Result<(), Box<dyn Error>> {
    let mut edges = Map::new();
    for (name, points) in fixtures::points() {
        let mut found = Map::new();
        for &algorithm in ALGORITHMS {
            let options = ReconstructOptions {
                algorithm,
                ..Default::default()
            };
            let curves = reconstruct_with(&points, &options)?;
            found.insert(
                algorithm.info().name.to_owned(),
                json!(curves.edges().concat()),
            );
        }
        edges.insert(name, Value::Object(found));
    }
    let mut samples = Map::new();
    for (name, curve) in fixtures::curves() {
        let found = sample(&measure(&curve)?, Condition::rho(0.9)?)?;
        let points: Vec<[f64; 2]> = found
            .samples
            .points()
            .iter()
            .map(|p| p.to_array())
            .collect();
        samples.insert(name, json!(points.concat()));
    }
    let milliseconds = milliseconds_of_many()?;
    println!(
        "{}",
        json!({"edges": edges, "samples": samples, "milliseconds": milliseconds})
    );
    Ok(())
}

/// The best of ten times for the points that the browser test makes too, on one thread.
fn milliseconds_of_many() -> Result<f64, Box<dyn Error>> {
    let spiral = |i: i32| {
        let angle = f64::from(i).sqrt() * 0.5;
        angle * DVec2::from_angle(angle)
    };
    let points: Vec<DVec2> = (1..=100_000).map(spiral).collect();
    let options = ReconstructOptions {
        algorithm: &HnnCrust::MUTUAL,
        merge_duplicates: true,
        ..Default::default()
    };
    let mut best = f64::INFINITY;
    let one = rayon::ThreadPoolBuilder::new().num_threads(1).build()?;
    for _ in 0..10 {
        let start = Instant::now();
        one.install(|| reconstruct_with(&points, &options))?;
        best = best.min(1e3 * start.elapsed().as_secs_f64());
    }
    Ok(best)
}
