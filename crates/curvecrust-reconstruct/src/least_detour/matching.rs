//! A 2-matching, and what its points cost.
//!
//! A 2-matching is a set of edges with at most two at each point (J. Edmonds, "Maximum Matching and
//! a Polyhedron with 0,1-Vertices", Journal of Research of the National Bureau of Standards 69B,
//! 1965).

use crate::detour::detour;
use curvecrust_geometry::{DVec2, Edge, EdgeSet};

/// No partner.
pub(super) const NONE: u32 = u32::MAX;

/// What the free ends of a point cost.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Penalty {
    /// One free end: the point has one edge.
    pub(super) one: f64,
    /// Two free ends: the point is isolated. No less than one of them, and at most twice as much.
    pub(super) both: f64,
}

/// At most two edges at each point, at most one at a terminus.
pub(super) struct Matching<'a> {
    points: &'a [DVec2],
    penalties: Vec<Penalty>,
    partners: Vec<[u32; 2]>,
    /// Those partners that stay.
    certified: Vec<[u32; 2]>,
    is_terminus: Vec<bool>,
}

impl<'a> Matching<'a> {
    /// No edges, and no penalties.
    pub(super) fn new(points: &'a [DVec2], is_terminus: Vec<bool>) -> Self {
        Self {
            points,
            penalties: vec![Penalty::default(); points.len()],
            partners: vec![[NONE; 2]; points.len()],
            certified: vec![[NONE; 2]; points.len()],
            is_terminus,
        }
    }

    pub(super) fn partners(&self, v: u32) -> [u32; 2] {
        self.partners[v as usize]
    }

    pub(super) fn set_penalties(&mut self, penalties: Vec<Penalty>) {
        self.penalties = penalties;
    }

    /// The penalty of one free end of a point.
    pub(super) fn penalty(&self, v: u32) -> f64 {
        self.penalties[v as usize].one
    }

    pub(super) fn length(&self, v: u32, w: u32) -> f64 {
        self.points[v as usize].distance(self.points[w as usize])
    }

    /// How many more edges the point may have.
    pub(super) fn free_ends(&self, v: u32) -> usize {
        let none = self.partners(v).into_iter().filter(|&p| p == NONE).count();
        none - usize::from(self.is_terminus[v as usize])
    }

    pub(super) fn has_free_end(&self, v: u32) -> bool {
        self.free_ends(v) > 0
    }

    pub(super) fn contains(&self, v: u32, w: u32) -> bool {
        self.partners(v).contains(&w)
    }

    pub(super) fn is_certified(&self, v: u32, w: u32) -> bool {
        self.certified[v as usize].contains(&w)
    }

    /// Whether certified edges saturate the point: it has as many of them as it may have edges.
    pub(super) fn is_saturated(&self, v: u32) -> bool {
        let certified = self.certified[v as usize];
        let left = certified.into_iter().filter(|&p| p == NONE).count();
        left == usize::from(self.is_terminus[v as usize])
    }

    /// Whether the two have a partner in common.
    pub(super) fn would_close_triangle(&self, v: u32, w: u32) -> bool {
        let others = self.partners(w);
        let is_shared = |p: u32| p != NONE && others.contains(&p);
        self.partners(v).into_iter().any(is_shared)
    }

    /// Adds an edge; both ends must be free, and the edge must not be there.
    pub(super) fn add(&mut self, v: u32, w: u32) {
        add_partners(&mut self.partners, v, w);
    }

    /// Adds an edge for good.
    pub(super) fn certify(&mut self, v: u32, w: u32) {
        add_partners(&mut self.partners, v, w);
        add_partners(&mut self.certified, v, w);
    }

    /// Removes an edge.
    pub(super) fn remove(&mut self, v: u32, w: u32) {
        for (from, to) in [(v, w), (w, v)] {
            if let Some(slot) = self.partners[from as usize].iter_mut().find(|p| **p == to) {
                *slot = NONE;
            }
        }
    }

    /// What a point costs: its detour if it has two edges, else the penalty of its free ends,
    /// without those that are `pending`: a path still seeks a partner for them.
    pub(super) fn cost(&self, v: u32, pending: usize) -> f64 {
        match self.partners(v) {
            [p, q] if p != NONE && q != NONE => {
                let [p, q] = [p, q].map(|id| self.points[id as usize]);
                detour(self.points[v as usize], p, q)
            }
            _ => match self.free_ends(v).saturating_sub(pending) {
                0 => 0.0,
                1 => self.penalties[v as usize].one,
                _ => self.penalties[v as usize].both,
            },
        }
    }

    pub(super) fn edges(&self) -> EdgeSet {
        let edges = (0u32..).zip(&self.partners).flat_map(|(v, partners)| {
            let larger = partners.iter().filter(move |&&p| p != NONE && v < p);
            larger.filter_map(move |&p| Edge::new(v.into(), p.into()))
        });
        EdgeSet::new(self.partners.len(), edges)
    }
}

/// Makes two points partners of each other.
pub(super) fn add_partners(partners: &mut [[u32; 2]], v: u32, w: u32) {
    for (from, to) in [(v, w), (w, v)] {
        if let Some(slot) = partners[from as usize].iter_mut().find(|p| **p == NONE) {
            *slot = to;
        }
    }
}
