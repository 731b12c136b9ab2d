//! Shapefiles (`.shp`): all points and multipoints, and the vertices of lines, polygons and patches
//! on request. The `.prj` beside one names its reference system.
//!
//! The crate `shapefile` reserves what a record says it has, of shapes that are held as a whole,
//! and closes rings that are open. Records are read here as they come, and hold no more than
//! their length. The format is that of ESRI's white paper "ESRI Shapefile Technical Description".

use super::gathered::{Gathered, Vertex};
use super::system::System;
use super::{Flaw, Place, PointList, Problem, ReadOptions};
use crate::input::Source;
use std::io::{self, BufRead, ErrorKind, Read};

/// Bytes of the file that names the reference system.
const LONGEST_SYSTEM: u64 = 1 << 16;
/// Bytes of a header, and of a bounding box.
const HEADER: u64 = 100;
const BOX: u64 = 32;

pub(super) fn read(source: Source, options: &ReadOptions) -> Result<PointList, Flaw> {
    let mut found = Gathered::new(options);
    if let Some(text) = source.beside("prj", LONGEST_SYSTEM)
        && let Some(system) = System::of_wkt(&String::from_utf8_lossy(&text))
    {
        found.system(system);
    }
    let mut input = source.into_reader();
    let cut = |error: io::Error| match error.kind() {
        ErrorKind::UnexpectedEof => problem("its header is cut off").into(),
        _ => Flaw::from(error),
    };
    if big_endian(&mut input).map_err(cut)? != 9994 {
        return Err(problem("it starts otherwise").into());
    }
    skip(&mut input, 20).map_err(cut)?;
    // Lengths are in words of two bytes.
    let words = u64::from(big_endian(&mut input).map_err(cut)?);
    skip(&mut input, HEADER - 28).map_err(cut)?;
    let mut left = (2 * words).saturating_sub(HEADER);
    for number in 1.. {
        if left == 0 {
            break;
        }
        found.go_to(Place::Item("shape", number));
        let length = record(&mut found, &mut input)?;
        left = left.saturating_sub(8 + length);
    }
    Ok(found.finish())
}

fn problem(what: &str) -> Problem {
    Problem::Shapefile(what.to_owned())
}

/// Reads a record and returns the length of its content.
fn record(found: &mut Gathered, input: &mut impl BufRead) -> Result<u64, Flaw> {
    let place = found.flaw(problem("the file is cut off")).place;
    let broken = |error: io::Error| match error.kind() {
        ErrorKind::UnexpectedEof => problem("the file is cut off").at(place),
        _ => Problem::Io(error).at(place),
    };
    big_endian(input).map_err(broken)?;
    let length = 2 * u64::from(big_endian(input).map_err(broken)?);
    let mut content = Content {
        input: input.take(length),
    };
    match content.shape(found) {
        // The end of the record, or that of the file.
        Err(Broken::Io(error)) if error.kind() == ErrorKind::UnexpectedEof => {
            let what = match content.input.limit() {
                0 => "the record is shorter than its shape",
                _ => "the file is cut off",
            };
            return Err(found.flaw(problem(what)));
        }
        Err(Broken::Io(error)) => return Err(broken(error)),
        Err(Broken::Flaw(flaw)) => return Err(flaw),
        Ok(()) => {}
    }
    let rest = content.input.limit();
    skip(input, rest).map_err(broken)?;
    Ok(length)
}

fn big_endian(input: &mut impl Read) -> io::Result<u32> {
    let mut bytes = [0; 4];
    input.read_exact(&mut bytes)?;
    Ok(u32::from_be_bytes(bytes))
}

fn skip(input: &mut impl Read, count: u64) -> io::Result<()> {
    match io::copy(&mut input.take(count), &mut io::sink())? {
        passed if passed < count => Err(ErrorKind::UnexpectedEof.into()),
        _ => Ok(()),
    }
}

/// Why a shape cannot be read.
enum Broken {
    Io(io::Error),
    Flaw(Flaw),
}

impl From<io::Error> for Broken {
    fn from(error: io::Error) -> Self {
        Self::Io(error)
    }
}

impl From<Flaw> for Broken {
    fn from(flaw: Flaw) -> Self {
        Self::Flaw(flaw)
    }
}

/// The content of a record.
struct Content<R> {
    input: R,
}

impl<R: Read> Content<R> {
    fn shape(&mut self, found: &mut Gathered) -> Result<(), Broken> {
        let kind = self.whole()?;
        // Those of the second ten have a height, which may stand for nothing, and a measure.
        let has_heights = matches!(kind, 11..=18 | 31);
        found.measure(matches!(kind, 21..=28));
        match kind {
            0 => Ok(()),
            1 | 11 | 21 => {
                let place = self.position()?;
                let height = has_heights.then(|| self.number()).transpose()?;
                Ok(found.point((place, height))?)
            }
            8 | 18 | 28 => {
                skip(&mut self.input, BOX)?;
                let count = self.whole()?;
                for vertex in self.vertices(count, has_heights)? {
                    found.point(vertex)?;
                }
                Ok(())
            }
            3 | 13 | 23 => self.parts(found, "Polyline", has_heights, false),
            5 | 15 | 25 => self.parts(found, "Polygon", has_heights, false),
            31 => self.parts(found, "Multipatch", has_heights, true),
            other => {
                let what = format!("its type is {other}, which is not known");
                Err(found.flaw(Problem::Shapefile(what)).into())
            }
        }
    }

    /// The vertices of the parts of a shape, each part a line.
    fn parts(
        &mut self,
        found: &mut Gathered,
        name: &str,
        has_heights: bool,
        has_kinds: bool,
    ) -> Result<(), Broken> {
        found.wants_vertices(name)?;
        skip(&mut self.input, BOX)?;
        let [parts, points] = [self.whole()?, self.whole()?];
        let mut starts = Vec::new();
        for _ in 0..parts {
            starts.push(self.whole()?);
        }
        if has_kinds {
            skip(&mut self.input, 4 * u64::from(parts))?;
        }
        let ends = starts.iter().skip(1).chain([&points]);
        if starts.first().is_some_and(|&start| start != 0)
            || starts
                .iter()
                .zip(ends.clone())
                .any(|(start, end)| start > end)
            || starts.is_empty() && points > 0
        {
            return Err(found.flaw(problem("its parts are not in order")).into());
        }
        let mut vertices = self.vertices(points, has_heights)?.into_iter();
        for (start, end) in starts.iter().zip(ends) {
            let line = vertices.by_ref().take((end - start) as usize);
            found.line(line.map(Ok))?;
        }
        Ok(())
    }

    /// So many places and, behind the least and the largest of them, their heights.
    fn vertices(&mut self, count: u32, has_heights: bool) -> Result<Vec<Vertex>, Broken> {
        // No more is reserved than is read.
        let mut vertices: Vec<Vertex> = Vec::new();
        for _ in 0..count {
            vertices.push((self.position()?, None));
        }
        if has_heights {
            skip(&mut self.input, 16)?;
            for vertex in &mut vertices {
                vertex.1 = Some(self.number()?);
            }
        }
        Ok(vertices)
    }

    fn position(&mut self) -> io::Result<[f64; 2]> {
        Ok([self.number()?, self.number()?])
    }

    fn number(&mut self) -> io::Result<f64> {
        let mut bytes = [0; 8];
        self.input.read_exact(&mut bytes)?;
        Ok(f64::from_le_bytes(bytes))
    }

    fn whole(&mut self) -> io::Result<u32> {
        let mut bytes = [0; 4];
        self.input.read_exact(&mut bytes)?;
        Ok(u32::from_le_bytes(bytes))
    }
}
