//! GeoJSON (RFC 7946): a collection of features, one a line.

use super::{Feature, Places, Position, Shape, Streamed};
use crate::points::System;
use curvecrust::geometry::Segment;
use serde::ser::{Serialize, SerializeMap, Serializer};
use std::io::{self, Write};

pub(super) fn write<'a, P: Serialize>(
    out: &mut dyn Write,
    features: impl Iterator<Item = Feature<'a, P>>,
    system: Option<&System>,
) -> io::Result<()> {
    write!(out, r#"{{"type":"FeatureCollection","#)?;
    // RFC 7946 knows no other system than that of longitudes and latitudes; maps in metres name
    // theirs as GeoJSON had it before.
    if let Some(code) = system.and_then(System::epsg)
        && code != System::WGS84
    {
        let name = format!("urn:ogc:def:crs:EPSG::{code}");
        write!(
            out,
            r#""crs":{{"type":"name","properties":{{"name":"{name}"}}}},"#
        )?;
    }
    write!(out, r#""features":["#)?;
    for (i, feature) in features.enumerate() {
        write!(out, "{}", if i == 0 { "\n" } else { ",\n" })?;
        serde_json::to_writer(&mut *out, &feature)?;
    }
    writeln!(out, "\n]}}")
}

impl<P: Serialize> Serialize for Feature<'_, P> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(Some(3))?;
        map.serialize_entry("type", "Feature")?;
        map.serialize_entry("properties", &self.properties)?;
        map.serialize_entry("geometry", &self.shape)?;
        map.end()
    }
}

impl Serialize for Shape<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(Some(2))?;
        match self {
            Self::Polygon(rings) => {
                map.serialize_entry("type", "Polygon")?;
                let ring = |ring| Streamed(move || positions(Places::closed(ring)));
                map.serialize_entry("coordinates", &Streamed(|| rings.iter().map(ring)))?;
            }
            Self::Line(line) => {
                map.serialize_entry("type", "LineString")?;
                map.serialize_entry("coordinates", &Streamed(|| positions(line.positions())))?;
            }
            Self::Points(points) => {
                map.serialize_entry("type", "MultiPoint")?;
                map.serialize_entry("coordinates", &Streamed(|| positions(points.positions())))?;
            }
            Self::Segments(segments) => {
                map.serialize_entry("type", "MultiLineString")?;
                let line = |s: &Segment| [s.a.to_array(), s.b.to_array()];
                map.serialize_entry("coordinates", &Streamed(|| segments.iter().map(line)))?;
            }
        }
        map.end()
    }
}

fn positions(positions: impl Iterator<Item = Position>) -> impl Iterator<Item = impl Serialize> {
    positions.map(|position| Streamed(move || position.coordinates()))
}
