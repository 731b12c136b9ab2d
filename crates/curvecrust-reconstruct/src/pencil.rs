//! Whether Voronoi vertices leave room for a disc that touches two samples.

use curvecrust_geometry::point_set::by_coordinates;
use curvecrust_geometry::{DVec2, PointSet, orient2d};
use curvecrust_voronoi::Delaunay;
use rstar::{AABB, PointDistance, RTree, RTreeObject};

/// The Voronoi vertices of a point set, ready for searches.
pub(crate) struct VoronoiVertices {
    tree: RTree<VoronoiVertex>,
}

impl VoronoiVertices {
    pub(crate) fn new(points: &PointSet, delaunay: &Delaunay) -> Self {
        let vertices = delaunay
            .triangles()
            .map(|triangle| VoronoiVertex::of(triangle.map(|id| points[id])));
        Self {
            tree: RTree::bulk_load(vertices.collect()),
        }
    }

    /// Whether some disc with `p` and `q` on its boundary has no Voronoi vertex inside.
    ///
    /// Tries one disc after the other. Every Voronoi vertex in a disc narrows the range of discs
    /// that may still be free and drives the disc out of it; the next one halves what is left.
    pub(crate) fn spare_a_disc_through(&self, p: DVec2, q: DVec2) -> bool {
        let pencil = Pencil { p, across: q - p };
        let mut range = Range::ALL;
        loop {
            let tried = range.probe();
            let Some((centre, reach_squared)) = pencil.disc(tried) else {
                // Too large for a tree: every vertex is asked.
                self.tree.iter().for_each(|v| range.narrow(&pencil, v));
                return !range.is_empty();
            };
            let near = self
                .tree
                .nearest_neighbor_iter_with_distance_2(centre)
                .take_while(|&(_, distance_squared)| distance_squared <= reach_squared);
            for (vertex, _) in near {
                range.narrow(&pencil, vertex);
                if !range.contains(tried) {
                    break;
                }
            }
            if range.is_empty() {
                return false;
            }
            if range.contains(tried) {
                return true;
            }
        }
    }
}

/// The circumcentre of a Delaunay triangle, as an offset from one of its corners: near corners, a
/// coordinate would have lost the digits that matter, and a shift of all points would change them.
struct VoronoiVertex {
    corner: DVec2,
    offset: DVec2,
}

impl VoronoiVertex {
    /// Of a counter-clockwise triangle.
    fn of(corners: [DVec2; 3]) -> Self {
        // The corner opposite the longest side: its own sides are the shortest.
        let opposite = |i: usize| corners[(i + 1) % 3].distance_squared(corners[(i + 2) % 3]);
        let first = [1, 2].into_iter().fold(0, |best, i| {
            let longer = opposite(i).total_cmp(&opposite(best));
            let before = by_coordinates(corners[best], corners[i]);
            if longer.then(before).is_gt() { i } else { best }
        });
        let [a, b, c] = [0, 1, 2].map(|i| corners[(first + i) % 3]);
        let (ab, ac) = (b - a, c - a);
        let across = ac * ab.length_squared() - ab * ac.length_squared();
        // The area from the exact predicate: positive even for a sliver.
        let offset = -across.perp() / (2.0 * orient2d(a, b, c));
        Self { corner: a, offset }
    }

    fn position(&self) -> [f64; 2] {
        (self.corner + self.offset).into()
    }
}

impl RTreeObject for VoronoiVertex {
    type Envelope = AABB<[f64; 2]>;

    fn envelope(&self) -> Self::Envelope {
        AABB::from_point(self.position())
    }
}

impl PointDistance for VoronoiVertex {
    fn distance_2(&self, point: &[f64; 2]) -> f64 {
        DVec2::from(self.position()).distance_squared((*point).into())
    }
}

/// All discs with p and q on their boundary, each named by the cotangent of the angle under which
/// pq is seen from its boundary on the left: 0 for the smallest disc, more for centres to the left.
struct Pencil {
    p: DVec2,
    /// q - p.
    across: DVec2,
}

impl Pencil {
    /// Centre and squared radius, enlarged by more than the rounding of any distance to the centre
    /// and of the disc of any vertex; `None` beyond the range of doubles.
    fn disc(&self, cotangent: f64) -> Option<([f64; 2], f64)> {
        let to_centre = (self.across + cotangent * self.across.perp()) / 2.0;
        let centre = self.p + to_centre;
        let radius = to_centre.length();
        let slack = 32.0 * f64::EPSILON * (radius + centre.length());
        let reach = radius + slack;
        let squared = reach * reach;
        squared.is_finite().then(|| (centre.into(), squared))
    }
}

/// The discs of a pencil that no vertex has ruled out, by their cotangents.
#[derive(Clone, Copy, Debug)]
struct Range {
    low: f64,
    high: f64,
}

impl Range {
    const ALL: Self = Self {
        low: f64::NEG_INFINITY,
        high: f64::INFINITY,
    };

    /// Rules out the discs that hold the vertex.
    fn narrow(&mut self, pencil: &Pencil, vertex: &VoronoiVertex) {
        let from_p = (vertex.corner - pencil.p) + vertex.offset;
        // Far vertices of slivers would overflow in squares.
        let size = from_p.abs().max_element();
        let direction = from_p / size;
        let sine = pencil.across.perp_dot(direction);
        let cosine = size * direction.length_squared() - direction.dot(pencil.across);
        if sine > 0.0 {
            self.high = self.high.min(cosine / sine);
        } else if sine < 0.0 {
            self.low = self.low.max(cosine / sine);
        } else if cosine < 0.0 {
            // Between p and q: inside every disc.
            self.high = f64::NEG_INFINITY;
        }
    }

    fn contains(&self, cotangent: f64) -> bool {
        self.low <= cotangent && cotangent <= self.high
    }

    fn is_empty(&self) -> bool {
        self.low > self.high
    }

    /// The smallest disc if it is left, else one in the middle, so that the range shrinks fast.
    fn probe(&self) -> f64 {
        if self.contains(0.0) {
            0.0
        } else if self.high.is_infinite() {
            2.0 * self.low + 1.0
        } else if self.low.is_infinite() {
            2.0 * self.high - 1.0
        } else {
            self.low / 2.0 + self.high / 2.0
        }
    }
}
