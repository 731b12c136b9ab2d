//! Tables (`.csv`, `.tsv`): two columns without names, or columns named x and y among any others.
//!
//! Commas, semicolons or tabs stand between columns, whichever the first line holds; lines that start
//! with a `#` do not count. The first line is one of names if nothing in it is a number.

use super::{Flaw, Place, Problem, coordinate, flaw::shown};
use crate::input::Source;
use csv::{ByteRecord, Reader, ReaderBuilder, Trim};
use curvecrust::DVec2;
use std::io::{self, Read};

pub(super) fn read(source: Source) -> Result<Vec<DVec2>, Flaw> {
    let mut reader = ReaderBuilder::new()
        .has_headers(false)
        .flexible(true)
        .comment(Some(b'#'))
        .trim(Trim::None)
        .delimiter(delimiter(source.head()))
        .buffer_capacity(1 << 16)
        .from_reader(source.into_reader());
    let mut record = ByteRecord::new();
    if !next(&mut reader, &mut record)? {
        return Ok(Vec::new());
    }
    let mut points = Vec::new();
    let width = record.len();
    let columns = if is_header(&record) {
        named(&record)?
    } else if width > 2 {
        let line = line(&record);
        return Err(Problem::Unnamed { found: width }.at(Place::Line(line)));
    } else {
        points.push(point(&record, Columns { x: 0, y: 1 })?);
        Columns { x: 0, y: 1 }
    };
    while next(&mut reader, &mut record)? {
        if record.len() != width {
            return Err(ragged(&record, width));
        }
        points.push(point(&record, columns)?);
    }
    Ok(points)
}

/// Which columns hold the coordinates.
#[derive(Clone, Copy)]
struct Columns {
    x: usize,
    y: usize,
}

/// What stands between the columns: of the candidates, the first in the first line that counts.
fn delimiter(head: &[u8]) -> u8 {
    let mut lines = head.split(|&byte| byte == b'\n');
    let line = lines.find(|line| !line.starts_with(b"#") && !line.trim_ascii().is_empty());
    let found = line.and_then(|line| line.iter().find(|byte| b",;\t".contains(byte)));
    *found.unwrap_or(&b',')
}

fn next(reader: &mut Reader<impl Read>, record: &mut ByteRecord) -> Result<bool, Flaw> {
    let read = reader.read_byte_record(record);
    // Records of bytes and of any length can fail to be read, and in no other way.
    read.map_err(|error| Problem::Io(io::Error::from(error)).into())
}

fn line(record: &ByteRecord) -> u64 {
    record.position().map_or(1, csv::Position::line)
}

fn is_header(record: &ByteRecord) -> bool {
    let is_number = |field: &[u8]| {
        let text = str::from_utf8(field.trim_ascii()).unwrap_or_default();
        text.parse::<f64>().is_ok()
    };
    !record.iter().any(is_number)
}

fn named(header: &ByteRecord) -> Result<Columns, Flaw> {
    let place = Place::Line(line(header));
    let find = |name: &'static str| {
        let is_named = |field: &[u8]| field.trim_ascii().eq_ignore_ascii_case(name.as_bytes());
        let mut found = (0..header.len()).filter(|&i| is_named(&header[i]));
        match (found.next(), found.next()) {
            (Some(column), None) => Ok(column),
            (Some(_), Some(_)) => Err(Problem::TwoColumns(name).at(place)),
            (None, _) => {
                let names: Vec<_> = header.iter().map(|f| format!("`{}`", shown(f))).collect();
                let found = names.join(", ");
                let missing = name;
                Err(Problem::NoColumn { missing, found }.at(place))
            }
        }
    };
    Ok(Columns {
        x: find("x")?,
        y: find("y")?,
    })
}

fn point(record: &ByteRecord, columns: Columns) -> Result<DVec2, Flaw> {
    let value = |column: usize| match record.get(column) {
        Some(field) => coordinate(field.trim_ascii())
            .map_err(|problem| problem.at(Place::Field(line(record), column + 1))),
        None => Err(short(record)),
    };
    Ok(DVec2::new(value(columns.x)?, value(columns.y)?))
}

fn ragged(record: &ByteRecord, expected: usize) -> Flaw {
    let found = record.len();
    if found == 1 {
        return short(record);
    }
    Problem::Ragged { found, expected }.at(Place::Line(line(record)))
}

fn short(record: &ByteRecord) -> Flaw {
    let found = shown(record.get(0).unwrap_or_default());
    Problem::Short(found).at(Place::Line(line(record)))
}
