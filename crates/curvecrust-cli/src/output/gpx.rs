//! GPX 1.1: points as way points, lines and rings as tracks; x is the longitude, y the latitude.

use super::{Feature, Number, Position, Shape};
use std::io::{self, ErrorKind, Write};

pub(super) fn write<'a, P>(
    out: &mut dyn Write,
    features: impl Iterator<Item = Feature<'a, P>>,
) -> io::Result<()> {
    // Way points come before tracks.
    let shapes: Vec<Shape<'a>> = features.map(|feature| feature.shape).collect();
    writeln!(out, r#"<?xml version="1.0" encoding="UTF-8"?>"#)?;
    let schema = "http://www.topografix.com/GPX/1/1";
    writeln!(
        out,
        r#"<gpx version="1.1" creator="curvecrust" xmlns="{schema}">"#
    )?;
    for shape in &shapes {
        if let Shape::Points(points) = shape {
            points
                .positions()
                .try_for_each(|p| position(out, "wpt", p))?;
        }
    }
    for shape in &shapes {
        match shape {
            Shape::Points(_) => {}
            Shape::Line(line) => track(out, [line.positions()])?,
            Shape::Polygon(rings) => track(out, rings.iter().map(|ring| ring.closed()))?,
            Shape::Segments(segments) => {
                track(out, segments.iter().map(|s| [s.a, s.b].map(Position::from)))?;
            }
        }
    }
    writeln!(out, "</gpx>")
}

/// A track, of which each part is a segment.
fn track<I: IntoIterator<Item = Position>>(
    out: &mut dyn Write,
    parts: impl IntoIterator<Item = I>,
) -> io::Result<()> {
    writeln!(out, "<trk>")?;
    for part in parts {
        writeln!(out, "<trkseg>")?;
        let mut points = part.into_iter();
        points.try_for_each(|p| position(out, "trkpt", p))?;
        writeln!(out, "</trkseg>")?;
    }
    writeln!(out, "</trk>")
}

fn position(out: &mut dyn Write, name: &str, position: Position) -> io::Result<()> {
    let p = position.place;
    let (x, y) = (Number(p.x), Number(p.y));
    if p.x.abs() > 180.0 || p.y.abs() > 90.0 {
        let message = format!("gpx holds longitudes and latitudes, and ({x}, {y}) is none");
        return Err(io::Error::new(ErrorKind::InvalidInput, message));
    }
    match position.height.map(Number) {
        None => writeln!(out, r#"<{name} lat="{y}" lon="{x}"/>"#),
        Some(z) => writeln!(
            out,
            r#"<{name} lat="{y}" lon="{x}"><ele>{z}</ele></{name}>"#
        ),
    }
}
