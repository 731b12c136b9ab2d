//! Points from files, one module a format. See `docs/formats.md`.

mod delimited;
mod flaw;
mod geojson;
mod json;
mod npy;
mod svg;
mod text;

pub(crate) use flaw::{Flaw, Place, PointsError, Problem};

use crate::format::Format;
use crate::input::{self, Source};
use curvecrust::DVec2;
use std::path::Path;

/// The formats that points are read from.
pub(crate) const FORMATS: &[Format] = &[
    Format::Csv,
    Format::Text,
    Format::Json,
    Format::Geojson,
    Format::Npy,
    Format::Svg,
];

/// Reads points, of which there must be at least one. They are finite and of magnitudes that a point
/// set can hold; some may be equal.
///
/// The format is the one given, else that of the file's name, else what the content looks like.
pub(crate) fn read(path: &Path, from: Option<Format>) -> Result<Vec<DVec2>, PointsError> {
    Source::open(path)
        .map_err(Flaw::from)
        .and_then(|source| read_source(source, from.or_else(|| Format::of_name(path))))
        .map_err(|flaw| PointsError::new(input::name(path), flaw))
}

/// The same from an opened source, in the format given, else what the content looks like.
pub(crate) fn read_source(source: Source, format: Option<Format>) -> Result<Vec<DVec2>, Flaw> {
    let head = source.head();
    if head.is_empty() {
        return Err(Problem::NoPoints.into());
    }
    if head.starts_with(b"\xff\xfe") || head.starts_with(b"\xfe\xff") {
        return Err(Problem::Utf16.into());
    }
    let points = match format.unwrap_or_else(|| looks_like(head)) {
        Format::Csv => delimited::read(source),
        Format::Text => text::read(source.into_reader()),
        Format::Npy => npy::read(source.into_reader()),
        Format::Json => whole(source).and_then(|bytes| json::read(&bytes)),
        Format::Geojson => whole(source).and_then(|bytes| geojson::read(&bytes)),
        Format::Svg => whole(source).and_then(|bytes| svg::read(&bytes)),
        other => Err(Problem::Unreadable(other).into()),
    }?;
    if points.is_empty() {
        return Err(Problem::NoPoints.into());
    }
    Ok(points)
}

fn whole(source: Source) -> Result<Vec<u8>, Flaw> {
    Ok(source.into_bytes()?)
}

/// The format of content without a name.
fn looks_like(head: &[u8]) -> Format {
    let mut lines = head.split(|&byte| byte == b'\n').map(<[u8]>::trim_ascii);
    let line = lines.find(|line| !line.is_empty() && !line.starts_with(b"#"));
    match line.unwrap_or_default() {
        [b'{' | b'[', ..] => Format::Json,
        [b'<', ..] => Format::Svg,
        [0x93, b'N', ..] => Format::Npy,
        line if line.iter().any(|byte| b",;\t".contains(byte)) => Format::Csv,
        _ => Format::Text,
    }
}

/// The coordinate that a token stands for.
fn coordinate(token: &[u8]) -> Result<f64, Problem> {
    let number = str::from_utf8(token).ok().and_then(|t| t.parse().ok());
    match number {
        Some(value) => in_range(value, || flaw::shown(token)),
        None => Err(Problem::NotANumber(flaw::shown(token))),
    }
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
