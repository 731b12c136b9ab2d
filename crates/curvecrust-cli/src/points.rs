//! Points from files, one module a format. See `docs/formats.md`.

mod columns;
mod csv_records;
mod flaw;
mod geojson;
mod gpx;
mod json;
mod json_text;
pub(crate) mod npy;
mod obj;
mod quote;
mod records;
mod separator;
mod svg;
mod table;
mod text_records;
mod wkt;

pub(crate) use columns::ColumnNames;
pub(crate) use flaw::{Flaw, Place, PointsError, Problem};

use crate::format::Format;
use crate::input::{self, Source};
use crate::number::Number;
use curvecrust::DVec2;
use quote::quoted;
use separator::Separator;
use std::path::Path;

/// The formats that points are read from.
pub(crate) const FORMATS: &[Format] = &[
    Format::Csv,
    Format::Text,
    Format::Json,
    Format::Geojson,
    Format::Wkt,
    Format::Gpx,
    Format::Obj,
    Format::Npy,
    Format::Svg,
];

/// What was read from a file.
#[derive(Debug, Default)]
pub(crate) struct PointList {
    /// The points, finite and of magnitudes that a point set can hold; some may be equal.
    pub(crate) points: Vec<DVec2>,
    /// What the user should know about how they were read.
    pub(crate) notes: Vec<String>,
}

/// What the user says about how points are read.
#[derive(Clone, Debug, Default)]
pub(crate) struct Wanted {
    /// The columns of a table; `None`: those with names that are known.
    pub(crate) columns: Option<ColumnNames>,
    /// Whether vertices of lines and polygons are points.
    pub(crate) vertices: bool,
}

/// Reads points, of which there must be at least one.
///
/// The format is the one given, else that of the file's name, else what the content looks like.
pub(crate) fn read(
    path: &Path,
    from: Option<Format>,
    wanted: &Wanted,
) -> Result<PointList, PointsError> {
    Source::open(path)
        .map_err(Flaw::from)
        .and_then(|source| read_source(source, from.or_else(|| Format::of_name(path)), wanted))
        .map_err(|flaw| PointsError::new(input::name(path), flaw))
}

/// The same from an opened source, in the format given, else what the content looks like.
pub(crate) fn read_source(
    mut source: Source,
    format: Option<Format>,
    wanted: &Wanted,
) -> Result<PointList, Flaw> {
    let head = source.head();
    if head.is_empty() {
        return Err(Problem::NoPoints.into());
    }
    if head.starts_with(b"\xff\xfe") || head.starts_with(b"\xfe\xff") {
        return Err(Problem::Utf16.into());
    }
    let format = match format {
        Some(format) => format,
        None => looks_like(&mut source)?,
    };
    let names = wanted.columns.as_ref();
    if names.is_some() && !matches!(format, Format::Csv | Format::Text) {
        return Err(Problem::NoTable(format).into());
    }
    let list = match format {
        Format::Csv => table::read(source, Separator::Byte(b','), names),
        Format::Text => table::read(source, Separator::WhiteSpace, names),
        Format::Npy => npy::read(source.into_reader()),
        Format::Json => json::read(&source.into_bytes()?, wanted.vertices),
        Format::Geojson => geojson::read(&source.into_bytes()?, wanted.vertices),
        Format::Wkt => wkt::read(&source.into_bytes()?, wanted.vertices),
        Format::Gpx => gpx::read(&source.into_bytes()?),
        Format::Obj => obj::read(&source.into_bytes()?),
        Format::Svg => svg::read(&source.into_bytes()?),
        other => Err(Problem::Unreadable(other).into()),
    }?;
    if list.points.is_empty() {
        return Err(Problem::NoPoints.into());
    }
    Ok(list)
}

impl From<Vec<DVec2>> for PointList {
    fn from(points: Vec<DVec2>) -> Self {
        Self {
            points,
            notes: Vec::new(),
        }
    }
}

impl PointList {
    /// Points of which some have a height.
    fn with_heights(points: Vec<DVec2>, has_heights: bool) -> Self {
        let note = has_heights.then(|| String::from("heights are left out"));
        Self {
            points,
            notes: note.into_iter().collect(),
        }
    }
}

/// The format of content without a name, by its first line that is no comment.
fn looks_like(source: &mut Source) -> Result<Format, Flaw> {
    let head = source.peek(|head| first_line(head).is_some())?;
    Ok(match first_line(head).unwrap_or_default() {
        [b'{' | b'[', ..] => Format::Json,
        [b'<', ..] if contains(head, b"<gpx") => Format::Gpx,
        [b'<', ..] => Format::Svg,
        line if starts_vertex(line) => Format::Obj,
        line if starts_geometry(line) => Format::Wkt,
        [0x93, b'N', ..] => Format::Npy,
        // What separates its columns is found as it is read.
        _ => Format::Text,
    })
}

fn contains(text: &[u8], part: &[u8]) -> bool {
    text.windows(part.len()).any(|window| window == part)
}

/// Whether a line starts as well-known text does: with the name of a geometry, and what may follow
/// it. A header of a table may start with such a name too.
fn starts_geometry(line: &[u8]) -> bool {
    const NAMES: [&[u8]; 7] = [
        b"POINT",
        b"MULTIPOINT",
        b"LINESTRING",
        b"MULTILINESTRING",
        b"POLYGON",
        b"MULTIPOLYGON",
        b"GEOMETRYCOLLECTION",
    ];
    let line = line.to_ascii_uppercase();
    let end = line.iter().position(|byte| !byte.is_ascii_uppercase());
    let (name, rest) = line.split_at(end.unwrap_or(line.len()));
    let rest = rest.trim_ascii_start();
    let follows = [&b"("[..], b"Z", b"M", b"EMPTY"];
    line.starts_with(b"SRID=")
        || NAMES.contains(&name) && follows.iter().any(|start| rest.starts_with(start))
}

/// Whether a line is a vertex of Wavefront OBJ: a `v` and numbers.
fn starts_vertex(line: &[u8]) -> bool {
    let mut words = line
        .split(u8::is_ascii_whitespace)
        .filter(|w| !w.is_empty());
    words.next() == Some(b"v") && words.next().is_some_and(|word| is_number(word, false))
}

/// The vertices of a line, of a closed one the first once.
fn opened<T>(line: &[T], is_same: impl Fn(&T, &T) -> bool) -> &[T] {
    match line {
        [first, inner @ .., last] if is_same(first, last) => &line[..=inner.len()],
        line => line,
    }
}

/// The first line that is neither empty nor a comment, or as much of it as is known.
fn first_line(head: &[u8]) -> Option<&[u8]> {
    let mut lines = head.split(|&byte| byte == b'\n').map(<[u8]>::trim_ascii);
    lines.find(|line| !line.is_empty() && !line.starts_with(b"#"))
}

/// The coordinate that a token stands for, which may have a comma in front of its decimals.
fn coordinate(token: &[u8], has_decimal_commas: bool) -> Result<f64, Problem> {
    match number(token, has_decimal_commas) {
        Some(value) => in_range(value, || quoted(token)),
        None => Err(Problem::NotANumber(quoted(token))),
    }
}

fn is_number(token: &[u8], has_decimal_commas: bool) -> bool {
    number(token, has_decimal_commas).is_some()
}

fn number(token: &[u8], has_decimal_commas: bool) -> Option<f64> {
    let text = str::from_utf8(token).ok()?;
    let number = text.parse().ok();
    // With a point as well, a comma would separate thousands.
    let is_decimal = || has_decimal_commas && text.contains(',') && !text.contains('.');
    number.or_else(|| {
        is_decimal()
            .then(|| text.replacen(',', ".", 1).parse().ok())
            .flatten()
    })
}

/// The number itself, if a point set can hold it.
fn in_double_range(value: f64) -> Result<f64, Problem> {
    in_range(value, || Number(value).to_string())
}

/// The number itself, if a point set can hold it; `found` is what stood there.
fn in_range(value: f64, found: impl FnOnce() -> String) -> Result<f64, Problem> {
    use curvecrust::geometry::PointSet;
    let magnitude = value.abs();
    if !value.is_finite() {
        Err(Problem::NotFinite(found()))
    } else if magnitude > PointSet::MAX_MAGNITUDE
        || (magnitude < PointSet::MIN_MAGNITUDE && magnitude > 0.0)
    {
        Err(Problem::Magnitude(found()))
    } else {
        Ok(value)
    }
}
