//! Well-known text: one geometry, a collection unless there is exactly one shape.

use super::{Feature, Number, Shape};
use curvecrust::DVec2;
use std::io::{self, Write};

pub(super) fn write<'a, P>(
    out: &mut dyn Write,
    features: impl Iterator<Item = Feature<'a, P>>,
) -> io::Result<()> {
    let mut shapes = features.map(|feature| feature.shape).peekable();
    let Some(first) = shapes.next() else {
        return writeln!(out, "GEOMETRYCOLLECTION EMPTY");
    };
    if shapes.peek().is_none() {
        geometry(out, &first)?;
        return writeln!(out);
    }
    write!(out, "GEOMETRYCOLLECTION(")?;
    geometry(out, &first)?;
    for shape in shapes {
        writeln!(out, ",")?;
        geometry(out, &shape)?;
    }
    writeln!(out, ")")
}

fn geometry(out: &mut dyn Write, shape: &Shape<'_>) -> io::Result<()> {
    match shape {
        Shape::Polygon(rings) => {
            write!(out, "POLYGON")?;
            listed(out, rings, |out, ring| positions(out, ring.closed()))
        }
        Shape::Line(line) => {
            write!(out, "LINESTRING")?;
            positions(out, line.iter())
        }
        Shape::Points(points) => {
            write!(out, "MULTIPOINT")?;
            listed(out, points.iter(), |out, p| positions(out, [p]))
        }
        Shape::Segments(segments) => {
            write!(out, "MULTILINESTRING")?;
            listed(out, *segments, |out, s| positions(out, [s.a, s.b]))
        }
    }
}

fn positions(out: &mut dyn Write, points: impl IntoIterator<Item = DVec2>) -> io::Result<()> {
    listed(out, points, |out, p| {
        write!(out, "{} {}", Number(p.x), Number(p.y))
    })
}

/// Items in brackets, or `EMPTY`.
fn listed<T>(
    out: &mut dyn Write,
    items: impl IntoIterator<Item = T>,
    write_item: impl Fn(&mut dyn Write, T) -> io::Result<()>,
) -> io::Result<()> {
    let mut items = items.into_iter();
    let Some(first) = items.next() else {
        return write!(out, " EMPTY");
    };
    write!(out, "(")?;
    write_item(out, first)?;
    for item in items {
        write!(out, ", ")?;
        write_item(out, item)?;
    }
    write!(out, ")")
}
