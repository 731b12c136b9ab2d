//! Gathan-like: after T. K. Dey, R. Wenger, "Reconstructing Curves with Sharp Corners",
//! Computational Geometry 19(2-3), 2001. Its text was not available: this is a sketch of its idea.
//!
//! The pole of a sample is the farthest Voronoi vertex of its cell, in the direction of the rays
//! where the cell is unbounded. From the sample to the pole runs an estimate of the normal, as long
//! as the sample is far from the medial axis. A Delaunay edge fits a sample if it is within 40
//! degrees of the tangent and no longer than the way to the pole. On either side of the normal each
//! sample takes the shortest edge that fits; the edges stay that both ends take.
//!
//! At a corner the estimates fail, and samples are left with less than two edges. Those are joined
//! by Delaunay edges, the shortest first, that are at most twice as long as the longest edge that
//! stayed at either end.
//!
//! No sampling condition is known to make this sketch exact. Cost: that of the Delaunay
//! triangulation, O(n log n).

use curvecrust_geometry::{DVec2, EdgeSet, PointSet};

use crate::algorithm::{AlgorithmInfo, Basis, Reconstructor, Scope};
use crate::delaunay_graph::DelaunayGraph;
use crate::voronoi_vertex::VoronoiVertex;

/// The sine of 40 degrees, the largest angle between an edge and a tangent.
const STEEPEST: f64 = 0.642_787_609_686_539_4;

/// How much longer than the edges beside it an edge at a corner may be.
const AT_CORNERS: f64 = 2.0;

/// The edges of the Gathan-like algorithm: rings and chains.
///
/// ```
/// use curvecrust_geometry::{DVec2, PointSet};
/// use curvecrust_reconstruct::gathan;
///
/// let ring = (0..24).map(|i| DVec2::from_angle(f64::from(i) * std::f64::consts::TAU / 24.0));
/// assert_eq!(gathan(&PointSet::new(ring.collect())?).degrees(), [2; 24]);
/// # Ok::<(), curvecrust_geometry::PointSetError>(())
/// ```
#[must_use]
pub fn gathan(points: &PointSet) -> EdgeSet {
    let graph = DelaunayGraph::new(points);
    let poles = poles(&graph);
    let taken = graph.taken_by_both(|v| taken(&graph, v, &poles[v as usize]));
    let mut degrees = vec![0_u8; graph.len()];
    // The longest edge that stays at each sample.
    let mut longest = vec![0.0_f64; graph.len()];
    let mut stays = vec![false; graph.edges.len()];
    for number in taken {
        let [p, q] = graph.ends(number);
        stays[number as usize] = true;
        for end in [p, q] {
            degrees[end as usize] += 1;
            longest[end as usize] = graph.length(p, q);
        }
    }
    for (number, [p, q]) in graph.pairs().enumerate() {
        let lack = [p, q].iter().all(|&v| degrees[v as usize] < 2);
        let most = AT_CORNERS * longest[p as usize].max(longest[q as usize]);
        if lack && !stays[number] && graph.length(p, q) <= most {
            stays[number] = true;
            degrees[p as usize] += 1;
            degrees[q as usize] += 1;
        }
    }
    let kept = graph.pairs().zip(&stays).filter(|(_, stays)| **stays);
    graph.edge_set(kept.map(|(pair, _)| pair))
}

/// The edges that a sample takes, by their numbers: on the left and on the right of its normal.
fn taken(graph: &DelaunayGraph, v: u32, pole: &Pole) -> [Option<u32>; 2] {
    [1.0, -1.0].map(|side| {
        let fits = |&(_, w): &(u32, u32)| {
            let edge = graph.at(w) - graph.at(v);
            let length = edge.length();
            length <= pole.distance
                && pole.normal.dot(edge).abs() <= STEEPEST * length
                && side * pole.normal.perp_dot(edge) > 0.0
        };
        graph.around(v).find(fits).map(|(number, _)| number)
    })
}

/// From a sample to its pole.
#[derive(Clone, Copy, Default)]
struct Pole {
    /// A unit vector, or 0 where there is no Voronoi vertex.
    normal: DVec2,
    /// Infinite where the cell is unbounded.
    distance: f64,
}

fn poles(graph: &DelaunayGraph) -> Vec<Pole> {
    let mut poles = vec![Pole::default(); graph.len()];
    for corners in graph.delaunay.triangles() {
        let vertex = VoronoiVertex::new(&graph.points, corners);
        for corner in corners {
            let to_vertex = vertex.seen_from(graph.points[corner]).vector;
            let distance = libm::hypot(to_vertex.x, to_vertex.y);
            let pole = &mut poles[corner.index()];
            if distance > pole.distance {
                // Squares of the distances of slivers would overflow.
                let normal = (to_vertex / distance).normalize_or_zero();
                *pole = Pole { normal, distance };
            }
        }
    }
    let mut outwards = vec![DVec2::ZERO; graph.len()];
    for dual in &graph.edges {
        let across = graph.points[dual.ends[1]] - graph.points[dual.ends[0]];
        let ray = match dual.triangles {
            [None, Some(_) | None] => across.perp(),
            [Some(_), None] => -across.perp(),
            [Some(_), Some(_)] => continue,
        };
        for end in dual.ends {
            outwards[end.index()] += ray.normalize_or_zero();
        }
    }
    for (pole, ray) in poles.iter_mut().zip(outwards) {
        let normal = ray.normalize_or_zero();
        if normal != DVec2::ZERO {
            let distance = f64::INFINITY;
            *pole = Pole { normal, distance };
        }
    }
    poles
}

/// The Gathan-like algorithm behind the common contract.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Gathan;

impl Reconstructor for Gathan {
    fn info(&self) -> AlgorithmInfo {
        AlgorithmInfo {
            basis: Basis::Argued,
            scope: Scope::CLOSED.with_corners(),
            ..AlgorithmInfo::new(
                "gathan-like",
                "after Dey, Wenger: Reconstructing Curves with Sharp Corners. \
                 Computational Geometry 2001",
                "O(n log n)",
            )
        }
    }

    fn reconstruct(&self, points: &PointSet) -> EdgeSet {
        gathan(points)
    }
}
