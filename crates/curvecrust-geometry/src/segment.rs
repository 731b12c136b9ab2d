//! Straight segments.

use glam::DVec2;

/// The straight segment between two points, which may coincide.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Segment {
    /// Its start.
    pub a: DVec2,
    /// Its end.
    pub b: DVec2,
}

impl Segment {
    /// The segment from `a` to `b`.
    #[must_use]
    pub fn new(a: DVec2, b: DVec2) -> Self {
        Self { a, b }
    }

    /// The length.
    #[must_use]
    pub fn length(self) -> f64 {
        self.a.distance(self.b)
    }

    /// The point of the segment closest to `p`.
    #[must_use]
    pub fn closest_point(self, p: DVec2) -> DVec2 {
        // From the end nearer to p: a far end, perhaps very far, costs no digits.
        let (near, far) = if p.distance_squared(self.a) <= p.distance_squared(self.b) {
            (self.a, self.b)
        } else {
            (self.b, self.a)
        };
        let along = far - near;
        let t = (p - near).dot(along) / along.length_squared();
        // The foot may lie behind the near end; a NaN is that of a point. It lies beyond the far
        // end only where rounding took the wrong end of a very short segment for the nearer.
        if t > 0.0 {
            near + along * t.min(1.0)
        } else {
            near
        }
    }

    /// The squared distance from `p` to the segment.
    #[must_use]
    pub fn distance_squared(self, p: DVec2) -> f64 {
        self.closest_point(p).distance_squared(p)
    }

    /// The distance from `p` to the segment.
    ///
    /// ```
    /// use curvecrust_geometry::{DVec2, Segment};
    ///
    /// let segment = Segment::new(DVec2::ZERO, DVec2::new(2.0, 0.0));
    /// assert_eq!(segment.distance(DVec2::new(1.0, 3.0)), 3.0);
    /// assert_eq!(segment.distance(DVec2::new(5.0, 4.0)), 5.0);
    /// ```
    #[must_use]
    pub fn distance(self, p: DVec2) -> f64 {
        self.distance_squared(p).sqrt()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_far_end_costs_no_digits() {
        let far = DVec2::new(1e20, 1e20);
        let p = DVec2::new(0.0, 2.0);
        for segment in [
            Segment::new(DVec2::ZERO, far),
            Segment::new(far, DVec2::ZERO),
        ] {
            assert!((segment.distance(p) - 2f64.sqrt()).abs() < 1e-15);
        }
    }

    #[test]
    fn very_short_segments_are_not_left() {
        let a = DVec2::new(0.1, 0.0);
        let b = DVec2::new(0.1, 1e-17);
        for segment in [Segment::new(a, b), Segment::new(b, a)] {
            for p in [DVec2::new(0.1, 1.0), DVec2::new(0.1, -1.0)] {
                assert!((segment.distance(p) - 1.0).abs() < 1e-15);
            }
        }
    }

    #[test]
    fn a_point_is_a_segment() {
        let segment = Segment::new(DVec2::X, DVec2::X);
        assert_eq!(segment.closest_point(DVec2::new(1.0, 7.0)), DVec2::X);
    }
}
