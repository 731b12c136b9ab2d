//! Scans in LAS and LAZ, by the crate `las`: the x and y of all points, read in pieces.
//!
//! What a header promises is settled by [`bounds`] and [`packed`] before the crate sees it. LAZ is
//! unpacked by a process of its own, in [`apart`].

mod apart;
mod bounds;
mod frames;
mod packed;

pub(crate) use apart::serve;

use super::gathered::Gathered;
use super::system::System;
use super::{Flaw, Place, PointList, Problem, ReadOptions};
use crate::input::{Seekable, Source};
use apart::Decoder;
use las::crs::GeoTiffData;
use las::{Header, PointDataBuilder, Reader};
use std::io::{BufReader, Seek};

/// Bytes of points that are unpacked at once.
const PIECE: u64 = 1 << 20;

/// Keys of GeoTIFF for systems that are projected, and those that are not.
const PROJECTED: u16 = 3072;
const GEODETIC: u16 = 2048;

/// A part of what is in a file, in the order of the file.
enum Part<'a> {
    System(System),
    /// The x, y and z of the next points.
    Points(&'a [[f64; 3]]),
}

pub(super) fn read(source: Source, options: &ReadOptions) -> Result<PointList, Flaw> {
    let mut found = Gathered::new(options);
    let mut done = 0;
    let mut take = |part: Part<'_>| {
        match part {
            Part::System(system) => found.system(system),
            Part::Points(points) => {
                for &[x, y, z] in points {
                    done += 1;
                    found.go_to(place(done));
                    found.point(([x, y], Some(z)))?;
                }
            }
        }
        Ok(())
    };
    let decoder = match is_packed(source.head()) {
        true => Decoder::start(&source),
        false => None,
    };
    match decoder {
        Some(decoder) => decoder.read(source, &mut take)?,
        None => decode(source.into_seekable()?, &mut take)?,
    }
    Ok(found.finish())
}

/// Whether this is the head of a LAZ file: the format of its points says so.
fn is_packed(head: &[u8]) -> bool {
    head.starts_with(b"LASF")
        && head
            .get(104)
            .is_some_and(|format| u64::from(*format) & bounds::PACKED != 0)
}

/// Takes what is in the file, part by part.
fn decode(
    mut source: Seekable,
    take: &mut dyn FnMut(Part<'_>) -> Result<(), Flaw>,
) -> Result<(), Flaw> {
    let bounds::Promise { points, record } = bounds::check(&mut source)?;
    if points == 0 {
        return Ok(());
    }
    source.rewind()?;
    let mut reader = Reader::new(BufReader::new(source)).map_err(flaw)?;
    if let Some(system) = system(reader.header()) {
        take(Part::System(system))?;
    }
    let piece = (PIECE / record.max(1)).max(1);
    let mut data = PointDataBuilder::new().for_header(reader.header()).build();
    let mut coordinates = Vec::new();
    let mut done = 0;
    while done < points {
        let count = reader.fill_points(piece, &mut data);
        let count = count.map_err(|error| Problem::Las(error.to_string()).at(place(done + 1)))?;
        if count == 0 {
            let what = "points";
            let promised = points;
            return Err(Problem::CutOff {
                what,
                promised,
                found: done,
            }
            .into());
        }
        coordinates.clear();
        let axes = data.x().zip(data.y()).zip(data.z());
        coordinates.extend(axes.map(|((x, y), z)| [x, y, z]));
        take(Part::Points(&coordinates))?;
        done += count;
    }
    Ok(())
}

/// That of a point, counted from 1.
fn place(number: u64) -> Place {
    Place::Item("point", number)
}

fn flaw(error: las::Error) -> Flaw {
    match error {
        las::Error::Io(error) => error.into(),
        other => Problem::Las(other.to_string()).into(),
    }
}

/// The reference system, by its text or by the number that GeoTIFF has for it.
fn system(header: &Header) -> Option<System> {
    if let Some(text) = header.get_wkt_crs_bytes() {
        return System::of_wkt(&String::from_utf8_lossy(text));
    }
    let keys = header.get_geotiff_crs().ok()??.entries;
    let code = |id: u16| {
        let mut keys = keys.iter();
        keys.find_map(|key| match key.data {
            // 32767 says that the system has no number.
            GeoTiffData::U16(code) if key.id == id && code != 32767 => Some(code),
            _ => None,
        })
    };
    let code = code(PROJECTED).or_else(|| code(GEODETIC))?;
    Some(System::of_epsg(code.into()))
}
