//! How much more hard points cost than well-spread ones, by algorithm: a table of ratios, those
//! above 4 marked. The first argument is the number of points, 100,000 if there is none; the
//! second and third, if any, parts of the names of the algorithms and of the sets to run.
//!
//! With `growth` in front of them it prints how processor time grows where it once grew as the
//! square, or where the search has work at every point: lfs on drawings, Crust beyond the 53 bits
//! of a double, least detour on scattered points. Exponents above their goals are marked.

#![allow(clippy::print_stdout, reason = "a program for a terminal")]

use std::error::Error;
use std::hint::black_box;
use std::time::Instant;

use curvecrust_benches::growth::{self, Growth};
use curvecrust_geometry::PointSet;
use curvecrust_reconstruct::{ALGORITHMS, Crust, LeastDetour, Reconstructor};
use curvecrust_testing::drawings::{DRAWINGS, ONE_CURVE};
use curvecrust_testing::hard_points::{HARD_POINTS, HardPoints, WELL_SPREAD};
use curvecrust_testing::scattered::SCATTERED;

/// Of each algorithm on each set.
const RUNS: usize = 3;

/// Seconds after which a run is not repeated.
const LONG: f64 = 0.1;

/// Hard points that have more than 53 bits.
const WIDE: [&str; 2] = ["exponential spiral", "grid at 1e17 and the origin"];

/// The largest exponent that lfs and Crust should have.
const GOAL: f64 = 1.2;

/// The same for least detour on scattered points.
const SCATTERED_GOAL: f64 = 1.3;

fn main() -> Result<(), Box<dyn Error>> {
    let mut arguments = std::env::args().skip(1).peekable();
    let is_growth = arguments.next_if_eq("growth").is_some();
    let size = arguments.next().and_then(|n| n.parse().ok());
    let size = size.unwrap_or(100_000);
    let [wanted, sets] = [(); 2].map(|()| arguments.next().unwrap_or_default());
    if is_growth {
        return print_growth(size, &wanted, &sets);
    }
    print_ratios(size, &wanted, &sets);
    Ok(())
}

/// Processor time of one thread, and the exponents by which it grows from a sixteenth of the
/// points.
fn print_growth(size: usize, wanted: &str, sets: &str) -> Result<(), Box<dyn Error>> {
    rayon::ThreadPoolBuilder::new()
        .num_threads(1)
        .build_global()?;
    println!(
        "{:>12} {:>28} {:>8} {:>8} {:>8} {:>5}",
        "", "", "points", "seconds", "exponent", "goal"
    );
    let row = |method: &str, set: &str, growth: Growth, goal: f64| {
        let exponent = growth.exponent();
        let mark = if exponent > goal { "!" } else { "" };
        let (points, seconds) = growth.many;
        println!(
            "{method:>12} {set:>28} {points:>8} {seconds:>8.3} {exponent:>8.2} {goal:>5}{mark}"
        );
    };
    if "lfs".contains(wanted) {
        let chosen = DRAWINGS.iter().filter(|d| d.name.contains(sets));
        for drawing in [&ONE_CURVE].into_iter().chain(chosen) {
            row("lfs", drawing.name, growth::of_lfs(drawing, size)?, GOAL);
        }
    }
    let wide = HARD_POINTS.iter().filter(|hard| WIDE.contains(&hard.name));
    let wide = wide.map(|hard| (&Crust as &dyn Reconstructor, hard, GOAL));
    let scattered = SCATTERED.iter();
    let scattered =
        scattered.map(|hard| (&LeastDetour as &dyn Reconstructor, hard, SCATTERED_GOAL));
    for (algorithm, hard, goal) in wide.chain(scattered) {
        let name = algorithm.info().name;
        if name.contains(wanted) && hard.name.contains(sets) {
            let growth = growth::of_algorithm(algorithm, hard, size);
            row(name, hard.name, growth, goal);
        }
    }
    Ok(())
}

/// Times as multiples of those for well-spread points.
fn print_ratios(size: usize, wanted: &str, sets: &str) {
    let algorithms: Vec<&dyn Reconstructor> = ALGORITHMS
        .iter()
        .copied()
        .filter(|a| a.info().name.contains(wanted))
        .collect();
    let names: Vec<&str> = algorithms.iter().map(|a| a.info().name).collect();
    println!("{size} points, ratios to well spread ones, the fastest of up to {RUNS} runs each");
    println!("{:>38} {:>8} {}", "", "set", names.join(" "));
    let spread = times(&WELL_SPREAD, size, &algorithms);
    row(WELL_SPREAD.name, &names, &spread, |t| format!("{t:.4} s"));
    for hard in HARD_POINTS.iter().filter(|hard| hard.name.contains(sets)) {
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
