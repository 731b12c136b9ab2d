//! Straight segments.

use glam::DVec2;

/// The straight segment between two points, which may coincide.
#[derive(Clone, Copy, Debug, PartialEq)]
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
        let along = self.b - self.a;
        let squared = along.length_squared();
        if squared > 0.0 {
            let t = (p - self.a).dot(along) / squared;
            // From the nearer end, so that the far end is met exactly.
            if t <= 0.5 {
                self.a + along * t.max(0.0)
            } else {
                self.b - along * (1.0 - t).max(0.0)
            }
        } else {
            self.a
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
