//! `cargo xtask docs`: the files under docs that are made, not written.

use crate::claims;
use crate::compare::published;
use crate::counterexamples;
use crate::family;
use crate::method;
use crate::paper::figures::{self, PointSets};
use crate::paper::models;
use crate::puzzles;

/// The files that are made: their names below the root, and what they should hold.
///
/// # Errors
/// If what they are made of cannot be read.
pub fn made() -> anyhow::Result<Vec<(String, String)>> {
    let images = images()?.into_iter();
    let images = images.map(|(name, text)| (name.to_owned(), text));
    let family = family::figures()?.into_iter();
    let family = family.map(|(name, figure)| (name, figure.to_svg()));
    let pages = [
        (puzzles::NAME.to_owned(), puzzles::page()?),
        (claims::NAME.to_owned(), claims::page()?),
    ];
    let others = [published::made()?, counterexamples::made()?].concat();
    Ok(images.chain(family).chain(pages).chain(others).collect())
}

/// Figures of the paper on our own curves and points, for the README, and those of
/// `docs/method.md`.
fn images() -> anyhow::Result<Vec<(&'static str, String)>> {
    let models = models::redrawn()?;
    let points = PointSets::redrawn()?;
    Ok(vec![
        (
            "docs/images/teaser.svg",
            figures::figure_1(&models)?.figure.to_svg(),
        ),
        ("docs/images/bunny.svg", figures::bunny(&models)?.to_svg()),
        (
            "docs/images/sharp-angles.svg",
            figures::figure_3(&points).figure.to_svg(),
        ),
        (
            "docs/images/near-strands.svg",
            method::near_strands()?.to_svg(),
        ),
        (
            "docs/images/sharp-corner.svg",
            method::sharp_corner()?.to_svg(),
        ),
        (
            "docs/images/facing-ends.svg",
            method::facing_ends()?.to_svg(),
        ),
        ("docs/images/gap-ahead.svg", method::gap_ahead()?.to_svg()),
    ])
}
