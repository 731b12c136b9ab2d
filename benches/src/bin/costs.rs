//! What each algorithm costs on many curves: processor time of one thread a point, as a multiple of
//! Crust's on the same points, and the exponent by which it grows from a sixteenth of the points.
//! The rows are those of the table in `docs/algorithms.md`.
//!
//! The argument is the number of points, a million if there is none. Those that make tours or one
//! polygon take a tenth of it.

#![allow(clippy::print_stdout, reason = "a program for a terminal")]

use std::error::Error;

use curvecrust_benches::growth;
use curvecrust_geometry::DVec2;
use curvecrust_reconstruct::{ALGORITHMS, Crust};
use curvecrust_testing::hard_points::HardPoints;
use curvecrust_testing::planted::many_curves;

const POINTS: usize = 1_000_000;

/// Algorithms that are global, which take fewer points.
const GLOBAL: [&str; 3] = ["connect2d", "sig-connect2d", "shortest-tour"];

/// Closed curves of a thousand points each, in no order.
const MANY_CURVES: HardPoints = HardPoints {
    name: "many curves",
    points: curves,
};

fn main() -> Result<(), Box<dyn Error>> {
    let mut arguments = std::env::args().skip(1);
    let most = arguments.next().map_or(Ok(POINTS), |n| n.parse())?;
    let wanted = arguments.next().unwrap_or_default();
    rayon::ThreadPoolBuilder::new()
        .num_threads(1)
        .build_global()?;
    println!("| algorithm | points | a point | beside Crust | exponent |");
    println!("|---|---|---|---|---|");
    let [of_all, of_global] = [most, most / 10].map(|points| {
        let crust = growth::of_algorithm(&Crust, &MANY_CURVES, points);
        (points, crust.each())
    });
    let chosen = ALGORITHMS.iter().map(|a| (a, a.info().name));
    for (&algorithm, name) in chosen.filter(|(_, name)| name.contains(&wanted)) {
        let is_global = GLOBAL.contains(&name);
        let (points, crust) = if is_global { of_global } else { of_all };
        let growth = growth::of_algorithm(algorithm, &MANY_CURVES, points);
        let (each, exponent) = (growth.each(), growth.exponent());
        println!(
            "| {name} | {} | {:.2} µs | {:.1} | {exponent:.2} |",
            growth.many.0,
            1e6 * each,
            each / crust
        );
    }
    Ok(())
}

fn curves(points: usize) -> Vec<DVec2> {
    many_curves(points, 1).map_or_else(|_| Vec::new(), |planted| planted.points.points().to_vec())
}
