//! How well a curve explains points, beside a background of evenly spread ones.

use std::f64::consts::TAU;

/// The width of a normal distribution that is as high as at its middle, in deviations:
/// sqrt(2 pi e).
const WIDTH: f64 = 4.13;
/// The least width of a band, in spacings along it.
const THINNEST: f64 = 0.05;

/// By how much the logarithm of the likelihood of `count` points is larger if they belong to a band
/// of a length and a deviation than if they belong to a background of a density.
pub(crate) fn of_band(count: f64, length: f64, sigma: f64, density: f64) -> f64 {
    let width = WIDTH * sigma.max(THINNEST * length / count);
    count * ((count / length / width / density).ln() - 1.0)
}

/// The logarithm of the density of a normal distribution.
pub(crate) fn log_normal(distance: f64, sigma: f64) -> f64 {
    let z = distance / sigma;
    -0.5 * z * z - (sigma * TAU.sqrt()).ln()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn densities_integrate_to_one() {
        let step = 0.01;
        let sum: f64 = (-800..=800)
            .map(|i| log_normal(f64::from(i) * step, 0.7).exp())
            .sum();
        assert!((sum * step - 1.0).abs() < 1e-9, "{sum}");
    }

    #[test]
    fn a_band_as_dense_as_the_background_is_no_curve() {
        let (count, length, sigma) = (50.0, 3.0, 0.4);
        let density = count / length / (WIDTH * sigma);
        assert!((of_band(count, length, sigma, density) + count).abs() < 1e-9);
        assert!(of_band(count, length, sigma, density / 100.0) > count);
    }
}
