//! Beyond the bound: as few samples as an algorithm still reconstructs.
//!
//! A sampling condition is sufficient and seldom necessary: HNN-Crust returns the manifold boundary
//! from far fewer samples than rho < 0.9 asks for, if they are the right ones. A local search
//! removes, merges and moves samples along the curve, at random but seeded, as long as the
//! algorithm returns exactly the manifold boundary and the curve stays near the chords.
//!
//! The result is verified for this sample set and guaranteed for no other: not for a rotated one,
//! when distances are nearly equal, nor for one with another sample.
//!
//! For HNN-Crust, a step checks only the choices that it can change. A sample that is removed was
//! chosen by its two neighbours alone; one that is added matters to samples that it is near enough
//! to. Cost of a step: O(k) for k samples. Other algorithms run in full.

mod chain;
mod oracle;
mod search;

use curvecrust_geometry::{DVec2, Progress};
use curvecrust_reconstruct::{HnnCrust, Reconstructor};

use crate::arcs::Arcs;
use crate::condition::{Condition, DeviationLimit};
use crate::error::SamplingError;
use crate::placed::PlacedSamples;
use crate::sampled_curve::SampledCurve;
use crate::sampling::Sampling;

use chain::Chains;
use oracle::Oracle;
use search::Search;

/// How [`sample_verified_with`] goes about it.
#[derive(Clone, Copy, Debug)]
pub struct VerifyOptions<'a> {
    /// The algorithm that has to return the manifold boundary; HNN-Crust by default.
    pub algorithm: &'a dyn Reconstructor,
    /// How far the curve may be from the chord between consecutive samples, everywhere; by default
    /// nearer than lfs, so that no chord gets across the medial axis.
    pub deviation: DeviationLimit,
    /// How often all samples are moved at random to find more that can go. Some 100 find most, a
    /// few 1000 nearly all; 300 by default.
    pub rounds: usize,
    /// Where the random numbers begin: the same seed gives the same samples. 1 by default.
    pub seed: u64,
    /// Places that stay samples where they are samples, such as corners; none by default.
    pub fixed: &'a [DVec2],
    /// Hears how many rounds are done, of how many.
    pub progress: Progress<'a>,
}

impl Default for VerifyOptions<'_> {
    fn default() -> Self {
        Self {
            algorithm: &HnnCrust::MUTUAL,
            deviation: DeviationLimit::OfLfs(1.0),
            rounds: 300,
            seed: 1,
            fixed: &[],
            progress: Progress::default(),
        }
    }
}

impl VerifyOptions<'_> {
    /// The default options; where a condition has a limit for the Hausdorff distance, the curve
    /// keeps within that.
    #[must_use]
    pub fn of(condition: Condition) -> Self {
        let default = Self::default();
        let limit = condition.hausdorff_limit();
        Self {
            deviation: limit.map_or(default.deviation, DeviationLimit::Length),
            ..default
        }
    }
}

/// Takes samples away from `start`, and moves others along the curve, as long as HNN-Crust returns
/// exactly the [manifold boundary](SampledCurve::manifold_boundary), and the curve is nearer to it
/// than lfs.
///
/// A closed component keeps three samples, an open one both ends. The condition of `start` need not
/// hold for what is left, which may attain more than its bound.
///
/// # Errors
/// [`NotReconstructed`](SamplingError::NotReconstructed) if the algorithm does not return the
/// manifold boundary of `start`, [`LimitExceeded`](SamplingError::LimitExceeded) if `start` does
/// not keep the limit, and what [`PlacedSamples::of`] finds.
///
/// ```
/// use curvecrust_curve::Curve;
/// use curvecrust_reconstruct::hnn_crust;
/// use curvecrust_sampling::{Condition, VerifyOptions, sample_curve, sample_verified_with};
///
/// let d = "M 0 0 C 30 -20 50 20 80 0 S 120 40 80 60 S 30 30 0 60 S -30 20 0 0 Z";
/// let curve = Curve::from_path_data(d)?;
/// let start = sample_curve(&curve, Condition::rho(0.9)?)?;
/// let options = VerifyOptions { rounds: 20, ..VerifyOptions::default() };
/// let fewer = sample_verified_with(&start, &options)?.samples;
/// assert!(fewer.len() < start.samples.len());
/// assert_eq!(hnn_crust(&fewer.point_set()?), fewer.manifold_boundary());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn sample_verified(start: &Sampling) -> Result<Sampling, SamplingError> {
    sample_verified_with(start, &VerifyOptions::default())
}

/// [`sample_verified`] by the given [options](VerifyOptions).
///
/// # Errors
/// Those of [`sample_verified`].
pub fn sample_verified_with(
    start: &Sampling,
    options: &VerifyOptions<'_>,
) -> Result<Sampling, SamplingError> {
    let VerifyOptions {
        algorithm,
        deviation,
        rounds,
        seed,
        fixed,
        progress,
    } = *options;
    let measured = &start.measured;
    let placed = PlacedSamples::of(measured, &start.samples)?;
    let name = algorithm.info().name;
    if !is_reconstructed(&start.samples, algorithm) {
        return Err(SamplingError::NotReconstructed { algorithm: name });
    }
    let arcs = Arcs::of(measured);
    let chains = Chains::new(measured, &placed, fixed);
    if let Some((component, dense)) = chains.beyond(&arcs, deviation) {
        return Err(SamplingError::LimitExceeded { component, dense });
    }
    let oracle = Oracle::new(algorithm, deviation, &arcs);
    let mut search = Search::new(chains, oracle, seed);
    search.shrink();
    let mut samples = search.chains().sampled(measured);
    for round in 0..rounds {
        progress.report(round, rounds);
        search.perturb();
        search.shrink();
        if search.chains().len() < samples.len() {
            samples = search.chains().sampled(measured);
        }
    }
    progress.report(rounds, rounds);
    // Whatever the steps have looked at: this is what is promised.
    if !is_reconstructed(&samples, algorithm) {
        samples = start.samples.clone();
    }
    Ok(Sampling::new(measured, &arcs, samples, start.condition))
}

fn is_reconstructed(sampled: &SampledCurve, algorithm: &dyn Reconstructor) -> bool {
    sampled
        .point_set()
        .is_ok_and(|points| algorithm.reconstruct(&points) == sampled.manifold_boundary())
}
