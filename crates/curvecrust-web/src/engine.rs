//! What answers the messages of the page.

mod curve;
mod reconstruct;

use crate::error::Error;
use crate::message::{self, Answer, Received};
use crate::points;
use curve::Loaded;
use curvecrust::reconstruct::ALGORITHMS;
use serde::Deserialize;

/// Answers messages, and keeps the curve that was loaded last.
#[derive(Debug, Default)]
pub struct Engine {
    loaded: Option<Loaded>,
}

/// What the page may ask for.
#[derive(Deserialize)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
enum Request {
    /// The algorithms, with what is known of them.
    Algorithms,
    /// The edges of the points that follow.
    Reconstruct(reconstruct::Request),
    /// Loads a curve: its dense points, their lfs and the medial axis.
    Curve(curve::Source),
    /// Samples of the curve that was loaded.
    Sample(curve::SampleRequest),
    /// The numbers of samples of the curve for the bounds of the paper's Table 2.
    Counts,
    /// The points of a file.
    Points { name: String, text: String },
}

impl Engine {
    /// Answers a message, with an error in words where there is no other answer.
    #[must_use]
    pub fn answer(&mut self, message: &[u8]) -> Vec<u8> {
        match self.perform(message) {
            Ok(answer) => answer.into_bytes(),
            Err(error) => message::of_error(&error),
        }
    }

    fn perform(&mut self, message: &[u8]) -> Result<Answer, Error> {
        let received = Received::parse(message)?;
        match serde_json::from_slice(received.header)? {
            Request::Algorithms => Ok(algorithms()),
            Request::Reconstruct(request) => request.perform(received.points()),
            Request::Curve(source) => {
                // A drawing that is none leaves the one before it.
                let loaded = Loaded::new(&source)?;
                let answer = loaded.describe();
                self.loaded = Some(loaded);
                Ok(answer)
            }
            Request::Sample(request) => self.curve()?.sample(request),
            Request::Counts => self.curve()?.counts(),
            Request::Points { name, text } => {
                let found = points::read(&name, &text)?;
                let mut answer = Answer::default();
                answer.value("format", found.format);
                answer.points("points", found.points);
                Ok(answer)
            }
        }
    }

    fn curve(&self) -> Result<&Loaded, Error> {
        self.loaded.as_ref().ok_or(Error::NoCurve)
    }
}

fn algorithms() -> Answer {
    let mut answer = Answer::default();
    let list: Vec<_> = ALGORITHMS
        .iter()
        .map(|algorithm| {
            let info = algorithm.info();
            let guarantees: Vec<_> = info.guarantees.iter().map(ToString::to_string).collect();
            serde_json::json!({
                "name": info.name,
                "citation": info.citation,
                "guarantees": guarantees,
            })
        })
        .collect();
    answer.value("algorithms", list);
    answer
}

#[cfg(test)]
mod tests;
