//! What content is: by its magic number, whatever it is named; else by its first line.

mod magic;
mod markup;

use super::value::is_number;
use super::{Flaw, Problem};
use crate::format::Format;
use crate::input::Source;
use magic::Magic;

/// The format that content is read in: that of its magic number, else the one asked for, else that
/// of the name, else what it looks like.
pub(super) fn format_of(
    source: &mut Source,
    asked: Option<Format>,
    named: Option<Format>,
) -> Result<Format, Flaw> {
    let head = source.head();
    if head.starts_with(b"\xff\xfe") || head.starts_with(b"\xfe\xff") {
        return Err(Problem::Utf16.into());
    }
    match magic::find(head) {
        Some(Magic::Readable(format)) => {
            return match asked {
                Some(asked) if asked != format => Err(Problem::Asked { asked, format }.into()),
                _ => Ok(format),
            };
        }
        Some(Magic::Foreign { what, advice }) => {
            return Err(Problem::Foreign { what, advice }.into());
        }
        None => {}
    }
    let format = match asked.or(named) {
        Some(format) => Some(format),
        None => looks_like(source)?,
    };
    match format {
        Some(format) if format.is_binary() || !is_binary(source.head()) => Ok(format),
        None if !is_binary(source.head()) => Ok(Format::Text),
        _ => Err(Problem::Binary.into()),
    }
}

/// Whether bytes are no text, in whatever code: more than a sixth of them steer a terminal or are
/// none of UTF-8, and at least one is such a control.
fn is_binary(head: &[u8]) -> bool {
    let is_control = |byte: &u8| matches!(byte, 0..=8 | 14..=31 | 127);
    let controls = head.iter().filter(|byte| is_control(byte)).count();
    let invalid: usize = head.utf8_chunks().map(|chunk| chunk.invalid().len()).sum();
    controls > 0 && 6 * (controls + invalid) > head.len()
}

/// The format of content without a name, by its first line that is no comment; `None` if it may be
/// a table. What separates the columns of one is found as it is read.
fn looks_like(source: &mut Source) -> Result<Option<Format>, Flaw> {
    let head = source.peek(|head| first_line(head).is_some())?;
    let line = first_line(head).unwrap_or_default();
    if line.starts_with(b"<") {
        let head = source.peek(|head| markup::root(head).is_some())?;
        return Ok(Some(markup::format(head)?));
    }
    Ok(match line {
        line if starts_json(line) => Some(Format::Json),
        line if starts_vertex(line) => Some(Format::Obj),
        line if starts_geometry(line) => Some(Format::Wkt),
        line if starts_hexadecimal(line) => Some(Format::Wkb),
        line if line == b"0" && starts_section(head) => Some(Format::Dxf),
        _ => None,
    })
}

/// The first line that is neither empty nor a comment, or as much of it as is known.
fn first_line(head: &[u8]) -> Option<&[u8]> {
    let mut lines = head.split(|&byte| byte == b'\n').map(<[u8]>::trim_ascii);
    lines.find(|line| !line.is_empty() && !line.starts_with(b"#"))
}

/// Whether a line starts an object or an array. A header may start with a unit: `[m] [m]`.
fn starts_json(line: &[u8]) -> bool {
    let [first, rest @ ..] = line else {
        return false;
    };
    match (first, rest.trim_ascii_start().first()) {
        (b'{', next) => matches!(next, None | Some(b'"' | b'}')),
        (b'[', next) => !next.is_some_and(u8::is_ascii_alphabetic),
        _ => false,
    }
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

/// Whether a line is well-known binary in hexadecimal digits, as databases print it: an order of
/// bytes, 0 or 1, and more digits than a number has.
fn starts_hexadecimal(line: &[u8]) -> bool {
    line.len() > 30
        && (line.starts_with(b"00") || line.starts_with(b"01"))
        && line.iter().all(u8::is_ascii_hexdigit)
}

/// Whether a line is a vertex of Wavefront OBJ: a `v` and numbers.
fn starts_vertex(line: &[u8]) -> bool {
    let mut words = line
        .split(u8::is_ascii_whitespace)
        .filter(|w| !w.is_empty());
    words.next() == Some(b"v") && words.next().is_some_and(|word| is_number(word, false))
}

/// Whether the second line is that of a drawing exchange file.
fn starts_section(head: &[u8]) -> bool {
    let mut lines = head.split(|&byte| byte == b'\n').map(<[u8]>::trim_ascii);
    lines.any(|line| line == b"SECTION")
}
