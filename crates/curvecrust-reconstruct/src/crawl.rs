//! Crawl: A. D. Parakkat, R. Muthuganapathy, "Crawl through Neighbors: A Simple Curve
//! Reconstruction Algorithm", Computer Graphics Forum (SGP) 35(5), 2016. Its text was not
//! available: this follows descriptions of it, so the definition is argued.
//!
//! The shortest Delaunay edge between two free points starts a chain. Both ends of the chain grow:
//! each time by the shortest Delaunay edge at either of them that leads to a free point or closes
//! the chain. When it is closed, or no such edge is left, the next chain starts from what is free.
//! The chain takes every gap that an edge spans, so separate curves are joined unless they close
//! before.
//!
//! No sampling condition is known to make it exact. Cost: that of the Delaunay triangulation,
//! O(n log n).

use curvecrust_geometry::{EdgeSet, PointSet};

use crate::algorithm::{AlgorithmInfo, Basis, Reconstructor, Scope};
use crate::delaunay_graph::DelaunayGraph;
use crate::paths::Paths;

/// The edges of Crawl: rings and chains.
///
/// Lengths are compared in floating point; of equal ones, the first by coordinates is taken.
///
/// ```
/// use curvecrust_geometry::{DVec2, PointSet};
/// use curvecrust_reconstruct::crawl;
///
/// let ring = (0..12).map(|i| DVec2::from_angle(f64::from(i) * std::f64::consts::TAU / 12.0));
/// let edges = crawl(&PointSet::new(ring.collect())?);
/// assert_eq!(edges.degrees(), [2; 12]);
/// # Ok::<(), curvecrust_geometry::PointSetError>(())
/// ```
#[must_use]
pub fn crawl(points: &PointSet) -> EdgeSet {
    let graph = DelaunayGraph::new(points);
    let mut paths = Paths::new(graph.len());
    for [p, q] in graph.pairs() {
        if !paths.is_free(p) || !paths.is_free(q) {
            continue;
        }
        let mut ends = paths.join(p, q);
        while let Some([from, to]) = next(&graph, &paths, ends) {
            let closes = ends.contains(&to);
            ends = paths.join(from, to);
            if closes {
                break;
            }
        }
    }
    graph.edge_set(paths.pairs())
}

/// The shortest edge by which a chain may grow, from one of its ends.
fn next(graph: &DelaunayGraph, paths: &Paths, ends: [u32; 2]) -> Option<[u32; 2]> {
    let shortest = |from: u32| {
        let mut around = graph.around(from);
        let goes_on =
            |to: u32| paths.is_free(to) || paths.far_end(from) == to && !paths.are_joined(from, to);
        let found = around.find(|&(_, to)| goes_on(to))?;
        Some((found.0, [from, found.1]))
    };
    let found = ends.into_iter().filter_map(shortest);
    found
        .min_by_key(|&(number, _)| number)
        .map(|(_, step)| step)
}

/// Crawl behind the common contract.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Crawl;

impl Reconstructor for Crawl {
    fn info(&self) -> AlgorithmInfo {
        AlgorithmInfo {
            basis: Basis::Argued,
            scope: Scope::CLOSED_AND_OPEN.with_corners(),
            ..AlgorithmInfo::new(
                "crawl",
                "Parakkat, Muthuganapathy: Crawl through Neighbors. SGP 2016",
                "O(n log n)",
            )
        }
    }

    fn reconstruct(&self, points: &PointSet) -> EdgeSet {
        crawl(points)
    }
}
