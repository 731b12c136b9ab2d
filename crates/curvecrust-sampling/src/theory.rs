//! What a sampling bound implies, in closed form.
//!
//! S. Ohrhallinger, S. A. Mitchell, M. Wimmer, *Curve Reconstruction with Many Fewer Samples*, SGP
//! 2016: Lemmas 8 to 10, Theorem 1 and the columns of Table 1, as the paper states them. Angles are
//! in radians.

use std::f64::consts::{PI, TAU};

/// The least angle between consecutive edges of a sample with bound `b`, at constant curvature:
/// pi - 4 asin(b / 2) (Lemma 8; tight there). NaN for a bound above 2.
///
/// For a rho-sample with rho < 1 it is a lower bound on any smooth curve.
///
/// ```
/// use curvecrust_sampling::theory::least_angle;
///
/// assert_eq!(least_angle(0.9).to_degrees().round(), 73.0);
/// assert_eq!(least_angle(1.0).to_degrees().round(), 60.0);
/// ```
#[must_use]
pub fn least_angle(b: f64) -> f64 {
    PI - 4.0 * (b / 2.0).asin()
}

/// The rho for which every epsilon-sample is a rho-sample: epsilon / (1 - epsilon) (Theorem 1), for
/// epsilon < 1.
///
/// ```
/// use curvecrust_sampling::theory::rho_of_epsilon;
///
/// assert_eq!(rho_of_epsilon(0.5), 1.0);
/// assert!(rho_of_epsilon(0.47) < 0.9);
/// ```
#[must_use]
pub fn rho_of_epsilon(epsilon: f64) -> f64 {
    epsilon / (1.0 - epsilon)
}

/// The average number of samples on a circle whose consecutive edges meet at `angle` (Table 1).
#[must_use]
pub fn samples_on_circle(angle: f64) -> f64 {
    TAU / (PI - angle)
}

/// The average number of samples, for bound `b`, on parallel lines as long as their distance
/// (Table 1): consecutive ones are 2 b lfs apart, and lfs is half the distance.
#[must_use]
pub fn samples_on_parallel_lines(b: f64) -> f64 {
    1.0 / b
}

/// How far a curve may be from the polygon of a rho-sample, as a factor of lfs: rho^2 / 2
/// (Lemma 10), for rho < 1.
#[must_use]
pub fn distance_to_polygon(rho: f64) -> f64 {
    rho * rho / 2.0
}

#[cfg(test)]
mod tests {
    use super::*;

    fn near(a: f64, b: f64) -> bool {
        (a - b).abs() < 1e-12
    }

    /// On regular polygons, whose samples are as far as the bound from the middle of the arc
    /// between them.
    #[test]
    fn circles_attain_what_bounds_imply() {
        for n in (3..50u32).map(f64::from) {
            let bound = 2.0 * (PI / n / 2.0).sin();
            let angle = PI - TAU / n;
            assert!(near(least_angle(bound), angle));
            assert!((samples_on_circle(angle) - n).abs() < 1e-9);
            assert!(near(distance_to_polygon(bound), 1.0 - (PI / n).cos()));
        }
    }

    /// Two lines at distance 2, where lfs is 1: samples 2 b apart on either, 2 / 2 b of them along
    /// 2 on each.
    #[test]
    fn lines_have_closed_forms() {
        for b in [0.1, 0.47, 0.9] {
            assert!(near(samples_on_parallel_lines(b), 2.0 / (2.0 * b)));
        }
        for (epsilon, rho) in [(0.5, 1.0), (1.0 / 3.0, 0.5), (0.2, 0.25)] {
            assert!(near(rho_of_epsilon(epsilon), rho));
        }
    }
}
