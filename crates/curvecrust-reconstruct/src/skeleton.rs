//! The skeleton that the one-step crust leaves over: a medial axis from samples alone.

use curvecrust_geometry::{DVec2, PointId, PointSet, Segment};
use curvecrust_voronoi::DualEdge;
use rayon::prelude::*;
use rstar::{AABB, PointDistance, RTree, RTreeObject};

/// Beyond this many extents of the points, the skeleton is not looked at: squares of distances
/// stay finite, and no local feature size that a curve can have is missed.
const FAR: f64 = (1u128 << 100) as f64;

/// A Voronoi edge of the samples.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SkeletonEdge {
    /// The samples whose cells it parts, ascending.
    pub sites: [PointId; 2],
    /// The Voronoi vertex at which it starts.
    pub start: DVec2,
    /// Where it leads.
    pub end: SkeletonEnd,
}

/// The far end of a Voronoi edge.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum SkeletonEnd {
    /// A Voronoi vertex.
    At(DVec2),
    /// None: the edge is a ray in the direction of this vector, whose length means nothing.
    Towards(DVec2),
}

impl SkeletonEdge {
    /// The dual of a Delaunay edge; `None` if it is a whole line, which has no start.
    pub(crate) fn dual_of(points: &PointSet, dual: &DualEdge) -> Option<Self> {
        let ([p, q], [mut left, mut right]) = (dual.ends, dual.centres);
        let sites = [p.min(q), p.max(q)];
        if p > q {
            (left, right) = (right, left);
        }
        let to_left = (points[sites[1]] - points[sites[0]]).perp();
        let (start, end) = match (left, right) {
            (Some(left), Some(right)) => (left, SkeletonEnd::At(right)),
            (Some(left), None) => (left, SkeletonEnd::Towards(-to_left)),
            (None, Some(right)) => (right, SkeletonEnd::Towards(to_left)),
            (None, None) => return None,
        };
        Some(Self { sites, start, end })
    }

    /// The part within `far` of a place, or a little more; `None` if both ends are farther.
    fn clipped(&self, place: DVec2, far: f64) -> Option<Segment> {
        let is_near = |v: DVec2| (v - place).abs().max_element() <= far;
        let from = |start: DVec2, direction: DVec2| {
            let unit = (direction / direction.abs().max_element()).normalize_or_zero();
            Segment::new(start, start + unit * (4.0 * far))
        };
        match self.end {
            SkeletonEnd::At(end) => match (is_near(self.start), is_near(end)) {
                (true, true) => Some(Segment::new(self.start, end)),
                (true, false) => Some(from(self.start, end - self.start)),
                (false, true) => Some(from(end, self.start - end)),
                (false, false) => None,
            },
            SkeletonEnd::Towards(direction) => {
                is_near(self.start).then(|| from(self.start, direction))
            }
        }
    }
}

/// The duals of all Delaunay edges outside the one-step crust, ascending by their sites.
///
/// Empty for points on one line, whose edges are all in the crust.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Skeleton {
    edges: Vec<SkeletonEdge>,
}

impl Skeleton {
    pub(crate) fn new(mut edges: Vec<SkeletonEdge>) -> Self {
        edges.sort_unstable_by_key(|e| e.sites);
        Self { edges }
    }

    /// The edges.
    #[must_use]
    pub fn edges(&self) -> &[SkeletonEdge] {
        &self.edges
    }

    /// For every point its distance to the skeleton, an estimate of its local feature size; infinite
    /// if there is no skeleton.
    ///
    /// It approaches the local feature size as the samples get denser, and means little where they
    /// violate every sampling condition. Parts of the skeleton farther than 2^100 times the extent
    /// of the points count as infinitely far. Cost: O(n log n).
    #[must_use]
    pub fn lfs(&self, points: &PointSet) -> Vec<f64> {
        let Some(&first) = points.points().first() else {
            return Vec::new();
        };
        let (low, high) = points
            .points()
            .iter()
            .fold((first, first), |(low, high), &p| (low.min(p), high.max(p)));
        let far = FAR * (high - low).max_element();
        let pieces = self.edges.iter().filter_map(|e| e.clipped(first, far));
        let tree = RTree::bulk_load(pieces.map(Piece).collect());
        let distance = |&p: &DVec2| {
            tree.nearest_neighbor(p.into())
                .map_or(f64::INFINITY, |piece| piece.0.distance(p))
        };
        points.points().par_iter().map(distance).collect()
    }
}

/// A segment in an R-tree.
struct Piece(Segment);

impl RTreeObject for Piece {
    type Envelope = AABB<[f64; 2]>;

    fn envelope(&self) -> Self::Envelope {
        AABB::from_corners(self.0.a.into(), self.0.b.into())
    }
}

impl PointDistance for Piece {
    fn distance_2(&self, &point: &[f64; 2]) -> f64 {
        self.0.distance_squared(point.into())
    }
}
