//! An implicit tree of bounding boxes over points in spatial order.

use curvecrust_geometry::parallel::*;
use curvecrust_geometry::{DVec2, PointId};
use std::array::from_fn;

use super::bounds::{Bounds, Rect};
use super::lanes::{WIDTH, bits, compiled_for_each_processor, indices, least, max, min, most};

/// Leaves that make a task, a multiple of 16.
const TASK: usize = 256;

/// The coordinates of the points of one leaf. NaN, which is neither near nor inside of anything,
/// fills up the last leaf.
#[derive(Clone, Debug)]
pub(super) struct Leaf {
    pub(super) x: [f64; WIDTH],
    pub(super) y: [f64; WIDTH],
}

impl Leaf {
    fn new(points: impl Iterator<Item = DVec2>) -> Self {
        let mut leaf = Self {
            x: [f64::NAN; WIDTH],
            y: [f64::NAN; WIDTH],
        };
        for (slot, point) in points.enumerate().take(WIDTH) {
            leaf.x[slot] = point.x;
            leaf.y[slot] = point.y;
        }
        leaf
    }

    #[inline(always)]
    pub(super) fn point(&self, slot: usize) -> DVec2 {
        DVec2::new(self.x[slot % WIDTH], self.y[slot % WIDTH])
    }

    #[inline(always)]
    #[expect(
        clippy::cast_possible_truncation,
        reason = "cuts are taken smaller by more"
    )]
    fn bounds(&self) -> Bounds {
        let rect = Rect {
            low: DVec2::new(least(&self.x), least(&self.y)),
            high: DVec2::new(most(&self.x), most(&self.y)),
        };
        let unit = rect.inverse_sides();
        let [mut sums, mut differences] = [[0.0; WIDTH]; 2];
        for i in 0..WIDTH {
            let u = (self.x[i] - rect.low.x) * unit.x;
            let v = (self.y[i] - rect.low.y) * unit.y;
            sums[i] = u + v;
            differences[i] = u - v;
        }
        let sums = [least(&sums) as f32, most(&sums) as f32];
        let differences = [least(&differences) as f32, most(&differences) as f32];
        Bounds::new(rect, sums, differences)
    }

    /// The bounding box of the points in some slots.
    #[inline(always)]
    pub(super) fn bounds_of(&self, slots: std::ops::Range<usize>) -> Rect {
        let points = slots.map(|slot| self.point(slot));
        points.fold(Rect::EMPTY, |Rect { low, high }, p| Rect {
            low: DVec2::new(min(p.x, low.x), min(p.y, low.y)),
            high: DVec2::new(max(high.x, p.x), max(high.y, p.y)),
        })
    }

    /// The slots of the points in a rectangle, as bits.
    #[inline(always)]
    pub(super) fn inside(&self, rect: Rect) -> u32 {
        bits(|i| {
            (self.x[i] <= rect.high.x)
                & (self.x[i] >= rect.low.x)
                & (self.y[i] <= rect.high.y)
                & (self.y[i] >= rect.low.y)
        })
    }
}

/// The bounding boxes of up to 16 children; those that are missing are empty.
#[derive(Clone, Debug)]
pub(super) struct Node {
    pub(super) low_x: [f64; WIDTH],
    pub(super) low_y: [f64; WIDTH],
    pub(super) high_x: [f64; WIDTH],
    pub(super) high_y: [f64; WIDTH],
    /// The cuts of all children, corner by corner.
    cuts: [[f32; WIDTH]; 4],
}

impl Node {
    #[inline(always)]
    fn over<T>(children: &[T], bounds: impl Fn(&T) -> Bounds) -> Self {
        let mut all = [Bounds::EMPTY; WIDTH];
        for (all, child) in all.iter_mut().zip(children) {
            *all = bounds(child);
        }
        Self {
            low_x: all.map(|b| b.rect.low.x),
            low_y: all.map(|b| b.rect.low.y),
            high_x: all.map(|b| b.rect.high.x),
            high_y: all.map(|b| b.rect.high.y),
            cuts: from_fn(|corner| all.map(|b| b.cuts[corner])),
        }
    }

    #[inline(always)]
    pub(super) fn rect(&self) -> Rect {
        Rect {
            low: DVec2::new(least(&self.low_x), least(&self.low_y)),
            high: DVec2::new(most(&self.high_x), most(&self.high_y)),
        }
    }

    /// By how much the least product of a normal with points of a child, measured from the corner
    /// that the normal points away from, is above 0 because that corner is cut.
    #[inline(always)]
    pub(super) fn cut(&self, corner: usize, i: usize, normal: DVec2) -> f64 {
        let x = (self.high_x[i] - self.low_x[i]) * normal.x.abs();
        let y = (self.high_y[i] - self.low_y[i]) * normal.y.abs();
        f64::from(self.cuts[corner][i]) * if x < y { x } else { y }
    }

    #[expect(
        clippy::cast_possible_truncation,
        reason = "cuts are taken smaller by more"
    )]
    fn bounds(&self) -> Bounds {
        let rect = self.rect();
        let unit = rect.inverse_sides();
        let u = |x: f64| (x - rect.low.x) * unit.x;
        let v = |y: f64| (y - rect.low.y) * unit.y;
        let (low_u, low_v) = (self.low_x.map(u), self.low_y.map(v));
        let (high_u, high_v) = (self.high_x.map(u), self.high_y.map(v));
        let cut = |corner, i| self.cut(corner, i, unit);
        let sums = [
            least(&from_fn(|i| low_u[i] + low_v[i] + cut(0, i))),
            most(&from_fn(|i| high_u[i] + high_v[i] - cut(3, i))),
        ];
        let differences = [
            least(&from_fn(|i| low_u[i] - high_v[i] + cut(2, i))),
            most(&from_fn(|i| high_u[i] - low_v[i] - cut(1, i))),
        ];
        let rounded = |range: [f64; 2]| range.map(|x| x as f32);
        Bounds::new(rect, rounded(sums), rounded(differences))
    }

    /// The children whose boxes meet a rectangle, as bits.
    #[inline(always)]
    fn meeting(&self, rect: Rect) -> u32 {
        bits(|i| {
            (self.low_x[i] <= rect.high.x)
                & (self.high_x[i] >= rect.low.x)
                & (self.low_y[i] <= rect.high.y)
                & (self.high_y[i] >= rect.low.y)
        })
    }
}

compiled_for_each_processor! {
    /// The node over up to 16 leaves.
    fn parent(leaves: &[Leaf]) -> Node {
        Node::over(leaves, |leaf| leaf.bounds())
    }
}

/// Points in spatial order, 16 to a leaf, under nodes of 16 children. Child `c` of node `i` of a
/// level is node (or leaf) 16 i + c of the level below.
#[derive(Debug)]
pub(super) struct Tree {
    count: usize,
    leaves: Vec<Leaf>,
    /// The parents of the leaves first, the root last; empty iff there is no leaf.
    levels: Vec<Vec<Node>>,
}

impl Tree {
    /// The tree over `points` in the given order.
    pub(super) fn new(points: &[DVec2], order: &[PointId]) -> Self {
        let leaf = |ids: &[PointId]| Leaf::new(ids.iter().map(|id| points[id.index()]));
        let chunks = order.par_chunks(WIDTH).with_min_len(TASK);
        let leaves: Vec<Leaf> = chunks.map(leaf).collect();
        let chunks = leaves.par_chunks(WIDTH).with_min_len(TASK / WIDTH);
        let mut level: Vec<Node> = chunks.map(parent).collect();
        let mut levels = Vec::new();
        while level.len() > 1 {
            let parent = |nodes: &[Node]| Node::over(nodes, Node::bounds);
            let above = level.chunks(WIDTH).map(parent).collect();
            levels.push(std::mem::replace(&mut level, above));
        }
        levels.extend((!level.is_empty()).then_some(level));
        Self {
            count: order.len(),
            leaves,
            levels,
        }
    }

    /// The number of points.
    pub(super) fn len(&self) -> usize {
        self.count
    }

    pub(super) fn leaves(&self) -> &[Leaf] {
        &self.leaves
    }

    /// The leaf of an index below the number of leaves.
    #[inline(always)]
    pub(super) fn leaf(&self, index: u32) -> &Leaf {
        &self.leaves[index as usize]
    }

    /// The node over all points and its level, 0 being that of the parents of leaves; `None` iff
    /// there is no point.
    #[inline(always)]
    pub(super) fn root(&self) -> Option<(usize, &Node)> {
        let root = self.levels.last()?.first()?;
        Some((self.levels.len() - 1, root))
    }

    #[inline(always)]
    pub(super) fn node(&self, level: usize, index: u32) -> &Node {
        &self.levels[level][index as usize]
    }

    /// The leaves whose boxes meet a rectangle; `None` if they, or the nodes above, are too many.
    #[inline(always)]
    pub(super) fn meeting<'a>(&self, rect: Rect, room: &'a mut Room) -> Option<&'a [u32]> {
        let Room { now, next } = room;
        let (mut now, mut next) = (now, next);
        now[0] = 0;
        let mut len = usize::from(!self.levels.is_empty());
        for level in self.levels.iter().rev() {
            let mut children = 0;
            for &parent in &now[..len] {
                for child in indices(level[parent as usize].meeting(rect)) {
                    *next.get_mut(children)? = 16 * parent + child;
                    children += 1;
                }
            }
            (now, next) = (next, now);
            len = children;
        }
        Some(&now[..len])
    }
}

/// Room for the nodes of two levels that a rectangle meets.
#[derive(Debug, Default)]
pub(super) struct Room {
    now: [u32; 32],
    next: [u32; 32],
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    /// On a grid, on a curve, on a line, or close to a line.
    fn points() -> impl Strategy<Value = Vec<DVec2>> {
        let grid = (0..9i32, 0..9i32).prop_map(|(x, y)| DVec2::new(x.into(), y.into()));
        let curve = (0.0..1.0).prop_map(|t: f64| DVec2::from_angle(6.0 * t) * (1.0 + t));
        let line = (0.0..1.0).prop_map(|t: f64| DVec2::new(3.0 * t, 5.0));
        let near_line =
            (0.0..1.0, 0.0..1e-9).prop_map(|(t, y): (f64, f64)| DVec2::new(-t, 2.0 * t + y));
        let some = |one| prop::collection::vec(one, 1..600);
        prop_oneof![
            some(grid.boxed()),
            some(curve.boxed()),
            some(line.boxed()),
            some(near_line.boxed())
        ]
    }

    /// How far the nearest of the points is from a corner, in units of the sides.
    fn from_corner(points: &[DVec2], rect: Rect, corner: usize) -> f64 {
        let at = [rect.low.x, rect.high.x][corner % 2];
        let beside = [rect.low.y, rect.high.y][corner / 2];
        let unit = rect.inverse_sides();
        let distance = |p: &DVec2| (p.x - at).abs() * unit.x + (p.y - beside).abs() * unit.y;
        points.iter().map(distance).fold(f64::INFINITY, f64::min)
    }

    proptest! {
        #[test]
        fn no_point_lies_in_a_corner_that_is_cut(points in points()) {
            let order: Vec<PointId> = (0..).take(points.len()).map(PointId::from).collect();
            let tree = Tree::new(&points, &order);
            for (level, nodes) in tree.levels.iter().enumerate() {
                let per_child = WIDTH.pow(u32::try_from(level).unwrap() + 1);
                let children = nodes.iter().flat_map(|node| (0..WIDTH).map(move |i| (node, i)));
                for ((node, i), points) in children.zip(points.chunks(per_child)) {
                    let rect = Rect {
                        low: DVec2::new(node.low_x[i], node.low_y[i]),
                        high: DVec2::new(node.high_x[i], node.high_y[i]),
                    };
                    prop_assume!(rect.low.x < rect.high.x && rect.low.y < rect.high.y);
                    for corner in 0..4 {
                        let (cut, distance) =
                            (f64::from(node.cuts[corner][i]), from_corner(points, rect, corner));
                        prop_assert!(cut <= distance);
                        // Of leaves all of it, but for rounding.
                        prop_assert!(level > 0 || cut >= distance - 1e-6);
                    }
                }
            }
        }
    }

    /// Of a circle, boxes at every level reach hardly out of it.
    #[test]
    fn the_corners_of_arcs_are_cut() {
        let count = 1 << 14;
        let at =
            |i: u32| DVec2::from_angle(f64::from(i) / f64::from(count) * std::f64::consts::TAU);
        let points: Vec<DVec2> = (0..count).map(at).collect();
        let order: Vec<PointId> = (0..count).map(PointId::from).collect();
        let tree = Tree::new(&points, &order);
        // At 45 degrees: how far what is left of each child is from the tangent.
        let normal = DVec2::splat(-std::f64::consts::FRAC_1_SQRT_2);
        for (level, width) in [(0, 16), (1, 256)] {
            let child = count as usize / 8 / width;
            let (node, i) = (&tree.levels[level][child / WIDTH], child % WIDTH);
            let corner = DVec2::new(node.high_x[i], node.high_y[i]).dot(normal) + 1.0;
            let angle = width as f64 / f64::from(count) * std::f64::consts::TAU;
            assert!(corner < -0.4 * angle);
            assert!(corner + node.cut(3, i, normal) > -angle * angle, "{level}");
        }
    }
}
