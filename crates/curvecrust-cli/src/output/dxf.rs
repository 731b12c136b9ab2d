//! Drawing exchange format, of AutoCAD R12: the version that every program reads.
//!
//! Rings are closed polylines and chains open ones, on layers named after their kind. Each item is
//! a line with the code of a group and a line with its value.

use super::{Feature, Number, Places, Position, Shape};
use curvecrust::DVec2;
use std::io::{self, Write};

pub(super) fn write<'a, P>(
    out: &mut dyn Write,
    features: impl Iterator<Item = Feature<'a, P>>,
) -> io::Result<()> {
    write!(
        out,
        "0\nSECTION\n2\nHEADER\n9\n$ACADVER\n1\nAC1009\n0\nENDSEC\n"
    )?;
    write!(out, "0\nSECTION\n2\nENTITIES\n")?;
    for feature in features {
        match feature.shape {
            Shape::Polygon(rings) => {
                for ring in &rings {
                    polyline(out, "rings", ring, true)?;
                }
            }
            Shape::Line(line) => polyline(out, "chains", &line, false)?,
            Shape::Points(points) => {
                for p in points.positions() {
                    write!(out, "0\nPOINT\n8\npoints\n")?;
                    place(out, 10, p)?;
                }
            }
            Shape::Segments(segments) => {
                for segment in segments {
                    write!(out, "0\nLINE\n8\nlines\n")?;
                    place(out, 10, segment.a.into())?;
                    place(out, 11, segment.b.into())?;
                }
            }
        }
    }
    write!(out, "0\nENDSEC\n0\nEOF\n")
}

fn polyline(out: &mut dyn Write, layer: &str, points: &Places<'_>, closed: bool) -> io::Result<()> {
    // A polyline whose vertices have heights of their own, and such a vertex, say so by a flag.
    let (line, vertex) = match points.has_heights() {
        true => (8, "70\n32\n"),
        false => (0, ""),
    };
    let flags = u8::from(closed) + line;
    write!(out, "0\nPOLYLINE\n8\n{layer}\n66\n1\n70\n{flags}\n")?;
    place(out, 10, DVec2::ZERO.into())?;
    for p in points.positions() {
        write!(out, "0\nVERTEX\n8\n{layer}\n{vertex}")?;
        place(out, 10, p)?;
    }
    write!(out, "0\nSEQEND\n8\n{layer}\n")
}

/// A place in space, its x under the given code.
fn place(out: &mut dyn Write, code: u32, position: Position) -> io::Result<()> {
    let Position { place: p, height } = position;
    let [x, y, z] = [p.x, p.y, height.unwrap_or(0.0)].map(Number);
    write!(out, "{code}\n{x}\n{}\n{y}\n{}\n{z}\n", code + 10, code + 20)
}
