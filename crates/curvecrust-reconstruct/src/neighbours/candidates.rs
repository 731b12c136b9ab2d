//! Passes over the points around a leaf, without a branch.

use curvecrust_geometry::DVec2;

use super::half_plane::{ERROR, HalfPlane};
use super::lanes::indices;
use super::search::Best;
use super::tree::{Leaf, Rect};

/// Points for which candidates are compared in one pass: few enough to stay in registers.
pub(super) const LANES: usize = 8;

/// Room for candidates, a power of two.
const ROOM: usize = 128;

/// The points around a leaf.
pub(super) struct Candidates {
    x: [f64; ROOM],
    y: [f64; ROOM],
    at: [u32; ROOM],
    len: usize,
}

/// The closest candidates of some points.
pub(super) struct Closest {
    /// The squared distance of the closest.
    pub(super) squared: [f64; LANES],
    /// That of the next; the same if there is a tie.
    pub(super) second: [f64; LANES],
    /// The index of the closest, a number below [`ROOM`]; as a double, so that all vectors have
    /// the same shape.
    index: [f64; LANES],
}

/// Some points s, and what makes a candidate q wanted: (q - s) . normal is at most the limit.
#[derive(Default)]
pub(super) struct Wanted {
    pub(super) x: [f64; LANES],
    pub(super) y: [f64; LANES],
    pub(super) normal_x: [f64; LANES],
    pub(super) normal_y: [f64; LANES],
    pub(super) limit: [f64; LANES],
}

impl Candidates {
    pub(super) fn new() -> Self {
        Self {
            x: [0.0; ROOM],
            y: [0.0; ROOM],
            at: [0; ROOM],
            len: 0,
        }
    }

    pub(super) fn clear(&mut self) {
        self.len = 0;
    }

    /// Adds the points of a leaf that lie in a rectangle; `None` if there may be no room for them.
    #[inline(always)]
    pub(super) fn add(&mut self, leaf: &Leaf, index: u32, rect: Rect) -> Option<()> {
        for slot in indices(leaf.inside(rect)) {
            *self.x.get_mut(self.len)? = leaf.x[slot as usize];
            self.y[self.len] = leaf.y[slot as usize];
            self.at[self.len] = 16 * index + slot;
            self.len += 1;
        }
        Some(())
    }

    /// The closest candidates of some points; wanted or not, if `HALF` is false. A point is no
    /// candidate for itself.
    ///
    /// The limit is exceeded by what rounding may add to a candidate no closer than the nearest
    /// neighbour: the closest wanted one is never missed, and must be verified.
    #[inline(always)]
    pub(super) fn closest<const HALF: bool>(&self, to: &Wanted) -> Closest {
        let mut squared = [f64::INFINITY; LANES];
        let mut second = [f64::INFINITY; LANES];
        let mut index = [0.0; LANES];
        let mut i = 0.0;
        let len = self.len.min(ROOM);
        for (&x, &y) in self.x[..len].iter().zip(&self.y[..len]) {
            for l in 0..LANES {
                let (a_x, a_y) = (x - to.x[l], y - to.y[l]);
                let d = a_x * a_x + a_y * a_y;
                let mut wanted = d > 0.0;
                if HALF {
                    let along = a_x * to.normal_x[l] + a_y * to.normal_y[l];
                    wanted &= along <= to.limit[l] + 2.0 * ERROR * d;
                }
                let d = if wanted { d } else { f64::INFINITY };
                let larger = if d > squared[l] { d } else { squared[l] };
                second[l] = if larger < second[l] {
                    larger
                } else {
                    second[l]
                };
                index[l] = if d < squared[l] { i } else { index[l] };
                squared[l] = if d < squared[l] { d } else { squared[l] };
            }
            i += 1.0;
        }
        Closest {
            squared,
            second,
            index,
        }
    }

    /// The closest candidate of one of the points.
    #[inline(always)]
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "an index below ROOM"
    )]
    pub(super) fn best(&self, closest: &Closest, lane: usize) -> Best {
        let squared = closest.squared[lane];
        let index = closest.index[lane] as usize % ROOM;
        if squared < f64::INFINITY {
            Best {
                squared,
                point: DVec2::new(self.x[index], self.y[index]),
                at: self.at[index],
            }
        } else {
            Best::NONE
        }
    }

    /// The closest candidate other than `s` in the half-plane, or at all without one; ties and
    /// signs are decided exactly.
    #[inline(always)]
    pub(super) fn search(&self, s: DVec2, plane: Option<&HalfPlane>) -> Best {
        let len = self.len.min(ROOM);
        let mut best = Best::NONE;
        for ((&x, &y), &at) in self.x[..len].iter().zip(&self.y).zip(&self.at) {
            let point = DVec2::new(x, y);
            let squared = (point - s).length_squared();
            let beats = squared > 0.0 && best.is_beaten_by(squared, point);
            if beats && plane.is_none_or(|plane| plane.contains(point)) {
                best = Best { squared, point, at };
            }
        }
        best
    }
}
