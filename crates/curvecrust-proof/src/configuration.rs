//! A box of the four unknowns, and what it determines.
//!
//! Names, coordinates and the numbers of lemmas are those of `docs/theorem-2.md`.

use crate::interval::Interval;
use crate::vector::Vector;

/// A box of the unknowns: the distance |q s1|; the curvature, positive if it bends down, of the
/// circle through q and s1 that touches the x axis at s1; the tangent of half the angle of the
/// curve at q; the distance |q z|.
pub type Unknowns = [Interval; 4];

/// All that the unknowns may be (Lemma 8).
pub(crate) fn root(rho: Interval) -> Unknowns {
    [
        Interval::new(0.0, (2.0 * rho.square()).high()),
        Interval::new(-1.0, 1.0),
        Interval::new(-2.0, 2.0),
        Interval::new(0.0, (2.0 * rho).high()),
    ]
}

/// What the unknowns determine. The sample s1 is the origin, the x axis the tangent there.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Configuration {
    pub(crate) rho: Interval,
    /// |q s1|.
    pub(crate) distance: Interval,
    pub(crate) curvature: Interval,
    /// |q z|.
    pub(crate) height: Interval,
    pub(crate) q: Vector,
    /// The direction of the curve at q, towards s1.
    pub(crate) tangent: Vector,
    /// The direction from q to z.
    pub(crate) normal: Vector,
    pub(crate) z: Vector,
    /// The product of the normal and q / |q s1|.
    pub(crate) slope: Interval,
}

impl Configuration {
    pub(crate) fn new(unknowns: &Unknowns, rho: Interval) -> Self {
        let [distance, curvature, half, height] = *unknowns;
        let sine = 0.5 * (curvature * distance);
        let cosine = (Interval::point(1.0) - sine.square()).sqrt();
        let direction = Vector::new(-cosine, -sine);
        let q = direction.times(distance);
        let [x, y] = half.cosine_and_sine();
        let tangent = Vector::new(x, y);
        let normal = tangent.turned();
        Self {
            rho,
            distance,
            curvature,
            height,
            q,
            tangent,
            normal,
            z: q + normal.times(height),
            slope: normal.dot(direction),
        }
    }

    /// |z s1| squared, by the triangle s1 q z.
    pub(crate) fn square_of_z(&self) -> Interval {
        self.distance.square() + self.height * (2.0 * (self.distance * self.slope) + self.height)
    }

    /// What lfs(q) is at least, if that of the whole interval is at least `reach`.
    pub(crate) fn lfs(&self, reach: Interval) -> Interval {
        reach.max(Interval::point(1.0) - self.distance).lower()
    }

    /// How far the normal of q runs in the disc about s1 of radius 1 or that about q of radius
    /// `lfs`, up (`side` 1) or down (-1): the radius of a disc free of the curve (Lemma 3).
    pub(crate) fn radius(&self, lfs: Interval, side: f64) -> Interval {
        let slope = side * (self.distance * self.slope);
        let square = slope.square() + Interval::point(1.0) - self.distance.square();
        let root = square.sqrt();
        // The normal enters the disc about s1 before it leaves that about q.
        if square.is_positive() && (-(slope + root)).is_below(lfs) {
            return (root - slope).max(lfs).lower();
        }
        lfs
    }
}
