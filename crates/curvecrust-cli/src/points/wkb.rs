//! Well-known binary, ISO's and PostGIS's (EWKB), as bytes or as hexadecimal digits: the points of
//! all geometries, one after the other; the vertices of lines and polygons on request.
//!
//! The crate `wkb` takes what it does not know for something else, curves for points, and panics
//! where points inside of others carry a reference system. This reader knows the order of bytes,
//! the type and the dimension of every geometry by itself, and holds nothing but its place.

use super::gathered::{Gathered, Vertex};
use super::system::System;
use super::{Flaw, Place, PointList, Problem, ReadOptions};

/// Geometries in geometries.
const DEEPEST: usize = 64;

const HAS_HEIGHT: u32 = 0x8000_0000;
const HAS_MEASURE: u32 = 0x4000_0000;
const HAS_SRID: u32 = 0x2000_0000;

pub(super) fn read(bytes: &[u8], options: &ReadOptions) -> Result<PointList, Flaw> {
    let mut found = Gathered::new(options);
    if let [0 | 1, ..] = bytes {
        let mut rest = bytes;
        for number in 1.. {
            if rest.is_empty() {
                break;
            }
            found.go_to(Place::Item("geometry", number));
            rest = collect(&mut found, rest)?;
        }
    } else {
        for (number, line) in (1..).zip(bytes.split(|&byte| byte == b'\n')) {
            found.go_to(Place::Line(number));
            let line = line.trim_ascii();
            // PostgreSQL marks bytes by a backslash.
            let digits = line.strip_prefix(br"\x").unwrap_or(line);
            if !digits.is_empty() {
                let bytes = bytes_of(digits)
                    .ok_or_else(|| found.flaw(problem("these are no hexadecimal digits")))?;
                if !collect(&mut found, &bytes)?.is_empty() {
                    return Err(found.flaw(problem("the line goes on after its geometry")));
                }
            }
        }
    }
    Ok(found.finish())
}

/// Takes the points of the geometry that the bytes start with, and returns what follows it.
pub(super) fn collect<'a>(found: &mut Gathered, bytes: &'a [u8]) -> Result<&'a [u8], Flaw> {
    let mut bytes = Bytes {
        rest: bytes,
        big_endian: false,
    };
    bytes.geometry(found, DEEPEST)?;
    Ok(bytes.rest)
}

fn bytes_of(digits: &[u8]) -> Option<Vec<u8>> {
    let (pairs, rest) = digits.as_chunks::<2>();
    let value = |digit: u8| {
        char::from(digit)
            .to_digit(16)
            .and_then(|d| u8::try_from(d).ok())
    };
    let bytes = pairs
        .iter()
        .map(|&[high, low]| Some(16 * value(high)? + value(low)?));
    if rest.is_empty() {
        bytes.collect()
    } else {
        None
    }
}

fn problem(what: &str) -> Problem {
    Problem::Wkb(what.to_owned())
}

/// What was not read yet.
struct Bytes<'a> {
    rest: &'a [u8],
    big_endian: bool,
}

/// Which coordinates a position has beside x and y.
#[derive(Clone, Copy)]
struct Dimension {
    height: bool,
    measure: bool,
}

impl Bytes<'_> {
    /// Reads one geometry, which holds at most `levels` of others in each other.
    fn geometry(&mut self, found: &mut Gathered, levels: usize) -> Result<(), Flaw> {
        if levels == 0 {
            return Err(found.flaw(problem("geometries in geometries")));
        }
        self.big_endian = match self.take(found)? {
            [0] => true,
            [1] => false,
            [other] => {
                let what = format!("the order of bytes is {other}, and has to be 0 or 1");
                return Err(found.flaw(Problem::Wkb(what)));
            }
        };
        let code = self.whole(found)?;
        if code & HAS_SRID != 0 {
            let srid = self.whole(found)?;
            found.system(System::of_srid(srid));
        }
        let kind = code & 0x1fff_ffff;
        let dimension = Dimension {
            height: code & HAS_HEIGHT != 0 || matches!(kind / 1000, 1 | 3),
            measure: code & HAS_MEASURE != 0 || matches!(kind / 1000, 2 | 3),
        };
        let levels = levels - 1;
        match (kind / 1000, kind % 1000) {
            (0..=3, 1) => self.point(found, dimension),
            (0..=3, 2) => {
                found.wants_vertices("LineString")?;
                self.line(found, dimension)
            }
            (0..=3, 3) => {
                found.wants_vertices("Polygon")?;
                let rings = self.whole(found)?;
                (0..rings).try_for_each(|_| self.line(found, dimension))
            }
            (0..=3, 4..=7) => {
                let parts = self.whole(found)?;
                (0..parts).try_for_each(|_| self.geometry(found, levels))
            }
            _ => {
                let what = format!("its type is {kind}: 1 to 7 are known, points to collections");
                Err(found.flaw(Problem::Wkb(what)))
            }
        }
    }

    fn point(&mut self, found: &mut Gathered, dimension: Dimension) -> Result<(), Flaw> {
        let vertex = self.position(found, dimension)?;
        // A point that is empty has no numbers.
        if vertex.0.iter().all(|number| number.is_nan()) {
            return Ok(());
        }
        found.measure(dimension.measure);
        found.point(vertex)
    }

    fn line(&mut self, found: &mut Gathered, dimension: Dimension) -> Result<(), Flaw> {
        let count = self.whole(found)?;
        let mut vertices = Vec::new();
        for _ in 0..count {
            vertices.push(self.position(found, dimension)?);
        }
        found.measure(dimension.measure && count > 0);
        found.line(vertices.into_iter().map(Ok))
    }

    fn position(&mut self, found: &Gathered, dimension: Dimension) -> Result<Vertex, Flaw> {
        let place = [self.number(found)?, self.number(found)?];
        let height = dimension.height.then(|| self.number(found)).transpose()?;
        if dimension.measure {
            self.number(found)?;
        }
        Ok((place, height))
    }

    fn whole(&mut self, found: &Gathered) -> Result<u32, Flaw> {
        let bytes = self.take(found)?;
        Ok(match self.big_endian {
            true => u32::from_be_bytes(bytes),
            false => u32::from_le_bytes(bytes),
        })
    }

    fn number(&mut self, found: &Gathered) -> Result<f64, Flaw> {
        let bytes = self.take(found)?;
        Ok(match self.big_endian {
            true => f64::from_be_bytes(bytes),
            false => f64::from_le_bytes(bytes),
        })
    }

    fn take<const N: usize>(&mut self, found: &Gathered) -> Result<[u8; N], Flaw> {
        let (bytes, rest) = self
            .rest
            .split_first_chunk()
            .ok_or_else(|| found.flaw(problem("the geometry is cut off")))?;
        self.rest = rest;
        Ok(*bytes)
    }
}
