//! GathanG-like: after T. K. Dey, R. Wenger, "Fast Reconstruction of Curves with Sharp Corners",
//! International Journal of Computational Geometry & Applications 12(5), 2002. Its text could not
//! be had: this is a sketch of its idea.
//!
//! Each sample takes its nearest neighbour, and the shortest Delaunay edge at an angle of 150
//! degrees or more to it. The edges stay that both ends take: they make the smooth chains. The ends
//! of these chains meet at corners, where up to two samples may lie that belong to no chain. So two
//! ends are joined by a Delaunay edge, or by a path of two or three Delaunay edges through such
//! samples; the shortest paths first, each end and each sample once.
//!
//! All ends are joined that can be, however far they are, so curves that end are closed, and some
//! edges are arbitrary. For smooth closed curves it is published that epsilon < 0.5 suffices; for
//! this sketch of it nothing is proven. Cost: that of the Delaunay triangulation, O(n log n).

use std::cmp::Ordering;

use curvecrust_geometry::{EdgeSet, PointSet};

use crate::algorithm::{AlgorithmInfo, Basis, Reconstructor, Scope};
use crate::delaunay_graph::DelaunayGraph;
use crate::paths::Paths;

/// The cosine of 150 degrees, the sharpest turn inside a chain.
const SHARPEST: f64 = -0.866_025_403_784_438_6;

/// From a sample of no chain, paths go on to this many of its nearest Delaunay neighbours.
const NEAREST: usize = 12;

/// The edges of the GathanG-like algorithm: rings and chains.
///
/// ```
/// use curvecrust_geometry::{DVec2, PointSet};
/// use curvecrust_reconstruct::gathan_g;
///
/// // A square with its corners.
/// let side = |from: DVec2, by: DVec2| (0..10).map(move |i| from + by * f64::from(i));
/// let (x, y) = (DVec2::X, DVec2::Y);
/// let sides = [(0.0 * x, x), (10.0 * x, y), (10.0 * (x + y), -x), (10.0 * y, -y)];
/// let square = sides.into_iter().flat_map(|(from, by)| side(from, by));
/// assert_eq!(gathan_g(&PointSet::new(square.collect())?).degrees(), [2; 40]);
/// # Ok::<(), curvecrust_geometry::PointSetError>(())
/// ```
#[must_use]
pub fn gathan_g(points: &PointSet) -> EdgeSet {
    let graph = DelaunayGraph::new(points);
    let mut paths = smooth_chains(&graph);
    let mut ways: Vec<Way> = graph
        .vertices()
        .filter(|&v| is_loose_end(&paths, v))
        .flat_map(|end| ways_from(&graph, &paths, end))
        .collect();
    ways.sort_unstable_by(|a, b| a.compare(b));
    for way in ways {
        let [first, .., last] = way.stops[..] else {
            continue;
        };
        let inner = &way.stops[1..way.stops.len() - 1];
        let is_open = is_loose_end(&paths, first)
            && is_loose_end(&paths, last)
            && inner.iter().all(|&v| paths.is_free(v));
        if is_open {
            for edge in way.stops.windows(2) {
                paths.join(edge[0], edge[1]);
            }
        }
    }
    graph.edge_set(paths.pairs())
}

/// The end of a chain, not a sample alone.
fn is_loose_end(paths: &Paths, v: u32) -> bool {
    paths.is_end(v) && !paths.is_free(v)
}

fn smooth_chains(graph: &DelaunayGraph) -> Paths {
    let taken = |v: u32| {
        let mut around = graph.around(v);
        let nearest = around.next();
        let opposite = nearest.and_then(|(_, first)| {
            let back = graph.at(first) - graph.at(v);
            around.find(|&(_, w)| {
                let on = graph.at(w) - graph.at(v);
                back.dot(on) <= SHARPEST * back.length() * on.length()
            })
        });
        [nearest, opposite].map(|edge| edge.map(|(number, _)| number))
    };
    let mut paths = Paths::new(graph.len());
    for number in graph.taken_by_both(taken) {
        let [p, q] = graph.ends(number);
        paths.join(p, q);
    }
    paths
}

/// A path that may join two ends at a corner.
struct Way {
    length: f64,
    /// The numbers of its edges, which come by length and then by coordinates.
    numbers: Vec<u32>,
    /// From end to end.
    stops: Vec<u32>,
}

impl Way {
    fn compare(&self, other: &Self) -> Ordering {
        let by_length = self.length.total_cmp(&other.length);
        by_length.then_with(|| self.numbers.cmp(&other.numbers))
    }
}

/// The paths from the end of a chain to others through at most two samples of no chain.
fn ways_from(graph: &DelaunayGraph, paths: &Paths, end: u32) -> Vec<Way> {
    let mut ways = Vec::new();
    let mut unfinished = vec![(Vec::new(), vec![end])];
    while let Some((numbers, stops)) = unfinished.pop() {
        let Some(&at) = stops.last() else { continue };
        for (number, to) in graph.around(at).take(NEAREST) {
            let mut numbers: Vec<u32> = numbers.clone();
            let mut stops = stops.clone();
            numbers.push(number);
            let is_known = stops.contains(&to) || paths.are_joined(at, to);
            stops.push(to);
            if is_known {
                continue;
            }
            if paths.is_free(to) && numbers.len() < 3 {
                unfinished.push((numbers, stops));
            } else if is_loose_end(paths, to) {
                // In either direction the same sum.
                numbers.sort_unstable();
                let lengths = numbers.iter().map(|&number| {
                    let [p, q] = graph.ends(number);
                    graph.length(p, q)
                });
                ways.push(Way {
                    length: lengths.sum(),
                    numbers,
                    stops,
                });
            }
        }
    }
    ways
}

/// The GathanG-like algorithm behind the common contract.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct GathanG;

impl Reconstructor for GathanG {
    fn info(&self) -> AlgorithmInfo {
        AlgorithmInfo {
            basis: Basis::Argued,
            scope: Scope::CLOSED.with_corners(),
            ..AlgorithmInfo::new(
                "gathan-g-like",
                "after Dey, Wenger: Fast Reconstruction of Curves with Sharp Corners. IJCGA 2002",
                "O(n log n)",
            )
        }
    }

    fn reconstruct(&self, points: &PointSet) -> EdgeSet {
        gathan_g(points)
    }
}
