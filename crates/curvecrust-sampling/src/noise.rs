//! Samples with errors: seeded noise and outliers, to try reconstructions on.

use curvecrust_geometry::{DVec2, Random};

use crate::error::SamplingError;
use crate::sampling::Sampling;

/// How samples are displaced.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Noise {
    /// The distribution of the displacements; Gaussian by default.
    pub shape: NoiseShape,
    /// Its size: the standard deviation of either coordinate, or the radius of the disc. A tenth of
    /// lfs by default.
    pub size: NoiseSize,
    /// Where the random numbers begin: the same seed gives the same points. 0 by default.
    pub seed: u64,
}

impl Default for Noise {
    fn default() -> Self {
        Self {
            shape: NoiseShape::Gaussian,
            size: NoiseSize::OfLfs(0.1),
            seed: 0,
        }
    }
}

/// Points to add that belong to no curve.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Outliers {
    /// How many; none by default.
    pub count: usize,
    /// How far beyond the bounding box of the points they may be, as a fraction of its larger side;
    /// 0 by default.
    pub margin: f64,
    /// Where the random numbers begin: the same seed gives the same points. 0 by default.
    pub seed: u64,
}

/// How displacements are distributed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NoiseShape {
    /// Both coordinates normal and independent.
    Gaussian,
    /// Uniform in a disc.
    Disc,
}

/// How large displacements are, as a fraction of a length.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum NoiseSize {
    /// Of lfs at the sample, or of the extent if that is smaller.
    OfLfs(f64),
    /// Of the extent: the larger side of the bounding box of the dense points.
    OfExtent(f64),
}

/// The samples, in their order, each displaced at random.
///
/// # Errors
/// [`Parameter`](SamplingError::Parameter) if the fraction is negative or not finite;
/// [`NoSuchPlace`](SamplingError::NoSuchPlace) if the samples are of another dense curve.
pub fn with_noise(sampling: &Sampling, noise: Noise) -> Result<Vec<DVec2>, SamplingError> {
    let Sampling {
        samples, measured, ..
    } = sampling;
    let (NoiseSize::OfLfs(fraction) | NoiseSize::OfExtent(fraction)) = noise.size;
    if !(fraction >= 0.0 && fraction.is_finite()) {
        return Err(SamplingError::Parameter {
            name: "the size of the noise",
            value: fraction,
            range: "a fraction, not below 0",
        });
    }
    let (low, high) = bounds(measured.dense().points());
    let extent = (high - low).max_element().max(0.0);
    let mut random = Random::new(noise.seed);
    let samples = samples.points().iter().zip(samples.dense_indices());
    let displaced = samples.enumerate().map(|(index, (&p, &dense))| {
        let lfs = measured.lfs().values().get(dense).copied();
        let lfs = lfs.ok_or(SamplingError::NoSuchPlace {
            index,
            dense,
            t: 0.0,
        })?;
        let size = match noise.size {
            NoiseSize::OfLfs(fraction) => fraction * lfs.min(extent),
            NoiseSize::OfExtent(fraction) => fraction * extent,
        };
        let (in_disc, squared) = in_disc(&mut random);
        let unit = match noise.shape {
            NoiseShape::Disc => in_disc,
            // Marsaglia's polar method.
            NoiseShape::Gaussian => in_disc * (-2.0 * squared.ln() / squared).sqrt(),
        };
        Ok(p + size * unit)
    });
    displaced.collect()
}

/// A uniform point of the unit disc other than its centre, and its squared distance to it.
fn in_disc(random: &mut Random) -> (DVec2, f64) {
    loop {
        let p = DVec2::new(
            random.fine_between(-1.0, 1.0),
            random.fine_between(-1.0, 1.0),
        );
        let squared = p.length_squared();
        if squared > 0.0 && squared < 1.0 {
            return (p, squared);
        }
    }
}

/// The points, and after them outliers that are uniform in their bounding box, widened on all sides
/// by the margin. No points have no outliers.
///
/// # Errors
/// [`Parameter`](SamplingError::Parameter) if the margin is negative or not finite.
pub fn with_outliers(points: &[DVec2], outliers: Outliers) -> Result<Vec<DVec2>, SamplingError> {
    let Outliers {
        count,
        margin,
        seed,
    } = outliers;
    if !(margin >= 0.0 && margin.is_finite()) {
        return Err(SamplingError::Parameter {
            name: "margin",
            value: margin,
            range: "a fraction, not below 0",
        });
    }
    let mut all = points.to_vec();
    if points.is_empty() {
        return Ok(all);
    }
    let (low, high) = bounds(points);
    let wider = DVec2::splat(margin * (high - low).max_element());
    let (low, high) = (low - wider, high + wider);
    let mut random = Random::new(seed);
    all.extend((0..count).map(|_| {
        let x = random.fine_between(low.x, high.x);
        DVec2::new(x, random.fine_between(low.y, high.y))
    }));
    Ok(all)
}

fn bounds(points: &[DVec2]) -> (DVec2, DVec2) {
    let empty = (DVec2::INFINITY, DVec2::NEG_INFINITY);
    let fold = |(low, high): (DVec2, DVec2), p: &DVec2| (low.min(*p), high.max(*p));
    points.iter().fold(empty, fold)
}
