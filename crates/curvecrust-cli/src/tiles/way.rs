//! How the edges of a tile are found.

use curvecrust::tiles::{Method, SolveStars, solve_crust_tile};

/// The name of the algorithm Crust.
const CRUST: &str = "crust";

/// What an algorithm needs of other tiles.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Way {
    /// Every sample makes choices; those that are open are asked for one by one.
    Choices(Method),
    /// A tile is solved with runs of other tiles, until every star is certain.
    Stars(SolveStars),
}

impl Way {
    /// The way of an algorithm; `None` if it has no tiles.
    pub(crate) fn of_name(name: &str) -> Option<Self> {
        if name == CRUST {
            return Some(Self::Stars(solve_crust_tile));
        }
        Method::of_name(name).map(Self::Choices)
    }

    /// The algorithms that have tiles.
    pub(crate) fn names() -> Vec<&'static str> {
        let choices = Method::ALL.iter().map(|(name, _)| *name);
        choices.chain([CRUST]).collect()
    }

    /// Bytes that are needed for each point of a tile: most while its neighbours are sought, or for
    /// stars while its Voronoi vertices are sorted.
    pub(super) fn bytes(self) -> u64 {
        match self {
            Self::Choices(_) => super::POINT,
            Self::Stars(_) => 1280,
        }
    }
}
