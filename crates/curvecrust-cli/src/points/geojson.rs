//! GeoJSON (RFC 7946), by the crate of that name: the positions of all `Point`s and `MultiPoint`s,
//! in order, without their heights; the vertices of lines and polygons on request.

use super::json_text::parse;
use super::{Flaw, Place, PointList, Problem, in_double_range, opened};
use curvecrust::DVec2;
use geojson::{GeoJson, Geometry, GeometryValue, Position};

pub(super) fn read(bytes: &[u8], vertices: bool) -> Result<PointList, Flaw> {
    let mut positions = Positions {
        vertices,
        ..Positions::default()
    };
    match parse(bytes)? {
        GeoJson::Geometry(geometry) => positions.collect(&geometry)?,
        GeoJson::Feature(feature) => {
            // A feature without a geometry is no place.
            feature
                .geometry
                .iter()
                .try_for_each(|g| positions.collect(g))?;
        }
        GeoJson::FeatureCollection(collection) => {
            for (index, feature) in collection.features.iter().enumerate() {
                positions.feature = Some(index + 1);
                positions.count = 0;
                feature
                    .geometry
                    .iter()
                    .try_for_each(|g| positions.collect(g))?;
            }
        }
    }
    let Positions {
        points,
        has_heights,
        ..
    } = positions;
    Ok(PointList::with_heights(points, has_heights))
}

#[derive(Default)]
struct Positions {
    points: Vec<DVec2>,
    has_heights: bool,
    /// Whether vertices count as points.
    vertices: bool,
    /// The number of the feature that is being read, in a collection.
    feature: Option<usize>,
    /// The number of positions of this feature so far.
    count: usize,
}

impl Positions {
    fn collect(&mut self, geometry: &Geometry) -> Result<(), Flaw> {
        match &geometry.value {
            GeometryValue::Point { coordinates } => self.take(coordinates, "Point"),
            GeometryValue::MultiPoint { coordinates } => {
                let mut positions = coordinates.iter();
                positions.try_for_each(|position| self.take(position, "MultiPoint"))
            }
            GeometryValue::GeometryCollection { geometries } => {
                geometries.iter().try_for_each(|g| self.collect(g))
            }
            GeometryValue::LineString { coordinates } if self.vertices => {
                self.take_line(coordinates, "LineString")
            }
            GeometryValue::MultiLineString { coordinates } if self.vertices => {
                let mut lines = coordinates.iter();
                lines.try_for_each(|line| self.take_line(line, "MultiLineString"))
            }
            GeometryValue::Polygon { coordinates } if self.vertices => {
                let mut rings = coordinates.iter();
                rings.try_for_each(|ring| self.take_line(ring, "Polygon"))
            }
            GeometryValue::MultiPolygon { coordinates } if self.vertices => {
                let mut rings = coordinates.iter().flatten();
                rings.try_for_each(|ring| self.take_line(ring, "MultiPolygon"))
            }
            other => {
                let problem = Problem::Geometry(other.type_name().to_owned());
                Err(match self.feature {
                    Some(feature) => problem.at(Place::Feature(feature)),
                    None => problem.into(),
                })
            }
        }
    }

    /// The vertices of a line, of a closed one the first once.
    fn take_line(&mut self, line: &[Position], of: &str) -> Result<(), Flaw> {
        let mut line = opened(line, |a, b| a == b).iter();
        line.try_for_each(|position| self.take(position, of))
    }

    fn take(&mut self, position: &Position, of: &str) -> Result<(), Flaw> {
        self.count += 1;
        let place = Place::Position(self.feature, self.count);
        let [x, y, heights @ ..] = position.as_slice() else {
            return Err(Problem::Coordinates(of.to_owned()).at(place));
        };
        let value = |value: f64| in_double_range(value).map_err(|problem| problem.at(place));
        self.points.push(DVec2::new(value(*x)?, value(*y)?));
        self.has_heights |= !heights.is_empty();
        Ok(())
    }
}
