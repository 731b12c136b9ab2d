//! JSON: an array of `[x, y]`, or an object with such an array as `points` or `samples`, such as the
//! program prints. An object with a `type` is GeoJSON.

use super::{Flaw, Place, Problem, geojson, in_range};
use curvecrust::DVec2;
use serde::Deserialize;
use serde::de::{DeserializeOwned, Deserializer, Error, IgnoredAny, SeqAccess, Visitor};
use std::fmt;

/// What is looked at in an object.
#[derive(Deserialize)]
struct Object {
    r#type: Option<IgnoredAny>,
    points: Option<Vec<Pair>>,
    samples: Option<Vec<Pair>>,
}

/// A point, written as `[x, y]`.
pub(super) struct Pair(pub(super) DVec2);

pub(super) fn read(bytes: &[u8]) -> Result<Vec<DVec2>, Flaw> {
    let pairs: Vec<Pair> = if bytes.trim_ascii_start().starts_with(b"[") {
        parse(bytes)?
    } else {
        let object: Object = parse(bytes)?;
        match (object.r#type, object.points, object.samples) {
            (Some(_), ..) => return geojson::read(bytes),
            (None, Some(points), None) | (None, None, Some(points)) => points,
            (None, None, None) => return Err(Problem::NoArray.into()),
            (None, Some(_), Some(_)) => return Err(Problem::TwoArrays.into()),
        }
    };
    Ok(pairs.into_iter().map(|pair| pair.0).collect())
}

/// Parses JSON; errors know their place.
pub(super) fn parse<T: DeserializeOwned>(bytes: &[u8]) -> Result<T, Flaw> {
    serde_json::from_slice(bytes).map_err(|error| {
        let (line, column) = (error.line(), error.column());
        let message = error.to_string();
        let suffix = format!(" at line {line} column {column}");
        let message = message.strip_suffix(&suffix).unwrap_or(&message);
        Problem::Json(message.to_owned()).at(Place::Column(line as u64, column))
    })
}

impl<'de> Deserialize<'de> for Pair {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_seq(PairVisitor)
    }
}

struct PairVisitor;

impl<'de> Visitor<'de> for PairVisitor {
    type Value = Pair;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a point [x, y]")
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut seq: A) -> Result<Pair, A::Error> {
        let mut next = || -> Result<f64, A::Error> {
            let value: Option<f64> = seq.next_element()?;
            let value =
                value.ok_or_else(|| A::Error::custom("a point is [x, y], but here is less"))?;
            in_range(value, || value.to_string()).map_err(A::Error::custom)
        };
        let point = DVec2::new(next()?, next()?);
        match seq.next_element::<IgnoredAny>()? {
            None => Ok(Pair(point)),
            Some(_) => Err(A::Error::custom("a point is [x, y], but here is more")),
        }
    }
}
