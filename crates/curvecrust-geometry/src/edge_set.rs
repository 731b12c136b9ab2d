//! Undirected edges between the points of a set, in canonical order.

use std::fmt;

use crate::point_id::PointId;

/// An undirected edge; `a() < b()`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Edge {
    a: PointId,
    b: PointId,
}

impl Edge {
    /// The edge between two points, in either order; `None` if they are the same.
    #[must_use]
    pub fn new(p: PointId, q: PointId) -> Option<Self> {
        (p != q).then(|| Self {
            a: p.min(q),
            b: p.max(q),
        })
    }

    /// The end with the smaller id.
    #[must_use]
    pub fn a(self) -> PointId {
        self.a
    }

    /// The end with the larger id.
    #[must_use]
    pub fn b(self) -> PointId {
        self.b
    }

    /// Both ends, ascending.
    #[must_use]
    pub fn ends(self) -> [PointId; 2] {
        [self.a, self.b]
    }
}

impl From<Edge> for [PointId; 2] {
    fn from(edge: Edge) -> Self {
        edge.ends()
    }
}

impl fmt::Display for Edge {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}-{}", self.a, self.b)
    }
}

/// A set of undirected edges over the vertices `0..vertex_count()`.
///
/// # Guarantees
/// Edges are sorted and unique, so equal reconstructions compare equal, whatever order they were
/// found in; no edge joins a vertex to itself; every end is below `vertex_count()`.
///
/// ```
/// use curvecrust_geometry::{Edge, EdgeSet, PointId};
///
/// let id = |i| PointId::from(i);
/// let edges = [(2, 1), (0, 1), (1, 2)].map(|(p, q)| Edge::new(id(p), id(q)).unwrap());
/// let set = EdgeSet::new(4, edges);
/// assert_eq!(set.len(), 2);
/// assert_eq!(set.degrees(), [1, 2, 1, 0]);
/// assert_eq!(set.leaves(), [id(0), id(2)]);
/// assert_eq!(set.isolated(), [id(3)]);
/// ```
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct EdgeSet {
    vertex_count: usize,
    edges: Vec<Edge>,
}

impl EdgeSet {
    /// Collects edges in any order, repeated or not.
    ///
    /// The vertices are `0..vertex_count`, or up to the largest end of an edge if that is more; of
    /// those beyond the last [`PointId`] there are none.
    #[must_use]
    pub fn new(vertex_count: usize, edges: impl IntoIterator<Item = Edge>) -> Self {
        let mut edges: Vec<Edge> = edges.into_iter().collect();
        if !edges.is_sorted_by(|e, f| e < f) {
            edges.sort_unstable();
            edges.dedup();
        }
        let used = edges.iter().map(|e| e.b).max().map_or(0, |b| b.index() + 1);
        Self {
            vertex_count: vertex_count.min(u32::MAX as usize).max(used),
            edges,
        }
    }

    /// The number of vertices, isolated ones included.
    #[must_use]
    pub fn vertex_count(&self) -> usize {
        self.vertex_count
    }

    /// The number of edges.
    #[must_use]
    pub fn len(&self) -> usize {
        self.edges.len()
    }

    /// Whether there is no edge.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.edges.is_empty()
    }

    /// The edges, ascending.
    #[must_use]
    pub fn edges(&self) -> &[Edge] {
        &self.edges
    }

    /// Whether the edge belongs to the set, in O(log n).
    #[must_use]
    pub fn contains(&self, edge: Edge) -> bool {
        self.edges.binary_search(&edge).is_ok()
    }

    /// The edges of this set that `other` lacks, ascending.
    pub fn difference<'a>(&'a self, other: &'a Self) -> impl Iterator<Item = Edge> + 'a {
        self.edges.iter().copied().filter(|&e| !other.contains(e))
    }

    /// The number of edges at each vertex.
    #[must_use]
    pub fn degrees(&self) -> Vec<u32> {
        let mut degrees = vec![0; self.vertex_count];
        for end in self.edges.iter().flat_map(|e| e.ends()) {
            degrees[end.index()] += 1;
        }
        degrees
    }

    /// The vertices of degree 1, ascending.
    #[must_use]
    pub fn leaves(&self) -> Vec<PointId> {
        self.with_degree(|d| d == 1)
    }

    /// The vertices without an edge, ascending.
    #[must_use]
    pub fn isolated(&self) -> Vec<PointId> {
        self.with_degree(|d| d == 0)
    }

    /// The vertices of degree 3 or more, ascending.
    #[must_use]
    pub fn junctions(&self) -> Vec<PointId> {
        self.with_degree(|d| d > 2)
    }

    fn with_degree(&self, wanted: impl Fn(u32) -> bool) -> Vec<PointId> {
        vertices_with_degree(&self.degrees(), wanted)
    }
}

/// The vertices whose degrees are wanted, ascending; given are the degrees of all.
///
/// ```
/// use curvecrust_geometry::{PointId, edge_set::vertices_with_degree};
///
/// let leaves = vertices_with_degree(&[1, 2, 1], |degree| degree == 1);
/// assert_eq!(leaves, [0, 2].map(PointId::from));
/// ```
#[must_use]
pub fn vertices_with_degree(degrees: &[u32], wanted: impl Fn(u32) -> bool) -> Vec<PointId> {
    (0u32..)
        .zip(degrees)
        .filter(|&(_, &degree)| wanted(degree))
        .map(|(vertex, _)| PointId::from(vertex))
        .collect()
}

/// As many vertices as the ends of the edges need.
impl FromIterator<Edge> for EdgeSet {
    fn from_iter<I: IntoIterator<Item = Edge>>(edges: I) -> Self {
        Self::new(0, edges)
    }
}

impl AsRef<[Edge]> for EdgeSet {
    fn as_ref(&self) -> &[Edge] {
        &self.edges
    }
}

impl<'a> IntoIterator for &'a EdgeSet {
    type Item = &'a Edge;
    type IntoIter = std::slice::Iter<'a, Edge>;

    fn into_iter(self) -> Self::IntoIter {
        self.edges.iter()
    }
}

impl IntoIterator for EdgeSet {
    type Item = Edge;
    type IntoIter = std::vec::IntoIter<Edge>;

    fn into_iter(self) -> Self::IntoIter {
        self.edges.into_iter()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;
    use std::collections::BTreeSet;

    fn set(pairs: &BTreeSet<(u32, u32)>) -> EdgeSet {
        let edges = pairs.iter().rev();
        let edges = edges.filter_map(|&(p, q)| Edge::new(q.into(), p.into()));
        EdgeSet::new(7, edges)
    }

    fn ascending_pairs() -> impl Strategy<Value = BTreeSet<(u32, u32)>> {
        let pair = (0u32..7, 0u32..7).prop_filter("p < q", |(p, q)| p < q);
        prop::collection::btree_set(pair, 0..12)
    }

    proptest! {
        #[test]
        fn sets_of_edges_are_sets_of_pairs(a in ascending_pairs(), b in ascending_pairs()) {
            let [edges, others] = [&a, &b].map(set);
            let pairs = |edges: Vec<Edge>| -> Vec<(u32, u32)> {
                edges.iter().map(|e| (e.a().into(), e.b().into())).collect()
            };
            prop_assert_eq!(edges.len(), a.len());
            prop_assert_eq!(edges.is_empty(), a.is_empty());
            let lacking: Vec<_> = a.difference(&b).copied().collect();
            prop_assert_eq!(pairs(edges.difference(&others).collect()), lacking);
            prop_assert_eq!(edges.as_ref(), edges.edges());
            prop_assert_eq!(pairs(edges.into_iter().collect()), Vec::from_iter(a));
        }

        #[test]
        fn degrees_count_the_pairs_of_a_vertex(pairs in ascending_pairs()) {
            let edges = set(&pairs);
            let degree = |v: u32| pairs.iter().filter(|&&(p, q)| p == v || q == v).count();
            let with = |is_it: fn(usize) -> bool| -> Vec<PointId> {
                (0..7).filter(|&v| is_it(degree(v))).map(PointId::from).collect()
            };
            prop_assert_eq!(edges.isolated(), with(|degree| degree == 0));
            prop_assert_eq!(edges.leaves(), with(|degree| degree == 1));
            prop_assert_eq!(edges.junctions(), with(|degree| degree >= 3));
        }
    }

    #[test]
    fn there_are_no_more_vertices_than_ids() {
        assert_eq!(EdgeSet::new(7, []).vertex_count(), 7);
        assert_eq!(EdgeSet::new(usize::MAX, []).vertex_count(), 0xffff_ffff);
    }
}
