//! Samples whose choice their tile cannot be certain of.

use crate::sample::Sample;

/// What is not certain about the choice of a sample.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Lack {
    /// The nearest neighbour, and with it the half neighbour.
    Nearest,
    /// The half neighbour alone.
    Half,
}

/// A sample whose choice is not certain, and the best that its tile and the halo offer.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OpenSample {
    /// The sample.
    pub sample: Sample,
    /// What is not certain.
    pub lacks: Lack,
    /// The nearest sample that is loaded; `None` if no other is.
    pub nearest: Option<Sample>,
    /// The half neighbour among the samples that are loaded, if `nearest` is the nearest neighbour;
    /// `None` if there is none.
    pub half: Option<Sample>,
}

impl OpenSample {
    /// How far around the sample everything has to be loaded to make its choice certain, unless a
    /// nearer neighbour turns up there; infinite where the half-plane holds no loaded sample, as
    /// at the end of an open curve.
    #[must_use]
    pub fn radius(&self) -> f64 {
        let half = self.half.map(|half| half.point.distance(self.sample.point));
        half.unwrap_or(f64::INFINITY)
    }
}
