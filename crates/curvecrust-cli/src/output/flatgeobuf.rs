//! FlatGeobuf, by the crate of that name: a feature for every shape, in their order, which an index
//! would change.

use super::{Attribute, Attributes, Feature, Kind, Position, Shape};
use crate::points::System;
use flatgeobuf::geozero::error::Result as GeozeroResult;
use flatgeobuf::geozero::{ColumnValue, GeomProcessor, PropertyProcessor};
use flatgeobuf::{
    ColumnType, Error, FgbCrs, FgbWriter, FgbWriterOptions, GeometryType, GeozeroGeometry,
};
use std::io::{self, Write};

/// What the layer is called, as the format asks for a name.
const LAYER: &str = "curves";

/// Positions of a feature, which the format holds in 2^31 bytes.
const MOST: usize = 80_000_000;

pub(super) fn write<'a, P: Attributes>(
    out: &mut dyn Write,
    features: impl Iterator<Item = Feature<'a, P>>,
    system: Option<&System>,
) -> io::Result<()> {
    // What all of them are stands in front of them.
    let features: Vec<Feature<'a, P>> = features.collect();
    let mut kinds = features.iter().map(|feature| kind(&feature.shape));
    let first = kinds.next().unwrap_or(GeometryType::Unknown);
    let kind = match kinds.all(|kind| kind == first) {
        true => first,
        false => GeometryType::Unknown,
    };
    let has_heights = features.iter().any(|f| f.shape.has_heights());
    let options = FgbWriterOptions {
        write_index: false,
        detect_type: false,
        promote_to_multi: false,
        has_z: has_heights,
        crs: system.map(definition).unwrap_or_default(),
        ..FgbWriterOptions::default()
    };
    let writer = FgbWriter::create_with_options(LAYER, kind, options);
    let mut writer = writer.map_err(io::Error::other)?;
    for (name, column) in P::COLUMNS {
        let column = match column {
            Kind::Word => ColumnType::String,
            Kind::Whole => ColumnType::UInt,
            Kind::Real => ColumnType::Double,
        };
        writer.add_column(name, column, |_, _| {});
    }
    for Feature { shape, properties } in features {
        if shape.len() > MOST {
            let message = format!("flatgeobuf holds at most {MOST} points of one curve");
            return Err(io::Error::other(message));
        }
        let mut written = Ok(());
        let added = writer.add_feature_geom(Geometry(&shape), |feature| {
            written = write_properties(feature, &properties);
        });
        added.and(written).map_err(io::Error::other)?;
    }
    writer.write(out).map_err(failure)
}

/// The error of the output, if that is the reason: a reader that closes a pipe is none.
fn failure(error: Error) -> io::Error {
    match error {
        Error::IO(error) => error,
        error => io::Error::other(error),
    }
}

fn kind(shape: &Shape<'_>) -> GeometryType {
    match shape {
        Shape::Polygon(_) => GeometryType::Polygon,
        Shape::Line(_) => GeometryType::LineString,
        Shape::Points(_) => GeometryType::MultiPoint,
        Shape::Segments(_) => GeometryType::MultiLineString,
    }
}

/// The reference system in the terms of the format.
fn definition(system: &System) -> FgbCrs<'_> {
    let code = system.epsg().and_then(|code| i32::try_from(code).ok());
    FgbCrs {
        org: code.map(|_| "EPSG"),
        code: code.unwrap_or_default(),
        name: Some(system.name()),
        wkt: system.text(),
        ..FgbCrs::default()
    }
}

fn write_properties<P: Attributes>(
    feature: &mut impl PropertyProcessor,
    properties: &P,
) -> GeozeroResult<()> {
    let columns = P::COLUMNS.iter().zip(properties.values());
    for (index, ((name, _), value)) in columns.enumerate() {
        let value = match value {
            Attribute::Word(word) => ColumnValue::String(word),
            Attribute::Whole(Some(number)) => ColumnValue::UInt(number),
            Attribute::Real(number) => ColumnValue::Double(number),
            // What is missing has no value.
            Attribute::Whole(None) => continue,
        };
        feature.property(index, name, &value)?;
    }
    Ok(())
}

struct Geometry<'a>(&'a Shape<'a>);

impl GeozeroGeometry for Geometry<'_> {
    fn process_geom<P: GeomProcessor>(&self, to: &mut P) -> GeozeroResult<()> {
        match self.0 {
            Shape::Polygon(rings) => {
                to.polygon_begin(true, rings.len(), 0)?;
                for (index, ring) in rings.iter().enumerate() {
                    to.linestring_begin(false, ring.len() + 1, index)?;
                    positions(to, ring.closed())?;
                    to.linestring_end(false, index)?;
                }
                to.polygon_end(true, 0)
            }
            Shape::Line(line) => {
                to.linestring_begin(true, line.len(), 0)?;
                positions(to, line.positions())?;
                to.linestring_end(true, 0)
            }
            Shape::Points(points) => {
                to.multipoint_begin(points.len(), 0)?;
                positions(to, points.positions())?;
                to.multipoint_end(0)
            }
            Shape::Segments(segments) => {
                to.multilinestring_begin(segments.len(), 0)?;
                for (index, segment) in segments.iter().enumerate() {
                    to.linestring_begin(false, 2, index)?;
                    positions(to, [segment.a, segment.b].map(Position::from))?;
                    to.linestring_end(false, index)?;
                }
                to.multilinestring_end(0)
            }
        }
    }
}

fn positions(
    to: &mut impl GeomProcessor,
    positions: impl IntoIterator<Item = Position>,
) -> GeozeroResult<()> {
    for (index, Position { place, height }) in positions.into_iter().enumerate() {
        match height {
            None => to.xy(place.x, place.y, index)?,
            Some(_) => to.coordinate(place.x, place.y, height, None, None, None, index)?,
        }
    }
    Ok(())
}
