//! SIG-Connect2D: D. Marin, S. Ohrhallinger, M. Wimmer, "SIGDT: 2D Curve Reconstruction", Computer
//! Graphics Forum (Pacific Graphics) 41(7), 2022. Its graph is published; the costs by which it
//! chooses are argued here, as those of [Connect2D](mod@crate::connect2d) are.
//!
//! The graph has the Delaunay edges of the [sphere-of-influence
//! graph](mod@crate::sphere_of_influence), so it adapts to the density without a parameter; a
//! sample with less than two of them gets its shortest Gabriel edges until it has two. Each
//! component of the graph is one closed curve: its outline is inflated and sculpted as in
//! Connect2D, on the Delaunay triangulation of its samples alone.
//!
//! No sampling condition is known to make it exact. Cost: that of the Delaunay triangulations,
//! O(n log n).

use curvecrust_geometry::{EdgeSet, PointSet};
use curvecrust_voronoi::{Delaunay, DualEdge};

use crate::algorithm::{AlgorithmInfo, Basis, Reconstructor, Scope};
use crate::clusters::Clusters;
use crate::delaunay_edges::is_gabriel_edge;
use crate::delaunay_graph::DelaunayGraph;
use crate::region::Region;
use crate::sphere_of_influence::{circles_meet, nearest_distances};

/// The edges of SIG-Connect2D: a ring through each component of its graph; the edges of the graph
/// where all points of a component lie on one line.
///
/// ```
/// use curvecrust_geometry::{DVec2, PointSet};
/// use curvecrust_reconstruct::sig_connect2d;
///
/// let ring = |centre: f64| {
///     let angle = |i: i32| f64::from(i) * std::f64::consts::TAU / 24.0;
///     (0..24).map(move |i| DVec2::new(centre, 0.0) + DVec2::from_angle(angle(i)))
/// };
/// let edges = sig_connect2d(&PointSet::new(ring(0.0).chain(ring(3.0)).collect())?);
/// assert_eq!((edges.degrees(), edges.chains().len()), (vec![2; 48], 2));
/// # Ok::<(), curvecrust_geometry::PointSetError>(())
/// ```
#[must_use]
pub fn sig_connect2d(points: &PointSet) -> EdgeSet {
    let graph = DelaunayGraph::new(points);
    let edges = graph_edges(&graph);
    let mut clusters = Clusters::new(graph.len());
    for &[p, q] in &edges {
        clusters.join(p, q);
    }
    // The place of every vertex in its component.
    let mut components: Vec<Component> = Vec::new();
    let mut component_of = vec![usize::MAX; graph.len()];
    let mut place = vec![0_u32; graph.len()];
    for v in graph.vertices() {
        let name = clusters.name(v) as usize;
        if component_of[name] == usize::MAX {
            component_of[name] = components.len();
            components.push(Component::default());
        }
        component_of[v as usize] = component_of[name];
        let component = &mut components[component_of[name]];
        place[v as usize] = component.next_place();
        component.vertices.push(v);
    }
    for pair in edges {
        let inside = pair.map(|v| place[v as usize]);
        components[component_of[pair[0] as usize]]
            .edges
            .push(inside);
    }
    graph.edge_set(
        components
            .iter()
            .flat_map(|component| component.ring(&graph)),
    )
}

/// The edges whose circles meet, and Gabriel edges for samples that have less than two.
fn graph_edges(graph: &DelaunayGraph) -> Vec<[u32; 2]> {
    let radius = nearest_distances(&graph.points);
    let mut degrees = vec![0_u32; graph.len()];
    let (near, far): (Vec<&DualEdge>, Vec<&DualEdge>) = graph
        .edges
        .iter()
        .partition(|dual| circles_meet(&graph.points, &radius, dual.ends));
    let mut edges: Vec<[u32; 2]> = near.iter().map(|dual| dual.ends.map(u32::from)).collect();
    for &end in edges.iter().flatten() {
        degrees[end as usize] += 1;
    }
    for dual in far {
        let pair = dual.ends.map(u32::from);
        let lacks = pair.iter().any(|&v| degrees[v as usize] < 2);
        if lacks && is_gabriel_edge(&graph.points, dual) {
            edges.push(pair);
            for end in pair {
                degrees[end as usize] += 1;
            }
        }
    }
    edges
}

/// A component of the graph.
#[derive(Default)]
struct Component {
    vertices: Vec<u32>,
    /// Between places in `vertices`.
    edges: Vec<[u32; 2]>,
}

impl Component {
    fn next_place(&self) -> u32 {
        u32::try_from(self.vertices.len()).unwrap_or(u32::MAX)
    }

    /// Its ring; its edges if it has no ring.
    fn ring(&self, graph: &DelaunayGraph) -> Vec<[u32; 2]> {
        let places = self.vertices.iter().map(|&v| graph.at(v)).collect();
        // They are valid, as they are points of a set.
        let points = PointSet::new(places).unwrap_or_default();
        let delaunay = Delaunay::new(&points);
        let edges = if delaunay.triangles().next().is_some() {
            let mut region = Region::within(&points, &delaunay, &self.edges);
            region.inflate();
            region.sculpt();
            region.boundary()
        } else {
            self.edges.clone()
        };
        let named = |[p, q]: [u32; 2]| [p, q].map(|place| self.vertices[place as usize]);
        edges.into_iter().map(named).collect()
    }
}

/// SIG-Connect2D behind the common contract.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SigConnect2d;

impl Reconstructor for SigConnect2d {
    fn info(&self) -> AlgorithmInfo {
        AlgorithmInfo {
            basis: Basis::Argued,
            scope: Scope::CLOSED.with_corners(),
            ..AlgorithmInfo::new(
                "sig-connect2d",
                "Marin, Ohrhallinger, Wimmer: SIGDT: 2D Curve Reconstruction. \
                 Pacific Graphics 2022",
                "O(n log n)",
            )
        }
    }

    fn reconstruct(&self, points: &PointSet) -> EdgeSet {
        sig_connect2d(points)
    }
}
