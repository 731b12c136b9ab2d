//! Scans in LAS and LAZ, by the crate `las`: the x and y of all points, read in pieces.
//!
//! What a header promises is settled by [`bounds`] and [`packed`] before the crate sees it.

mod bounds;
mod packed;

use super::gathered::Gathered;
use super::system::System;
use super::{Flaw, Place, PointList, Problem, Wanted};
use crate::input::Seekable;
use las::crs::GeoTiffData;
use las::{Header, PointDataBuilder, Reader};
use std::io::{BufReader, Seek};

/// Bytes of points that are unpacked at once.
const PIECE: u64 = 1 << 20;

/// Keys of GeoTIFF for systems that are projected, and those that are not.
const PROJECTED: u16 = 3072;
const GEODETIC: u16 = 2048;

pub(super) fn read(mut source: Seekable, wanted: &Wanted) -> Result<PointList, Flaw> {
    let bounds::Promise { points, record } = bounds::check(&mut source)?;
    if points == 0 {
        return Ok(PointList::default());
    }
    source.rewind()?;
    let mut reader = Reader::new(BufReader::new(source)).map_err(flaw)?;
    let mut found = Gathered::new(wanted);
    if let Some(system) = system(reader.header()) {
        found.system(system);
    }
    let piece = (PIECE / record.max(1)).max(1);
    let mut data = PointDataBuilder::new().for_header(reader.header()).build();
    let mut done = 0;
    while done < points {
        found.go_to(Place::Item("point", done + 1));
        let count = reader.fill_points(piece, &mut data);
        let count = count.map_err(|error| Problem::Las(error.to_string()).at(place(done)))?;
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
        let axes = data.x().zip(data.y()).zip(data.z());
        for (number, ((x, y), z)) in (done..).zip(axes) {
            found.go_to(place(number));
            found.point(([x, y], Some(z)))?;
        }
        done += count;
    }
    Ok(found.finish())
}

fn place(number: u64) -> Place {
    Place::Item("point", number + 1)
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
