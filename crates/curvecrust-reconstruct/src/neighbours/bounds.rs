//! Where the points of a leaf or of a node are: a rectangle without its empty corners.

use curvecrust_geometry::DVec2;

/// An axis-parallel rectangle.
#[derive(Clone, Copy, Debug)]
pub(super) struct Rect {
    pub(super) low: DVec2,
    pub(super) high: DVec2,
}

impl Rect {
    /// Holds nothing and meets nothing.
    pub(super) const EMPTY: Self = Self {
        low: DVec2::INFINITY,
        high: DVec2::NEG_INFINITY,
    };

    /// The rectangle grown by `margin` on each side.
    #[inline(always)]
    pub(super) fn grown(self, margin: f64) -> Self {
        Self {
            low: self.low - margin,
            high: self.high + margin,
        }
    }

    /// 1 / width and 1 / height, 0 where these are 0.
    #[inline(always)]
    pub(super) fn inverse_sides(self) -> DVec2 {
        let inverse = |x: f64| if x > 0.0 { 1.0 / x } else { 0.0 };
        let sides = self.high - self.low;
        DVec2::new(inverse(sides.x), inverse(sides.y))
    }
}

/// How much of each corner of a rectangle is empty: those at low and high x below, then above.
///
/// A corner that is cut by `c` is farther than `c` from all points, by the sum of both distances in
/// units of the sides of the rectangle. Points on a curve lie along a diagonal of their box: two of
/// its corners are cut by nearly 1, and a half-plane that touches the curve does not reach the
/// rest.
pub(super) type Cuts = [f32; 4];

/// A rectangle around points, and its empty corners.
#[derive(Clone, Copy, Debug)]
pub(super) struct Bounds {
    pub(super) rect: Rect,
    pub(super) cuts: Cuts,
}

impl Bounds {
    pub(super) const EMPTY: Self = Self {
        rect: Rect::EMPTY,
        cuts: [0.0; 4],
    };

    /// From the least and the most of u + v and of u - v, where u and v say how far points are from
    /// the low to the high sides, from 0 to 1.
    #[inline(always)]
    pub(super) fn new(rect: Rect, [low, high]: [f32; 2], [left, right]: [f32; 2]) -> Self {
        // Sums of up to 2 err by 2^-24 where they are rounded to f32, and what follows by as much.
        let safe = |cut: f32| (cut - 4.0 * f32::EPSILON).max(0.0);
        Self {
            rect,
            cuts: [low, 1.0 - right, 1.0 + left, 2.0 - high].map(safe),
        }
    }
}
