//! The nearest of many segments.

use glam::DVec2;

use crate::segment::Segment;

/// Segments in a balanced tree of boxes, for nearest-segment queries.
///
/// Built by halving at the median midpoint, so that neither uneven density nor segments that run
/// far out unbalance it: O(n log n), and several times faster than an R*-tree to build and to ask.
/// The boxes lie along the segments in them.
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
    boxes: Vec<Rectangle>,
}

/// The most segments of a node that is not halved.
const LEAF: usize = 8;

/// A rectangle in any direction. Pieces of smooth curves fill long thin ones, which keep clear of
/// discs that touch the curve nearby; upright boxes reach into them.
#[derive(Clone, Copy, Debug)]
struct Rectangle {
    centre: DVec2,
    /// The direction of one side, of length 1.
    axis: DVec2,
    /// Half the extents along the axis and across.
    half: DVec2,
}

impl Rectangle {
    const EMPTY: Self = Self {
        centre: DVec2::ZERO,
        axis: DVec2::X,
        half: DVec2::NEG_INFINITY,
    };

    /// The smaller of two rectangles around points: upright, or along a diameter of the points.
    fn around(points: &[DVec2]) -> Self {
        let Some(&first) = points.first() else {
            return Self::EMPTY;
        };
        let farthest = |from: DVec2| {
            points.iter().fold(from, |far, &p| {
                let farther = p.distance_squared(from) > far.distance_squared(from);
                if farther { p } else { far }
            })
        };
        let end = farthest(first);
        let diameter = (farthest(end) - end).normalize_or(DVec2::X);
        let [upright, along] = [DVec2::X, diameter].map(|axis| Self::along(axis, first, points));
        if along.half.x * along.half.y < upright.half.x * upright.half.y {
            along
        } else {
            upright
        }
    }

    fn along(axis: DVec2, first: DVec2, points: &[DVec2]) -> Self {
        let (low, high) =
            points
                .iter()
                .fold((DVec2::INFINITY, DVec2::NEG_INFINITY), |(low, high), &p| {
                    let (along, across) = (axis.dot(p - first), axis.perp_dot(p - first));
                    let local = DVec2::new(along, across);
                    (low.min(local), high.max(local))
                });
        let (middle, half) = ((low + high) / 2.0, (high - low) / 2.0);
        let centre = first + axis * middle.x + axis.perp() * middle.y;
        // More than what rounding may take from the extents or move the centre.
        let size = centre.abs().max_element() + first.abs().max_element() + half.max_element();
        Self {
            centre,
            axis,
            half: half + size * 16.0 * f64::EPSILON,
        }
    }

    fn corners(&self) -> [DVec2; 4] {
        let (along, across) = (self.axis * self.half.x, self.axis.perp() * self.half.y);
        [
            along + across,
            along - across,
            -along - across,
            across - along,
        ]
        .map(|to_corner| self.centre + to_corner)
    }

    /// No more than the squared distance of `p` to anything inside.
    fn distance_squared(&self, p: DVec2) -> f64 {
        let d = p - self.centre;
        let local = DVec2::new(d.dot(self.axis).abs(), self.axis.perp_dot(d).abs());
        let beyond = (local - self.half).max(DVec2::ZERO);
        beyond.length_squared() * (1.0 - 32.0 * f64::EPSILON)
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

/// The points that will be asked for lie in this disc.
#[derive(Clone, Copy)]
struct Disc {
    centre: DVec2,
    radius: f64,
}

impl Disc {
    const PLANE: Self = Self {
        centre: DVec2::ZERO,
        radius: f64::INFINITY,
    };

    /// The part of a segment that holds its closest points to all points of the disc: the closest
    /// points to two points are no farther apart than these are.
    fn part_of(self, segment: Segment) -> Segment {
        // More than rounding may move a closest point.
        let radius = self.radius * (1.0 + 1e-9);
        if segment.length() <= radius {
            return segment;
        }
        let closest = segment.closest_point(self.centre);
        let cut = |end: DVec2| {
            if end.distance(closest) <= radius {
                end
            } else {
                closest + (end - closest).normalize_or_zero() * radius
            }
        };
        Segment::new(cut(segment.a), cut(segment.b))
    }
}

impl SegmentTree {
    /// Builds the tree.
    #[must_use]
    pub fn new(segments: impl IntoIterator<Item = Segment>) -> Self {
        Self::for_queries_in(Disc::PLANE, segments)
    }

    /// Builds the tree for queries no farther than `radius` from `centre`; of others the answer is
    /// some segment, not always the nearest.
    ///
    /// For segments that run far out of where the queries are: as wholes they would fill boxes that
    /// overlap everywhere.
    #[must_use]
    pub fn near(centre: DVec2, radius: f64, segments: impl IntoIterator<Item = Segment>) -> Self {
        Self::for_queries_in(Disc { centre, radius }, segments)
    }

    fn for_queries_in(queries: Disc, segments: impl IntoIterator<Item = Segment>) -> Self {
        let item = |segment: Segment| {
            let part = queries.part_of(segment);
            let twice_midpoint = part.a + part.b;
            (segment, twice_midpoint)
        };
        let mut items: Vec<Item> = segments.into_iter().map(item).collect();
        let leaves = items.len().div_ceil(LEAF).max(1).next_power_of_two();
        let mut boxes = vec![Rectangle::EMPTY; 2 * leaves - 1];
        build(queries, &mut items, &mut boxes, 0);
        Self {
            segments: items.into_iter().map(|(segment, _)| segment).collect(),
            boxes,
        }
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

    /// A segment nearest to `p`, and its distance, if that is below `limit`: the smaller the limit,
    /// the faster.
    #[must_use]
    pub fn nearest_within(&self, p: DVec2, limit: f64) -> Option<(Segment, f64)> {
        let mut best = Best {
            segment: *self.segments.first()?,
            // Not below the square of any distance below the limit, whatever rounding does.
            squared: limit * limit * (1.0 + 8.0 * f64::EPSILON),
        };
        let root = self.boxes.first()?;
        if root.distance_squared(p) < best.squared {
            self.search(p, 0, &self.segments, &mut best);
        }
        // Where none is nearer than the limit, this is some segment.
        let distance = best.segment.distance(p);
        (distance < limit).then_some((best.segment, distance))
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

/// A segment, and twice the midpoint of its part that queries may find.
type Item = (Segment, DVec2);

/// Orders the segments of a node for its descendants, and fills in their boxes.
fn build(queries: Disc, items: &mut [Item], boxes: &mut [Rectangle], node: usize) {
    if 2 * node + 2 >= boxes.len() {
        let mut ends = [DVec2::ZERO; 2 * LEAF];
        for (ends, &(segment, _)) in ends.chunks_exact_mut(2).zip(&*items) {
            let part = queries.part_of(segment);
            ends.copy_from_slice(&[part.a, part.b]);
        }
        boxes[node] = Rectangle::around(&ends[..2 * items.len()]);
        return;
    }
    let middle = items.len() / 2;
    let (low, high) = items.iter().fold(
        (DVec2::INFINITY, DVec2::NEG_INFINITY),
        |(low, high), &(_, m)| (low.min(m), high.max(m)),
    );
    let DVec2 { x, y } = high - low;
    if middle > 0 {
        let key = |&(_, m): &Item| if x > y { m.x } else { m.y };
        items.select_nth_unstable_by(middle, |s, t| key(s).total_cmp(&key(t)));
    }
    let (before, after) = items.split_at_mut(middle);
    build(queries, before, boxes, 2 * node + 1);
    build(queries, after, boxes, 2 * node + 2);
    let halves = [boxes[2 * node + 1], boxes[2 * node + 2]];
    let corners = halves.map(|half| half.corners());
    // With fewer segments than leaves, the first half is empty more often.
    let from = if before.is_empty() { 1 } else { 0 };
    let to = if after.is_empty() { 1 } else { 2 };
    boxes[node] = Rectangle::around(corners[from.min(to)..to].as_flattened());
}

#[cfg(test)]
mod tests {
    #![allow(
        clippy::float_cmp,
        reason = "the minimum is one of the distances, unrounded"
    )]

    use super::*;
    use crate::Random;
    use proptest::prelude::*;

    #[test]
    fn parts_hold_all_closest_points_to_a_disc() {
        let mut random = Random::new(1);
        let mut at = |size: f64| {
            let unit = DVec2::new(random.between(-1.0, 1.0), random.between(-1.0, 1.0));
            unit * size
        };
        for _ in 0..1_000 {
            let disc = Disc {
                centre: at(1.0),
                radius: at(1.0).length(),
            };
            for size in [1.0, 1e3, 1e20] {
                let segment = Segment::new(at(1.0), at(size));
                let part = disc.part_of(segment);
                assert!(part.length() <= disc.radius * (2.0 + 1e-8) || part == segment);
                let p = disc.centre + at(1.0).normalize() * disc.radius;
                let closest = segment.closest_point(p);
                assert!(part.distance(closest) < 1e-12, "{segment:?} {part:?} {p}");
            }
        }
    }

    /// The axis of a wave: rays from between its crests, to Voronoi vertices that rounding puts
    /// anywhere far out. As wholes, each of them was looked at for every query.
    #[test]
    fn far_ends_do_not_make_boxes_overlap() {
        let count = 2_000;
        let ray = |i: u32| {
            let start = DVec2::new(f64::from(i) / f64::from(count), 0.5);
            let length = 10f64.powi(14 + i32::try_from(i * 7 % 5).unwrap());
            let sense = if i.is_multiple_of(2) { 1.0 } else { -1.0 };
            Segment::new(start, start + DVec2::new(0.0, sense * length))
        };
        let rays: Vec<Segment> = (0..count).map(ray).collect();
        let tree = SegmentTree::near(DVec2::splat(0.5), 0.75, rays);
        for i in (0..count).step_by(50) {
            let p = DVec2::new((f64::from(i) + 0.4) / f64::from(count), 0.5);
            let (_, distance) = tree.nearest(p).unwrap();
            let squared = distance * distance;
            let looked_at = tree
                .boxes
                .iter()
                .filter(|b| b.distance_squared(p) < squared);
            assert!(looked_at.count() < 60, "of {}", tree.boxes.len());
        }
    }

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
            let cut = SegmentTree::near(DVec2::new(0.1, 0.2), 3.2, segments.iter().copied());
            for q in queries {
                let p = DVec2::from_array(q);
                let least = segments.iter().map(|s| s.distance(p)).min_by(f64::total_cmp);
                prop_assert_eq!(tree.nearest(p).map(|found| found.1), least);
                prop_assert_eq!(cut.nearest(p).map(|found| found.1), least);
                for limit in [0.01, 0.1, 1.0] {
                    let found = tree.nearest_within(p, limit).map(|found| found.1);
                    prop_assert_eq!(found, least.filter(|&distance| distance < limit));
                }
                for &near in segments.iter().take(3) {
                    let found = tree.nearest_after(p, near);
                    prop_assert_eq!(found.map(|found| found.1), least);
                }
            }
        }
    }
}
