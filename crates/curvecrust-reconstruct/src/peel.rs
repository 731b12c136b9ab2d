//! Peel: A. D. Parakkat, S. Methirumangalath, R. Muthuganapathy, "Peeling the longest: A simple
//! generalized curve reconstruction algorithm", Computers & Graphics 74, 2018. Its text could not
//! be had: this follows descriptions of it, so the definition is argued.
//!
//! Of every Delaunay triangle the longest edge is peeled off, which leaves the Urquhart graph (R.
//! B. Urquhart, 1980). Of that, the edges stay that are among the two shortest at both of their
//! ends. Chains and rings result. A gap is closed where no third point is near its two ends.
//!
//! No sampling condition is known to make it exact. Cost: that of the Delaunay triangulation,
//! O(n log n).

use curvecrust_geometry::{EdgeSet, PointSet};
use curvecrust_voronoi::DualEdge;

use crate::algorithm::{AlgorithmInfo, Basis, Reconstructor, Scope};
use crate::clusters::Clusters;
use crate::delaunay_graph::DelaunayGraph;

/// The edges of Peel.
///
/// Where points are cocircular and the triangulation is not unique, an edge is peeled off if it is
/// the longest of a triangle that some triangulation has. Lengths are compared in floating point.
///
/// ```
/// use curvecrust_geometry::{DVec2, PointSet};
/// use curvecrust_reconstruct::peel;
///
/// let arc: Vec<DVec2> = (0..20).map(|i| DVec2::from_angle(f64::from(i) / 10.0)).collect();
/// assert_eq!(peel(&PointSet::new(arc)?).len(), 19);
/// # Ok::<(), curvecrust_geometry::PointSetError>(())
/// ```
#[must_use]
pub fn peel(points: &PointSet) -> EdgeSet {
    let graph = DelaunayGraph::new(points);
    let faces = Faces::new(&graph);
    let mut kept = vec![0_u8; graph.len()];
    let mut left = Vec::new();
    for (dual, ends) in graph.edges.iter().zip(graph.pairs()) {
        if faces.make_longest(&graph, dual) {
            continue;
        }
        // They come by length: the first two at a vertex are its shortest.
        let [p, q] = ends.map(|v| v as usize);
        let among_shortest = kept[p] < 2 && kept[q] < 2;
        for end in [p, q] {
            kept[end] = kept[end].saturating_add(1);
        }
        if among_shortest {
            left.push(ends);
        }
    }
    graph.edge_set(left)
}

/// The triangles, those around one circle together.
struct Faces {
    corners: Vec<[u32; 3]>,
    /// For the triangles that share their circle: the round, and a vertex on it, ascending.
    on_circles: Vec<[u32; 2]>,
    /// Which round a triangle belongs to: its own number if it is alone.
    round: Vec<u32>,
}

impl Faces {
    fn new(graph: &DelaunayGraph) -> Self {
        let corners: Vec<[u32; 3]> = graph
            .delaunay
            .triangles()
            .map(|corners| corners.map(u32::from))
            .collect();
        let mut clusters = Clusters::new(corners.len());
        let mut shared = Vec::new();
        for dual in &graph.inside_circles {
            if let [Some(left), Some(right)] = dual.triangles.map(number) {
                clusters.join(left, right);
                shared.extend([left, right]);
            }
        }
        let faces = (0u32..).take(corners.len());
        let round: Vec<u32> = faces.map(|face| clusters.name(face)).collect();
        let on_circle = |face: &u32| {
            let round = round[*face as usize];
            corners[*face as usize].map(|corner| [round, corner])
        };
        let mut on_circles: Vec<[u32; 2]> = shared.iter().flat_map(on_circle).collect();
        on_circles.sort_unstable();
        on_circles.dedup();
        Self {
            corners,
            on_circles,
            round,
        }
    }

    /// The vertices on the circle around a triangle.
    fn on_circle(&self, face: u32) -> impl Iterator<Item = u32> + '_ {
        let round = self.round[face as usize];
        let first = self.on_circles.partition_point(|pair| pair[0] < round);
        let shared = self.on_circles[first..].iter();
        let shared = shared.take_while(move |pair| pair[0] == round);
        let own = self.corners[face as usize];
        own.into_iter().chain(shared.map(|pair| pair[1]))
    }

    /// Whether the edge is longer than the two others of a triangle beside it.
    fn make_longest(&self, graph: &DelaunayGraph, dual: &DualEdge) -> bool {
        let [p, q] = dual.ends.map(u32::from);
        let [a, b] = [p, q].map(|end| graph.at(end));
        let squared = a.distance_squared(b);
        let is_between = |r: u32| {
            let at = graph.at(r);
            r != p && r != q && at.distance_squared(a).max(at.distance_squared(b)) < squared
        };
        let mut beside = dual.triangles.into_iter().filter_map(number);
        beside.any(|face| self.on_circle(face).any(is_between))
    }
}

fn number(face: Option<usize>) -> Option<u32> {
    u32::try_from(face?).ok()
}

/// Peel behind the common contract.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Peel;

impl Reconstructor for Peel {
    fn info(&self) -> AlgorithmInfo {
        AlgorithmInfo {
            basis: Basis::Argued,
            scope: Scope::CLOSED.with_corners(),
            ..AlgorithmInfo::new(
                "peel",
                "Parakkat, Methirumangalath, Muthuganapathy: Peeling the Longest. \
                 Computers & Graphics 2018",
                "O(n log n)",
            )
        }
    }

    fn reconstruct(&self, points: &PointSet) -> EdgeSet {
        peel(points)
    }
}
