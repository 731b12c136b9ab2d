//! The closest point of a half-plane, by a search of the whole tree.

use curvecrust_geometry::DVec2;
use curvecrust_geometry::point_set::by_coordinates;

use super::bounds::Rect;
use super::half_plane::{ERROR, HalfPlane};
use super::lanes::{WIDTH, bits, indices};
use super::tree::{Leaf, Node, Tree};

/// Levels of nodes, a power of two: 2^32 points in leaves of 16 have seven.
const LEVELS: usize = 8;

/// No point has this position.
pub(super) const NONE: u32 = u32::MAX;

/// The best point found so far.
#[derive(Clone, Copy, Debug)]
pub(super) struct Best {
    pub(super) squared: f64,
    pub(super) point: DVec2,
    /// Its position in the spatial order, or [`NONE`].
    pub(super) at: u32,
}

impl Best {
    pub(super) const NONE: Self = Self {
        squared: f64::INFINITY,
        point: DVec2::INFINITY,
        at: NONE,
    };

    #[inline(always)]
    pub(super) fn is_beaten_by(&self, squared: f64, point: DVec2) -> bool {
        squared < self.squared
            || (squared <= self.squared && by_coordinates(point, self.point).is_lt())
    }
}

/// What is sought: the point closest to `s`, other than `s`, of a half-plane or of the plane.
struct Query {
    s: DVec2,
    plane: Option<HalfPlane>,
    normal: DVec2,
    /// If (q - s) . normal, as computed, is above this, q certainly lies outside the half-plane.
    limit: f64,
}

impl Query {
    /// For points within a box.
    #[inline(always)]
    fn new(s: DVec2, plane: Option<HalfPlane>, bounds: Rect) -> Self {
        let (normal, limit) = match &plane {
            Some(plane) => {
                let products = (bounds.high - bounds.low).dot(plane.normal.abs());
                let error = 2.0 * ERROR * (products + plane.threshold);
                (plane.normal, plane.threshold + error)
            }
            None => (DVec2::ZERO, f64::INFINITY),
        };
        Self {
            s,
            plane,
            normal,
            limit,
        }
    }

    /// Squared distances to the boxes of the children; infinite for those outside the half-plane.
    ///
    /// Rounding is monotonic, so no point of a box is computed to be nearer than its box, or to lie
    /// further along the half-plane's inside than its corner. By how much that corner is cut may
    /// err by less than the limit leaves room for.
    #[inline(always)]
    fn to_boxes(&self, node: &Node) -> [f64; WIDTH] {
        let (s, normal) = (self.s, self.normal);
        let side = |along: f64, low, high| if along > 0.0 { (0, low) } else { (1, high) };
        let (right, corner_x): (_, &[f64; WIDTH]) = side(normal.x, &node.low_x, &node.high_x);
        let (up, corner_y): (_, &[f64; WIDTH]) = side(normal.y, &node.low_y, &node.high_y);
        let corner = right + 2 * up;
        std::array::from_fn(|i| {
            let x = gap(node.low_x[i] - s.x, s.x - node.high_x[i]);
            let y = gap(node.low_y[i] - s.y, s.y - node.high_y[i]);
            let along = (corner_x[i] - s.x) * normal.x + (corner_y[i] - s.y) * normal.y;
            let outside = along + node.cut(corner, i, normal) > self.limit;
            if outside {
                f64::INFINITY
            } else {
                x * x + y * y
            }
        })
    }

    /// Squared distances to points that may lie in the half-plane; infinite for the others and `s`.
    #[inline(always)]
    fn to_points(&self, leaf: &Leaf) -> [f64; WIDTH] {
        std::array::from_fn(|i| {
            let (x, y) = (leaf.x[i] - self.s.x, leaf.y[i] - self.s.y);
            let squared = x * x + y * y;
            let along = x * self.normal.x + y * self.normal.y;
            let wanted = (along <= self.limit) & (squared > 0.0);
            if wanted { squared } else { f64::INFINITY }
        })
    }

    /// The best of `best` and the points of a leaf.
    #[inline(always)]
    fn closest_of_leaf(&self, leaf: &Leaf, index: u32, mut best: Best) -> Best {
        let distances = self.to_points(leaf);
        for slot in indices(up_to(&distances, best.squared)) {
            let point = leaf.point(slot as usize);
            let squared = distances[slot as usize];
            if best.is_beaten_by(squared, point)
                && self.plane.as_ref().is_none_or(|p| p.contains(point))
            {
                best = Best {
                    squared,
                    point,
                    at: 16 * index + slot,
                };
            }
        }
        best
    }
}

/// How far a value is outside an interval, from the signed distances beyond its two ends.
#[inline(always)]
fn gap(below: f64, above: f64) -> f64 {
    let most = if below > above { below } else { above };
    if most > 0.0 { most } else { 0.0 }
}

/// The finite numbers up to a limit, as bits.
#[inline(always)]
fn up_to(values: &[f64; WIDTH], limit: f64) -> u32 {
    bits(|i| (values[i] <= limit) & (values[i] < f64::INFINITY))
}

/// A node on the way of a search.
#[derive(Clone, Copy, Default)]
struct Visit {
    node: u32,
    /// The children that are left, as bits.
    open: u32,
    /// Squared distances of all children.
    distances: [f64; WIDTH],
}

impl Visit {
    #[inline(always)]
    fn new(query: &Query, index: u32, node: &Node) -> Self {
        Self {
            node: index,
            open: u32::MAX,
            distances: query.to_boxes(node),
        }
    }

    /// The nearest child that is left and not farther than a limit; it is left no more.
    #[inline(always)]
    fn next_child(&mut self, limit: f64) -> Option<u32> {
        self.open &= up_to(&self.distances, limit);
        let distance = |child: u32| self.distances[child as usize % WIDTH];
        let nearer = |a, b| if distance(b) < distance(a) { b } else { a };
        let nearest = indices(self.open).reduce(nearer)?;
        self.open &= !(1 << nearest);
        Some(16 * self.node + nearest)
    }
}

impl Tree {
    /// The closest point other than `s` of the half-plane, or of the plane without one; `best` if
    /// none is closer.
    #[inline(always)]
    pub(super) fn closest(&self, s: DVec2, plane: Option<HalfPlane>, mut best: Best) -> Best {
        let Some((top, root)) = self.root() else {
            return best;
        };
        let query = Query::new(s, plane, root.rect());
        let mut path = [Visit::default(); LEVELS];
        let mut level = top % LEVELS;
        path[level] = Visit::new(&query, 0, root);
        loop {
            match path[level].next_child(best.squared) {
                Some(leaf) if level == 0 => {
                    best = query.closest_of_leaf(self.leaf(leaf), leaf, best);
                }
                Some(node) => {
                    level -= 1;
                    path[level] = Visit::new(&query, node, self.node(level, node));
                }
                None if level < top => level = (level + 1) % LEVELS,
                None => return best,
            }
        }
    }
}
