//! PLY, of scanners and of Stanford: x and y of the vertices, whatever else they have.
//!
//! The format is a [`header`] of lines, which names the elements and their properties, and then
//! the elements, as words of lines or as bytes in either order.

mod header;

use super::columns::ColumnNames;
use super::heights::Heights;
use super::quote::{left_out, listed};
use super::value::{coordinate, in_double_range};
use super::{Flaw, Place, PointList, Problem, ReadOptions, quoted};
use curvecrust::DVec2;
use header::{Element, Encoding, Header, Kind, Property, Type};
use std::io::{self, BufRead, ErrorKind, Read};

/// Where x and y are among the properties of a vertex.
#[derive(Clone, Copy)]
struct Columns {
    x: usize,
    y: usize,
    /// That of the heights, if those are wanted.
    z: Option<usize>,
}

/// The points that were read so far.
struct Found {
    points: Vec<DVec2>,
    heights: Heights,
}

pub(super) fn read(mut input: impl BufRead, options: &ReadOptions) -> Result<PointList, Flaw> {
    let Header {
        encoding,
        elements,
        lines,
    } = header::read(&mut input)?;
    let vertices = elements.iter().position(|element| element.name == "vertex");
    let vertices = vertices.ok_or_else(|| Problem::Ply("it has no vertices".into()))?;
    let columns = columns(&elements[vertices], options)?;
    let before = &elements[..vertices];
    let mut found = Found {
        points: Vec::new(),
        heights: Heights::new(options),
    };
    match encoding {
        Encoding::Text => {
            let vertex = &elements[vertices];
            words(&mut input, lines, before, vertex, columns, &mut found)?;
        }
        Encoding::Bytes { big_endian } => {
            let mut bytes = Bytes { input, big_endian };
            bytes.points(before, &elements[vertices], columns, &mut found)?;
        }
    }
    let mut list = PointList::new(found.points, found.heights);
    list.notes.extend(note(&elements[vertices], columns));
    Ok(list)
}

fn columns(vertex: &Element, options: &ReadOptions) -> Result<Columns, Problem> {
    let (x, y) = match &options.columns {
        Some(ColumnNames { x, y }) => (x.as_str(), y.as_str()),
        None => ("x", "y"),
    };
    let find = |name: &str| {
        let mut properties = vertex.properties.iter();
        let found = properties.position(|p| p.is_scalar() && p.name.eq_ignore_ascii_case(name));
        found.ok_or_else(|| Problem::NoColumn {
            missing: listed([name.as_bytes()].into_iter()),
            found: listed(vertex.properties.iter().map(|p| p.name.as_bytes())),
        })
    };
    Ok(Columns {
        x: find(x)?,
        y: find(y)?,
        z: options.heights.then(|| find("z")).transpose()?,
    })
}

/// What of the vertices is left out.
fn note(vertex: &Element, Columns { x, y, z }: Columns) -> Option<String> {
    let properties = vertex.properties.iter().enumerate();
    let others = properties.filter(|&(index, _)| index != x && index != y && Some(index) != z);
    let others: Vec<&[u8]> = others.map(|(_, p)| p.name.as_bytes()).collect();
    (!others.is_empty()).then(|| left_out(others.into_iter()))
}

fn cut_off(vertex: &Element, found: u64) -> Flaw {
    let (what, promised) = ("vertices", vertex.count);
    Problem::CutOff {
        what,
        promised,
        found,
    }
    .into()
}

/// The points of a file of lines, of which some were read.
fn words(
    input: &mut impl BufRead,
    mut line: u64,
    before: &[Element],
    vertex: &Element,
    columns: Columns,
    into: &mut Found,
) -> Result<(), Flaw> {
    let mut text = Vec::new();
    let mut next = |text: &mut Vec<u8>| -> io::Result<Option<u64>> {
        loop {
            text.clear();
            if input.read_until(b'\n', text)? == 0 {
                return Ok(None);
            }
            line += 1;
            if !text.trim_ascii().is_empty() {
                return Ok(Some(line));
            }
        }
    };
    for element in before {
        for _ in 0..element.count {
            next(&mut text)?.ok_or_else(|| cut_off(vertex, 0))?;
        }
    }
    for found in 0..vertex.count {
        let line = next(&mut text)?.ok_or_else(|| cut_off(vertex, found))?;
        let taken = take_words(&text, vertex, columns, into);
        taken.map_err(|problem| problem.at(Place::Line(line)))?;
    }
    Ok(())
}

/// Takes the point of a line of words, one a property; a list has its length in front.
fn take_words(
    text: &[u8],
    vertex: &Element,
    columns: Columns,
    into: &mut Found,
) -> Result<(), Problem> {
    let mut words = text
        .split(u8::is_ascii_whitespace)
        .filter(|word| !word.is_empty());
    let short = || Problem::Short(quoted(text.trim_ascii()));
    let mut point = DVec2::ZERO;
    let mut height = None;
    for (index, property) in vertex.properties.iter().enumerate() {
        let word = words.next().ok_or_else(short)?;
        if index == columns.x {
            point.x = coordinate(word, false)?;
        }
        if index == columns.y {
            point.y = coordinate(word, false)?;
        }
        if Some(index) == columns.z {
            height = into.heights.of_word(Some(word), false)?;
        }
        if !property.is_scalar() {
            let length = str::from_utf8(word).ok().and_then(|word| word.parse().ok());
            let length: usize = length.ok_or_else(|| Problem::NotANumber(quoted(word)))?;
            for _ in 0..length {
                words.next().ok_or_else(short)?;
            }
        }
    }
    into.points.push(point);
    into.heights.take(height)
}

/// A file of bytes behind the header.
struct Bytes<R> {
    input: R,
    big_endian: bool,
}

impl<R: Read> Bytes<R> {
    fn points(
        &mut self,
        before: &[Element],
        vertex: &Element,
        columns: Columns,
        into: &mut Found,
    ) -> Result<(), Flaw> {
        for element in before {
            for _ in 0..element.count {
                for property in &element.properties {
                    self.value(property)
                        .map_err(|error| broken(error, vertex, 0))?;
                }
            }
        }
        for found in 0..vertex.count {
            let place = Place::Item("vertex", found + 1);
            let mut point = DVec2::ZERO;
            let mut height = None;
            for (index, property) in vertex.properties.iter().enumerate() {
                let value = self.value(property);
                let value = value.map_err(|error| broken(error, vertex, found))?;
                let number = || in_double_range(value).map_err(|problem| problem.at(place));
                if index == columns.x {
                    point.x = number()?;
                }
                if index == columns.y {
                    point.y = number()?;
                }
                if Some(index) == columns.z {
                    height = Some(value);
                }
            }
            into.points.push(point);
            let taken = into.heights.take(height);
            taken.map_err(|problem| problem.at(place))?;
        }
        Ok(())
    }

    /// The value of a property; a list is passed over.
    fn value(&mut self, property: &Property) -> io::Result<f64> {
        match property.kind {
            Kind::Scalar(of) => self.number(of),
            Kind::List { length, of } => {
                let mut buffer = [0; 8];
                let items = length.count(self.bytes(length, &mut buffer)?);
                let bytes = items * of.size() as u64;
                let passed = io::copy(&mut (&mut self.input).take(bytes), &mut io::sink())?;
                if passed < bytes {
                    return Err(ErrorKind::UnexpectedEof.into());
                }
                // A list is no coordinate.
                Ok(f64::NAN)
            }
        }
    }

    fn number(&mut self, of: Type) -> io::Result<f64> {
        let mut buffer = [0; 8];
        Ok(of.value(self.bytes(of, &mut buffer)?))
    }

    /// The bytes of a number, the least significant first.
    fn bytes<'a>(&mut self, of: Type, buffer: &'a mut [u8; 8]) -> io::Result<&'a [u8]> {
        let bytes = &mut buffer[..of.size()];
        self.input.read_exact(bytes)?;
        if self.big_endian {
            bytes.reverse();
        }
        Ok(bytes)
    }
}

fn broken(error: io::Error, vertex: &Element, found: u64) -> Flaw {
    match error.kind() {
        ErrorKind::UnexpectedEof => cut_off(vertex, found),
        _ => error.into(),
    }
}
