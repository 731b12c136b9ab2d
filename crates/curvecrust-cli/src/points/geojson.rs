//! GeoJSON (RFC 7946), by the crate of that name: the positions of all `Point`s and `MultiPoint`s,
//! in order; the vertices of lines and polygons on request.

use super::gathered::{Gathered, Vertex};
use super::json_text::parse;
use super::system::System;
use super::{Flaw, Place, PointList, Problem, ReadOptions};
use geojson::{GeoJson, Geometry, GeometryValue, Position};
use serde_json::Value;

pub(super) fn read(bytes: &[u8], options: &ReadOptions) -> Result<PointList, Flaw> {
    let mut found = Gathered::new(options);
    found.go_to(Place::Position(None, 0));
    match parse(bytes)? {
        GeoJson::Geometry(geometry) => collect(&mut found, &geometry)?,
        // A feature without a geometry is no place.
        GeoJson::Feature(feature) => {
            let mut geometry = feature.geometry.iter();
            geometry.try_for_each(|g| collect(&mut found, g))?;
        }
        GeoJson::FeatureCollection(collection) => {
            let members = collection.foreign_members.as_ref();
            if let Some(system) = members.and_then(|members| system(members.get("crs")?)) {
                found.system(system);
            }
            for (index, feature) in collection.features.iter().enumerate() {
                found.go_to(Place::Position(Some(index + 1), 0));
                let mut geometry = feature.geometry.iter();
                geometry.try_for_each(|g| collect(&mut found, g))?;
            }
        }
    }
    Ok(found.finish())
}

/// The reference system of GeoJSON before RFC 7946, which maps in metres have to this day:
/// `urn:ogc:def:crs:EPSG::25832` or `EPSG:25832`.
fn system(crs: &Value) -> Option<System> {
    let name = crs.get("properties")?.get("name")?.as_str()?;
    let mut parts = name.rsplit(':');
    let (code, mut authority) = (parts.next()?, parts);
    match code.parse() {
        Ok(code) if authority.any(|part| part == "EPSG") => Some(System::of_epsg(code)),
        _ if code == "CRS84" => Some(System::of_longitudes("OGC:CRS84")),
        _ => None,
    }
}

fn collect(found: &mut Gathered, geometry: &Geometry) -> Result<(), Flaw> {
    let name = geometry.value.type_name();
    match &geometry.value {
        GeometryValue::Point { coordinates } => take(found, coordinates, name),
        GeometryValue::MultiPoint { coordinates } => {
            let mut positions = coordinates.iter();
            positions.try_for_each(|position| take(found, position, name))
        }
        GeometryValue::GeometryCollection { geometries } => {
            geometries.iter().try_for_each(|g| collect(found, g))
        }
        GeometryValue::LineString { coordinates } => take_line(found, coordinates, name),
        GeometryValue::MultiLineString { coordinates } | GeometryValue::Polygon { coordinates } => {
            let mut lines = coordinates.iter();
            lines.try_for_each(|line| take_line(found, line, name))
        }
        GeometryValue::MultiPolygon { coordinates } => {
            let mut rings = coordinates.iter().flatten();
            rings.try_for_each(|ring| take_line(found, ring, name))
        }
    }
}

/// The vertices of a line, of a closed one the first once.
fn take_line(found: &mut Gathered, line: &[Position], of: &str) -> Result<(), Flaw> {
    found.wants_vertices(of)?;
    let vertices = line.iter().map(|position| Ok(coordinates(position, of)?));
    found.line(vertices)
}

fn take(found: &mut Gathered, position: &Position, of: &str) -> Result<(), Flaw> {
    let vertex = coordinates(position, of).map_err(|problem| found.flaw(problem))?;
    found.point(vertex)
}

/// The first two numbers of a position, and the third if there is one.
fn coordinates(position: &Position, of: &str) -> Result<Vertex, Problem> {
    match position.as_slice() {
        [x, y, rest @ ..] => Ok(([*x, *y], rest.first().copied())),
        _ => Err(Problem::Coordinates(of.to_owned())),
    }
}
