//! Signs without rounding error: Shewchuk's adaptive predicates, by the `robust` crate.

use glam::DVec2;
use robust::Coord;

fn coord(p: DVec2) -> Coord<f64> {
    Coord { x: p.x, y: p.y }
}

/// Positive iff `a`, `b`, `c` turn counter-clockwise, negative iff clockwise, zero iff collinear.
///
/// The sign is exact for coordinates in the range of a [`PointSet`](crate::PointSet); the value
/// approximates twice the signed area of the triangle.
#[must_use]
pub fn orient2d(a: DVec2, b: DVec2, c: DVec2) -> f64 {
    robust::orient2d(coord(a), coord(b), coord(c))
}

/// Positive iff `d` lies inside the circle through the counter-clockwise triangle `a`, `b`, `c`,
/// negative iff outside, zero iff on it; for a clockwise triangle the signs swap.
///
/// The sign is exact for coordinates in the range of a [`PointSet`](crate::PointSet).
///
/// ```
/// use curvecrust_geometry::{DVec2, in_circle};
///
/// let [a, b, c] = [DVec2::X, DVec2::Y, DVec2::NEG_X];
/// assert!(in_circle(a, b, c, DVec2::ZERO) > 0.0);
/// assert_eq!(in_circle(a, b, c, DVec2::NEG_Y), 0.0);
/// ```
#[must_use]
pub fn in_circle(a: DVec2, b: DVec2, c: DVec2, d: DVec2) -> f64 {
    robust::incircle(coord(a), coord(b), coord(c), coord(d))
}
