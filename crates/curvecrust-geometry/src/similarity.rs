//! Similarity transforms that lose no digit of a shape: a shift and a scale by a power of two.

use glam::DVec2;

/// Maps `p` to `(p - shift) * scale`, where the scale is a power of two.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Similarity {
    shift: DVec2,
    scale: f64,
}

impl Similarity {
    /// The transform that takes the bounding box of finite points into the unit box, its lower left
    /// corner to the origin and its larger extent into (1/2, 1].
    ///
    /// The identity scale for no points, and for points without extent.
    ///
    /// ```
    /// use curvecrust_geometry::{DVec2, Similarity};
    ///
    /// let points = [DVec2::new(10.0, 5.0), DVec2::new(16.0, 6.0)];
    /// let to_unit = Similarity::to_unit_box(points);
    /// assert_eq!(to_unit.apply(points[1]), DVec2::new(0.75, 0.125));
    /// assert_eq!(to_unit.invert(to_unit.apply(points[1])), points[1]);
    /// assert_eq!(to_unit.invert_length(0.5), 4.0);
    /// ```
    #[must_use]
    pub fn to_unit_box(points: impl IntoIterator<Item = DVec2>) -> Self {
        let mut points = points.into_iter();
        let Some(first) = points.next() else {
            return Self {
                shift: DVec2::ZERO,
                scale: 1.0,
            };
        };
        let (low, high) = points.fold((first, first), |(low, high), p| (low.min(p), high.max(p)));
        Self {
            shift: low,
            scale: power_of_two_below_inverse((high - low).max_element()),
        }
    }

    /// The image of `p`.
    #[must_use]
    pub fn apply(self, p: DVec2) -> DVec2 {
        (p - self.shift) * self.scale
    }

    /// The point whose image is `p`, up to the rounding of one addition.
    #[must_use]
    pub fn invert(self, p: DVec2) -> DVec2 {
        p / self.scale + self.shift
    }

    /// The length whose image is `length`, exactly.
    #[must_use]
    pub fn invert_length(self, length: f64) -> f64 {
        length / self.scale
    }
}

/// The largest power of two whose product with `extent` is at most 1; 1 if `extent` has no inverse.
fn power_of_two_below_inverse(extent: f64) -> f64 {
    if !(extent.is_normal() && extent > 0.0) {
        return 1.0;
    }
    // Truncating the mantissa of the inverse; a subnormal or infinite inverse has no exponent.
    let inverse = 1.0 / extent;
    if !inverse.is_normal() {
        return 1.0;
    }
    f64::from_bits(inverse.to_bits() & !((1 << 52) - 1))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_scale_is_a_power_of_two_and_fits() {
        for extent in [1e-300, 1e-9, 0.3, 1.0, 1.5, 7.0, 1e12, 1e300] {
            let s = power_of_two_below_inverse(extent);
            assert_eq!(s.to_bits() & ((1 << 52) - 1), 0);
            let image = extent * s;
            assert!(image > 0.499 && image <= 1.0, "{extent}: {image}");
        }
        assert_eq!(power_of_two_below_inverse(0.0).to_bits(), 1f64.to_bits());
    }
}
