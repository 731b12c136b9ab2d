//! What curves a set of edges forms: rings, open paths, and what is neither.

use curvecrust_geometry::EdgeSet;

/// The connected components of a set of edges, by kind; isolated vertices are none.
///
/// ```
/// use curvecrust_evaluate::Topology;
/// use curvecrust_geometry::{Edge, EdgeSet, PointId};
///
/// let edge = |a, b| Edge::new(PointId::from(a), PointId::from(b)).unwrap();
/// let ring_and_path = EdgeSet::new(6, [edge(0, 1), edge(1, 2), edge(0, 2), edge(3, 4)]);
/// let topology = Topology::new(&ring_and_path);
/// assert_eq!((topology.closed, topology.open, topology.branching), (1, 1, 0));
/// assert_eq!(topology.degrees, [1, 2, 3, 0]);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct Topology {
    /// Components that are rings.
    pub closed: usize,
    /// Components that are paths with two ends.
    pub open: usize,
    /// Components with a vertex of degree 3 or more.
    pub branching: usize,
    /// The number of vertices of degree 0, 1, 2, and of 3 or more.
    pub degrees: [usize; 4],
}

impl Topology {
    /// Looks at every vertex and edge once.
    #[must_use]
    pub fn new(edges: &EdgeSet) -> Self {
        let degrees = edges.degrees();
        let mut roots = Roots((0..degrees.len()).collect());
        for edge in edges.edges() {
            roots.join(edge.a().index(), edge.b().index());
        }
        // The least and the largest degree in each component, at its root.
        let mut extremes = vec![(u32::MAX, 0); degrees.len()];
        let mut topology = Self::default();
        for (v, &degree) in degrees.iter().enumerate() {
            topology.degrees[(degree as usize).min(3)] += 1;
            let (least, most) = &mut extremes[roots.of(v)];
            *least = degree.min(*least);
            *most = degree.max(*most);
        }
        for extremes in extremes {
            match extremes {
                (2, 2) => topology.closed += 1,
                (1, 1 | 2) => topology.open += 1,
                (u32::MAX, _) | (0, _) => {}
                _ => topology.branching += 1,
            }
        }
        topology
    }

    /// Whether there are as many components of each kind; isolated vertices do not count.
    #[must_use]
    pub fn agrees_with(&self, other: &Self) -> bool {
        let kinds = |t: &Self| [t.closed, t.open, t.branching];
        kinds(self) == kinds(other)
    }
}

/// Disjoint sets of vertices, by path halving.
struct Roots(Vec<usize>);

impl Roots {
    fn of(&mut self, mut v: usize) -> usize {
        while self.0[v] != v {
            self.0[v] = self.0[self.0[v]];
            v = self.0[v];
        }
        v
    }

    fn join(&mut self, v: usize, w: usize) {
        let (v, w) = (self.of(v), self.of(w));
        self.0[v.max(w)] = v.min(w);
    }
}
