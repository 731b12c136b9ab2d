//! Euclidean minimum spanning tree: L. H. de Figueiredo, J. de Miranda Gomes, "Computational
//! Morphology of Curves", The Visual Computer 11(2), 1994.
//!
//! The tree through all points of the least length, by Kruskal's algorithm on the Delaunay
//! triangulation, which holds it. If any two samples that are not consecutive are farther from each
//! other than all consecutive ones are, the tree of an open curve is the path along its samples.
//!
//! A user who knows the shape may say so. One open curve is the longest path of the tree: the hair
//! of short branches is cut, so not all points are on it. One closed curve is that path with an
//! edge between its ends. Cost: that of the Delaunay triangulation, O(n log n).

use std::cmp::Ordering;

use curvecrust_geometry::point_set::by_coordinates;
use curvecrust_geometry::{EdgeSet, PointSet};

use crate::adjacency::Adjacency;
use crate::algorithm::{AlgorithmInfo, Reconstructor, Scope, reconstruct_termini_alone};
use crate::clusters::Clusters;
use crate::delaunay_graph::DelaunayGraph;
use crate::error::ReconstructError;
use crate::known::{Known, Shape};

/// The minimum spanning tree: one edge less than there are points.
///
/// Lengths are compared in floating point; of equal ones, the first by coordinates is taken.
///
/// ```
/// use curvecrust_geometry::{DVec2, PointSet};
/// use curvecrust_reconstruct::spanning_tree;
///
/// let wave = (0..30).map(|i| DVec2::new(f64::from(i), (f64::from(i) / 3.0).sin()));
/// let tree = spanning_tree(&PointSet::new(wave.collect())?);
/// assert_eq!((tree.len(), tree.leaves().len()), (29, 2));
/// # Ok::<(), curvecrust_geometry::PointSetError>(())
/// ```
#[must_use]
pub fn spanning_tree(points: &PointSet) -> EdgeSet {
    let graph = DelaunayGraph::new(points);
    graph.edge_set(tree_of(&graph))
}

/// The edges of the tree, the shortest first.
pub(crate) fn tree_of(graph: &DelaunayGraph) -> Vec<[u32; 2]> {
    let mut clusters = Clusters::new(graph.len());
    let joins = |&[p, q]: &[u32; 2]| clusters.join(p, q);
    graph.pairs().filter(joins).collect()
}

/// The longest path of a tree, from one end to the other.
fn longest_path(graph: &DelaunayGraph, tree: &[[u32; 2]]) -> Vec<u32> {
    let adjacent = Adjacency::new(graph.len(), tree);
    let Some(first) = graph.vertices().next() else {
        return Vec::new();
    };
    // The vertex that is farthest from any other one is an end of a longest path.
    let far = |from: u32| paths_from(graph, &adjacent, from);
    let (end, _) = far(first);
    let (mut at, before) = far(end);
    let mut path = vec![at];
    while at != end {
        at = before[at as usize];
        path.push(at);
    }
    path
}

/// The vertex that is the farthest along the tree, and for each the one before it.
fn paths_from(graph: &DelaunayGraph, adjacent: &Adjacency, from: u32) -> (u32, Vec<u32>) {
    let mut before = vec![from; graph.len()];
    let mut farthest = (from, 0.0);
    let mut waiting = vec![(from, 0.0)];
    while let Some((v, length)) = waiting.pop() {
        if is_farther(graph, (v, length), farthest).is_gt() {
            farthest = (v, length);
        }
        for &w in adjacent.of(v) {
            if w != before[v as usize] {
                before[w as usize] = v;
                waiting.push((w, length + graph.length(v, w)));
            }
        }
    }
    (farthest.0, before)
}

fn is_farther(graph: &DelaunayGraph, v: (u32, f64), w: (u32, f64)) -> Ordering {
    let by_length = v.1.total_cmp(&w.1);
    by_length.then_with(|| by_coordinates(graph.at(v.0), graph.at(w.0)))
}

/// The minimum spanning tree behind the common contract.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SpanningTree;

impl Reconstructor for SpanningTree {
    fn info(&self) -> AlgorithmInfo {
        AlgorithmInfo {
            honours_known: true,
            scope: Scope {
                closed: false,
                ..Scope::CLOSED_AND_OPEN.with_corners().of_one_curve()
            },
            ..AlgorithmInfo::new(
                "spanning-tree",
                "Figueiredo, Gomes: Computational Morphology of Curves. The Visual Computer 1994",
                "O(n log n)",
            )
        }
    }

    fn reconstruct(&self, points: &PointSet) -> EdgeSet {
        spanning_tree(points)
    }

    /// One open or one closed curve, as the module says.
    fn reconstruct_known(
        &self,
        points: &PointSet,
        known: &Known,
    ) -> Result<EdgeSet, ReconstructError> {
        let is_one = known.curves.is_none_or(|curves| curves.get() == 1);
        let (Some(shape), true, true) = (known.shape, known.termini.is_empty(), is_one) else {
            return reconstruct_termini_alone(self, points, known);
        };
        known.check(points)?;
        let graph = DelaunayGraph::new(points);
        let path = longest_path(&graph, &tree_of(&graph));
        let closing = match (shape, path.first(), path.last()) {
            (Shape::Closed, Some(&first), Some(&last)) => Some([first, last]),
            _ => None,
        };
        let along = path.windows(2).map(|edge| [edge[0], edge[1]]);
        Ok(graph.edge_set(along.chain(closing)))
    }
}
