//! Rectangles: what a tile knows, and where samples are.

use glam::DVec2;

/// A closed rectangle with sides parallel to the axes, perhaps without an end.
///
/// Its points are those between `low` and `high` in both coordinates; if a coordinate of `low` is
/// larger than that of `high`, there are none.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Area {
    /// The least x and y.
    pub low: DVec2,
    /// The greatest x and y.
    pub high: DVec2,
}

impl Area {
    /// The whole plane.
    pub const EVERYTHING: Self = Self {
        low: DVec2::NEG_INFINITY,
        high: DVec2::INFINITY,
    };
    /// No point.
    pub const NOTHING: Self = Self {
        low: DVec2::INFINITY,
        high: DVec2::NEG_INFINITY,
    };

    /// The smallest area that contains some points; [`NOTHING`](Self::NOTHING) for none.
    ///
    /// ```
    /// use curvecrust_geometry::DVec2;
    /// use curvecrust_tiles::Area;
    ///
    /// let area = Area::of([DVec2::new(0.0, 3.0), DVec2::new(2.0, 1.0)]);
    /// assert!(area.contains(DVec2::new(2.0, 3.0)) && !area.contains(DVec2::new(2.5, 2.0)));
    /// assert!(Area::EVERYTHING.covers(area) && area.covers(Area::NOTHING));
    /// assert_eq!(Area::of([]), Area::NOTHING);
    /// ```
    #[must_use]
    pub fn of(points: impl IntoIterator<Item = DVec2>) -> Self {
        let points = points.into_iter();
        points.fold(Self::NOTHING, |area, p| Self {
            low: area.low.min(p),
            high: area.high.max(p),
        })
    }

    /// The smallest area that covers both.
    #[must_use]
    pub fn union(self, other: Self) -> Self {
        Self {
            low: self.low.min(other.low),
            high: self.high.max(other.high),
        }
    }

    /// The area grown by a margin on each side.
    #[must_use]
    pub fn grown(self, margin: f64) -> Self {
        Self {
            low: self.low - margin,
            high: self.high + margin,
        }
    }

    /// Whether there is no point in it.
    #[must_use]
    pub fn is_empty(self) -> bool {
        !self.low.cmple(self.high).all()
    }

    /// Whether a point lies in it or on its border.
    #[must_use]
    pub fn contains(self, point: DVec2) -> bool {
        self.low.cmple(point).all() && point.cmple(self.high).all()
    }

    /// Whether all of another area lies in it.
    #[must_use]
    pub fn covers(self, other: Self) -> bool {
        other.is_empty() || (self.contains(other.low) && self.contains(other.high))
    }

    /// The square of the distance of a point from what lies outside; 0 if it lies outside itself.
    ///
    /// Rounding is monotonic: no point outside has a smaller squared distance, as computed from
    /// the differences of its coordinates.
    #[must_use]
    pub fn inside_squared(self, point: DVec2) -> f64 {
        let sides = (point - self.low).min(self.high - point);
        let side = sides.min_element().max(0.0);
        side * side
    }

    /// The square of the distance of a point from the area; 0 if it lies in it, infinite if there
    /// is no point in it.
    ///
    /// No point of the area has a smaller squared distance, as computed.
    #[must_use]
    pub fn distance_squared(self, point: DVec2) -> f64 {
        let gaps = (self.low - point).max(point - self.high);
        gaps.max(DVec2::ZERO).length_squared()
    }
}
