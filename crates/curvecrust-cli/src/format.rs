//! The formats, and the endings of file names that stand for them.

use clap::ValueEnum;
use std::path::Path;

/// A format that points or results are read from or written in.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum Format {
    /// Table with comma, semicolon or tab between columns
    Csv,
    /// Whitespace between x and y, one point a line
    Text,
    /// Arrays of [x, y], or the object that --json prints
    Json,
    /// GeoJSON (RFC 7946)
    Geojson,
    /// Well-known text
    Wkt,
    /// Exchange format of GPS receivers
    Gpx,
    /// Places and tracks of Google Earth
    Kml,
    /// Vertices of Wavefront
    Obj,
    /// Drawing exchange format, of AutoCAD R12
    Dxf,
    /// Scalable vector graphics
    Svg,
    /// NumPy array
    Npy,
    /// Archive of NumPy arrays
    Npz,
    /// Polygon file format, of scanners
    Ply,
    /// Well-known binary
    Wkb,
    /// Shapefile
    Shapefile,
    /// Scans, compressed (LAZ) or not
    Las,
    /// FlatGeobuf
    Flatgeobuf,
    /// Parquet, GeoParquet as well
    Parquet,
}

impl Format {
    /// The format of the ending of a name; `None` without a known one, as for `-`.
    pub(crate) fn of_name(path: &Path) -> Option<Self> {
        let extension = path.extension()?.to_str()?.to_ascii_lowercase();
        Some(match extension.as_str() {
            "csv" | "tsv" => Self::Csv,
            "xy" | "txt" | "dat" | "p2d" => Self::Text,
            "json" => Self::Json,
            "geojson" => Self::Geojson,
            "wkt" => Self::Wkt,
            "gpx" => Self::Gpx,
            "kml" => Self::Kml,
            "obj" => Self::Obj,
            "dxf" => Self::Dxf,
            "svg" => Self::Svg,
            "npy" => Self::Npy,
            "npz" => Self::Npz,
            "ply" => Self::Ply,
            "wkb" | "ewkb" => Self::Wkb,
            "shp" => Self::Shapefile,
            "las" | "laz" => Self::Las,
            "fgb" => Self::Flatgeobuf,
            "parquet" | "geoparquet" => Self::Parquet,
            _ => return None,
        })
    }

    /// The format of the ending of a name, if it tells more than that there is text.
    pub(crate) fn of_content_named(path: &Path) -> Option<Self> {
        let extension = path.extension()?.to_str()?.to_ascii_lowercase();
        match extension.as_str() {
            "txt" | "dat" => None,
            _ => Self::of_name(path),
        }
    }

    /// Whether it is no text.
    pub(crate) fn is_binary(self) -> bool {
        self == Self::Npy || self.is_of_feature()
    }

    /// Whether its reader is one that the program can be built without.
    pub(crate) fn is_of_feature(self) -> bool {
        match self {
            Self::Npz
            | Self::Ply
            | Self::Wkb
            | Self::Shapefile
            | Self::Las
            | Self::Flatgeobuf
            | Self::Parquet => true,
            Self::Csv
            | Self::Text
            | Self::Json
            | Self::Geojson
            | Self::Wkt
            | Self::Gpx
            | Self::Kml
            | Self::Obj
            | Self::Dxf
            | Self::Svg
            | Self::Npy => false,
        }
    }

    /// The name by which `--from` and `--to` know it.
    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::Csv => "csv",
            Self::Text => "text",
            Self::Json => "json",
            Self::Geojson => "geojson",
            Self::Wkt => "wkt",
            Self::Gpx => "gpx",
            Self::Kml => "kml",
            Self::Obj => "obj",
            Self::Dxf => "dxf",
            Self::Svg => "svg",
            Self::Npy => "npy",
            Self::Npz => "npz",
            Self::Ply => "ply",
            Self::Wkb => "wkb",
            Self::Shapefile => "shapefile",
            Self::Las => "las",
            Self::Flatgeobuf => "flatgeobuf",
            Self::Parquet => "parquet",
        }
    }
}

/// A list of formats in a sentence: `csv, json or svg`.
pub(crate) fn listed(formats: &[Format]) -> String {
    let names: Vec<_> = formats.iter().map(|format| format.name()).collect();
    match names.split_last() {
        Some((last, rest)) if !rest.is_empty() => format!("{} or {last}", rest.join(", ")),
        _ => names.concat(),
    }
}
