//! The edges at a stage of the work, and what they cost.

use curvecrust_geometry::{DVec2, Edge, EdgeSet};

/// No partner.
pub(super) const NONE: u32 = u32::MAX;

/// What it costs to leave slots of a point open.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Price {
    /// One of them.
    pub(super) slot: f64,
    /// Both: no less than one, and at most twice as much.
    pub(super) both: f64,
}

/// At most two partners for every point, at most one for a terminus.
pub(super) struct Joins<'a> {
    points: &'a [DVec2],
    prices: Vec<Price>,
    partners: Vec<[u32; 2]>,
    /// Those of the partners that stay.
    certified: Vec<[u32; 2]>,
    is_terminus: Vec<bool>,
}

impl<'a> Joins<'a> {
    /// No joins, and nothing to pay for open slots.
    pub(super) fn new(points: &'a [DVec2], is_terminus: Vec<bool>) -> Self {
        Self {
            points,
            prices: vec![Price::default(); points.len()],
            partners: vec![[NONE; 2]; points.len()],
            certified: vec![[NONE; 2]; points.len()],
            is_terminus,
        }
    }

    pub(super) fn partners(&self, v: u32) -> [u32; 2] {
        self.partners[v as usize]
    }

    pub(super) fn set_prices(&mut self, prices: Vec<Price>) {
        self.prices = prices;
    }

    /// What it costs to leave one slot of a point open.
    pub(super) fn price(&self, v: u32) -> f64 {
        self.prices[v as usize].slot
    }

    pub(super) fn length(&self, v: u32, w: u32) -> f64 {
        self.points[v as usize].distance(self.points[w as usize])
    }

    /// How many more partners the point may have.
    pub(super) fn open_slots(&self, v: u32) -> usize {
        let none = self.partners(v).into_iter().filter(|&p| p == NONE).count();
        none - usize::from(self.is_terminus[v as usize])
    }

    pub(super) fn is_open(&self, v: u32) -> bool {
        self.open_slots(v) > 0
    }

    pub(super) fn are_joined(&self, v: u32, w: u32) -> bool {
        self.partners(v).contains(&w)
    }

    pub(super) fn is_certified(&self, v: u32, w: u32) -> bool {
        self.certified[v as usize].contains(&w)
    }

    /// Whether all that the point may have is certified.
    pub(super) fn is_settled(&self, v: u32) -> bool {
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

    /// Joins two points; both must be open and not joined.
    pub(super) fn join(&mut self, v: u32, w: u32) {
        put(&mut self.partners, v, w);
    }

    /// Joins two points for good.
    pub(super) fn certify(&mut self, v: u32, w: u32) {
        put(&mut self.partners, v, w);
        put(&mut self.certified, v, w);
    }

    /// Parts two points that are joined.
    pub(super) fn part(&mut self, v: u32, w: u32) {
        for (from, to) in [(v, w), (w, v)] {
            if let Some(slot) = self.partners[from as usize].iter_mut().find(|p| **p == to) {
                *slot = NONE;
            }
        }
    }

    /// What a point costs: its detour if it has two partners, else its open slots without those
    /// `in_hand`, whose partners are still sought.
    pub(super) fn cost(&self, v: u32, in_hand: usize) -> f64 {
        match self.partners(v) {
            [p, q] if p != NONE && q != NONE => {
                let [p, q] = [p, q].map(|id| self.points[id as usize]);
                detour(self.points[v as usize], p, q)
            }
            _ => match self.open_slots(v).saturating_sub(in_hand) {
                0 => 0.0,
                1 => self.prices[v as usize].slot,
                _ => self.prices[v as usize].both,
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

/// Uses a slot of both ends.
pub(super) fn put(slots: &mut [[u32; 2]], v: u32, w: u32) {
    for (from, to) in [(v, w), (w, v)] {
        if let Some(slot) = slots[from as usize].iter_mut().find(|p| **p == NONE) {
            *slot = to;
        }
    }
}

/// How much longer the way from p to q is by way of v: |vp| + |vq| - |pq|.
///
/// In a form whose error is relative to the shorter of |vp| and |vq|.
pub(super) fn detour(v: DVec2, p: DVec2, q: DVec2) -> f64 {
    let (a, b) = (p - v, q - v);
    let (a_length, b_length) = (a.length(), b.length());
    let around = a_length + b_length + p.distance(q);
    (2.0 * (a_length * b_length + a.dot(b)) / around).max(0.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_detour_is_what_the_triangle_inequality_leaves() {
        let v = DVec2::new(1.0, 2.0);
        let at = |degrees: f64, length: f64| v + DVec2::from_angle(degrees.to_radians()) * length;
        for (p, q) in [
            (at(0.0, 3.0), at(90.0, 4.0)),
            (at(10.0, 1.0), at(160.0, 7.0)),
        ] {
            let expected = v.distance(p) + v.distance(q) - p.distance(q);
            assert!((detour(v, p, q) - expected).abs() < 1e-14);
        }
        // Straight on, and back: twice the shorter way.
        assert!(detour(v, at(0.0, 5.0), at(180.0, 0.1)) < 1e-16);
        assert!((detour(v, at(0.0, 5.0), at(0.0, 0.1)) - 0.2).abs() < 1e-15);
    }
}
