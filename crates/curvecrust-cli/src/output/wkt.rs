//! Well-known text: one geometry, a collection unless there is exactly one shape.

use super::{Feature, Number, Shape};
use curvecrust::DVec2;
use std::fmt::Display;
use std::io::{self, Write};

pub(super) fn write(out: &mut dyn Write, features: &[Feature]) -> io::Result<()> {
    let geometries = features.iter().map(|feature| geometry(&feature.shape));
    match features {
        [_] => writeln!(out, "{}", joined(geometries, "")),
        [] => writeln!(out, "GEOMETRYCOLLECTION EMPTY"),
        _ => writeln!(out, "GEOMETRYCOLLECTION({})", joined(geometries, ",\n")),
    }
}

fn geometry(shape: &Shape) -> String {
    match shape {
        Shape::Polygon(rings) => {
            let ring = |ring: &Vec<DVec2>| in_brackets(ring.iter().chain(ring.first()));
            format!("POLYGON({})", joined(rings.iter().map(ring), ", "))
        }
        Shape::Line(line) => format!("LINESTRING{}", in_brackets(line)),
        Shape::Points(points) if points.is_empty() => String::from("MULTIPOINT EMPTY"),
        Shape::Points(points) => {
            let points = points.iter().map(|p| in_brackets([p]));
            format!("MULTIPOINT({})", joined(points, ", "))
        }
        Shape::Segments(segments) if segments.is_empty() => String::from("MULTILINESTRING EMPTY"),
        Shape::Segments(segments) => {
            let segments = segments.iter().map(|s| in_brackets([&s.a, &s.b]));
            format!("MULTILINESTRING({})", joined(segments, ", "))
        }
    }
}

fn in_brackets<'a>(points: impl IntoIterator<Item = &'a DVec2>) -> String {
    let points = points.into_iter();
    let pairs = points.map(|p| format!("{} {}", Number(p.x), Number(p.y)));
    format!("({})", joined(pairs, ", "))
}

fn joined(parts: impl IntoIterator<Item = impl Display>, between: &str) -> String {
    let parts: Vec<String> = parts.into_iter().map(|part| part.to_string()).collect();
    parts.join(between)
}
