//! The triangulation, and every edge with its dual.

use std::sync::OnceLock;

use curvecrust_geometry::parallel::*;
use curvecrust_geometry::point_set::by_coordinates;
use curvecrust_geometry::{DVec2, Interrupt, PointId, PointSet, orient2d};
use spade::handles::{FaceHandle, InnerTag};
use spade::{DelaunayTriangulation, Point2, Triangulation};

use crate::order::brio_order;

type Spade = DelaunayTriangulation<Point2<f64>>;
type SpadeTriangle<'a> = FaceHandle<'a, InnerTag, Point2<f64>, (), (), ()>;

/// Triangles that make a task.
const TASK: usize = 1 << 12;

/// The Delaunay triangulation of a point set, with its Voronoi vertices.
///
/// Exact: no point lies inside the circumcircle of a triangle. Where four or more points lie on one
/// empty circle the triangulation is not unique; which one is built depends on the coordinates, not
/// on the order of the points. Fewer than three points, or points on one line, have no triangle,
/// but edges between neighbours on the line.
///
/// ```
/// use curvecrust_geometry::{DVec2, PointSet};
/// use curvecrust_voronoi::Delaunay;
///
/// let corners = [(0.0, 0.0), (4.0, 0.0), (0.0, 2.0)].map(|(x, y)| DVec2::new(x, y));
/// let delaunay = Delaunay::new(&PointSet::new(corners.to_vec())?);
/// assert_eq!(delaunay.triangles().count(), 1);
/// assert_eq!(delaunay.edges().count(), 3);
/// for edge in delaunay.edges() {
///     // One side is the circumcentre, the other is unbounded.
///     let centre = delaunay.voronoi_edge(&edge).into_iter().flatten().next();
///     assert_eq!(centre, Some(DVec2::new(2.0, 1.0)));
/// }
/// # Ok::<(), curvecrust_geometry::PointSetError>(())
/// ```
#[derive(Debug)]
pub struct Delaunay {
    triangulation: Spade,
    /// The ids of the points in order of insertion, which is the order of spade's vertices.
    ids: Vec<PointId>,
    /// The circumcentres, in order of spade's inner faces; not all who triangulate want them.
    centres: OnceLock<Vec<DVec2>>,
    /// All points along the line that they lie on; empty, and the triangulation is not, if they lie
    /// on none.
    row: Vec<PointId>,
}

/// A Delaunay edge with what lies left and right of it. Its dual is the Voronoi edge between the
/// cells of its ends: [`Delaunay::voronoi_edge`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DualEdge {
    /// The ends `a`, `b` of the Delaunay edge: the sites whose cells the Voronoi edge parts.
    pub ends: [PointId; 2],
    /// The third vertex of the triangle left and of the one right of the line from `a` to `b`;
    /// `None` where the hull leaves no triangle.
    pub apexes: [Option<PointId>; 2],
    /// The same triangles, by their places in the order of [`Delaunay::triangles`].
    pub triangles: [Option<usize>; 2],
}

impl Delaunay {
    /// Triangulates the points, in O(n log n) expected time for points as they occur on curves.
    ///
    /// The insertion starts from a triangle: as long as all points lie on one line, spade would
    /// look at every one of them to insert the next.
    #[must_use]
    #[expect(
        clippy::expect_used,
        clippy::missing_panics_doc,
        reason = "spade refuses just what a PointSet refuses"
    )]
    pub fn new(points: &PointSet) -> Self {
        let mut ids = brio_order(points);
        if !starts_with_triangle(points, &mut ids) {
            ids.sort_unstable_by(|&p, &q| by_coordinates(points[p], points[q]));
            return Self {
                triangulation: Spade::new(),
                ids: Vec::new(),
                centres: OnceLock::new(),
                row: ids,
            };
        }
        // All at once: one by one, every insertion would wait for memory.
        let places: Vec<Point2<f64>> = ids
            .iter()
            .map(|&id| Point2::new(points[id].x, points[id].y))
            .collect();
        let mut triangulation = Spade::with_capacity(ids.len(), 3 * ids.len(), 2 * ids.len());
        let interrupt = Interrupt::current();
        let mut previous = None;
        for place in places {
            interrupt.check();
            let inserted = match previous {
                Some(hint) => triangulation.insert_with_hint(place, hint),
                None => triangulation.insert(place),
            };
            let vertex = inserted.expect("a PointSet holds only coordinates that spade accepts");
            previous = Some(vertex);
        }
        Self {
            triangulation,
            ids,
            centres: OnceLock::new(),
            row: Vec::new(),
        }
    }

    /// The triangles, each counter-clockwise.
    pub fn triangles(&self) -> impl Iterator<Item = [PointId; 3]> + '_ {
        self.triangulation
            .inner_faces()
            .map(|face| face.vertices().map(|v| self.id(v.index())))
    }

    /// The Voronoi vertices: the circumcentres of the triangles, in the order of
    /// [`triangles`](Self::triangles). Those of cocircular triangles coincide up to rounding.
    #[must_use]
    pub fn voronoi_vertices(&self) -> &[DVec2] {
        self.centres.get_or_init(|| {
            let faces: Vec<_> = self.triangulation.fixed_inner_faces().collect();
            let centre = |&face| circumcentre(self.triangulation.face(face));
            faces.par_iter().with_min_len(TASK).map(centre).collect()
        })
    }

    /// The edges, each once.
    pub fn edges(&self) -> impl Iterator<Item = DualEdge> + '_ {
        let on_a_line = self.row.windows(2).map(|pair| DualEdge {
            ends: [pair[0], pair[1]],
            apexes: [None; 2],
            triangles: [None; 2],
        });
        let edges = self.triangulation.undirected_edges().map(|edge| {
            let edge = edge.as_directed();
            let sides = [edge, edge.rev()];
            DualEdge {
                ends: sides.map(|side| self.id(side.from().index())),
                apexes: sides.map(|side| Some(self.id(side.opposite_vertex()?.index()))),
                // spade's face 0 is the outer one; the inner faces follow.
                triangles: sides.map(|side| Some(side.face().as_inner()?.index() - 1)),
            }
        });
        edges.chain(on_a_line)
    }

    /// The Voronoi edge dual to a Delaunay edge: the circumcentres of the triangles to its left and
    /// right. `None`: it is unbounded on that side, a ray along the bisector, or a line if both are
    /// `None`.
    ///
    /// # Panics
    /// If the edge is of another triangulation, with more triangles.
    #[must_use]
    pub fn voronoi_edge(&self, dual: &DualEdge) -> [Option<DVec2>; 2] {
        let centres = self.voronoi_vertices();
        dual.triangles.map(|triangle| Some(centres[triangle?]))
    }

    fn id(&self, vertex: usize) -> PointId {
        self.ids[vertex]
    }
}

/// Moves the first point that is not on the line through the first two behind them; false if all
/// points are on one line.
fn starts_with_triangle(points: &PointSet, ids: &mut [PointId]) -> bool {
    let [a, b, rest @ ..] = ids else { return false };
    let (a, b) = (points[*a], points[*b]);
    let corner = rest
        .iter()
        .position(|&id| orient2d(a, b, points[id]) != 0.0);
    if let Some(corner) = corner {
        rest[..=corner].rotate_right(1);
    }
    corner.is_some()
}

/// The circumcentre, with the area from the exact predicate: a sliver is not mistaken for a line.
fn circumcentre(face: SpadeTriangle<'_>) -> DVec2 {
    let [a, b, c] = face.positions().map(|p| DVec2::new(p.x, p.y));
    let (ab, ac) = (b - a, c - a);
    let across = ac * ab.length_squared() - ab * ac.length_squared();
    a - across.perp() / (2.0 * orient2d(a, b, c))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn circumcentres_are_equidistant() {
        let points = PointSet::new(vec![
            DVec2::new(0.0, 0.0),
            DVec2::new(3.0, 1.0),
            DVec2::new(1.0, 4.0),
        ])
        .unwrap();
        let delaunay = Delaunay::new(&points);
        let centre = delaunay.voronoi_vertices()[0];
        let radii = points.points().iter().map(|p| p.distance(centre));
        let spread = radii.clone().fold(0.0, f64::max) - radii.fold(f64::INFINITY, f64::min);
        assert!(spread < 1e-14);
    }
}
