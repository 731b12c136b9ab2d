//! How much a search for exchanges tries, and what it leaves as it is.

use super::constants::{BREADTH, FIRST_BREADTH};

/// How exchanges are sought.
#[derive(Clone, Copy)]
pub(super) struct Plan {
    /// In how many ways a path continues after each added edge.
    pub(super) breadth: &'static [usize],
    /// Whether paths are left that would cost too much even with the best partners for their ends.
    /// That misses little, and the search takes half the time.
    pub(super) leaves_early: bool,
    pub(super) bounds: Bounds,
}

impl Plan {
    /// Finds most exchanges, in a fraction of the time.
    pub(super) const NARROW: Self = Self {
        breadth: &FIRST_BREADTH,
        leaves_early: true,
        bounds: Bounds::None,
    };

    pub(super) const BROAD: Self = Self {
        breadth: &BREADTH,
        ..Self::NARROW
    };

    /// To explain a result.
    pub(super) const fn within(bounds: Bounds) -> Self {
        Self {
            leaves_early: false,
            bounds,
            ..Self::BROAD
        }
    }
}

/// What exchanges must leave as it is.
#[derive(Clone, Copy)]
pub(super) enum Bounds {
    /// Nothing.
    None,
    /// The edges of a node stay.
    Keep(u32),
    /// The edge of an arc stays out.
    Avoid(usize),
}
