//! A robust parabola through the points of a window.
//!
//! Source: D. Levin, *Mesh-Independent Surface Interpolation*, 2004 (moving least squares); the
//! weights are those of J. Tukey.

use glam::{DMat3, DVec2, DVec3};

use crate::robust::{NORMAL, median};

/// The fewest points that a parabola is fitted to.
const FEWEST: usize = 5;
const ROUNDS: usize = 3;
/// Residuals, in robust deviations, from which on a point has no weight.
const CUT: f64 = 3.5;
/// The least deviation, in spacings of the window: points of a clean curve must not lose weight
/// because a parabola is not the curve.
const FLOOR: f64 = 0.05;
/// A point supports the curve if its residual is within this many deviations.
const SUPPORT: f64 = 3.0;

/// What a window says.
#[derive(Clone, Debug)]
pub(crate) struct Parabola {
    /// The place of the centre on the parabola.
    pub(crate) place: DVec2,
    /// The robust deviation of the points from the parabola.
    pub(crate) sigma: f64,
    /// For each member, whether it lies near the parabola.
    pub(crate) supported: Vec<bool>,
}

/// Fits a parabola to the members of the window of a radius about a centre; `None` of fewer than
/// five.
pub(crate) fn parabola(
    points: &[DVec2],
    members: &[usize],
    centre: DVec2,
    radius: f64,
) -> Option<Parabola> {
    let count = members.len();
    if count < FEWEST {
        return None;
    }
    let relative: Vec<DVec2> = members
        .iter()
        .map(|&j| (points[j] - centre) / radius)
        .collect();
    let near: Vec<f64> = relative
        .iter()
        .map(|p| (1.0 - p.length_squared()).max(0.0))
        .collect();
    let mut robust = vec![1.0; count];
    let mut residuals = vec![0.0; count];
    let (mut mean, mut axis, mut curve, mut deviation) = (DVec2::ZERO, DVec2::X, DVec3::ZERO, 0.0);
    let floor = FLOOR * 2.0 / count as f64;
    for _ in 0..ROUNDS {
        let weight = |k: usize| near[k] * robust[k];
        let total: f64 = (0..count).map(weight).sum();
        if total <= 1e-12 {
            break;
        }
        mean = (0..count).map(|k| weight(k) * relative[k]).sum::<DVec2>() / total;
        axis = principal_axis((0..count).map(|k| (weight(k), relative[k] - mean)));
        let (mut normal, mut right) = (DMat3::ZERO, DVec3::ZERO);
        let local = |k: usize| {
            let p = relative[k] - mean;
            (p.dot(axis), axis.perp_dot(p))
        };
        for k in 0..count {
            let (u, v) = local(k);
            let powers = DVec3::new(1.0, u, u * u);
            let weighted = weight(k) * powers;
            normal += DMat3::from_cols(weighted, weighted * u, weighted * (u * u));
            right += weighted * v;
        }
        normal.z_axis.z += 1e-3 * normal.x_axis.x;
        curve = solve(normal, right);
        for (k, residual) in residuals.iter_mut().enumerate() {
            let (u, v) = local(k);
            *residual = v - curve.dot(DVec3::new(1.0, u, u * u));
        }
        let mut sizes: Vec<f64> = residuals.iter().map(|r| r.abs()).collect();
        let left = (count as f64 - 3.0).max(1.0);
        deviation = NORMAL * median(&mut sizes) * (count as f64 / left).sqrt();
        let cut = CUT * deviation.max(floor);
        for (w, r) in robust.iter_mut().zip(&residuals) {
            let z = r / cut;
            *w = if z.abs() < 1.0 {
                (1.0 - z * z).powi(2)
            } else {
                0.0
            };
        }
    }
    let u = (-mean).dot(axis).clamp(-1.0, 1.0);
    let v = curve.dot(DVec3::new(1.0, u, u * u));
    let near = SUPPORT * deviation.max(floor);
    Some(Parabola {
        place: centre + radius * (mean + u * axis + v * axis.perp()),
        sigma: deviation * radius,
        supported: residuals.iter().map(|r| r.abs() < near).collect(),
    })
}

/// The direction in which weighted points scatter most.
fn principal_axis(points: impl Iterator<Item = (f64, DVec2)>) -> DVec2 {
    let (mut squares, mut product) = (DVec2::ZERO, 0.0);
    for (weight, p) in points {
        squares += weight * p * p;
        product += weight * p.x * p.y;
    }
    DVec2::from_angle(0.5 * (2.0 * product).atan2(squares.x - squares.y))
}

fn solve(matrix: DMat3, right: DVec3) -> DVec3 {
    let scale = matrix.x_axis.x;
    let determinant = matrix.determinant();
    if determinant.abs() > 1e-14 * scale * scale * scale {
        matrix.inverse() * right
    } else if scale > 0.0 {
        DVec3::new(right.x / scale, 0.0, 0.0)
    } else {
        DVec3::ZERO
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_parabola_is_its_own_fit_and_an_outlier_has_no_support() {
        let on = |i: i32| {
            let x = f64::from(i) / 10.0;
            DVec2::new(x, 0.3 * x * x)
        };
        let mut points: Vec<DVec2> = (-9..=9).map(on).collect();
        points.push(DVec2::new(0.1, 0.8));
        let members: Vec<usize> = (0..points.len()).collect();
        let found = parabola(&points, &members, DVec2::new(0.0, 0.05), 1.3).unwrap();
        assert!(found.place.length() < 5e-3, "{}", found.place);
        let lost: Vec<usize> = (0..20).filter(|&k| !found.supported[k]).collect();
        assert_eq!(lost, [19]);
        assert!(parabola(&points, &members[..4], DVec2::ZERO, 1.0).is_none());
    }
}
