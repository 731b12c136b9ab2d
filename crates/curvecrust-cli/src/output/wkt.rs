//! Well-known text: one geometry, a collection unless there is exactly one shape.

use super::{Feature, Number, Position, Shape};
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
    let z = if shape.has_heights() { " Z" } else { "" };
    match shape {
        Shape::Polygon(rings) => {
            write!(out, "POLYGON{z}")?;
            listed(out, rings, |out, ring| positions(out, ring.closed()))
        }
        Shape::Line(line) => {
            write!(out, "LINESTRING{z}")?;
            positions(out, line.positions())
        }
        Shape::Points(points) => {
            write!(out, "MULTIPOINT{z}")?;
            listed(out, points.positions(), |out, p| positions(out, [p]))
        }
        Shape::Segments(segments) => {
            write!(out, "MULTILINESTRING")?;
            listed(out, *segments, |out, s| {
                positions(out, [s.a, s.b].map(Position::from))
            })
        }
    }
}

fn positions(out: &mut dyn Write, positions: impl IntoIterator<Item = Position>) -> io::Result<()> {
    listed(out, positions, |out, position| {
        for (i, number) in position.coordinates().enumerate() {
            write!(out, "{}{}", if i == 0 { "" } else { " " }, Number(number))?;
        }
        Ok(())
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
