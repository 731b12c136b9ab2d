//! Where the samples are that a tile does not have.

use curvecrust_geometry::DVec2;

use crate::area::Area;
use crate::atlas::Atlas;
use crate::region::Region;

/// Where the samples are that a tile does not have: outside of a rectangle, and in some areas.
///
/// The other parts of the plane are known to be empty of them, however far they reach. So the tile
/// is certain of what no area of other samples comes near to, such as the outside of a hull.
#[derive(Clone, Debug)]
pub struct Elsewhere {
    loaded: Area,
    /// The areas of which the tile does not have all samples; the others are empty.
    areas: Atlas,
}

/// An area to ask.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Asked {
    /// Its place in the atlas.
    pub(crate) area: usize,
    /// The square of its distance.
    squared: f64,
}

impl Asked {
    pub(crate) fn is_before(self, other: Self) -> bool {
        let order = self.squared.total_cmp(&other.squared);
        order.then(self.area.cmp(&other.area)).is_lt()
    }
}

impl Elsewhere {
    /// Everywhere but in a rectangle: nothing is known about the rest of the plane.
    /// [`Area::EVERYTHING`] says that there are no other samples, [`Area::NOTHING`] that they may
    /// be anywhere; so does one with a NaN.
    #[must_use]
    pub fn outside(loaded: Area) -> Self {
        let is_nan = loaded.low.is_nan() || loaded.high.is_nan();
        let loaded = if is_nan { Area::NOTHING } else { loaded };
        let all = Area::EVERYTHING;
        let [mut left, mut below, mut right, mut above] = [all; 4];
        left.high.x = loaded.low.x;
        below.high.y = loaded.low.y;
        right.low.x = loaded.high.x;
        above.low.y = loaded.high.y;
        let sides = [left, below, right, above];
        // Behind an infinite border there is nothing.
        let is_there = |side: &Area| {
            side.high.cmpgt(DVec2::NEG_INFINITY).all() && side.low.cmplt(DVec2::INFINITY).all()
        };
        Self {
            loaded,
            areas: Atlas::new(sides.into_iter().filter(is_there).collect()),
        }
    }

    /// Outside of a rectangle, and in the areas of an atlas.
    #[must_use]
    pub fn within(areas: Atlas, loaded: Area) -> Self {
        Self { loaded, areas }
    }

    /// Notes that the tile has all samples of an area of the atlas.
    pub fn note_read(&mut self, area: usize) {
        self.areas.clear(area);
    }

    /// The nearest area, as seen from a point, that may hold a missing sample in a region.
    pub(crate) fn nearest(&self, from: DVec2, region: &impl Region) -> Option<Asked> {
        if self.areas.is_empty() || region.is_inside(self.loaded) {
            return None;
        }
        let reach = |area: Area| {
            let is_met = !area.is_empty() && region.meets(area);
            is_met.then(|| area.distance_squared(from))
        };
        let (area, squared) = self.areas.nearest(reach, |_| true)?;
        Some(Asked { area, squared })
    }
}
