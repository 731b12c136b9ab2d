//! Edge sets as ordered polylines and rings.

use crate::component::Component;
use crate::edge_set::{Edge, EdgeSet};
use crate::point_id::PointId;

/// A maximal path of an edge set whose inner vertices have degree 2, or a ring of such vertices.
///
/// # Guarantees
/// - Consecutive vertices are joined by an edge; in a closed chain the last and the first too (the
///   first is not repeated).
/// - An open chain starts at the end with the smaller id (the smaller second vertex, when it runs
///   from a junction back to itself: it is then open, with equal ends).
/// - A closed chain starts at its smallest vertex and goes on to the smaller of its neighbours.
/// - Chains are sorted: by vertices, lexicographically.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Chain {
    vertices: Vec<PointId>,
    closed: bool,
}

impl Chain {
    /// A chain as data has it.
    #[cfg(feature = "serde")]
    pub(crate) fn of(vertices: Vec<PointId>, closed: bool) -> Self {
        Self { vertices, closed }
    }

    /// The vertices in order along the chain.
    #[must_use]
    pub fn vertices(&self) -> &[PointId] {
        &self.vertices
    }

    /// Whether an edge leads from the last vertex back to the first.
    #[must_use]
    pub fn is_closed(&self) -> bool {
        self.closed
    }

    /// The number of edges.
    #[must_use]
    pub fn edge_count(&self) -> usize {
        self.vertices.len() - usize::from(!self.closed)
    }

    /// The edges in order along the chain.
    pub fn edges(&self) -> impl Iterator<Item = Edge> + '_ {
        let order = Component {
            range: 0..self.vertices.len(),
            closed: self.closed,
        };
        let pairs = order.pairs();
        pairs.filter_map(|(i, j)| Edge::new(self.vertices[i], self.vertices[j]))
    }

    /// The same chain in the opposite direction; a closed one keeps its first vertex.
    #[must_use]
    pub fn reversed(mut self) -> Self {
        if self.closed {
            self.vertices[1..].reverse();
        } else {
            self.vertices.reverse();
        }
        self
    }
}

impl AsRef<[PointId]> for Chain {
    fn as_ref(&self) -> &[PointId] {
        &self.vertices
    }
}

impl From<Chain> for Vec<PointId> {
    fn from(chain: Chain) -> Self {
        chain.vertices
    }
}

/// Neighbours of every vertex in one array: those of `v` are `targets[first[v]..first[v + 1]]`.
struct Adjacency {
    first: Vec<usize>,
    targets: Vec<PointId>,
}

impl Adjacency {
    fn new(set: &EdgeSet) -> Self {
        // Behind each vertex v, at v + 1, where its neighbours start, and as they come in, where
        // they end.
        let mut first = vec![0; set.vertex_count() + 2];
        for end in set.edges().iter().flat_map(|e| e.ends()) {
            first[end.index() + 2] += 1;
        }
        for v in 1..first.len() {
            first[v] += first[v - 1];
        }
        let mut targets = vec![PointId::from(0); 2 * set.len()];
        // Edges are sorted, so each vertex gets its smaller neighbours first, all ascending.
        for edge in set.edges() {
            for (from, to) in [(edge.a(), edge.b()), (edge.b(), edge.a())] {
                let end = &mut first[from.index() + 1];
                targets[*end] = to;
                *end += 1;
            }
        }
        Self { first, targets }
    }

    fn of(&self, v: PointId) -> &[PointId] {
        &self.targets[self.first[v.index()]..self.first[v.index() + 1]]
    }

    /// The way on from inner vertex `v` when coming from `from`; `None` at the end of a chain.
    fn onward(&self, from: PointId, v: PointId) -> Option<PointId> {
        match *self.of(v) {
            [p, q] => Some(if p == from { q } else { p }),
            _ => None,
        }
    }

    /// The vertices from `start` by way of `second` until a chain's end, or until back at `start`.
    fn walk(&self, start: PointId, second: PointId) -> Vec<PointId> {
        let mut path = vec![start, second];
        let (mut from, mut at) = (start, second);
        while at != start {
            let Some(next) = self.onward(from, at) else {
                break;
            };
            path.push(next);
            (from, at) = (at, next);
        }
        path
    }
}

impl EdgeSet {
    /// The maximal open paths and closed rings, cut at junctions: every edge in exactly one.
    ///
    /// See [`Chain`] for their order and orientation; isolated vertices form no chain.
    #[must_use]
    pub fn chains(&self) -> Vec<Chain> {
        chains_of(self)
    }
}

fn chains_of(set: &EdgeSet) -> Vec<Chain> {
    let adjacency = Adjacency::new(set);
    let mut chains = Vec::new();
    let mut inner = vec![false; set.vertex_count()];
    let vertices = || (0u32..).take(set.vertex_count()).map(PointId::from);
    for start in vertices().filter(|&v| adjacency.of(v).len() != 2) {
        for &second in adjacency.of(start) {
            let path = adjacency.walk(start, second);
            for v in &path[1..path.len() - 1] {
                inner[v.index()] = true;
            }
            // Each open chain is walked from both of its ends and kept once.
            let reversed = path.iter().rev();
            if path.iter().le(reversed) {
                chains.push(Chain {
                    vertices: path,
                    closed: false,
                });
            }
        }
    }
    for start in vertices() {
        if let [second, _] = *adjacency.of(start)
            && !inner[start.index()]
        {
            let mut ring = adjacency.walk(start, second);
            ring.pop();
            for v in &ring {
                inner[v.index()] = true;
            }
            chains.push(Chain {
                vertices: ring,
                closed: true,
            });
        }
    }
    chains.sort_unstable();
    chains
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn set(n: usize, edges: &[(u32, u32)]) -> EdgeSet {
        let edge = |&(p, q)| Edge::new(PointId::from(p), PointId::from(q)).unwrap();
        EdgeSet::new(n, edges.iter().map(edge))
    }

    fn shown(set: &EdgeSet) -> Vec<(Vec<u32>, bool)> {
        let ids = |c: &Chain| c.vertices().iter().map(|&v| v.into()).collect();
        set.chains()
            .iter()
            .map(|c| (ids(c), c.is_closed()))
            .collect()
    }

    #[test]
    fn a_path_a_ring_and_an_isolated_vertex() {
        let set = set(8, &[(5, 1), (1, 3), (0, 6), (6, 4), (4, 0)]);
        assert_eq!(shown(&set), [(vec![0, 4, 6], true), (vec![3, 1, 5], false)]);
    }

    #[test]
    fn chains_are_cut_at_junctions() {
        // A lollipop: a ring 1-2-3 hanging at junction 1 of the path 0-1.
        let set = set(4, &[(0, 1), (1, 2), (2, 3), (3, 1)]);
        assert_eq!(
            shown(&set),
            [(vec![0, 1], false), (vec![1, 2, 3, 1], false)]
        );
    }

    proptest! {
        #[test]
        fn chains_cover_every_edge_once(
            pairs in prop::collection::vec((0u32..12, 0u32..12), 0..30),
        ) {
            let edges = pairs
                .iter()
                .filter_map(|&(p, q)| Edge::new(p.into(), q.into()));
            let set = EdgeSet::new(12, edges);
            let mut covered: Vec<Edge> = set
                .chains()
                .iter()
                .flat_map(|c| c.edges().collect::<Vec<_>>())
                .collect();
            covered.sort_unstable();
            prop_assert_eq!(covered, set.edges());
            for chain in set.chains() {
                prop_assert_eq!(chain.edge_count(), chain.edges().count());
                let ends = usize::from(!chain.is_closed());
                prop_assert_eq!(chain.as_ref().len(), chain.edge_count() + ends);
                prop_assert_eq!(chain.as_ref(), &Vec::from(chain.clone())[..]);
            }
        }

        #[test]
        fn reversed_chains_have_the_same_edges_the_other_way(
            count in 1u32..9,
            closed in any::<bool>(),
        ) {
            let closed = closed && count > 2;
            let steps = if closed { count } else { count - 1 };
            let edges: Vec<_> = (0..steps).map(|i| (i, (i + 1) % count)).collect();
            for chain in set(9, &edges).chains() {
                let reversed = chain.clone().reversed();
                let first = if closed { chain.vertices()[0] } else { chain.vertices()[count as usize - 1] };
                prop_assert_eq!(reversed.vertices()[0], first);
                let other_way: Vec<Edge> = reversed.edges().collect();
                let mut edges: Vec<Edge> = chain.edges().collect();
                edges.reverse();
                prop_assert_eq!(other_way, edges);
                prop_assert_eq!(reversed.reversed(), chain);
            }
        }
    }
}
