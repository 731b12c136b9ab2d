//! The Delaunay graph with its edges by length, for algorithms that choose among them.

use std::cmp::Ordering;

use curvecrust_geometry::point_set::by_coordinates;
use curvecrust_geometry::{DVec2, Edge, EdgeSet, PointId, PointSet};
use curvecrust_voronoi::{Delaunay, DualEdge};

use crate::adjacency::Adjacency;
use crate::delaunay_edges::has_length;

/// The edges of the Delaunay triangulation whose Voronoi edges are longer than a point.
///
/// They are the same for every triangulation of cocircular points, they connect all points, and a
/// shortest spanning tree is among them.
pub(crate) struct DelaunayGraph {
    /// The points along a Hilbert curve; vertices are their indices.
    pub(crate) points: PointSet,
    /// What the caller calls them.
    ids: Vec<PointId>,
    pub(crate) delaunay: Delaunay,
    /// The shortest first, equally long ones by the coordinates of their ends.
    pub(crate) edges: Vec<DualEdge>,
    /// The other edges of the triangulation, between triangles on one circle; in no order.
    pub(crate) inside_circles: Vec<DualEdge>,
    /// The edges at every vertex by their numbers, the shortest first.
    numbers: Adjacency,
}

impl DelaunayGraph {
    pub(crate) fn new(points: &PointSet) -> Self {
        let (points, ids) = points.in_hilbert_order();
        let delaunay = Delaunay::new(&points);
        let (longer, inside_circles): (Vec<DualEdge>, _) =
            delaunay.edges().partition(|dual| has_length(&points, dual));
        let keyed = longer.into_iter();
        let keyed = keyed.map(|dual| (squared(&points, dual.ends), dual));
        let mut keyed: Vec<(f64, DualEdge)> = keyed.collect();
        keyed.sort_unstable_by(|(a, e), (b, f)| {
            let by_places = || by_places(&points, e.ends, f.ends);
            a.total_cmp(b).then_with(by_places)
        });
        let edges: Vec<DualEdge> = keyed.into_iter().map(|(_, dual)| dual).collect();
        let ends: Vec<[u32; 2]> = edges.iter().map(|e| e.ends.map(u32::from)).collect();
        let numbers = Adjacency::of_numbers(points.len(), &ends);
        Self {
            points,
            ids,
            delaunay,
            edges,
            inside_circles,
            numbers,
        }
    }

    /// The number of points.
    pub(crate) fn len(&self) -> usize {
        self.points.len()
    }

    /// The vertices.
    pub(crate) fn vertices(&self) -> impl Iterator<Item = u32> + use<> {
        (0u32..).take(self.len())
    }

    /// The edges by their ends, the shortest first.
    pub(crate) fn pairs(&self) -> impl ExactSizeIterator<Item = [u32; 2]> + '_ {
        self.edges.iter().map(|dual| dual.ends.map(u32::from))
    }

    pub(crate) fn at(&self, v: u32) -> DVec2 {
        self.points.points()[v as usize]
    }

    pub(crate) fn length(&self, v: u32, w: u32) -> f64 {
        self.at(v).distance(self.at(w))
    }

    /// The edges at a vertex, the shortest first: each by its number in `edges`, and the vertex
    /// that it leads to.
    pub(crate) fn around(&self, v: u32) -> impl DoubleEndedIterator<Item = (u32, u32)> + '_ {
        let numbers = self.numbers.of(v).iter();
        numbers.map(move |&number| (number, self.beyond(number, v)))
    }

    /// The vertex that an edge leads to from another.
    pub(crate) fn beyond(&self, number: u32, v: u32) -> u32 {
        let [p, q] = self.ends(number);
        if p == v { q } else { p }
    }

    pub(crate) fn ends(&self, number: u32) -> [u32; 2] {
        self.edges[number as usize].ends.map(u32::from)
    }

    /// The numbers of the edges that both of their ends take, ascending; `takes` names those that a
    /// vertex takes.
    pub(crate) fn taken_by_both(&self, takes: impl Fn(u32) -> [Option<u32>; 2]) -> Vec<u32> {
        let taken: Vec<[Option<u32>; 2]> = self.vertices().map(takes).collect();
        let is_taken = |number: u32| {
            let mut ends = self.ends(number).into_iter();
            ends.all(|v| taken[v as usize].contains(&Some(number)))
        };
        let numbers = (0u32..).take(self.edges.len());
        numbers.filter(|&number| is_taken(number)).collect()
    }

    /// Edges between vertices, as edges between the points of the caller.
    pub(crate) fn edge_set(&self, pairs: impl IntoIterator<Item = [u32; 2]>) -> EdgeSet {
        let edge = |pair: [u32; 2]| {
            let [p, q] = pair.map(|v| self.ids[v as usize]);
            Edge::new(p, q)
        };
        EdgeSet::new(self.len(), pairs.into_iter().filter_map(edge))
    }
}

fn squared(points: &PointSet, [p, q]: [PointId; 2]) -> f64 {
    points[p].distance_squared(points[q])
}

/// By the end that comes first, then by the other one.
fn by_places(points: &PointSet, e: [PointId; 2], f: [PointId; 2]) -> Ordering {
    let sorted = |pair: [PointId; 2]| {
        let [p, q] = pair.map(|id| points[id]);
        if by_coordinates(p, q).is_le() {
            [p, q]
        } else {
            [q, p]
        }
    };
    let ([p, q], [r, s]) = (sorted(e), sorted(f));
    by_coordinates(p, r).then(by_coordinates(q, s))
}
