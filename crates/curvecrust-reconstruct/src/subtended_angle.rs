//! The angle that an edge subtends at a point, compared without rounding error.

use std::cmp::Ordering;

use curvecrust_geometry::DVec2;
use glam::Vec2Swizzles;
use num_bigint::BigInt;
use num_traits::{RefNum, Signed};

use crate::exact::{Vector, cross, dot, integers, small_integers, sub};

/// Half a unit in the last place of 1: the relative error of one operation.
const U: f64 = f64::EPSILON / 2.0;

/// The angle that the edge `pq` subtends at a point to its left.
#[derive(Clone, Copy, Debug)]
pub(crate) struct SubtendedAngle {
    p: DVec2,
    q: DVec2,
    at: DVec2,
    /// From the point to `p` and to `q`.
    u: DVec2,
    v: DVec2,
}

impl SubtendedAngle {
    pub(crate) fn new(p: DVec2, q: DVec2, at: DVec2) -> Self {
        let (u, v) = (p - at, q - at);
        Self { p, q, at, u, v }
    }

    /// Whether the angle is below 90 degrees, exactly: the point lies outside the closed disc with
    /// diameter `pq`.
    pub(crate) fn is_acute(&self) -> bool {
        let dot = self.u.dot(self.v);
        // Each product errs by 3 U, their sum by one more.
        let error = 8.0 * U * self.u.abs().dot(self.v.abs());
        if dot.abs() > error {
            return dot > 0.0;
        }
        self.is_acute_exactly()
    }

    #[cold]
    fn is_acute_exactly(&self) -> bool {
        let points = [self.p, self.q, self.at];
        match small_integers(points, 2) {
            Some(points) => cosine(&points).is_positive(),
            None => cosine(&integers(points).0).is_positive(),
        }
    }

    /// Whether the angle is below asin(1 / beta), exactly, for a beta above 1: the point lies
    /// outside the closed disc of radius `beta |pq| / 2` that touches both ends and whose centre is
    /// on the side of the point.
    pub(crate) fn is_below(&self, beta: f64) -> bool {
        // cos > sqrt(beta^2 - 1) sin, factored so that it does not overflow.
        let cotangent = (beta - 1.0).sqrt() * (beta + 1.0).sqrt();
        let cosine = self.u.dot(self.v);
        let sine = self.u.perp_dot(self.v).abs();
        let estimate = cosine - cotangent * sine;
        // Each product errs by 3 U, sums and the cotangent by a few more.
        let sines = cotangent * self.u.abs().dot(self.v.abs().yx());
        let error = 16.0 * U * (self.u.abs().dot(self.v.abs()) + sines);
        if estimate.abs() > error {
            return estimate > 0.0;
        }
        self.is_below_exactly(beta)
    }

    #[cold]
    fn is_below_exactly(&self, beta: f64) -> bool {
        let ([p, q, at], _) = integers([self.p, self.q, self.at]);
        let (u, v) = (sub(&p, &at), sub(&q, &at));
        let (cosine, sine) = (dot(&u, &v), cross(&u, &v));
        // beta = numerator / denominator
        let ([[numerator, denominator]], _) = integers([DVec2::new(beta, 1.0)]);
        let denominator = &denominator * &denominator;
        let squared = &numerator * &numerator - &denominator;
        cosine.is_positive() && &cosine * &cosine * denominator > squared * &sine * &sine
    }

    /// How this angle and `other`, which the edge subtends at a point to its right, compare to 90
    /// degrees in sum, exactly; both must be acute.
    pub(crate) fn sum_to_right_angle(&self, other: &Self) -> Ordering {
        // cos(a + b) = cos a cos b - sin a sin b falls as the sum grows.
        let cosines = self.u.dot(self.v) * other.u.dot(other.v);
        let sines = self.u.perp_dot(self.v) * other.u.perp_dot(other.v);
        let estimate = cosines - sines;
        // Each factor errs by 4 U of its terms, which are at most this.
        let size = |s: &Self| s.u.abs().dot(s.v.abs()) + s.u.abs().dot(s.v.abs().yx());
        let error = 16.0 * U * size(self) * size(other);
        if estimate.abs() > error {
            return 0.0_f64.total_cmp(&estimate);
        }
        self.sum_to_right_angle_exactly(other)
    }

    #[cold]
    fn sum_to_right_angle_exactly(&self, other: &Self) -> Ordering {
        // Both edges are pq, in either direction.
        let points = [self.p, self.q, self.at, other.at];
        match small_integers(points, 4) {
            Some(points) => 0.cmp(&cosine_of_sum(&points)),
            None => BigInt::ZERO.cmp(&cosine_of_sum(&integers(points).0)),
        }
    }
}

/// The cosine, times a positive number, of the angle that `pq` subtends at `a`.
fn cosine<T: Signed>([p, q, a]: &[Vector<T>; 3]) -> T
where
    for<'t> &'t T: RefNum<T>,
{
    dot(&sub(p, a), &sub(q, a))
}

/// The cosine, times a positive number, of the sum of the angles that `pq` subtends at `a` to its
/// left and at `b` to its right.
fn cosine_of_sum<T: Signed>([p, q, a, b]: &[Vector<T>; 4]) -> T
where
    for<'t> &'t T: RefNum<T>,
{
    let [u, v] = [sub(p, a), sub(q, a)];
    let [x, y] = [sub(q, b), sub(p, b)];
    dot(&u, &v) * dot(&x, &y) - cross(&u, &v) * cross(&x, &y)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Corners of a square of twice this size around the first point, in any order.
    fn corners<const N: usize>(most: f64) -> impl Iterator<Item = [DVec2; N]> {
        let corners = [(1.0, 1.0), (1.0, -1.0), (-1.0, -1.0), (-1.0, 1.0)];
        (0..64).map(move |which| {
            let corner = |place: usize| corners[which >> (2 * place) & 3];
            std::array::from_fn(|i| match i.checked_sub(1) {
                Some(place) => DVec2::from(corner(place)) * most,
                None => DVec2::ZERO,
            })
        })
    }

    /// In a debug build, where an overflow panics.
    #[test]
    fn small_integers_fit_into_128_bits() {
        for points in corners(2f64.powi(53) - 1.0) {
            let exact = cosine(&integers(points).0);
            assert_eq!(exact, cosine(&small_integers(points, 2).unwrap()).into());
        }
        for points in corners(2f64.powi(27) - 1.0) {
            let exact = cosine_of_sum(&integers(points).0);
            let of_small = cosine_of_sum(&small_integers(points, 4).unwrap());
            assert_eq!(exact, of_small.into());
        }
    }
}
