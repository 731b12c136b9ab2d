//! GeoParquet 1.1, by the crate `parquet`: a row for every shape, as well-known binary, beside
//! columns of what is known about it. <https://geoparquet.org/releases/v1.1.0/>

use super::{Attribute, Attributes, Feature, Kind, Position, Shape, wkb};
use crate::points::System;
use parquet::basic::{Compression, LogicalType, Repetition, Type};
use parquet::data_type::{ByteArray, ByteArrayType, DoubleType, Int32Type};
use parquet::errors::{ParquetError, Result as ParquetResult};
use parquet::file::metadata::KeyValue;
use parquet::file::properties::{EnabledStatistics, WriterProperties};
use parquet::file::writer::{SerializedColumnWriter, SerializedFileWriter};
use parquet::schema::types::{ColumnPath, Type as SchemaType};
use serde_json::{Value, json};
use std::collections::BTreeSet;
use std::io::{self, Write};
use std::sync::Arc;

/// The column of the shapes.
const GEOMETRY: &str = "geometry";

/// Bytes of shapes that are held before they are written as a group of rows.
const GROUP: usize = 1 << 26;

pub(super) fn write<'a, P: Attributes>(
    out: &mut (dyn Write + Send),
    features: impl Iterator<Item = Feature<'a, P>>,
    system: Option<&System>,
) -> io::Result<()> {
    let schema = Arc::new(schema(P::COLUMNS).map_err(failure)?);
    let writer = SerializedFileWriter::new(out, schema, Arc::new(properties()));
    let mut writer = writer.map_err(failure)?;
    let mut extent = Extent::default();
    let mut group = Group::default();
    for Feature { shape, properties } in features {
        extent.take(&shape);
        group.take(wkb::bytes(&shape)?, properties.values());
        if group.bytes >= GROUP {
            group.write(P::COLUMNS, &mut writer).map_err(failure)?;
        }
    }
    group.write(P::COLUMNS, &mut writer).map_err(failure)?;
    let geo = extent.metadata(system).to_string();
    writer.append_key_value_metadata(KeyValue::new("geo".to_owned(), geo));
    writer.close().map_err(failure)?;
    Ok(())
}

/// Whether the format can name a reference system: without an entry it is that of longitudes and
/// latitudes, else PROJJSON.
pub(super) fn names(system: &System) -> bool {
    system.epsg() == Some(System::WGS84) || system.json().is_some()
}

/// The error of the output, if that is the reason: a reader that closes a pipe is none.
fn failure(error: ParquetError) -> io::Error {
    match error {
        ParquetError::External(error) => match error.downcast::<io::Error>() {
            Ok(error) => *error,
            Err(error) => io::Error::other(error),
        },
        error => io::Error::other(error),
    }
}

fn schema(columns: &[(&str, Kind)]) -> ParquetResult<SchemaType> {
    let primitive = SchemaType::primitive_type_builder;
    let geometry = primitive(GEOMETRY, Type::BYTE_ARRAY).with_repetition(Repetition::REQUIRED);
    let mut fields = vec![Arc::new(geometry.build()?)];
    for (name, kind) in columns {
        let field = match kind {
            Kind::Word => primitive(name, Type::BYTE_ARRAY)
                .with_logical_type(Some(LogicalType::String))
                .with_repetition(Repetition::REQUIRED),
            Kind::Whole => primitive(name, Type::INT32)
                .with_logical_type(Some(LogicalType::integer(32, false)))
                .with_repetition(Repetition::OPTIONAL),
            Kind::Real => primitive(name, Type::DOUBLE).with_repetition(Repetition::REQUIRED),
        };
        fields.push(Arc::new(field.build()?));
    }
    SchemaType::group_type_builder("schema")
        .with_fields(fields)
        .build()
}

fn properties() -> WriterProperties {
    let geometry = ColumnPath::from(GEOMETRY);
    WriterProperties::builder()
        .set_created_by(concat!("curvecrust ", env!("CARGO_PKG_VERSION")).to_owned())
        .set_compression(Compression::SNAPPY)
        // The least and the largest of bytes say nothing, nor are there any twice.
        .set_column_statistics_enabled(geometry.clone(), EnabledStatistics::None)
        .set_column_dictionary_enabled(geometry, false)
        .build()
}

/// Rows that were not written yet.
#[derive(Default)]
struct Group {
    shapes: Vec<ByteArray>,
    values: Vec<Vec<Attribute>>,
    bytes: usize,
}

impl Group {
    fn take(&mut self, shape: Vec<u8>, values: Vec<Attribute>) {
        self.bytes += shape.len();
        self.shapes.push(shape.into());
        self.values.push(values);
    }

    /// Writes the rows, if there are any, and forgets them.
    fn write<W: Write + Send>(
        &mut self,
        columns: &[(&str, Kind)],
        writer: &mut SerializedFileWriter<W>,
    ) -> ParquetResult<()> {
        let Self { shapes, values, .. } = std::mem::take(self);
        if shapes.is_empty() {
            return Ok(());
        }
        let mut group = writer.next_row_group()?;
        if let Some(mut column) = group.next_column()? {
            column
                .typed::<ByteArrayType>()
                .write_batch(&shapes, None, None)?;
            column.close()?;
        }
        drop(shapes);
        for (index, (_, kind)) in columns.iter().enumerate() {
            if let Some(column) = group.next_column()? {
                write_column(column, *kind, values.iter().map(|row| row[index]))?;
            }
        }
        group.close()?;
        Ok(())
    }
}

/// Writes the values of a column, which are of its kind.
fn write_column(
    mut column: SerializedColumnWriter<'_>,
    kind: Kind,
    values: impl Iterator<Item = Attribute>,
) -> ParquetResult<()> {
    match kind {
        Kind::Word => {
            let words = values.filter_map(|value| match value {
                Attribute::Word(word) => Some(ByteArray::from(word)),
                _ => None,
            });
            let words: Vec<_> = words.collect();
            column
                .typed::<ByteArrayType>()
                .write_batch(&words, None, None)?;
        }
        Kind::Whole => {
            let numbers = values.map(|value| match value {
                Attribute::Whole(number) => number.map(u32::cast_signed),
                _ => None,
            });
            let numbers: Vec<_> = numbers.collect();
            let levels: Vec<i16> = numbers.iter().map(|n| n.is_some().into()).collect();
            let numbers: Vec<i32> = numbers.into_iter().flatten().collect();
            column
                .typed::<Int32Type>()
                .write_batch(&numbers, Some(&levels), None)?;
        }
        Kind::Real => {
            let numbers = values.filter_map(|value| match value {
                Attribute::Real(number) => Some(number),
                _ => None,
            });
            let numbers: Vec<_> = numbers.collect();
            column
                .typed::<DoubleType>()
                .write_batch(&numbers, None, None)?;
        }
    }
    column.close()
}

/// What the metadata say of all shapes.
#[derive(Default)]
struct Extent {
    /// The least and the largest of each coordinate.
    bounds: Vec<[f64; 2]>,
    kinds: BTreeSet<&'static str>,
    has_heights: bool,
}

impl Extent {
    fn take(&mut self, shape: &Shape<'_>) {
        self.has_heights |= shape.has_heights();
        match shape {
            Shape::Polygon(rings) => {
                self.kinds.insert("Polygon");
                rings.iter().for_each(|ring| self.expand(ring.positions()));
            }
            Shape::Line(line) => {
                self.kinds.insert("LineString");
                self.expand(line.positions());
            }
            Shape::Points(points) => {
                self.kinds.insert("MultiPoint");
                self.expand(points.positions());
            }
            Shape::Segments(segments) => {
                self.kinds.insert("MultiLineString");
                self.expand(segments.iter().flat_map(|s| [s.a, s.b].map(Position::from)));
            }
        }
    }

    fn expand(&mut self, positions: impl Iterator<Item = Position>) {
        for position in positions {
            for (index, number) in position.coordinates().enumerate() {
                match self.bounds.get_mut(index) {
                    Some([low, high]) => (*low, *high) = (low.min(number), high.max(number)),
                    None => self.bounds.push([number; 2]),
                }
            }
        }
    }

    fn metadata(&self, system: Option<&System>) -> Value {
        let z = if self.has_heights { " Z" } else { "" };
        let kinds = self.kinds.iter().map(|kind| format!("{kind}{z}"));
        let mut column = json!({
            "encoding": "WKB",
            "geometry_types": kinds.collect::<Vec<_>>(),
            "orientation": "counterclockwise",
        });
        if !self.bounds.is_empty() {
            let low = self.bounds.iter().map(|[low, _]| *low);
            let high = self.bounds.iter().map(|[_, high]| *high);
            column["bbox"] = low.chain(high).collect::<Vec<_>>().into();
        }
        // Without an entry the system is that of longitudes and latitudes; null stands for one that
        // is not known.
        match system {
            Some(system) if system.epsg() == Some(System::WGS84) => {}
            system => column["crs"] = system.and_then(System::json).cloned().into(),
        }
        json!({
            "version": "1.1.0",
            "primary_column": GEOMETRY,
            "columns": {GEOMETRY: column},
        })
    }
}
