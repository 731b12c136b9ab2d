//! One kernel, as often as asked for, on one thread: what `cargo xtask ci instructions` counts.

#![allow(clippy::print_stderr, reason = "a program for a terminal")]

use std::error::Error;
use std::hint::black_box;
use std::process::ExitCode;

use curvecrust_benches::curves::dense_one_curve;
use curvecrust_benches::peers::anew;
use curvecrust_medial_axis::{Estimator, MeasuredCurve};
use curvecrust_reconstruct::neighbours::{HalfRule, neighbours};
use curvecrust_reconstruct::{crust, least_detour};
use curvecrust_sampling::{Condition, sample};
use curvecrust_testing::planted::{many_curves, uniform};
use curvecrust_voronoi::Delaunay;

/// Points for the algorithms, and dense points of a curve.
const POINTS: usize = 5_000;
const DENSE: usize = 3_000;
/// Scattered points, nothing of which is certain: nearly all of least detour is its search.
const SCATTERED: usize = 500;

fn main() -> Result<ExitCode, Box<dyn Error>> {
    let mut arguments = std::env::args().skip(1);
    let (Some(kernel), Some(runs)) = (arguments.next(), arguments.next()) else {
        eprintln!("usage: instructions KERNEL RUNS");
        return Ok(ExitCode::from(2));
    };
    let runs: u32 = runs.parse()?;
    rayon::ThreadPoolBuilder::new()
        .num_threads(1)
        .build_global()?;
    run(&kernel, runs)
}

fn run(kernel: &str, runs: u32) -> Result<ExitCode, Box<dyn Error>> {
    let points = many_curves(POINTS, 1)?.points;
    let scattered = uniform(SCATTERED, 1)?;
    let dense = dense_one_curve(DENSE)?;
    let measured = MeasuredCurve::new(dense.clone(), Estimator::Voronoi)?;
    let condition = Condition::rho(0.9)?;
    for _ in 0..runs {
        match kernel {
            "point-set" => drop(black_box(anew(&points))),
            "neighbours" => drop(black_box(neighbours(&points, HalfRule::Bisector))),
            "delaunay" => drop(black_box(Delaunay::new(&points))),
            "crust" => drop(black_box(crust(&points))),
            "least-detour" => drop(black_box(least_detour(&scattered))),
            "lfs" => drop(black_box(MeasuredCurve::new(
                dense.clone(),
                Estimator::Voronoi,
            )?)),
            "sampling" => drop(black_box(sample(&measured, condition)?)),
            other => {
                eprintln!("no kernel {other}");
                return Ok(ExitCode::from(2));
            }
        }
    }
    Ok(ExitCode::SUCCESS)
}
