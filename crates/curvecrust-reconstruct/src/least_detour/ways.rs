//! Unfinished paths, and the ways to continue them.

use super::constants::BREADTH;
use super::search_graph::NO_ARC;

/// The largest breadth.
const BROADEST: usize = BREADTH[0];

/// A path whose end still seeks a partner, and perhaps its first point too: their free ends are
/// pending.
#[derive(Clone, Copy)]
pub(super) struct OpenPath {
    /// The first point, if it seeks a partner.
    pub(super) t1: Option<u32>,
    /// t2i.
    pub(super) end: u32,
    /// The arc that the path removed there; [`NO_ARC`] if none.
    pub(super) removed: usize,
    /// The number of edges that the path adds.
    pub(super) added: usize,
    /// What the path adds to the cost, without penalties for pending free ends.
    pub(super) cost: f64,
    /// The sum of all amounts, removed or added, from which the cost results.
    pub(super) magnitude: f64,
}

/// A way to continue a path: it adds the edge of an arc from its end, and perhaps removes one at
/// the other end of that.
#[derive(Clone, Copy)]
pub(super) struct Way {
    pub(super) adds: usize,
    /// [`NO_ARC`] where the other end was isolated.
    pub(super) removes: usize,
    pub(super) next: OpenPath,
    /// What the path will cost at best.
    pub(super) promised: f64,
}

/// The most promising ways to continue a path.
pub(super) struct Cheapest {
    ways: [Way; BROADEST],
    len: usize,
    most: usize,
}

impl Cheapest {
    pub(super) fn new(most: usize) -> Self {
        let none = Way {
            adds: NO_ARC,
            removes: NO_ARC,
            next: OpenPath {
                t1: None,
                end: 0,
                removed: NO_ARC,
                added: 0,
                cost: f64::INFINITY,
                magnitude: 0.0,
            },
            promised: f64::INFINITY,
        };
        Self {
            ways: [none; BROADEST],
            len: 0,
            most,
        }
    }

    /// Of equals, the first stays.
    pub(super) fn insert(&mut self, way: Way) {
        let at = self
            .all()
            .partition_point(|other| other.promised <= way.promised);
        if at < self.most {
            self.len = (self.len + 1).min(self.most);
            self.ways[at..self.len].rotate_right(1);
            self.ways[at] = way;
        }
    }

    pub(super) fn all(&self) -> &[Way] {
        &self.ways[..self.len]
    }
}
