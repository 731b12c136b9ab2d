//! Points from files, one module a format. See `docs/formats.md`.

mod columns;
mod content;
mod csv_records;
#[cfg(feature = "flatgeobuf")]
mod flatgeobuf;
mod flaw;
mod gathered;
mod geojson;
mod gpx;
mod heights;
mod json;
mod json_text;
mod kml;
#[cfg(feature = "las")]
mod las;
pub(crate) mod npy;
#[cfg(feature = "npz")]
mod npz;
mod obj;
#[cfg(feature = "parquet")]
pub(crate) mod parquet;
#[cfg(feature = "ply")]
mod ply;
mod quote;
mod records;
mod separator;
#[cfg(feature = "shapefile")]
mod shapefile;
mod svg;
mod system;
mod table;
mod text_records;
#[cfg(any(feature = "las", feature = "npz", feature = "parquet"))]
mod unpacked;
mod value;
#[cfg(feature = "wkb")]
mod wkb;
mod wkt;
mod xml;

pub(crate) use columns::ColumnNames;
pub(crate) use flaw::{Flaw, Place, PointsError, Problem};
pub(crate) use heights::LEFT_OUT as HEIGHTS;
#[cfg(feature = "las")]
pub(crate) use las::serve as serve_decoder;
pub(crate) use system::System;

use crate::format::Format;
use crate::input::{self, Source};
use curvecrust::DVec2;
use heights::Heights;
use quote::quoted;
use separator::Separator;
use std::path::Path;
use value::{coordinate, in_double_range, is_number};

/// The formats that points are read from.
pub(crate) const FORMATS: &[Format] = &[
    Format::Csv,
    Format::Text,
    Format::Json,
    Format::Geojson,
    Format::Wkt,
    Format::Gpx,
    Format::Kml,
    Format::Obj,
    Format::Npy,
    Format::Svg,
    #[cfg(feature = "npz")]
    Format::Npz,
    #[cfg(feature = "ply")]
    Format::Ply,
    #[cfg(feature = "wkb")]
    Format::Wkb,
    #[cfg(feature = "shapefile")]
    Format::Shapefile,
    #[cfg(feature = "las")]
    Format::Las,
    #[cfg(feature = "flatgeobuf")]
    Format::Flatgeobuf,
    #[cfg(feature = "parquet")]
    Format::Parquet,
];

/// What was read from a file.
#[derive(Debug, Default)]
pub(crate) struct PointList {
    /// The points, finite and of magnitudes that a point set can hold; some may be equal.
    pub(crate) points: Vec<DVec2>,
    /// The height of every point, if heights were wanted.
    pub(crate) heights: Option<Vec<f64>>,
    /// The reference system of the coordinates, if the file names exactly one.
    pub(crate) system: Option<System>,
    /// What the user should know about how they were read.
    pub(crate) notes: Vec<String>,
}

/// How points are read.
#[derive(Clone, Debug, Default)]
pub(crate) struct ReadOptions {
    /// The columns of a table; `None`: those with names that are known.
    pub(crate) columns: Option<ColumnNames>,
    /// Whether vertices of lines and polygons are points.
    pub(crate) vertices: bool,
    /// Whether heights are kept, which every point must have then.
    pub(crate) heights: bool,
    /// Whether only those are read that are marked as ends of curves, if any are.
    pub(crate) termini: bool,
}

/// Reads points, of which there must be at least one.
///
/// The format is that of the content's magic number, else the one given, else that of the file's
/// name, else what the content looks like.
pub(crate) fn read(
    path: &Path,
    from: Option<Format>,
    options: &ReadOptions,
) -> Result<PointList, PointsError> {
    Source::open(path)
        .map_err(Flaw::from)
        .and_then(|source| read_source(source, from, Format::of_content_named(path), options))
        .map_err(|flaw| PointsError::new(input::name(path), flaw))
}

/// The same from an opened source, in the format asked for or that of its name.
pub(crate) fn read_source(
    mut source: Source,
    asked: Option<Format>,
    named: Option<Format>,
    options: &ReadOptions,
) -> Result<PointList, Flaw> {
    if source.head().is_empty() {
        return Err(Problem::NoPoints.into());
    }
    let format = content::format_of(&mut source, asked, named)?;
    let names = options.columns.as_ref();
    let has_columns = [
        Format::Csv,
        Format::Text,
        Format::Npz,
        Format::Ply,
        Format::Parquet,
    ];
    if names.is_some() && !has_columns.contains(&format) {
        return Err(Problem::NoTable(format).into());
    }
    let list = match format {
        Format::Csv => table::read(source, Separator::Byte(b','), options),
        Format::Text => table::read(source, Separator::WhiteSpace, options),
        Format::Npy => npy::read(source.into_reader(), options),
        Format::Json => json::read(&source.into_bytes()?, options),
        Format::Geojson => geojson::read(&source.into_bytes()?, options),
        Format::Wkt => wkt::read(&source.into_bytes()?, options),
        Format::Gpx => gpx::read(&source.into_bytes()?, options),
        Format::Kml => kml::read(&source.into_bytes()?, options),
        Format::Obj => obj::read(&source.into_bytes()?, options),
        Format::Svg => svg::read(&source.into_bytes()?),
        #[cfg(feature = "npz")]
        Format::Npz => npz::read(source.into_seekable()?, options),
        #[cfg(feature = "ply")]
        Format::Ply => ply::read(source.into_reader(), options),
        #[cfg(feature = "wkb")]
        Format::Wkb => wkb::read(&source.into_bytes()?, options),
        #[cfg(feature = "shapefile")]
        Format::Shapefile => shapefile::read(source, options),
        #[cfg(feature = "las")]
        Format::Las => las::read(source, options),
        #[cfg(feature = "flatgeobuf")]
        Format::Flatgeobuf => flatgeobuf::read(source.into_reader(), options),
        #[cfg(feature = "parquet")]
        Format::Parquet => parquet::read(source.into_seekable()?, options),
        other if other.is_of_feature() => Err(Problem::LeftOut(other).into()),
        other => Err(Problem::Unreadable(other).into()),
    }?;
    if options.heights && list.heights.is_none() {
        return Err(Problem::NoHeight.into());
    }
    if list.points.is_empty() {
        return Err(Problem::NoPoints.into());
    }
    Ok(list)
}

/// What notes say of the points of a ring that is closed by its first point.
pub(crate) const CLOSING: &str = "the last point repeats the first, which stands for both";

impl From<Vec<DVec2>> for PointList {
    fn from(points: Vec<DVec2>) -> Self {
        Self {
            points,
            ..Self::default()
        }
    }
}

impl PointList {
    /// Points with what is known of their heights.
    fn new(points: Vec<DVec2>, heights: Heights) -> Self {
        let (heights, note) = heights.finish();
        Self {
            points,
            heights,
            system: None,
            notes: note.into_iter().collect(),
        }
    }
}
