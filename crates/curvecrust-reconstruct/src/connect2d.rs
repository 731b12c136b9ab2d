//! Connect2D: S. Ohrhallinger, S. Mudur, "An Efficient Algorithm for Determining an Aesthetic Shape
//! Connecting Unorganized 2D Points", Computer Graphics Forum 32(8), 2013. Its steps are published;
//! the costs by which they choose are argued here, since the text was not available.
//!
//! One simple ring through all samples:
//!
//! 1. **Outline.** The minimum spanning tree; while it has leaves, each takes the shortest Delaunay
//!    edge that it has not.
//! 2. **Region.** The Delaunay triangles that cannot be reached from outside without crossing the
//!    outline are inside.
//! 3. **Inflate.** At a sample whose inside triangles are no single fan, the outside triangle is
//!    moved inside that lengthens the boundary least.
//! 4. **Sculpt.** While samples lie inside, the inside triangle abc with the boundary edge ab and c
//!    in the interior is moved outside for which |ac| + |bc| - |ab| is least.
//!
//! The boundary of the region is the result. It is one ring through all samples, unless step 3
//! encloses a hole or step 4 cannot go on: then there are several rings, or samples without edges.
//! It is published as correct for a closed curve with epsilon < 0.5. Cost: that of the Delaunay
//! triangulation, O(n log n).

use curvecrust_geometry::{EdgeSet, PointSet};

use crate::algorithm::{AlgorithmInfo, Basis, Reconstructor, Scope};
use crate::delaunay_graph::DelaunayGraph;
use crate::region::Region;
use crate::spanning_tree::tree_of;

/// The edges of Connect2D: a ring; a path if all points lie on one line.
///
/// Costs are compared in floating point. Where points are cocircular, the triangles are those that
/// [`Delaunay`](curvecrust_voronoi::Delaunay) chooses, which depends on the coordinates.
///
/// ```
/// use curvecrust_geometry::{DVec2, PointSet};
/// use curvecrust_reconstruct::connect2d;
///
/// let ring = (0..24).map(|i| {
///     let angle = f64::from(i) * std::f64::consts::TAU / 24.0;
///     (1.0 + 0.3 * (3.0 * angle).cos()) * DVec2::from_angle(angle)
/// });
/// assert_eq!(connect2d(&PointSet::new(ring.collect())?).degrees(), [2; 24]);
/// # Ok::<(), curvecrust_geometry::PointSetError>(())
/// ```
#[must_use]
pub fn connect2d(points: &PointSet) -> EdgeSet {
    let graph = DelaunayGraph::new(points);
    let tree = tree_of(&graph);
    if graph.delaunay.triangles().next().is_none() {
        return graph.edge_set(tree);
    }
    let outline = without_leaves(&graph, tree);
    let mut region = Region::within(&graph.points, &graph.delaunay, &outline);
    region.inflate();
    region.sculpt();
    graph.edge_set(region.boundary())
}

/// The edges, and for each of their leaves the shortest further one, until there are no leaves.
fn without_leaves(graph: &DelaunayGraph, mut edges: Vec<[u32; 2]>) -> Vec<[u32; 2]> {
    let mut partners = vec![Vec::new(); graph.len()];
    for &[p, q] in &edges {
        partners[p as usize].push(q);
        partners[q as usize].push(p);
    }
    loop {
        // All leaves at once, so that their order does not matter.
        let shortest = |v: u32| {
            let partners = &partners[v as usize];
            let mut further = graph.around(v).filter(|(_, w)| !partners.contains(w));
            further.next().map(|(_, w)| [v, w])
        };
        let leaves = graph
            .vertices()
            .filter(|&v| partners[v as usize].len() == 1);
        let taken: Vec<[u32; 2]> = leaves.filter_map(shortest).collect();
        if taken.is_empty() {
            return edges;
        }
        for [p, q] in taken {
            if !partners[p as usize].contains(&q) {
                partners[p as usize].push(q);
                partners[q as usize].push(p);
                edges.push([p, q]);
            }
        }
    }
}

/// Connect2D behind the common contract.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Connect2d;

impl Reconstructor for Connect2d {
    fn info(&self) -> AlgorithmInfo {
        AlgorithmInfo {
            basis: Basis::Argued,
            scope: Scope::CLOSED.with_corners().of_one_curve(),
            ..AlgorithmInfo::new(
                "connect2d",
                "Ohrhallinger, Mudur: An Efficient Algorithm for Determining an Aesthetic Shape \
                 Connecting Unorganized 2D Points. CGF 2013",
                "O(n log n)",
            )
        }
    }

    fn reconstruct(&self, points: &PointSet) -> EdgeSet {
        connect2d(points)
    }
}
