//! What can be compared: the algorithms of the library, and references that stand beside them in
//! comparisons only.

use super::shortest_tour::ShortestTour;
use anyhow::bail;
use curvecrust::reconstruct::{ALGORITHMS, Reconstructor};

/// Not algorithms for users: what they show is said in their files.
const REFERENCES: &[&dyn Reconstructor] = &[&ShortestTour];

fn all() -> impl Iterator<Item = &'static dyn Reconstructor> {
    ALGORITHMS.iter().chain(REFERENCES).copied()
}

/// All names, those of the library first.
#[must_use]
pub fn names() -> Vec<&'static str> {
    all().map(|algorithm| algorithm.info().name).collect()
}

/// The algorithm or reference of a name.
pub(super) fn named(name: &str) -> anyhow::Result<&'static dyn Reconstructor> {
    let Some(found) = all().find(|algorithm| algorithm.info().name == name) else {
        bail!(
            "there is no algorithm {name:?}: choose from {}",
            names().join(", ")
        );
    };
    Ok(found)
}
