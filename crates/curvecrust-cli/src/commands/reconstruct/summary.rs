//! A summary of a reconstruction in one line, for which its edges need no order.

use super::BarePoints;
use crate::number::counted;
use curvecrust::geometry::{EdgeSet, PointId};
use std::fmt;

/// Counts of what was found.
#[derive(Debug)]
pub(super) struct Summary {
    points: usize,
    duplicates: usize,
    edges: usize,
    rings: usize,
    open_chains: usize,
    leaves: usize,
    isolated: usize,
    junctions: usize,
    /// Leaves that the user named as ends.
    termini: usize,
}

impl Summary {
    pub(super) fn new(bare: &BarePoints, edges: &EdgeSet, termini: &[PointId]) -> Self {
        let degrees = edges.degrees();
        let with_degree = |degree| degrees.iter().filter(|&&d| d == degree).count();
        // Each open chain has two ends where the degree is not 2.
        let ends = degrees.iter().filter(|&&d| d != 2);
        let mut termini = termini.to_vec();
        termini.sort_unstable();
        termini.dedup();
        Self {
            points: bare.points.len(),
            duplicates: bare.row_count() - bare.points.len(),
            edges: edges.len(),
            rings: rings(edges, &degrees),
            open_chains: ends.sum::<u32>() as usize / 2,
            leaves: with_degree(1),
            isolated: with_degree(0),
            junctions: degrees.iter().filter(|&&d| d > 2).count(),
            termini: termini.iter().filter(|t| degrees[t.index()] == 1).count(),
        }
    }

    /// Points with another number of edges than they would have on the curves of a sound sampling.
    fn violations(&self) -> usize {
        self.leaves - self.termini + self.isolated + self.junctions
    }
}

impl fmt::Display for Summary {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", counted(self.points, "point"))?;
        if self.duplicates > 0 {
            write!(f, " ({} merged)", counted(self.duplicates, "duplicate"))?;
        }
        write!(
            f,
            ", {}: {}, {}, {}, {}",
            counted(self.edges, "edge"),
            counted(self.open_chains + self.rings, "chain"),
            counted(self.rings, "ring"),
            counted(self.leaves, "leaf"),
            counted(self.isolated, "isolated point"),
        )?;
        if self.junctions > 0 {
            write!(f, ", {}", counted(self.junctions, "junction"))?;
        }
        write!(f, ", {}", counted(self.violations(), "violation"))
    }
}

/// The number of rings: connected parts in which every vertex has two edges.
fn rings(edges: &EdgeSet, degrees: &[u32]) -> usize {
    let mut parts = Parts::new(degrees.len());
    for edge in edges.edges() {
        parts.join(edge.a().into(), edge.b().into());
    }
    let mut closed = vec![true; degrees.len()];
    for (vertex, &degree) in (0u32..).zip(degrees) {
        if degree != 2 {
            closed[parts.root(vertex) as usize] = false;
        }
    }
    let roots = (0u32..).zip(&closed).filter(|&(_, &closed)| closed);
    roots
        .filter(|&(v, _)| parts.parent[v as usize] == v)
        .count()
}

/// Disjoint sets of vertices.
struct Parts {
    parent: Vec<u32>,
}

impl Parts {
    fn new(count: usize) -> Self {
        Self {
            parent: (0u32..).take(count).collect(),
        }
    }

    fn root(&mut self, mut vertex: u32) -> u32 {
        // Each vertex on the way then points to the parent of its parent.
        while self.parent[vertex as usize] != vertex {
            let above = self.parent[self.parent[vertex as usize] as usize];
            self.parent[vertex as usize] = above;
            vertex = above;
        }
        vertex
    }

    fn join(&mut self, a: u32, b: u32) {
        let (a, b) = (self.root(a), self.root(b));
        self.parent[a.max(b) as usize] = a.min(b);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use curvecrust::geometry::Edge;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn counts_are_those_of_the_chains(
            pairs in prop::collection::vec((0u32..14, 0u32..14), 0..16),
        ) {
            let edges = pairs.iter().filter_map(|&(p, q)| Edge::new(p.into(), q.into()));
            let edges = EdgeSet::new(14, edges);
            let degrees = edges.degrees();
            let chains = edges.chains();
            let closed = chains.iter().filter(|chain| chain.is_closed()).count();
            let ends: u32 = degrees.iter().filter(|&&d| d != 2).sum();
            prop_assert_eq!(rings(&edges, &degrees), closed);
            prop_assert_eq!(ends as usize / 2, chains.len() - closed);
        }
    }
}
