//! Seeds that depend on nothing but names.

use curvecrust::geometry::Random;

/// The seed of a trial: of the experiment's seed, the names of what is run, and the trial's number.
/// Adding inputs, values or trials leaves the seeds of the others as they are.
pub(super) fn seed_of(seed: u64, experiment: &str, series: &str, x: f64, trial: u32) -> u64 {
    let names = format!("{experiment}\n{series}\n{x}\n{trial}");
    // FNV-1a, then mixed.
    let hash = names
        .bytes()
        .fold(0xcbf2_9ce4_8422_2325, |hash: u64, byte| {
            (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3)
        });
    Random::new(seed ^ hash).bits()
}
