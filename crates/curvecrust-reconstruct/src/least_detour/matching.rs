//! A 2-matching, and what its nodes cost.
//!
//! A 2-matching is a set of edges with at most two at each point (J. Edmonds, "Maximum Matching and
//! a Polyhedron with 0,1-Vertices", Journal of Research of the National Bureau of Standards 69B,
//! 1965).

use super::search_graph::{NO_ARC, SearchGraph};

/// The arcs from a node to its partners, [`NO_ARC`] where there is none.
pub(super) type Arcs = [usize; 2];

/// At most two edges at each node, at most one at a terminus.
pub(super) struct Matching<'a> {
    pub(super) graph: &'a SearchGraph<'a>,
    arcs: Vec<Arcs>,
}

impl<'a> Matching<'a> {
    /// The certified edges.
    pub(super) fn new(graph: &'a SearchGraph<'a>) -> Self {
        let certified = |v| {
            let mut arcs = graph.certified_at(v);
            std::array::from_fn(|_| arcs.next().unwrap_or(NO_ARC))
        };
        Self {
            graph,
            arcs: graph.nodes().map(certified).collect(),
        }
    }

    pub(super) fn arcs(&self, v: u32) -> Arcs {
        self.arcs[v as usize]
    }

    pub(super) fn contains(&self, v: u32, arc: usize) -> bool {
        self.arcs(v).contains(&arc)
    }

    /// How many more edges a node that is not saturated may have.
    pub(super) fn free_ends(&self, v: u32) -> usize {
        self.free_ends_with(v, self.arcs(v))
    }

    pub(super) fn has_free_end(&self, v: u32) -> bool {
        self.free_ends(v) > 0
    }

    fn free_ends_with(&self, v: u32, arcs: Arcs) -> usize {
        let none = arcs.into_iter().filter(|&arc| arc == NO_ARC).count();
        none - usize::from(self.graph.is_terminus(v))
    }

    /// What a node costs: its bend if it has two edges, else the penalty of its free ends, without
    /// those that are `pending`: a path still seeks a partner for them.
    pub(super) fn cost(&self, v: u32, pending: usize) -> f64 {
        self.cost_with(v, self.arcs(v), pending)
    }

    /// The same, if the node had these arcs.
    pub(super) fn cost_with(&self, v: u32, arcs: Arcs, pending: usize) -> f64 {
        let [p, q] = arcs;
        if p != NO_ARC && q != NO_ARC {
            self.graph.bend_of(v, p, q)
        } else {
            let free = self.free_ends_with(v, arcs).saturating_sub(pending);
            self.graph.penalty(v, free)
        }
    }

    /// Whether two nodes with these arcs have a partner in common.
    pub(super) fn share_partner(&self, arcs: Arcs, others: Arcs) -> bool {
        let partners = |arcs: Arcs| {
            let arcs = arcs.into_iter().filter(|&arc| arc != NO_ARC);
            arcs.map(|arc| self.graph.target(arc))
        };
        partners(arcs).any(|p| partners(others).any(|q| p == q))
    }

    /// Adds the edge of an arc; both ends must be free, and the edge must not be there.
    pub(super) fn add(&mut self, arc: usize) {
        for (v, arc) in self.ends(arc) {
            let arcs = &mut self.arcs[v as usize];
            *arcs = with(*arcs, arc);
        }
    }

    /// Removes the edge of an arc.
    pub(super) fn remove(&mut self, arc: usize) {
        for (v, arc) in self.ends(arc) {
            let arcs = &mut self.arcs[v as usize];
            *arcs = without(*arcs, arc);
        }
    }

    /// Both ends of the edge of an arc, each with the arc from there.
    fn ends(&self, arc: usize) -> [(u32, usize); 2] {
        let [v, w] = self.graph.ends(arc);
        [(v, arc), (w, self.graph.twin(arc))]
    }

    /// An arc of each edge that is not certified.
    pub(super) fn edges(&self) -> impl Iterator<Item = usize> + '_ {
        let nodes = self.graph.nodes().zip(&self.arcs);
        nodes.flat_map(move |(v, arcs)| {
            let open = self.graph.of(v);
            let is_first = move |&arc: &usize| open.contains(&arc) && v < self.graph.target(arc);
            arcs.iter().copied().filter(is_first)
        })
    }
}

/// The arcs and one more.
pub(super) fn with([p, q]: Arcs, arc: usize) -> Arcs {
    if p == NO_ARC { [arc, q] } else { [p, arc] }
}

/// The arcs without one of them.
pub(super) fn without(arcs: Arcs, arc: usize) -> Arcs {
    arcs.map(|other| if other == arc { NO_ARC } else { other })
}
