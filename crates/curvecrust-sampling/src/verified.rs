//! Beyond the bound: as few samples as an algorithm still reconstructs.
//!
//! A sampling condition is enough, seldom necessary: HNN-Crust returns the manifold boundary from far
//! fewer samples than a rho below 0.9 asks for, if they are the right ones. Here samples are removed, merged
//! and moved along the curve, at random but seeded, as long as the algorithm returns exactly the manifold
//! boundary and the curve stays near the chords. What is found is verified for this sample set. It is
//! guaranteed for no other: not for a rotated one, when distances are nearly equal, nor with one sample more.
//!
//! For HNN-Crust, a step looks only at the choices that it can change: a sample that is removed was chosen
//! by its two neighbours alone, one that is added concerns those that it is near enough to. Cost of a step: O(k)
//! for k samples. Other algorithms run in full.

mod chain;
mod oracle;
mod search;

use curvecrust_medial_axis::Measured;
use curvecrust_reconstruct::Reconstructor;

use crate::error::SamplingError;
use crate::gaps::Gaps;
use crate::placed::PlacedSamples;
use crate::sampled_curve::SampledCurve;

use chain::Chains;
use oracle::Oracle;
use search::Search;

/// Samples from which an algorithm has been seen to return the manifold boundary.
#[derive(Clone, Debug, PartialEq)]
pub struct VerifiedSampling {
    /// The samples: verified for this sample set, never guaranteed.
    pub samples: SampledCurve,
    /// The name of the algorithm.
    pub algorithm: &'static str,
    /// The limit that every interval keeps.
    pub deviation: DeviationLimit,
}

/// How far the curve may be from the chord of its interval, at every point of it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum DeviationLimit {
    /// As far as it likes. Then the manifold boundary need not look like the curve at all: most curves
    /// end up with four samples, of which HNN-Crust returns the quadrilateral.
    None,
    /// Nearer than this length: a Hausdorff limit.
    Length(f64),
    /// Nearer than this fraction of lfs at each point. Up to 1, no chord gets across the medial axis: the point
    /// of the chord that is nearest to a curve point moves along all of it, and is within lfs every time. So the
    /// polygon can be deformed into the curve without touching the axis.
    OfLfs(f64),
}

/// What [`sample_verified`] is to hold, and how long it is to look.
#[derive(Clone, Copy, Debug)]
pub struct Verification<'a> {
    /// The algorithm that has to return the manifold boundary.
    pub algorithm: &'a dyn Reconstructor,
    /// How far the curve may be from the chord of its interval, everywhere.
    pub deviation: DeviationLimit,
    /// How often samples are shaken to find more that can go. Some 100 find most, a few 1000 nearly all.
    pub rounds: usize,
    /// Where the random steps begin. The same seed gives the same samples.
    pub seed: u64,
}

/// Takes samples away from `start`, and moves others along the curve, as long as the algorithm returns
/// exactly the [manifold boundary](SampledCurve::manifold_boundary).
///
/// A closed component keeps three samples, an open one both ends. `progress` is told how many rounds are
/// done, of how many.
///
/// # Errors
/// [`NotReconstructed`](SamplingError::NotReconstructed) if the algorithm does not return the manifold
/// boundary of `start`, [`LimitExceeded`](SamplingError::LimitExceeded) if `start` does not keep the
/// limit, and what [`PlacedSamples::of`] finds.
///
/// ```
/// use curvecrust_curve::Curve;
/// use curvecrust_medial_axis::{Discretisation, Estimator, measure};
/// use curvecrust_reconstruct::{HnnCrust, hnn_crust};
/// use curvecrust_sampling::{Condition, DeviationLimit, Verification, sample, sample_verified};
///
/// let d = "M 0 0 C 30 -20 50 20 80 0 S 120 40 80 60 S 30 30 0 60 S -30 20 0 0 Z";
/// let curve = Curve::from_path_data(d)?;
/// let measured = measure(&curve, Discretisation::Adaptive { gap_to_lfs: 0.02 }, Estimator::Voronoi, &|_, _| {})?;
/// let start = sample(&measured, Condition::rho(0.9)?)?.samples;
/// let verification = Verification {
///     algorithm: &HnnCrust::MUTUAL,
///     deviation: DeviationLimit::OfLfs(0.9),
///     rounds: 20,
///     seed: 1,
/// };
/// let fewer = sample_verified(&measured, &start, verification, &|_done, _of| {})?.samples;
/// assert!(fewer.len() < start.len());
/// assert_eq!(hnn_crust(&fewer.point_set()?), fewer.manifold_boundary());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn sample_verified(
    measured: &Measured,
    start: &SampledCurve,
    verification: Verification<'_>,
    progress: &dyn Fn(usize, usize),
) -> Result<VerifiedSampling, SamplingError> {
    let Verification {
        algorithm,
        deviation,
        rounds,
        seed,
    } = verification;
    let placed = PlacedSamples::of(measured, start)?;
    let name = algorithm.info().name;
    if !is_reconstructed(start, algorithm) {
        return Err(SamplingError::NotReconstructed { algorithm: name });
    }
    let gaps = Gaps::of(measured);
    let chains = Chains::new(measured, &placed);
    if let Some((component, dense)) = chains.beyond(&gaps, deviation) {
        return Err(SamplingError::LimitExceeded { component, dense });
    }
    let oracle = Oracle::new(algorithm, deviation, &gaps);
    let mut search = Search::new(chains, oracle, seed);
    search.shrink();
    let mut samples = search.chains().sampled(measured);
    for round in 0..rounds {
        progress(round, rounds);
        search.shake();
        search.shrink();
        if search.chains().len() < samples.len() {
            samples = search.chains().sampled(measured);
        }
    }
    progress(rounds, rounds);
    // Whatever the steps have looked at: this is what is promised.
    if !is_reconstructed(&samples, algorithm) {
        samples = start.clone();
    }
    Ok(VerifiedSampling {
        samples,
        algorithm: name,
        deviation,
    })
}

fn is_reconstructed(sampled: &SampledCurve, algorithm: &dyn Reconstructor) -> bool {
    sampled
        .point_set()
        .is_ok_and(|points| algorithm.reconstruct(&points) == sampled.manifold_boundary())
}
