//! Seeds that depend on nothing but names.

use crate::digest::fnv1a;
use curvecrust::geometry::Random;

/// The seed of a trial: of the experiment's seed, the names of what is run, and the trial's number.
/// Adding inputs, values or trials leaves the seeds of the others as they are.
pub(super) fn seed_of(seed: u64, experiment: &str, series: &str, x: f64, trial: u32) -> u64 {
    let names = format!("{experiment}\n{series}\n{x}\n{trial}");
    Random::new(seed ^ fnv1a(names.bytes())).bits()
}
