//! Well-known binary, little-endian: one geometry, a collection unless there is exactly one shape.
//!
//! Heights are marked as ISO has it. A reference system, which that does not know, is put in front
//! as PostGIS has it (EWKB), and heights are marked as there.

use super::{Feature, Position, Shape};
use crate::points::System;
use std::io::{self, Write};

const POINT: u32 = 1;
const LINE: u32 = 2;
const POLYGON: u32 = 3;
const POINTS: u32 = 4;
const LINES: u32 = 5;
const COLLECTION: u32 = 7;

/// What is added to the type of a geometry with heights, by ISO and by PostGIS.
const HEIGHTS: u32 = 1000;
const EXTENDED_HEIGHTS: u32 = 0x8000_0000;
/// The same where the number of the reference system follows.
const SRID: u32 = 0x2000_0000;

pub(super) fn write<'a, P>(
    out: &mut dyn Write,
    features: impl Iterator<Item = Feature<'a, P>>,
    system: Option<&System>,
) -> io::Result<()> {
    // How many there are stands in front of them.
    let shapes: Vec<Shape<'a>> = features.map(|feature| feature.shape).collect();
    let srid = system.and_then(System::epsg);
    let has_heights = shapes.iter().any(Shape::has_heights);
    let mut writer = Writer {
        out,
        heights: match (has_heights, srid) {
            (false, _) => 0,
            (true, None) => HEIGHTS,
            (true, Some(_)) => EXTENDED_HEIGHTS,
        },
        srid,
    };
    match &shapes[..] {
        [shape] => writer.geometry(shape),
        shapes => {
            writer.start(COLLECTION, shapes.len())?;
            shapes.iter().try_for_each(|shape| writer.geometry(shape))
        }
    }
}

/// One shape as ISO has it.
#[cfg(feature = "parquet")]
pub(super) fn bytes(shape: &Shape<'_>) -> io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    let mut writer = Writer {
        out: &mut bytes,
        heights: if shape.has_heights() { HEIGHTS } else { 0 },
        srid: None,
    };
    writer.geometry(shape)?;
    Ok(bytes)
}

struct Writer<'a> {
    out: &'a mut dyn Write,
    /// What is added to the types of geometries for their heights.
    heights: u32,
    /// The number of the reference system, in front of the first geometry.
    srid: Option<u32>,
}

impl Writer<'_> {
    fn geometry(&mut self, shape: &Shape<'_>) -> io::Result<()> {
        match shape {
            Shape::Polygon(rings) => {
                self.start(POLYGON, rings.len())?;
                for ring in rings {
                    self.count(if ring.len() > 0 { ring.len() + 1 } else { 0 })?;
                    self.positions(ring.closed())?;
                }
                Ok(())
            }
            Shape::Line(line) => {
                self.start(LINE, line.len())?;
                self.positions(line.positions())
            }
            Shape::Points(points) => {
                self.start(POINTS, points.len())?;
                points.positions().try_for_each(|point| {
                    self.kind(POINT)?;
                    self.positions([point])
                })
            }
            Shape::Segments(segments) => {
                self.start(LINES, segments.len())?;
                segments.iter().try_for_each(|segment| {
                    self.start(LINE, 2)?;
                    self.positions([segment.a, segment.b].map(Position::from))
                })
            }
        }
    }

    /// The order of bytes and the type of a geometry, and how many parts follow.
    fn start(&mut self, of: u32, parts: usize) -> io::Result<()> {
        self.kind(of)?;
        self.count(parts)
    }

    fn kind(&mut self, kind: u32) -> io::Result<()> {
        self.out.write_all(&[1])?;
        let kind = kind + self.heights;
        // It stands in front of the first geometry alone.
        match self.srid.take() {
            None => self.out.write_all(&kind.to_le_bytes()),
            Some(srid) => {
                self.out.write_all(&(kind | SRID).to_le_bytes())?;
                self.out.write_all(&srid.to_le_bytes())
            }
        }
    }

    fn count(&mut self, count: usize) -> io::Result<()> {
        let count = u32::try_from(count).map_err(io::Error::other)?;
        self.out.write_all(&count.to_le_bytes())
    }

    fn positions(&mut self, positions: impl IntoIterator<Item = Position>) -> io::Result<()> {
        for number in positions.into_iter().flat_map(Position::coordinates) {
            self.out.write_all(&number.to_le_bytes())?;
        }
        Ok(())
    }
}
