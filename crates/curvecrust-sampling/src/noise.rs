//! Samples that went wrong: seeded noise and outliers, for what reconstructions make of them.

use curvecrust_geometry::DVec2;
use curvecrust_medial_axis::Measured;

use crate::error::SamplingError;
use crate::random::Random;
use crate::sampled_curve::SampledCurve;

/// How samples are displaced.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Noise {
    /// The distribution of the displacements.
    pub shape: NoiseShape,
    /// Its size: the standard deviation of either coordinate, or the radius of the disc.
    pub size: NoiseSize,
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

/// The samples, in their order, each displaced at random. The same seed gives the same points.
///
/// # Errors
/// [`Parameter`](SamplingError::Parameter) if the fraction is negative or not finite;
/// [`NoSuchPlace`](SamplingError::NoSuchPlace) if the samples are of another dense curve.
pub fn with_noise(
    measured: &Measured,
    sampled: &SampledCurve,
    noise: Noise,
    seed: u64,
) -> Result<Vec<DVec2>, SamplingError> {
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
    let mut random = Random::new(seed);
    let samples = sampled.points().iter().zip(sampled.dense_indices());
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
        let p = DVec2::new(random.between(-1.0, 1.0), random.between(-1.0, 1.0));
        let squared = p.length_squared();
        if squared > 0.0 && squared < 1.0 {
            return (p, squared);
        }
    }
}

/// The points, and after them `count` more that are uniform in their bounding box, widened on all sides by
/// a fraction of its larger side. No points have no outliers.
///
/// # Errors
/// [`Parameter`](SamplingError::Parameter) if the fraction is negative or not finite.
pub fn with_outliers(
    points: &[DVec2],
    count: usize,
    margin: f64,
    seed: u64,
) -> Result<Vec<DVec2>, SamplingError> {
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
        let x = random.between(low.x, high.x);
        DVec2::new(x, random.between(low.y, high.y))
    }));
    Ok(all)
}

fn bounds(points: &[DVec2]) -> (DVec2, DVec2) {
    let empty = (DVec2::INFINITY, DVec2::NEG_INFINITY);
    let fold = |(low, high): (DVec2, DVec2), p: &DVec2| (low.min(*p), high.max(*p));
    points.iter().fold(empty, fold)
}
