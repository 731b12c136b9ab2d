//! The skeleton that the one-step crust leaves over: a medial axis from samples alone.

use curvecrust_geometry::parallel::*;
use curvecrust_geometry::{DVec2, PointId, PointSet, Segment};
use curvecrust_voronoi::{Delaunay, DualEdge};
use rstar::{AABB, PointDistance, RTree, RTreeObject};

/// The farthest that the skeleton is looked for: squares of distances stay finite.
const FARTHEST: f64 = f64::from_bits((1023 + 500) << 52);

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
    pub(crate) fn dual_of(points: &PointSet, delaunay: &Delaunay, dual: &DualEdge) -> Option<Self> {
        let ([p, q], [mut left, mut right]) = (dual.ends, delaunay.voronoi_edge(dual));
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

    /// Where it lies on the bisector of its sites.
    fn on_bisector(&self, [p, q]: [DVec2; 2]) -> OnBisector {
        let foot = p + (q - p) / 2.0;
        let axis = (q - p).perp().normalize_or_zero();
        let start = (self.start - foot).dot(axis);
        let end = match self.end {
            SkeletonEnd::At(end) => (end - foot).dot(axis),
            SkeletonEnd::Towards(direction) => f64::INFINITY.copysign(direction.dot(axis)),
        };
        OnBisector {
            foot,
            axis,
            from: start.min(end),
            to: start.max(end),
        }
    }
}

/// The points `foot + t axis` of a line with `from <= t <= to`.
#[derive(Clone, Copy, Debug, PartialEq)]
struct OnBisector {
    foot: DVec2,
    /// A unit vector.
    axis: DVec2,
    from: f64,
    to: f64,
}

impl OnBisector {
    fn distance(&self, place: DVec2) -> f64 {
        let to_foot = self.foot - place;
        let t = (-to_foot.dot(self.axis)).max(self.from).min(self.to);
        let away = to_foot + t * self.axis;
        away.x.hypot(away.y)
    }

    /// The part no farther than `radius` from a place, or a little more; `None` if there is none.
    fn clipped(&self, place: DVec2, radius: f64) -> Option<Segment> {
        let middle = (place - self.foot).dot(self.axis);
        let (from, to) = (self.from.max(middle - radius), self.to.min(middle + radius));
        let at = |t: f64| self.foot + t * self.axis;
        (from <= to).then(|| Segment::new(at(from), at(to)))
    }
}

/// The duals of all Delaunay edges outside the one-step crust, ascending by their sites.
///
/// Empty for points on one line, whose edges are all in the crust.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Skeleton {
    edges: Vec<SkeletonEdge>,
    lines: Vec<OnBisector>,
}

impl Skeleton {
    pub(crate) fn new(points: &PointSet, mut edges: Vec<SkeletonEdge>) -> Self {
        edges.sort_unstable_by_key(|e| e.sites);
        let line = |e: &SkeletonEdge| e.on_bisector(e.sites.map(|id| points[id]));
        Self {
            lines: edges.iter().map(line).collect(),
            edges,
        }
    }

    /// The edges.
    #[must_use]
    pub fn edges(&self) -> &[SkeletonEdge] {
        &self.edges
    }

    /// For every point its distance to the skeleton, if it is a sample an estimate of its local
    /// feature size; infinite if there is no skeleton.
    ///
    /// It approaches the local feature size as the samples get denser, and means little where they
    /// violate every sampling condition. Skeletons farther than 2^500 count as infinitely far.
    /// Cost: O(n log n), but more if nearly all points lie on one line up to rounding, where every
    /// part of the skeleton is about as far.
    #[must_use]
    pub fn lfs(&self, points: &PointSet) -> Vec<f64> {
        let Some(&first) = points.points().first() else {
            return Vec::new();
        };
        let nearest = self.lines.iter().map(|line| line.distance(first));
        let nearest = nearest.fold(f64::INFINITY, f64::min);
        // No point is farther from the skeleton than this, nor is that place farther from the
        // first.
        let extent = points
            .points()
            .iter()
            .map(|p| p.distance(first))
            .fold(0.0, f64::max);
        let radius = 2.0 * extent + nearest;
        if radius > FARTHEST {
            return vec![f64::INFINITY; points.len()];
        }
        let near = self.lines.iter();
        let near = near.filter_map(|line| line.clipped(first, 1.01 * radius));
        let tree = RTree::bulk_load(near.map(Piece).collect());
        let distance = |&p: &DVec2| {
            tree.nearest_neighbor(p.into())
                .map_or(f64::INFINITY, |piece| piece.0.distance(p))
        };
        points.points().par_iter().map(distance).collect()
    }
}

/// The edges: [`Skeleton::edges`].
impl<'a> IntoIterator for &'a Skeleton {
    type Item = &'a SkeletonEdge;
    type IntoIter = std::slice::Iter<'a, SkeletonEdge>;

    fn into_iter(self) -> Self::IntoIter {
        self.edges.iter()
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
