//! How the time of the local feature size grows with drawings that repeat something.
//!
//! Each drawing is measured with a number of dense points and with a sixteenth of it. The table has
//! the exponent of growth, and the time as a multiple of that for one smooth curve. The first
//! argument is the number of dense points, by default 100,000. The second one is a part of the
//! names of drawings to run; by default all run. Processor time of one thread; the fastest of five
//! runs.

#![allow(clippy::print_stdout, reason = "a program for a terminal")]

use std::error::Error;

use curvecrust_benches::growth::{PER_SEGMENT, of_lfs};
use curvecrust_testing::drawings::{DRAWINGS, ONE_CURVE};

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
        let growth = of_lfs(drawing, most)?;
        let one_curve = *one_curve.get_or_insert(growth.each());
        println!(
            "{:>20} {:>10} {:>10.3} {:>9.2} {:>9.2}",
            drawing.name,
            growth.many.0,
            growth.many.1,
            growth.exponent(),
            growth.each() / one_curve
        );
    }
    Ok(())
}
