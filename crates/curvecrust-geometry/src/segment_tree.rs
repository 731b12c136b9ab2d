//! The nearest of many segments.

use glam::DVec2;

use crate::segment::Segment;

/// Segments in a balanced tree of boxes, for nearest-segment queries.
///
/// Built by halving at the median midpoint, so that neither uneven density nor segments that run far
/// out unbalance it: O(n log n), and several times faster than an R*-tree to build and to ask.
///
/// ```
/// use curvecrust_geometry::{DVec2, Segment, SegmentTree};
///
/// let tree = SegmentTree::new([
///     Segment::new(DVec2::ZERO, DVec2::X),
///     Segment::new(DVec2::new(0.0, 5.0), DVec2::new(1.0, 5.0)),
/// ]);
/// let (segment, distance) = tree.nearest(DVec2::new(0.5, 4.0)).unwrap();
/// assert_eq!((segment.a.y, distance), (5.0, 1.0));
/// ```
#[derive(Clone, Debug, Default)]
pub struct SegmentTree {
    /// In the order of the leaves.
    segments: Vec<Segment>,
    /// The root, then the two boxes of each node: those of node `i` are `2 i + 1` and `2 i + 2`.
    boxes: Vec<Aabb>,
}

/// The segments of a node are halved until they are at most so many.
const LEAF: usize = 8;

#[derive(Clone, Copy, Debug)]
struct Aabb {
    low: DVec2,
    high: DVec2,
}

impl Aabb {
    const EMPTY: Self = Self {
        low: DVec2::INFINITY,
        high: DVec2::NEG_INFINITY,
    };

    fn around(points: impl IntoIterator<Item = DVec2>) -> Self {
        points.into_iter().fold(Self::EMPTY, |b, p| Self {
            low: b.low.min(p),
            high: b.high.max(p),
        })
    }

    fn distance_squared(&self, p: DVec2) -> f64 {
        (self.low - p)
            .max(p - self.high)
            .max(DVec2::ZERO)
            .length_squared()
    }
}

/// The nearest segment so far.
#[derive(Clone, Copy)]
struct Best {
    segment: Segment,
    squared: f64,
}

impl Best {
    fn challenge(&mut self, segment: Segment, p: DVec2) {
        let squared = segment.distance_squared(p);
        if squared < self.squared {
            *self = Self { segment, squared };
        }
    }
}

impl SegmentTree {
    /// Builds the tree.
    #[must_use]
    pub fn new(segments: impl IntoIterator<Item = Segment>) -> Self {
        let segments: Vec<Segment> = segments.into_iter().collect();
        let depth = segments
            .len()
            .div_ceil(LEAF)
            .max(1)
            .next_power_of_two()
            .ilog2();
        let mut tree = Self {
            boxes: vec![Aabb::EMPTY; (2 << depth) - 1],
            segments,
        };
        build(&mut tree.segments, &mut tree.boxes, 0);
        tree
    }

    /// A segment nearest to `p`, and its distance; `None` if there are no segments.
    #[must_use]
    pub fn nearest(&self, p: DVec2) -> Option<(Segment, f64)> {
        self.nearest_after(p, *self.segments.first()?)
    }

    /// The same, faster when a segment of the tree is known to be near, such as the nearest to a
    /// point close by.
    #[must_use]
    pub fn nearest_after(&self, p: DVec2, near: Segment) -> Option<(Segment, f64)> {
        if self.segments.is_empty() {
            return None;
        }
        let mut best = Best {
            segment: near,
            squared: near.distance_squared(p),
        };
        self.search(p, 0, &self.segments, &mut best);
        Some((best.segment, best.squared.sqrt()))
    }

    /// Looks for a nearer one among the segments of a node, in the nearer half first.
    fn search(&self, p: DVec2, node: usize, segments: &[Segment], best: &mut Best) {
        let first = 2 * node + 1;
        let Some([left, right]) = self.boxes.get(first..first + 2) else {
            for &segment in segments {
                best.challenge(segment, p);
            }
            return;
        };
        let (before, after) = segments.split_at(segments.len() / 2);
        let mut halves = [
            (left.distance_squared(p), first, before),
            (right.distance_squared(p), first + 1, after),
        ];
        if halves[1].0 < halves[0].0 {
            halves.swap(0, 1);
        }
        for (squared, node, segments) in halves {
            if squared < best.squared {
                self.search(p, node, segments, best);
            }
        }
    }
}

/// Orders the segments of a node for its descendants, and fills in their boxes.
fn build(segments: &mut [Segment], boxes: &mut [Aabb], node: usize) {
    boxes[node] = Aabb::around(segments.iter().flat_map(|s| [s.a, s.b]));
    if 2 * node + 2 >= boxes.len() {
        return;
    }
    let middle = segments.len() / 2;
    let extent = Aabb::around(segments.iter().map(|s| s.a.midpoint(s.b)));
    let DVec2 { x, y } = extent.high - extent.low;
    if middle > 0 {
        // Twice the midpoints.
        if x > y {
            let key = |s: &Segment| s.a.x + s.b.x;
            segments.select_nth_unstable_by(middle, |s, t| key(s).total_cmp(&key(t)));
        } else {
            let key = |s: &Segment| s.a.y + s.b.y;
            segments.select_nth_unstable_by(middle, |s, t| key(s).total_cmp(&key(t)));
        }
    }
    let (before, after) = segments.split_at_mut(middle);
    build(before, boxes, 2 * node + 1);
    build(after, boxes, 2 * node + 2);
}

#[cfg(test)]
mod tests {
    #![allow(
        clippy::float_cmp,
        reason = "the minimum is one of the distances, unrounded"
    )]

    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn the_nearest_is_the_nearest(
            ends in prop::collection::vec(prop::array::uniform4(-1.0..1.0f64), 0..200),
            far in 0usize..20,
            queries in prop::collection::vec(prop::array::uniform2(-2.0..2.0f64), 20),
        ) {
            let segment = |(i, e): (usize, &[f64; 4])| {
                // Some run far out, most are short.
                let a = DVec2::new(e[0], e[1]);
                let scale = if i < far { 1e6 } else { 0.05 };
                Segment::new(a, a + DVec2::new(e[2], e[3]) * scale)
            };
            let segments: Vec<Segment> = ends.iter().enumerate().map(segment).collect();
            let tree = SegmentTree::new(segments.iter().copied());
            for q in queries {
                let p = DVec2::from_array(q);
                let least = segments.iter().map(|s| s.distance(p)).min_by(f64::total_cmp);
                prop_assert_eq!(tree.nearest(p).map(|found| found.1), least);
                for &near in segments.iter().take(3) {
                    let found = tree.nearest_after(p, near);
                    prop_assert_eq!(found.map(|found| found.1), least);
                }
            }
        }
    }
}
