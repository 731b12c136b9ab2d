//! Parts of the plane of which all samples have to be known.

use curvecrust_geometry::{DVec2, orient2d};
use curvecrust_reconstruct::partial_crust::Disc;

use crate::area::Area;

/// The relative error of a few operations, generously.
const ROUNDING: f64 = 16.0 * f64::EPSILON;

/// A closed part of the plane, rounded outwards: of rectangles it may meet a few too many.
pub(crate) trait Region {
    /// Whether it meets a rectangle that is not empty. What meets none, meets none inside of it.
    fn meets(&self, area: Area) -> bool;

    /// Whether all of it lies inside of a rectangle and not on its border.
    fn is_inside(&self, area: Area) -> bool;

    /// The smallest rectangle that holds it, about.
    fn bounds(&self) -> Area;
}

impl Region for Disc {
    fn meets(&self, area: Area) -> bool {
        // As seen from the point: differences have no error but that of their own rounding.
        let (low, high) = (area.low - self.from, area.high - self.from);
        let gaps = (low - self.to_centre).max(self.to_centre - high);
        let gap = gaps.max(DVec2::ZERO);
        let errs = ROUNDING * (gap.max_element() + self.to_centre.abs().max_element());
        let reach = self.radius + errs;
        // Not so if anything is NaN, or both are infinite.
        let is_apart = gap.length_squared() > reach * reach * (1.0 + ROUNDING);
        !is_apart
    }

    fn is_inside(&self, area: Area) -> bool {
        let (low, high) = (self.from - area.low, area.high - self.from);
        let side = (low + self.to_centre).min(high - self.to_centre);
        let errs = ROUNDING * (side.abs().min_element() + self.to_centre.abs().max_element());
        side.min_element() - errs > self.radius * (1.0 + ROUNDING)
    }

    fn bounds(&self) -> Area {
        let centre = self.from + self.to_centre;
        let radius = self.radius * (1.0 + ROUNDING) + ROUNDING * centre.abs().max_element();
        if centre.is_finite() && radius.is_finite() {
            Area::of([centre]).grown(radius)
        } else {
            Area::EVERYTHING
        }
    }
}

/// What lies right of the line from one sample to another, without the line.
///
/// Exact for rectangles whose corners have coordinates of samples or none.
#[derive(Clone, Copy, Debug)]
pub(crate) struct HalfPlane {
    pub(crate) from: DVec2,
    pub(crate) to: DVec2,
}

impl HalfPlane {
    fn outwards(&self) -> DVec2 {
        -(self.to - self.from).perp()
    }
}

impl Region for HalfPlane {
    fn meets(&self, area: Area) -> bool {
        let outwards = self.outwards();
        let corner = DVec2::select(outwards.cmpgt(DVec2::ZERO), area.high, area.low);
        // Along the line, any place will do.
        let corner = DVec2::select(outwards.cmpeq(DVec2::ZERO), self.from, corner);
        let is_far = !corner.is_finite();
        // Not so if a NaN comes of coordinates that are too large.
        let is_left = orient2d(self.from, self.to, corner) >= 0.0;
        is_far || !is_left
    }

    fn is_inside(&self, area: Area) -> bool {
        area == Area::EVERYTHING
    }

    fn bounds(&self) -> Area {
        let outwards = self.outwards();
        let mut bounds = Area::EVERYTHING;
        // A line along an axis bounds it on one side.
        if outwards.x == 0.0 && outwards.y > 0.0 {
            bounds.low.y = self.from.y;
        } else if outwards.x == 0.0 {
            bounds.high.y = self.from.y;
        } else if outwards.y == 0.0 && outwards.x > 0.0 {
            bounds.low.x = self.from.x;
        } else if outwards.y == 0.0 {
            bounds.high.x = self.from.x;
        }
        bounds
    }
}

/// What lies before a point in a direction, rounded outwards.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Before {
    pub(crate) from: DVec2,
    pub(crate) along: DVec2,
}

impl Region for Before {
    fn meets(&self, area: Area) -> bool {
        let is_behind = most(area, self.from, self.along) < 0.0;
        !is_behind
    }

    fn is_inside(&self, area: Area) -> bool {
        area == Area::EVERYTHING
    }

    fn bounds(&self) -> Area {
        Area::EVERYTHING
    }
}

/// At least the greatest product of a vector with what leads from a point into a rectangle; NaN if
/// it is not known.
pub(crate) fn most(area: Area, from: DVec2, along: DVec2) -> f64 {
    let (low, high) = (area.low - from, area.high - from);
    let term = |low: f64, high: f64, along: f64| match along {
        along if along > 0.0 => high * along,
        along if along < 0.0 => low * along,
        _ => 0.0,
    };
    let x = term(low.x, high.x, along.x);
    let y = term(low.y, high.y, along.y);
    x + y + ROUNDING * (x.abs() + y.abs())
}
