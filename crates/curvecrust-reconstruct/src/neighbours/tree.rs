//! An implicit tree of bounding boxes over points in spatial order.

use curvecrust_geometry::DVec2;
use rayon::prelude::*;

use super::lanes::{WIDTH, bits, indices, least, most};

/// Leaves that make a task, a multiple of 16.
const TASK: usize = 256;

/// An axis-parallel rectangle.
#[derive(Clone, Copy, Debug)]
pub(super) struct Rect {
    pub(super) low: DVec2,
    pub(super) high: DVec2,
}

impl Rect {
    /// Holds nothing and meets nothing.
    const EMPTY: Self = Self {
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
}

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
    fn bounds(&self) -> Rect {
        Rect {
            low: DVec2::new(least(&self.x), least(&self.y)),
            high: DVec2::new(most(&self.x), most(&self.y)),
        }
    }

    /// The bounding box of the points in some slots.
    #[inline(always)]
    pub(super) fn bounds_of(&self, slots: std::ops::Range<usize>) -> Rect {
        let points = slots.map(|slot| self.point(slot));
        points.fold(Rect::EMPTY, |rect, point| Rect {
            low: rect.low.min(point),
            high: rect.high.max(point),
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
}

impl Node {
    fn over(children: impl Iterator<Item = Rect>) -> Self {
        let mut rects = [Rect::EMPTY; WIDTH];
        for (rect, child) in rects.iter_mut().zip(children) {
            *rect = child;
        }
        Self {
            low_x: rects.map(|r| r.low.x),
            low_y: rects.map(|r| r.low.y),
            high_x: rects.map(|r| r.high.x),
            high_y: rects.map(|r| r.high.y),
        }
    }

    #[inline(always)]
    pub(super) fn bounds(&self) -> Rect {
        Rect {
            low: DVec2::new(least(&self.low_x), least(&self.low_y)),
            high: DVec2::new(most(&self.high_x), most(&self.high_y)),
        }
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
    /// The tree over `points` in the given order of their indices.
    pub(super) fn new(points: &[DVec2], order: &[u32]) -> Self {
        let leaf = |indices: &[u32]| Leaf::new(indices.iter().map(|&i| points[i as usize]));
        let chunks = order.par_chunks(WIDTH).with_min_len(TASK);
        let leaves: Vec<Leaf> = chunks.map(leaf).collect();
        let parent = |leaves: &[Leaf]| Node::over(leaves.iter().map(Leaf::bounds));
        let chunks = leaves.par_chunks(WIDTH).with_min_len(TASK / WIDTH);
        let mut level: Vec<Node> = chunks.map(parent).collect();
        let mut levels = Vec::new();
        while level.len() > 1 {
            let parent = |nodes: &[Node]| Node::over(nodes.iter().map(Node::bounds));
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
