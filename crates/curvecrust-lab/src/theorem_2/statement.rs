//! What is proven: no four unknowns in the root box satisfy all necessary conditions.

use super::interval::Interval;

/// A box of the four unknowns: |q|; the signed curvature of the circle through s1 and q that is
/// tangent to the axis; the tangent of half the angle of the curve at q; |q z|.
pub(super) type Unknowns = [Interval; 4];

/// A node of a certificate, in preorder; of a split the upper half comes first.
#[derive(Clone, Debug)]
pub enum Node {
    /// Halve the box along an unknown.
    Split(usize),
    /// The conditions without a ball refute the box.
    Refuted,
    /// A ball free of the curve holds z.
    Ball {
        /// Its centre.
        center: [f64; 2],
        /// Its radius.
        radius: f64,
    },
}

/// All that is possible: |q| < rho |q z|, |q z| < 2 rho, and angles up to asin rho² + asin rho,
/// which is less than 2 atan 2 for rho < 0.9.
pub(super) fn root(rho: Interval) -> Unknowns {
    let two = Interval::point(2.0);
    [
        Interval::new(0.0, (two * rho.square()).hi()),
        Interval::new(-1.0, 1.0),
        Interval::new(-2.0, 2.0),
        Interval::new(0.0, (two * rho).hi()),
    ]
}
