//! GeoJSON (RFC 7946): a collection of features, one a line.

use super::Shape;
use curvecrust::DVec2;
use serde::ser::{Serialize, SerializeMap, Serializer};
use serde_json::{Map, Value};
use std::io::{self, Write};

/// A shape and what is known about it.
#[derive(Debug)]
pub(crate) struct Feature {
    pub(crate) shape: Shape,
    pub(crate) properties: Map<String, Value>,
}

pub(super) fn write(out: &mut dyn Write, features: &[Feature]) -> io::Result<()> {
    write!(out, r#"{{"type":"FeatureCollection","features":["#)?;
    for (i, feature) in features.iter().enumerate() {
        write!(out, "{}", if i == 0 { "\n" } else { ",\n" })?;
        serde_json::to_writer(&mut *out, feature)?;
    }
    writeln!(out, "\n]}}")
}

impl Serialize for Feature {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(Some(3))?;
        map.serialize_entry("type", "Feature")?;
        map.serialize_entry("properties", &self.properties)?;
        map.serialize_entry("geometry", &self.shape)?;
        map.end()
    }
}

impl Serialize for Shape {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(Some(2))?;
        match self {
            Self::Polygon(rings) => {
                map.serialize_entry("type", "Polygon")?;
                let closed = |ring: &Vec<DVec2>| positions(ring.iter().chain(ring.first()));
                let rings: Vec<_> = rings.iter().map(closed).collect();
                map.serialize_entry("coordinates", &rings)?;
            }
            Self::Line(line) => {
                map.serialize_entry("type", "LineString")?;
                map.serialize_entry("coordinates", &positions(line))?;
            }
            Self::Points(points) => {
                map.serialize_entry("type", "MultiPoint")?;
                map.serialize_entry("coordinates", &positions(points))?;
            }
            Self::Segments(segments) => {
                map.serialize_entry("type", "MultiLineString")?;
                let lines = segments.iter().map(|s| positions([&s.a, &s.b]));
                map.serialize_entry("coordinates", &lines.collect::<Vec<_>>())?;
            }
        }
        map.end()
    }
}

fn positions<'a>(points: impl IntoIterator<Item = &'a DVec2>) -> Vec<[f64; 2]> {
    points.into_iter().map(|p| p.to_array()).collect()
}
