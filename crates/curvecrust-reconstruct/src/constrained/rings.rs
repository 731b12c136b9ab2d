//! Rings through points, as partners of each point.

use curvecrust_geometry::{PointId, PointSet};

use crate::known::are_on_a_line;

/// No partner.
pub(super) const NONE: u32 = u32::MAX;

/// At most two partners for each point.
pub(super) struct Partners {
    of: Vec<[u32; 2]>,
}

impl Partners {
    pub(super) fn new(count: usize) -> Self {
        Self {
            of: vec![[NONE; 2]; count],
        }
    }

    pub(super) fn of(&self, v: u32) -> [u32; 2] {
        self.of[v as usize]
    }

    pub(super) fn open_slots(&self, v: u32) -> usize {
        self.of(v).into_iter().filter(|&p| p == NONE).count()
    }

    pub(super) fn are_joined(&self, v: u32, w: u32) -> bool {
        self.of(v).contains(&w)
    }

    /// Joins two points, each with an open slot.
    pub(super) fn join(&mut self, v: u32, w: u32) {
        self.replace(v, NONE, w);
        self.replace(w, NONE, v);
    }

    /// Replaces the edges a b and c d by a c and b d.
    pub(super) fn exchange(&mut self, [a, b]: [u32; 2], [c, d]: [u32; 2]) {
        for (v, from, to) in [(a, b, c), (b, a, d), (c, d, a), (d, c, b)] {
            self.replace(v, from, to);
        }
    }

    /// Puts a point without partners into an edge.
    pub(super) fn insert(&mut self, v: u32, [a, b]: [u32; 2]) {
        self.replace(a, b, v);
        self.replace(b, a, v);
        self.of[v as usize] = [a, b];
    }

    fn replace(&mut self, v: u32, from: u32, to: u32) {
        if let Some(partner) = self.of[v as usize].iter_mut().find(|p| **p == from) {
            *partner = to;
        }
    }

    /// The paths and rings, each from the end or the point that comes first: from end to end, or
    /// once around.
    pub(super) fn curves(&self) -> Vec<Vec<u32>> {
        let count = self.of.len();
        let all = || (0u32..).take(count);
        let mut is_done = vec![false; count];
        let mut curves = Vec::new();
        for start in all().filter(|&v| self.open_slots(v) > 0).chain(all()) {
            let mut curve = Vec::new();
            let mut next = Some(start).filter(|&v| !is_done[v as usize]);
            while let Some(v) = next {
                is_done[v as usize] = true;
                curve.push(v);
                let mut partners = self.of(v).into_iter().filter(|&p| p != NONE);
                next = partners.find(|&p| !is_done[p as usize]);
            }
            if !curve.is_empty() {
                curves.push(curve);
            }
        }
        curves
    }
}

/// Whether points can be a polygon: they are three or more, and not on a line.
pub(super) fn make_polygon(points: &PointSet, ring: &[u32]) -> bool {
    ring.len() > 2 && !are_on_a_line(points, ring.iter().map(|&v| PointId::from(v)))
}
