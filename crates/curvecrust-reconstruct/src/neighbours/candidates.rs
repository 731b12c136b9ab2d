//! Passes over the points around a leaf, without a branch.

use curvecrust_geometry::DVec2;

use super::bounds::Rect;
use super::half_plane::{ERROR, HalfPlane};
use super::lanes::{indices, max, min};
use super::search::Best;
use super::tree::Leaf;

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

/// The bits of a [`key`] that name a candidate.
const INDEX: u64 = ROOM as u64 - 1;

/// A squared distance whose last bits are replaced by the index of its candidate: the least of such
/// keys tells both.
#[inline(always)]
fn key(squared: f64, index: u64) -> f64 {
    f64::from_bits(squared.to_bits() & !INDEX | index)
}

/// Whether the distance behind one key is certainly less than that behind another; false for an
/// infinite one.
#[inline(always)]
pub(super) fn is_closer(key: f64, than: f64) -> bool {
    f64::from_bits(key.to_bits() | INDEX) < than
}

/// The greatest distance that may be behind a key.
#[inline(always)]
pub(super) fn at_most(key: f64) -> f64 {
    if key < f64::INFINITY {
        f64::from_bits(key.to_bits() | INDEX)
    } else {
        key
    }
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

    /// Ends the list: what follows is neither near nor inside of anything.
    pub(super) fn finish(&mut self) {
        for (x, y) in self
            .x
            .iter_mut()
            .zip(&mut self.y)
            .skip(self.len)
            .take(LANES)
        {
            (*x, *y) = (f64::NAN, f64::NAN);
        }
    }

    /// The keys of the three closest candidates of each of some points, infinite where there are
    /// fewer. A point is no candidate for itself.
    #[inline(always)]
    pub(super) fn closest(&self, to_x: &[f64; LANES], to_y: &[f64; LANES]) -> [[f64; LANES]; 3] {
        let [mut first, mut second, mut third] = [[f64::INFINITY; LANES]; 3];
        let len = self.len.min(ROOM);
        for (index, (&x, &y)) in (0u64..).zip(self.x[..len].iter().zip(&self.y[..len])) {
            for l in 0..LANES {
                let (a_x, a_y) = (x - to_x[l], y - to_y[l]);
                let d = a_x * a_x + a_y * a_y;
                let key = if d > 0.0 {
                    key(d, index)
                } else {
                    f64::INFINITY
                };
                let not_first = max(first[l], key);
                first[l] = min(first[l], key);
                let not_second = max(second[l], not_first);
                second[l] = min(second[l], not_first);
                third[l] = min(third[l], not_second);
            }
        }
        [first, second, third]
    }

    /// The keys of the two closest candidates of a point s in a half-plane.
    ///
    /// The half-plane is taken a little larger, by what rounding may add to a candidate no closer
    /// than the nearest neighbour: none is missed, and what is found must be verified.
    #[inline(always)]
    fn closest_inside(&self, s: DVec2, plane: &HalfPlane) -> [f64; 2] {
        let [mut first, mut second] = [[f64::INFINITY; LANES]; 2];
        let (x, _) = self.x.as_chunks::<LANES>();
        let (y, _) = self.y.as_chunks::<LANES>();
        let chunks = x.iter().zip(y).take(self.len.div_ceil(LANES));
        for (start, (x, y)) in (0u64..).step_by(LANES).zip(chunks) {
            for l in 0..LANES {
                let (a_x, a_y) = (x[l] - s.x, y[l] - s.y);
                let d = a_x * a_x + a_y * a_y;
                let along = a_x * plane.normal.x + a_y * plane.normal.y;
                let mut wanted = d > 0.0;
                wanted &= along <= plane.threshold + 2.0 * ERROR * d;
                let key = if wanted { key(d, start) } else { f64::INFINITY };
                second[l] = min(second[l], max(first[l], key));
                first[l] = min(first[l], key);
            }
        }
        for l in 1..LANES {
            // The start of a chunk has no bits where the lane does.
            let key = if first[l] < f64::INFINITY {
                f64::from_bits(first[l].to_bits() | l as u64)
            } else {
                f64::INFINITY
            };
            second[0] = min(min(second[0], second[l]), max(first[0], key));
            first[0] = min(first[0], key);
        }
        [first[0], second[0]]
    }

    /// The candidate of a finite key.
    #[inline(always)]
    pub(super) fn of_key(&self, key: f64) -> (DVec2, u32) {
        let index = (key.to_bits() & INDEX) as usize;
        (DVec2::new(self.x[index], self.y[index]), self.at[index])
    }

    /// The closest candidate other than `s` in the half-plane, or at all without one; ties and
    /// signs are decided exactly. It must be known to be no farther than `bound`, if that is
    /// finite.
    #[inline(always)]
    pub(super) fn search(&self, s: DVec2, plane: Option<&HalfPlane>, mut bound: f64) -> Best {
        if let Some(plane) = plane
            && bound == f64::INFINITY
        {
            let [first, second] = self.closest_inside(s, plane);
            let (point, at) = self.of_key(first);
            if first < f64::INFINITY && plane.contains(point) {
                if is_closer(first, second) {
                    let squared = (point - s).length_squared();
                    return Best { squared, point, at };
                }
                bound = at_most(first);
            }
        }
        self.compare(s, plane, bound)
    }

    /// The same one by one, among the candidates up to a distance.
    #[inline(always)]
    fn compare(&self, s: DVec2, plane: Option<&HalfPlane>, bound: f64) -> Best {
        let mut best = Best::NONE;
        let (x, _) = self.x.as_chunks::<LANES>();
        let (y, _) = self.y.as_chunks::<LANES>();
        let (at, _) = self.at.as_chunks::<LANES>();
        let chunks = x.iter().zip(y).zip(at).take(self.len.div_ceil(LANES));
        for ((x, y), at) in chunks {
            let squared: [f64; LANES] = std::array::from_fn(|l| {
                let (a_x, a_y) = (x[l] - s.x, y[l] - s.y);
                a_x * a_x + a_y * a_y
            });
            let mut near = 0;
            for (l, &squared) in squared.iter().enumerate() {
                near |= u32::from((squared > 0.0) & (squared <= bound)) << l;
            }
            for l in indices(near) {
                let l = l as usize % LANES;
                let point = DVec2::new(x[l], y[l]);
                if best.is_beaten_by(squared[l], point)
                    && plane.is_none_or(|plane| plane.contains(point))
                {
                    best = Best {
                        squared: squared[l],
                        point,
                        at: at[l],
                    };
                }
            }
        }
        best
    }
}
