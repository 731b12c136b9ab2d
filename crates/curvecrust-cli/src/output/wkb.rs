//! Well-known binary, little-endian: one geometry, a collection unless there is exactly one shape.

use super::{Feature, Shape};
use curvecrust::DVec2;
use std::io::{self, Write};

const POINT: u32 = 1;
const LINE: u32 = 2;
const POLYGON: u32 = 3;
const POINTS: u32 = 4;
const LINES: u32 = 5;
const COLLECTION: u32 = 7;

pub(super) fn write<'a, P>(
    out: &mut dyn Write,
    features: impl Iterator<Item = Feature<'a, P>>,
) -> io::Result<()> {
    // How many there are stands in front of them.
    let shapes: Vec<Shape<'a>> = features.map(|feature| feature.shape).collect();
    match &shapes[..] {
        [shape] => geometry(out, shape),
        shapes => {
            start(out, COLLECTION, shapes.len())?;
            shapes.iter().try_for_each(|shape| geometry(out, shape))
        }
    }
}

fn geometry(out: &mut dyn Write, shape: &Shape<'_>) -> io::Result<()> {
    match shape {
        Shape::Polygon(rings) => {
            start(out, POLYGON, rings.len())?;
            for ring in rings {
                count(out, if ring.len() > 0 { ring.len() + 1 } else { 0 })?;
                positions(out, ring.closed())?;
            }
            Ok(())
        }
        Shape::Line(line) => {
            start(out, LINE, line.len())?;
            positions(out, line.iter())
        }
        Shape::Points(points) => {
            start(out, POINTS, points.len())?;
            points.iter().try_for_each(|point| {
                kind(out, POINT)?;
                positions(out, [point])
            })
        }
        Shape::Segments(segments) => {
            start(out, LINES, segments.len())?;
            segments.iter().try_for_each(|segment| {
                start(out, LINE, 2)?;
                positions(out, [segment.a, segment.b])
            })
        }
    }
}

/// The order of bytes and the type of a geometry, and how many parts follow.
fn start(out: &mut dyn Write, of: u32, parts: usize) -> io::Result<()> {
    kind(out, of)?;
    count(out, parts)
}

fn kind(out: &mut dyn Write, kind: u32) -> io::Result<()> {
    out.write_all(&[1])?;
    out.write_all(&kind.to_le_bytes())
}

fn count(out: &mut dyn Write, count: usize) -> io::Result<()> {
    let count = u32::try_from(count).map_err(io::Error::other)?;
    out.write_all(&count.to_le_bytes())
}

fn positions(out: &mut dyn Write, points: impl IntoIterator<Item = DVec2>) -> io::Result<()> {
    for point in points {
        out.write_all(&point.x.to_le_bytes())?;
        out.write_all(&point.y.to_le_bytes())?;
    }
    Ok(())
}
