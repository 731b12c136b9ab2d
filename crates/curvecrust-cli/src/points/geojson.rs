//! GeoJSON (RFC 7946): the positions of all `Point`s and `MultiPoint`s, in order.
//!
//! Read by serde itself, so that errors name line and column.

use super::json::parse;
use super::{Flaw, Problem, in_range};
use curvecrust::DVec2;
use serde::Deserialize;
use serde::de::{Deserializer, Error, SeqAccess, Visitor};
use std::fmt;

/// Any object of GeoJSON.
#[derive(Deserialize)]
struct Object {
    r#type: String,
    coordinates: Option<Coordinates>,
    geometry: Option<Box<Object>>,
    #[serde(default)]
    geometries: Vec<Object>,
    #[serde(default)]
    features: Vec<Object>,
}

/// Numbers in arrays, of any depth.
enum Coordinates {
    Number(f64),
    Array(Vec<Coordinates>),
}

pub(super) fn read(bytes: &[u8]) -> Result<Vec<DVec2>, Flaw> {
    let mut points = Vec::new();
    collect(&parse(bytes)?, &mut points)?;
    Ok(points)
}

fn collect(object: &Object, points: &mut Vec<DVec2>) -> Result<(), Problem> {
    let missing = || Problem::Coordinates(object.r#type.clone());
    match object.r#type.as_str() {
        "FeatureCollection" => object.features.iter().try_for_each(|f| collect(f, points)),
        "GeometryCollection" => object
            .geometries
            .iter()
            .try_for_each(|g| collect(g, points)),
        // A feature without a geometry is no place.
        "Feature" => object.geometry.iter().try_for_each(|g| collect(g, points)),
        "Point" => {
            points.push(position(object.coordinates.as_ref()).ok_or_else(missing)?);
            Ok(())
        }
        "MultiPoint" => {
            let Some(Coordinates::Array(positions)) = &object.coordinates else {
                return Err(missing());
            };
            for place in positions {
                points.push(position(Some(place)).ok_or_else(missing)?);
            }
            Ok(())
        }
        other => Err(Problem::Geometry(other.to_owned())),
    }
}

fn position(coordinates: Option<&Coordinates>) -> Option<DVec2> {
    match coordinates? {
        Coordinates::Array(values) => match values[..] {
            [Coordinates::Number(x), Coordinates::Number(y)] => Some(DVec2::new(x, y)),
            _ => None,
        },
        Coordinates::Number(_) => None,
    }
}

impl<'de> Deserialize<'de> for Coordinates {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(CoordinatesVisitor)
    }
}

struct CoordinatesVisitor;

impl<'de> Visitor<'de> for CoordinatesVisitor {
    type Value = Coordinates;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a number or an array")
    }

    fn visit_f64<E: Error>(self, value: f64) -> Result<Coordinates, E> {
        let value = in_range(value, || value.to_string()).map_err(E::custom)?;
        Ok(Coordinates::Number(value))
    }

    fn visit_i64<E: Error>(self, value: i64) -> Result<Coordinates, E> {
        Ok(Coordinates::Number(value as f64))
    }

    fn visit_u64<E: Error>(self, value: u64) -> Result<Coordinates, E> {
        Ok(Coordinates::Number(value as f64))
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut seq: A) -> Result<Coordinates, A::Error> {
        let mut values = Vec::new();
        while let Some(value) = seq.next_element()? {
            values.push(value);
        }
        Ok(Coordinates::Array(values))
    }
}
