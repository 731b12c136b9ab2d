//! The nearest of many segments.

use glam::DVec2;
use rstar::{AABB, PointDistance, RTree, RTreeObject};

use crate::segment::Segment;

/// Segments in an R*-tree, for nearest-segment queries.
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
#[derive(Debug)]
pub struct SegmentTree {
    tree: RTree<Indexed>,
}

/// A segment in the tree; with our own distance, which loses no digits of segments that run far out.
#[derive(Debug)]
struct Indexed(Segment);

impl SegmentTree {
    /// Builds the tree, in O(n log n).
    #[must_use]
    pub fn new(segments: impl IntoIterator<Item = Segment>) -> Self {
        let segments = segments.into_iter().map(Indexed).collect();
        Self {
            tree: RTree::bulk_load(segments),
        }
    }

    /// A segment nearest to `p`, and its distance; `None` if there are no segments.
    #[must_use]
    pub fn nearest(&self, p: DVec2) -> Option<(Segment, f64)> {
        let nearest = self.tree.nearest_neighbor(p.to_array())?.0;
        Some((nearest, nearest.distance(p)))
    }
}

impl RTreeObject for Indexed {
    type Envelope = AABB<[f64; 2]>;

    fn envelope(&self) -> Self::Envelope {
        AABB::from_corners(self.0.a.to_array(), self.0.b.to_array())
    }
}

impl PointDistance for Indexed {
    fn distance_2(&self, point: &[f64; 2]) -> f64 {
        self.0.distance_squared(DVec2::from_array(*point))
    }
}
