//! The values of options, and how they are read.

use crate::format::Format;
use crate::points;
use clap::ValueEnum;
use clap::builder::{PossibleValuesParser, TypedValueParser};
use curvecrust::reconstruct::{ALGORITHMS, Reconstructor};
use std::str::FromStr;

/// Which samples are taken.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum Count {
    /// Greedily, from the best of all starts
    Fewest,
    /// Greedily, from the start of each curve
    Greedy,
    /// Fewer than the condition asks for: as few as HNN-Crust still reconstructs, without a
    /// guarantee
    Verified,
}

/// What is done with corners.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum Corners {
    /// Refuse them, naming each
    Refuse,
    /// Take every smooth piece by itself, with the corners as samples; no theorem covers them
    Split,
}

/// What is done where strokes touch or cross.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum Strokes {
    /// Sample all together; cut those that touch; if that fails, sample each apart
    Auto,
    /// Refuse strokes that touch or cross, naming the place
    Together,
    /// Cut strokes where they touch or cross: one runs through the place, the others end a
    /// hundredth of the extent short of it
    Cut,
    /// Sample each stroke as if it were alone; no reconstruction of all together is promised
    Apart,
}

/// What is carried along with points.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum Keep {
    /// Heights; every point must have one
    Z,
}

/// A length, or a share of the extent of a curve.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Distance {
    Length(f64),
    Percent(f64),
}

impl Distance {
    /// The length that it is for a curve of some extent.
    pub(crate) fn of_extent(self, extent: f64) -> f64 {
        match self {
            Self::Length(length) => length,
            Self::Percent(share) => share / 100.0 * extent,
        }
    }
}

impl FromStr for Distance {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let (number, percent) = match text.strip_suffix('%') {
            Some(number) => (number, true),
            None => (text, false),
        };
        match number.trim().parse::<f64>() {
            Ok(value) if value.is_finite() && value > 0.0 => Ok(if percent {
                Self::Percent(value)
            } else {
                Self::Length(value)
            }),
            _ => Err(String::from(
                "give a length above 0, such as 2.5, or a share, such as 1%",
            )),
        }
    }
}

/// A share in percent, as a number of at most 1.
pub(super) fn percent(text: &str) -> Result<f64, String> {
    let number = text.strip_suffix('%').unwrap_or(text).trim();
    match number.parse::<f64>() {
        Ok(percent) if (0.0..=100.0).contains(&percent) => Ok(percent / 100.0),
        _ => Err(String::from("give a share from 0% to 100%, such as 0.01%")),
    }
}

/// A share of the local feature size.
pub(super) fn share(text: &str) -> Result<f64, String> {
    match text.parse::<f64>() {
        Ok(share) if share > 0.0 && share <= 1.0 => Ok(share),
        _ => Err(String::from(
            "give a share above 0 and at most 1, such as 0.02",
        )),
    }
}

/// The formats that points are read from.
pub(super) fn readable() -> impl TypedValueParser<Value = Format> {
    let values = points::FORMATS.iter().filter_map(Format::to_possible_value);
    PossibleValuesParser::new(values).try_map(|name| Format::from_str(&name, false))
}

/// An algorithm of the library.
pub(crate) type Algorithm = &'static dyn Reconstructor;

/// An algorithm, by its name.
pub(super) fn algorithm() -> impl TypedValueParser<Value = Algorithm> {
    let all = ALGORITHMS.iter().copied();
    PossibleValuesParser::new(all.clone().map(|algorithm| algorithm.info().name)).try_map(
        move |name| {
            let mut all = all.clone();
            all.find(|algorithm| algorithm.info().name == name)
                .ok_or("see `curvecrust algorithms`")
        },
    )
}
