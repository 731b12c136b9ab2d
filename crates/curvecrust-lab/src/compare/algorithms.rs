//! What can be compared: the algorithms of the library.

use anyhow::bail;
use curvecrust::reconstruct::{ALGORITHMS, Reconstructor};

/// All names.
#[must_use]
pub fn names() -> Vec<&'static str> {
    let all = ALGORITHMS.iter();
    all.map(|algorithm| algorithm.info().name).collect()
}

/// The algorithm of a name.
pub(crate) fn named(name: &str) -> anyhow::Result<&'static dyn Reconstructor> {
    let mut all = ALGORITHMS.iter().copied();
    let Some(found) = all.find(|algorithm| algorithm.info().name == name) else {
        bail!(
            "there is no algorithm {name:?}: choose from {}",
            names().join(", ")
        );
    };
    Ok(found)
}
