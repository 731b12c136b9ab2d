//! Samples of smooth closed curves on which an algorithm fails, and how sparse they are.
//!
//! A theorem says below which bound an algorithm is right; a counterexample says from which bound
//! on it may be wrong. Those of `fixtures/counterexamples` were found by [`Search`]; what their
//! samples satisfy is proven by interval arithmetic (`curvecrust_proof::SampledSplines`).

mod dense;
mod picture;
mod proven;
mod search;
mod shape;

use crate::compare::algorithms::named;
use crate::repository::{files, root};
use anyhow::Context;
use curvecrust::reconstruct::Reconstructor;
use std::fs;
use std::path::Path;

pub use dense::Dense;
pub(crate) use picture::made;
pub use proven::ProvenSamples;
pub use search::Search;

/// Samples of closed splines on which an algorithm fails.
#[derive(Clone, Debug)]
pub struct Counterexample {
    /// The name of the algorithm.
    pub algorithm: String,
    /// The samples, and the bound that they satisfy.
    pub samples: ProvenSamples,
}

/// All of `fixtures/counterexamples`, in the order of their names.
///
/// # Errors
/// If a file cannot be read or is none.
pub fn all() -> anyhow::Result<Vec<Counterexample>> {
    let paths = files(&root().join("fixtures/counterexamples"), "splines")?;
    let all = paths
        .iter()
        .map(|path| read(path, Counterexample::from_text));
    all.collect()
}

/// Two curves of one set of samples, between which no algorithm can tell: four petals, and a
/// flower.
///
/// The samples are on eight rays through the corners of a regular octagon. Outside, both curves
/// join the rays in the same pairs; inside, in either of the two ways.
///
/// # Errors
/// If a file cannot be read or is none.
pub fn two_curves() -> anyhow::Result<[ProvenSamples; 2]> {
    about_octagon(["petals", "flower"])
}

/// Two such curves with sparser samples.
///
/// # Errors
/// If a file cannot be read or is none.
pub fn two_sparser_curves() -> anyhow::Result<[ProvenSamples; 2]> {
    about_octagon(["sparser-petals", "sparser-flower"])
}

fn about_octagon([petals, flower]: [&str; 2]) -> anyhow::Result<[ProvenSamples; 2]> {
    let folder = root().join("fixtures/two-curves");
    let file = |name: &str| {
        let path = folder.join(name).with_extension("splines");
        read(&path, ProvenSamples::from_text)
    };
    Ok([file(petals)?, file(flower)?])
}

fn read<T>(path: &Path, parse: impl Fn(&str) -> anyhow::Result<T>) -> anyhow::Result<T> {
    let place = || path.display().to_string();
    let text = fs::read_to_string(path).with_context(place)?;
    parse(&text).with_context(place)
}

impl Counterexample {
    /// From its text: the algorithm, a space, and the samples.
    fn from_text(text: &str) -> anyhow::Result<Self> {
        let (algorithm, samples) = text.split_once(' ').context("no algorithm")?;
        Ok(Self {
            algorithm: algorithm.to_owned(),
            samples: ProvenSamples::from_text(samples)?,
        })
    }

    /// What [`all`] reads.
    #[must_use]
    pub fn to_text(&self) -> String {
        format!("{} {}", self.algorithm, self.samples.to_text())
    }

    /// The name of its files, without their endings.
    #[must_use]
    pub fn name(&self) -> String {
        format!("{}-{}", self.algorithm, self.samples.condition())
    }

    /// The algorithm.
    ///
    /// # Errors
    /// If there is none of its name.
    pub fn reconstructor(&self) -> anyhow::Result<&'static dyn Reconstructor> {
        named(&self.algorithm)
    }
}
