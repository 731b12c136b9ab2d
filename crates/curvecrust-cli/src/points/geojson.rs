//! GeoJSON (RFC 7946), by the crate of that name: the positions of all `Point`s and `MultiPoint`s, in
//! order.

use super::json::parse;
use super::{Flaw, Problem, in_range};
use curvecrust::DVec2;
use geojson::{GeoJson, Geometry, GeometryValue, Position};

pub(super) fn read(bytes: &[u8]) -> Result<Vec<DVec2>, Flaw> {
    let geometries = match parse(bytes)? {
        GeoJson::Geometry(geometry) => vec![geometry],
        // A feature without a geometry is no place.
        GeoJson::Feature(feature) => Vec::from_iter(feature.geometry),
        GeoJson::FeatureCollection(collection) => {
            let features = collection.features.into_iter();
            features.filter_map(|feature| feature.geometry).collect()
        }
    };
    let mut points = Vec::new();
    geometries
        .iter()
        .try_for_each(|geometry| collect(geometry, &mut points))?;
    Ok(points)
}

fn collect(geometry: &Geometry, points: &mut Vec<DVec2>) -> Result<(), Problem> {
    match &geometry.value {
        GeometryValue::Point { coordinates } => points.push(place(coordinates, "Point")?),
        GeometryValue::MultiPoint { coordinates } => {
            for position in coordinates {
                points.push(place(position, "MultiPoint")?);
            }
        }
        GeometryValue::GeometryCollection { geometries } => {
            for geometry in geometries {
                collect(geometry, points)?;
            }
        }
        other => return Err(Problem::Geometry(other.type_name().to_owned())),
    }
    Ok(())
}

fn place(position: &Position, of: &str) -> Result<DVec2, Problem> {
    let [x, y] = *position.as_slice() else {
        return Err(Problem::Coordinates(of.to_owned()));
    };
    let value = |value: f64| in_range(value, || value.to_string());
    Ok(DVec2::new(value(x)?, value(y)?))
}
