//! Numbers in the attributes of SVG: lists of points, lengths and transforms.
//!
//! Whatever cannot be read to its end is an error; nothing is cut off.

use glam::DVec2;
use svgtypes::{LengthUnit, NumberListParser};
use thiserror::Error;

pub use glam::DAffine2;

/// Why the value of an attribute cannot be read. Messages are to be put behind its name.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
#[non_exhaustive]
pub enum ValueError {
    /// Something else stands among the numbers, or one of them is not finite.
    #[error("is no list of numbers: {message}")]
    NumberList {
        /// What is wrong, and at which character.
        message: String,
    },
    /// The last point has no y.
    #[error("has an odd number of coordinates: give pairs")]
    OddCount,
    /// This is not a finite number with or without a unit.
    #[error("is not a length: give a number")]
    Length,
    /// This is not a list of transforms.
    #[error("is no list of transforms: {message}")]
    Transform {
        /// What is wrong, and at which character.
        message: String,
    },
}

/// A length.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Length {
    /// In user units, which are pixels of 1/96 inch.
    Absolute(f64),
    /// In percent of the size of the viewport.
    Percent(f64),
    /// In units of the font: `em` or `ex`.
    OfFont(f64),
}

impl Length {
    /// The number that was written, in whatever unit.
    #[must_use]
    pub fn sign(self) -> f64 {
        let (Self::Absolute(number) | Self::Percent(number) | Self::OfFont(number)) = self;
        number
    }
}

/// The points of a `polyline` or `polygon`; none for an empty list.
///
/// # Errors
/// [`ValueError::NumberList`] or [`ValueError::OddCount`].
///
/// ```
/// use curvecrust_curve::svg::value::{ValueError, points};
///
/// assert_eq!(points("0,0 1,2")?.len(), 2);
/// assert_eq!(points("0,0 1"), Err(ValueError::OddCount));
/// assert!(points("0,0 1,2 foo 3,3").unwrap_err().to_string().contains("position 9"));
/// # Ok::<(), ValueError>(())
/// ```
pub fn points(value: &str) -> Result<Vec<DVec2>, ValueError> {
    let numbers: Result<Vec<f64>, _> = NumberListParser::from(value).collect();
    let numbers = numbers.map_err(|error| ValueError::NumberList {
        message: error.to_string(),
    })?;
    let (pairs, rest) = numbers.as_chunks();
    if rest.is_empty() {
        Ok(pairs.iter().map(|&pair| DVec2::from_array(pair)).collect())
    } else {
        Err(ValueError::OddCount)
    }
}

/// A length with its unit.
///
/// # Errors
/// [`ValueError::Length`].
pub fn length(value: &str) -> Result<Length, ValueError> {
    let length = value.trim().parse::<svgtypes::Length>();
    let svgtypes::Length { number, unit } = length.map_err(|_| ValueError::Length)?;
    if !number.is_finite() {
        return Err(ValueError::Length);
    }
    Ok(match unit {
        LengthUnit::None | LengthUnit::Px => Length::Absolute(number),
        LengthUnit::In => Length::Absolute(number * 96.0),
        LengthUnit::Cm => Length::Absolute(number * (96.0 / 2.54)),
        LengthUnit::Mm => Length::Absolute(number * (96.0 / 25.4)),
        LengthUnit::Pt => Length::Absolute(number * (4.0 / 3.0)),
        LengthUnit::Pc => Length::Absolute(number * 16.0),
        LengthUnit::Percent => Length::Percent(number),
        LengthUnit::Em | LengthUnit::Ex => Length::OfFont(number),
    })
}

/// The product of a list of transforms; the identity for `none` or an empty list.
///
/// # Errors
/// [`ValueError::Transform`].
pub fn transform(value: &str) -> Result<DAffine2, ValueError> {
    if value.trim() == "none" {
        return Ok(DAffine2::IDENTITY);
    }
    let parsed = value.parse::<svgtypes::Transform>();
    let t = parsed.map_err(|error| ValueError::Transform {
        message: error.to_string(),
    })?;
    Ok(DAffine2::from_cols_array(&[t.a, t.b, t.c, t.d, t.e, t.f]))
}
