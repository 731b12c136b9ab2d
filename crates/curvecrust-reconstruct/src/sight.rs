//! The angles under which an edge is seen from other points, compared without rounding error.

use curvecrust_geometry::DVec2;
use glam::Vec2Swizzles;

use crate::expansion::Expansion;

/// Half a unit in the last place of 1: the relative error of one operation.
const U: f64 = f64::EPSILON / 2.0;

/// The edge `pq` as seen from a point to its left.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Sight {
    p: DVec2,
    q: DVec2,
    from: DVec2,
    /// From the point to `p` and to `q`.
    u: DVec2,
    v: DVec2,
}

impl Sight {
    pub(crate) fn new(p: DVec2, q: DVec2, from: DVec2) -> Self {
        let (u, v) = (p - from, q - from);
        Self { p, q, from, u, v }
    }

    /// Whether the angle is below 90 degrees, exactly: the point lies outside the closed disc with
    /// diameter `pq`.
    pub(crate) fn is_acute(&self) -> bool {
        let dot = self.u.dot(self.v);
        // Each product errs by 3 U, their sum by one more.
        let error = 8.0 * U * self.u.abs().dot(self.v.abs());
        let sign = if dot.abs() > error {
            dot
        } else {
            self.exact_dot().sign()
        };
        sign > 0.0
    }

    /// The cotangent of the angle, in floating point; infinite for slivers.
    pub(crate) fn cotangent(&self) -> f64 {
        // The point is to the left: only rounding makes the cross product negative.
        self.u.dot(self.v) / self.u.perp_dot(self.v).abs()
    }

    /// Whether this angle and `other` sum to 90 degrees or less, exactly; both must be acute.
    pub(crate) fn sums_to_right_angle_at_most(&self, other: &Self) -> bool {
        // cos(a + b) = cos a cos b - sin a sin b >= 0.
        let cosines = self.u.dot(self.v) * other.u.dot(other.v);
        let sines = self.u.perp_dot(self.v) * other.u.perp_dot(other.v);
        let estimate = cosines - sines;
        // Each factor errs by 4 U of its terms, which are at most this.
        let size = |s: &Self| s.u.abs().dot(s.v.abs()) + s.u.abs().dot(s.v.yx().abs());
        let error = 16.0 * U * size(self) * size(other);
        if estimate.abs() > error {
            return estimate > 0.0;
        }
        let cosines = self.exact_dot().times(&other.exact_dot());
        let sines = self.exact_cross().times(&other.exact_cross());
        cosines.minus(&sines).sign() >= 0.0
    }

    fn exact_dot(&self) -> Expansion {
        let [[ux, uy], [vx, vy]] = self.exact_sides();
        ux.times(&vx).plus(&uy.times(&vy))
    }

    fn exact_cross(&self) -> Expansion {
        let [[ux, uy], [vx, vy]] = self.exact_sides();
        ux.times(&vy).minus(&uy.times(&vx))
    }

    fn exact_sides(&self) -> [[Expansion; 2]; 2] {
        [self.p, self.q].map(|end| {
            [
                Expansion::difference(end.x, self.from.x),
                Expansion::difference(end.y, self.from.y),
            ]
        })
    }
}
