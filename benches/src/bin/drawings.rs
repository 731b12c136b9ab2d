//! How the time of the local feature size grows with drawings that repeat something.
//!
//! Each drawing is measured with a number of dense points and with a quarter of it. The table has
//! the exponent of growth, and the time as a multiple of that for one smooth curve. The first
//! argument is the number of dense points, by default 100,000. The second one is a part of the
//! names of drawings to run; by default all run. One thread; the fastest of three runs.

#![allow(clippy::print_stdout, reason = "a program for a terminal")]

use std::error::Error;
use std::hint::black_box;
use std::time::Instant;

use curvecrust_curve::DenseCurve;
use curvecrust_medial_axis::{Estimator, MeasuredCurve};
use curvecrust_testing::drawings::{DRAWINGS, Drawing, ONE_CURVE};

/// Dense points on each cubic.
const PER_SEGMENT: u32 = 30;

fn main() -> Result<(), Box<dyn Error>> {
    let mut arguments = std::env::args().skip(1);
    let most = arguments.next().and_then(|n| n.parse().ok());
    let most: usize = most.unwrap_or(100_000);
    let wanted = arguments.next().unwrap_or_default();
    rayon::ThreadPoolBuilder::new()
        .num_threads(1)
        .build_global()?;
    println!("lfs by {PER_SEGMENT} dense points a cubic");
    println!(
        "{:>20} {:>10} {:>10} {:>9} {:>9}",
        "", "points", "seconds", "exponent", "times one"
    );
    let mut one_curve = None;
    let chosen = DRAWINGS.iter().filter(|d| d.name.contains(&wanted));
    for drawing in [&ONE_CURVE].into_iter().chain(chosen) {
        let few = time_a_point(drawing, most / 4)?;
        let (points, each) = time_a_point(drawing, most)?;
        let one_curve = *one_curve.get_or_insert(each);
        println!(
            "{:>20} {points:>10} {:>10.3} {:>9.2} {:>9.2}",
            drawing.name,
            each * points as f64,
            1.0 + (each / few.1).ln() / (points as f64 / few.0 as f64).ln(),
            each / one_curve
        );
    }
    Ok(())
}

/// The number of dense points, and the seconds for each of them.
fn time_a_point(drawing: &Drawing, points: usize) -> Result<(usize, f64), Box<dyn Error>> {
    let curve = (drawing.curve)(points / PER_SEGMENT as usize);
    let dense = DenseCurve::per_segment(&curve, PER_SEGMENT)?;
    let count = dense.len();
    let mut least = f64::INFINITY;
    for _ in 0..3 {
        let dense = dense.clone();
        let start = Instant::now();
        black_box(MeasuredCurve::new(dense, Estimator::Voronoi)?);
        least = least.min(start.elapsed().as_secs_f64());
    }
    Ok((count, least / count as f64))
}
