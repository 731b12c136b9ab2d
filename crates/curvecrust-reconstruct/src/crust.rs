//! Crust: N. Amenta, M. Bern, D. Eppstein, "The Crust and the beta-Skeleton: Combinatorial Curve
//! Reconstruction", Graphical Models and Image Processing 60(2), 1998.
//!
//! Let V be the Voronoi vertices of the samples S. The crust is made of the Delaunay edges of
//! S u V whose ends are both samples: those that some disc free of samples and of Voronoi vertices
//! touches in both ends. No second triangulation is needed for it. In the pencil of discs through
//! p and q every Voronoi vertex rules out a half-line; the two ends of the edge's dual are tested
//! first and settle almost all edges, and the others are looked up in a tree.
//!
//! Correct for closed smooth curves with epsilon < 0.252; Table 1 of the HNN-Crust paper has 0.2,
//! after T. K. Dey, "Curve and Surface Reconstruction", 2006. All of V counts: without the far
//! Voronoi vertices of slivers on the hull, false edges of the hull would stay. Cost: that of the
//! Delaunay triangulation, O(n log n), plus a search around each edge.

use curvecrust_geometry::parallel::*;
use curvecrust_geometry::{Edge, EdgeSet, PointId, PointSet};
use curvecrust_voronoi::Delaunay;

use crate::algorithm::{AlgorithmInfo, Basis, Guarantee, Reconstructor, SamplingBound, Scope};
use crate::delaunay_edges::is_crust_edge;
use crate::voronoi_vertices::VoronoiVertices;

/// The edges of Crust.
///
/// Exact: the Voronoi vertices count where they are, not where rounding puts them. A disc with
/// Voronoi vertices on its boundary is free of them, so edges stay where a triangulation of S u V
/// would have a choice.
#[must_use]
pub fn crust(points: &PointSet) -> EdgeSet {
    let (points, ids) = &points.in_hilbert_order();
    let delaunay = Delaunay::new(points);
    let candidates: Vec<[PointId; 2]> = delaunay
        .edges()
        .filter(|dual| is_crust_edge(points, dual))
        .map(|dual| dual.ends)
        .collect();
    let length = |&[p, q]: &[PointId; 2]| points[p].distance(points[q]);
    let longest = candidates.iter().map(length).fold(0.0, f64::max);
    let vertices = VoronoiVertices::new(points, &delaunay, longest);
    let kept: Vec<_> = candidates
        .par_iter()
        .filter(|&&ends| vertices.spare_a_disc_through(ends))
        .filter_map(|&ends| {
            let [p, q] = ends.map(|v| ids[v.index()]);
            Edge::new(p, q)
        })
        .collect();
    EdgeSet::new(points.len(), kept)
}

/// Crust behind the common contract.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Crust;

impl Reconstructor for Crust {
    fn info(&self) -> AlgorithmInfo {
        AlgorithmInfo {
            name: "crust",
            citation: "Amenta, Bern, Eppstein: The Crust and the beta-Skeleton: Combinatorial \
                       Curve Reconstruction. GMIP 1998",
            guarantees: const { &[Guarantee::proven(SamplingBound::Epsilon(0.252))] },
            cost: "O(n log n)",
            honours_termini: false,
            honours_known: false,
            scope: Scope::CLOSED,
            basis: Basis::Published,
        }
    }

    fn reconstruct(&self, points: &PointSet) -> EdgeSet {
        crust(points)
    }
}
