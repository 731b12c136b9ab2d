//! The choices of the points of a leaf, found together.
//!
//! One box query around a leaf finds candidates, two passes over them the nearest and the half
//! neighbours of all of its points. A neighbour is certain if no point outside the box can be
//! closer, and none inside is equally close. For what is not, candidates are compared one by one,
//! with ties, and then the whole tree is searched.

use curvecrust_geometry::DVec2;

use super::HalfRule;
use super::bounds::Rect;
use super::candidates::{Candidates, LANES, at_most, is_closer};
use super::half_plane::HalfPlane;
use super::lanes::{WIDTH, bits, compiled_for_each_processor, max, min, sum};
use super::search::{Best, NONE};
use super::tree::{Leaf, Room, Tree};

/// Positions of the nearest and the half neighbour in the spatial order, or [`NONE`].
pub(super) type Choice = [u32; 2];

/// Leaves that make a task.
const LEAVES: usize = 64;

/// Points that make a task.
pub(super) const TASK: usize = LEAVES * WIDTH;

/// How far around a leaf candidates are taken, in typical distances between its points.
///
/// Half neighbours on a curve are nearly always closer; more would be found farther out, but more
/// candidates cost more than the searches that they save.
const MARGIN: f64 = 2.0;

/// A leaf is cut where the spatial order jumps by this many margins: one box around both sides
/// would be large.
const JUMP: f64 = 20.0;

/// Two points in a row that are closer than this fraction of the distance to the next count as one:
/// of two almost equal curves the neighbours along them are needed too.
const COINCIDENT: f64 = 1e-6;

compiled_for_each_processor! {
    /// Makes the choices of one task, those of the points from `TASK * task` on.
    pub(super) fn choose(tree: &Tree, rule: HalfRule, task: usize, choices: &mut [Choice]) {
        let mut kernel = Kernel {
            tree,
            rule,
            candidates: Candidates::new(),
            room: Room::default(),
        };
        let leaves = tree.leaves().iter().skip(LEAVES * task);
        for (leaf, choices) in leaves.zip(choices.chunks_mut(WIDTH)) {
            kernel.choose(leaf, choices);
        }
    }
}

struct Kernel<'a> {
    tree: &'a Tree,
    rule: HalfRule,
    candidates: Candidates,
    room: Room,
}

impl Kernel<'_> {
    /// The choices of the points of a leaf.
    #[inline(always)]
    fn choose(&mut self, leaf: &Leaf, choices: &mut [Choice]) {
        let gaps = gaps(leaf);
        let margin = MARGIN * typical_distance(&gaps);
        let limit = (JUMP * margin) * (JUMP * margin);
        let starts = bits(|slot| gaps[slot] > limit);
        let mut first = 0;
        while first < choices.len() {
            let later = starts >> first >> 1;
            let end = choices
                .len()
                .min(first + 1 + later.trailing_zeros() as usize);
            let rect = leaf.bounds_of(first..end).grown(margin);
            if self.collect(rect).is_none() {
                self.candidates.clear();
            }
            for choices in choices[first..end].chunks_mut(LANES) {
                self.choose_lanes(leaf, first, rect, choices);
                first += choices.len();
            }
        }
    }

    /// Collects the points in a rectangle; `None` if they are too many.
    #[inline(always)]
    fn collect(&mut self, rect: Rect) -> Option<()> {
        self.candidates.clear();
        for &index in self.tree.meeting(rect, &mut self.room)? {
            let leaf = self.tree.leaf(index);
            self.candidates.add(leaf, index, rect)?;
        }
        self.candidates.finish();
        Some(())
    }

    /// The choices of the points from slot `first` on, given the points in a rectangle around.
    ///
    /// The second closest point is the half neighbour if it lies in the half-plane, as nearly
    /// always on a curve.
    #[inline(always)]
    fn choose_lanes(&self, leaf: &Leaf, first: usize, rect: Rect, choices: &mut [Choice]) {
        let x: [f64; LANES] = std::array::from_fn(|l| leaf.x[(first + l) % WIDTH]);
        let y: [f64; LANES] = std::array::from_fn(|l| leaf.y[(first + l) % WIDTH]);
        let [nearest, second, third] = self.candidates.closest(&x, &y);
        let n0 = nearest.map(|key| self.candidates.of_key(key));
        let h = second.map(|key| self.candidates.of_key(key));
        let is_certain: [bool; LANES] = std::array::from_fn(|l| {
            let s = DVec2::new(x[l], y[l]);
            let (a, side) = (h[l].0 - s, side(s, rect));
            let plane = HalfPlane::new(self.rule, s, n0[l].0);
            is_closer(nearest[l], second[l])
                & is_closer(second[l], third[l])
                & (a.length_squared() < side * side)
                & plane.certainly_contains(h[l].0)
        });
        for (l, choice) in choices.iter_mut().enumerate().take(LANES) {
            *choice = if is_certain[l] {
                [n0[l].1, h[l].1]
            } else {
                let s = DVec2::new(x[l], y[l]);
                self.choose_one(s, side(s, rect), [nearest[l], second[l], third[l]])
            };
        }
    }

    /// The choice of a point, given its distance from what is no candidate, and the keys of the
    /// three closest candidates.
    #[inline(always)]
    fn choose_one(&self, s: DVec2, side: f64, keys: [f64; 3]) -> Choice {
        let (mut n0, mut at) = self.candidates.of_key(keys[0]);
        let is_certain = is_closer(keys[0], keys[1]) && (n0 - s).length_squared() < side * side;
        if !is_certain {
            let best = self.search(s, None, at_most(keys[0]), side * side);
            (n0, at) = (best.point, best.at);
        }
        if at == NONE {
            return [NONE; 2];
        }
        let plane = HalfPlane::new(self.rule, s, n0);
        let inside = |key: &f64| key.is_finite() && plane.contains(self.candidates.of_key(*key).0);
        let bound = keys.into_iter().find(inside).map_or(f64::INFINITY, at_most);
        [at, self.search(s, Some(plane), bound, side * side).at]
    }

    /// The closest point, among the candidates if one is closer than all other points.
    ///
    /// Where `bound` is finite, some candidate must be known to be no farther.
    #[inline(always)]
    fn search(&self, s: DVec2, plane: Option<HalfPlane>, bound: f64, others: f64) -> Best {
        let best = self.candidates.search(s, plane.as_ref(), bound);
        if best.squared < others {
            best
        } else {
            self.tree.closest(s, plane, best)
        }
    }
}

/// How far a point in a rectangle is from its boundary.
///
/// As rounding is monotonic, no point outside the rectangle is computed to be closer.
#[inline(always)]
fn side(s: DVec2, rect: Rect) -> f64 {
    let (a, b) = (s - rect.low, rect.high - s);
    min(min(a.x, b.x), min(a.y, b.y))
}

/// The squared distance from each point of a leaf to the one before, infinite where there is none.
#[inline(always)]
fn gaps(leaf: &Leaf) -> [f64; WIDTH] {
    let mut gaps = [f64::INFINITY; WIDTH];
    for (before, gap) in gaps[1..].iter_mut().enumerate() {
        let (x, y) = (
            leaf.x[before + 1] - leaf.x[before],
            leaf.y[before + 1] - leaf.y[before],
        );
        let squared = x * x + y * y;
        // Not for the NaN of missing points.
        *gap = if squared < f64::INFINITY {
            squared
        } else {
            *gap
        };
    }
    gaps
}

/// A mean of the distances from each point of a leaf to the closer of the ones before and after, in
/// which those of points that lie apart count less, and those of [`COINCIDENT`] points as the next
/// distance. 0 for a single point.
#[inline(always)]
fn typical_distance(gaps: &[f64; WIDTH]) -> f64 {
    // Those beside each slot, around: before at its index, after at the one after next.
    let mut known = [0.0; WIDTH + 2];
    for (known, &gap) in known[1..].iter_mut().zip(gaps) {
        *known = if gap < f64::INFINITY { gap } else { 0.0 };
    }
    (known[0], known[WIDTH + 1]) = (known[WIDTH], known[1]);
    let mut gaps = *gaps;
    for slot in 0..WIDTH {
        let beside = max(known[slot], known[slot + 2]);
        if gaps[slot] < COINCIDENT * COINCIDENT * beside {
            gaps[slot] = beside;
        }
    }
    let mut squared = gaps;
    for slot in 1..WIDTH {
        squared[slot - 1] = min(squared[slot - 1], gaps[slot]);
    }
    let distances = squared.map(f64::sqrt);
    let inverses = sum(&distances.map(|d| 1.0 / d));
    if inverses > 0.0 {
        let limit = 4.0 * WIDTH as f64 / inverses;
        sum(&distances.map(|d| if d < limit { d } else { limit })) / WIDTH as f64
    } else {
        0.0
    }
}
