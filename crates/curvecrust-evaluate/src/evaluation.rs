//! All that is measured of one reconstruction.

use curvecrust_geometry::{DVec2, EdgeSet, PointSet};

use crate::distances::Distances;
use crate::edges::EdgeComparison;
use crate::reference::Reference;
use crate::topology::Topology;

/// What should have been found.
#[derive(Clone, Copy, Debug)]
pub struct Truth<'a> {
    /// The curve that the samples stand for.
    pub curve: &'a Reference,
    /// The manifold boundary: the edges between consecutive samples.
    pub boundary: &'a EdgeSet,
}

/// What was found.
#[derive(Clone, Copy, Debug)]
pub struct Output<'a> {
    /// The vertices of the polygons.
    pub vertices: &'a PointSet,
    /// Their edges.
    pub edges: &'a EdgeSet,
    /// What the vertices are.
    pub kind: Kind,
    /// The time it took, in seconds, if that was measured.
    pub seconds: Option<f64>,
}

/// What the vertices of a reconstruction are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// The samples, with the ids of the manifold boundary: edges can be compared.
    Interpolating,
    /// Others, such as samples that were moved or fitted: edges cannot be compared one by one.
    Approximating,
}

/// A reconstruction beside the truth; [`METRICS`](crate::METRICS) are the numbers in it.
///
/// ```
/// use curvecrust_evaluate::{Evaluation, Kind, METRICS, Output, Reference, Truth};
/// use curvecrust_geometry::{DVec2, Edge, EdgeSet, PointSet, Segment};
///
/// let square = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)].map(|(x, y)| DVec2::new(x, y));
/// let points = PointSet::new(square.to_vec())?;
/// let id: Vec<_> = points.ids().collect();
/// let ring = (0..4).map(|i| Edge::new(id[i], id[(i + 1) % 4]).unwrap());
/// let boundary = EdgeSet::new(4, ring.clone());
/// let sides = (0..4).map(|i| Segment::new(square[i], square[(i + 1) % 4]));
/// let curve = Reference::of_segments(sides);
///
/// // One edge is missing.
/// let found = EdgeSet::new(4, ring.take(3));
/// let truth = Truth { curve: &curve, boundary: &boundary };
/// let kind = Kind::Interpolating;
/// let output = Output { vertices: &points, edges: &found, kind, seconds: None };
/// let evaluation = Evaluation::new(truth, output, 1e-3);
/// let value = |name| METRICS.iter().find(|m| m.name == name).unwrap().of(&evaluation).unwrap();
/// assert_eq!(value("exact").lower, 0.0);
/// assert_eq!(value("edge_recall").lower, 0.75);
/// assert_eq!(value("hausdorff_curve").lower, 0.5);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Evaluation {
    /// The edges against the true ones; `None` for an approximating output.
    pub comparison: Option<EdgeComparison>,
    /// The components of the manifold boundary.
    pub true_topology: Topology,
    /// The components of the output.
    pub topology: Topology,
    /// How far output and curve are apart, in the unit of the curve.
    pub distances: Distances,
    /// The larger side of the bounding box of the curve.
    pub extent: f64,
    /// The least angle between two edges at a vertex, in degrees; `None` where no two edges meet.
    pub least_angle: Option<f64>,
    /// The time it took, in seconds.
    pub seconds: Option<f64>,
}

impl Evaluation {
    /// Measures everything. `tolerance` is that of [`Reference::distances`], as a fraction of the
    /// extent.
    #[must_use]
    pub fn new(truth: Truth<'_>, output: Output<'_>, tolerance: f64) -> Self {
        let Output {
            vertices, edges, ..
        } = output;
        let comparable = output.kind == Kind::Interpolating;
        let extent = truth.curve.extent();
        Self {
            comparison: comparable.then(|| EdgeComparison::new(truth.boundary, edges)),
            true_topology: Topology::new(truth.boundary),
            topology: Topology::new(edges),
            distances: truth.curve.distances(vertices, edges, tolerance * extent),
            extent,
            least_angle: least_angle(vertices, edges),
            seconds: output.seconds,
        }
    }
}

/// The least angle between two edges at a vertex, in degrees.
fn least_angle(points: &PointSet, edges: &EdgeSet) -> Option<f64> {
    let mut directions: Vec<(usize, f64)> = Vec::with_capacity(2 * edges.len());
    for edge in edges
        .edges()
        .iter()
        .filter(|e| e.b().index() < points.len())
    {
        let along: DVec2 = points[edge.b()] - points[edge.a()];
        directions.push((edge.a().index(), along.to_angle()));
        directions.push((edge.b().index(), (-along).to_angle()));
    }
    directions.sort_unstable_by(|p, q| p.0.cmp(&q.0).then(p.1.total_cmp(&q.1)));
    let at_vertices = directions.chunk_by(|p, q| p.0 == q.0);
    let least = at_vertices
        .filter(|around| around.len() > 1)
        .map(least_between)
        .min_by(f64::total_cmp);
    least.map(f64::to_degrees)
}

/// The least angle between directions around a vertex, of which there are two at least, ascending.
fn least_between(around: &[(usize, f64)]) -> f64 {
    let inner = around.windows(2).map(|pair| pair[1].1 - pair[0].1);
    let over = match (around.first(), around.last()) {
        (Some(first), Some(last)) => first.1 + std::f64::consts::TAU - last.1,
        _ => f64::INFINITY,
    };
    inner.chain([over]).fold(f64::INFINITY, f64::min)
}
