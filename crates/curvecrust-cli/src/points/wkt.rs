//! Well-known text, by the crate of that name: the points of all geometries, one after the other in
//! the text; the vertices of lines and polygons on request.

use super::gathered::{Gathered, Vertex};
use super::system::System;
use super::{Flaw, Place, PointList, Problem, ReadOptions, quoted};
use std::str::FromStr;
use wkt::Wkt;
use wkt::types::{Coord, LineString};

/// Levels of brackets: the crate reads what is inside by recursion.
const DEEPEST: i32 = 64;

pub(super) fn read(bytes: &[u8], options: &ReadOptions) -> Result<PointList, Flaw> {
    let text = str::from_utf8(bytes).map_err(|_| Problem::NotWkt)?;
    let mut found = Gathered::new(options);
    for (line, text) in geometries(text)? {
        found.go_to(Place::Line(line));
        let problem = |message: &str| Problem::Wkt(message.to_owned()).at(Place::Line(line));
        let (system, text) = without_srid(text);
        if let Some(srid) = system {
            let srid = srid.trim().parse();
            let srid = srid.map_err(|_| problem("the number of SRID cannot be read"))?;
            found.system(System::of_srid(srid));
        }
        let geometry = Wkt::<f64>::from_str(text).map_err(problem)?;
        collect(&mut found, &geometry)?;
    }
    Ok(found.finish())
}

/// The geometries, each with the line that it starts in. One ends with the line in which its
/// brackets are closed.
fn geometries(text: &str) -> Result<Vec<(u64, &str)>, Flaw> {
    let mut found = Vec::new();
    let (mut depth, mut offset) = (0, 0);
    let mut start: Option<(u64, usize)> = None;
    for (number, line) in (1..).zip(text.split_inclusive('\n')) {
        let is_text = !line.trim().is_empty() && !line.trim_start().starts_with('#');
        if depth > 0 || is_text {
            let (first, from) = *start.get_or_insert((number, offset));
            for byte in line.bytes() {
                depth += match byte {
                    b'(' => 1,
                    b')' => -1,
                    _ => 0,
                };
                if depth > DEEPEST {
                    return Err(Problem::Wkt("brackets in brackets".into()).at(Place::Line(first)));
                }
            }
            if depth <= 0 {
                let whole = text[from..offset + line.len()].trim();
                found.push((first, whole.trim_end_matches(';')));
                (start, depth) = (None, 0);
            }
        }
        offset += line.len();
    }
    match start {
        Some((line, _)) => {
            Err(Problem::Wkt("a bracket is not closed".into()).at(Place::Line(line)))
        }
        None => Ok(found),
    }
}

/// The number of the reference system that PostGIS puts in front, and what follows it.
fn without_srid(text: &str) -> (Option<&str>, &str) {
    match text.split_once(';') {
        Some((start, rest)) if start.to_ascii_uppercase().starts_with("SRID=") => {
            (Some(&start["SRID=".len()..]), rest)
        }
        _ => (None, text),
    }
}

fn collect(found: &mut Gathered, geometry: &Wkt<f64>) -> Result<(), Flaw> {
    match geometry {
        Wkt::Point(point) => point.coord().map_or(Ok(()), |c| take(found, c)),
        Wkt::MultiPoint(many) => {
            let mut coords = many.points().iter().filter_map(|point| point.coord());
            coords.try_for_each(|c| take(found, c))
        }
        Wkt::GeometryCollection(many) => {
            many.geometries().iter().try_for_each(|g| collect(found, g))
        }
        Wkt::LineString(_) | Wkt::MultiLineString(_) | Wkt::Polygon(_) | Wkt::MultiPolygon(_) => {
            let name = format!("{geometry}");
            let name = name.split(|c: char| !c.is_ascii_alphabetic()).next();
            found.wants_vertices(&quoted(name.unwrap_or_default().as_bytes()))?;
            take_lines(found, geometry)
        }
    }
}

/// The vertices of lines and polygons.
fn take_lines(found: &mut Gathered, geometry: &Wkt<f64>) -> Result<(), Flaw> {
    match geometry {
        Wkt::LineString(line) => take_line(found, line),
        Wkt::MultiLineString(many) => {
            let mut lines = many.line_strings().iter();
            lines.try_for_each(|line| take_line(found, line))
        }
        Wkt::Polygon(polygon) => polygon.rings().iter().try_for_each(|r| take_line(found, r)),
        Wkt::MultiPolygon(many) => {
            let mut rings = many.polygons().iter().flat_map(|p| p.rings());
            rings.try_for_each(|ring| take_line(found, ring))
        }
        _ => Ok(()),
    }
}

fn take_line(found: &mut Gathered, line: &LineString<f64>) -> Result<(), Flaw> {
    let coords = line.coords();
    found.measure(coords.iter().any(|coord| coord.m.is_some()));
    found.line(coords.iter().map(|coord| Ok(vertex(coord))))
}

fn take(found: &mut Gathered, coord: &Coord<f64>) -> Result<(), Flaw> {
    found.measure(coord.m.is_some());
    found.point(vertex(coord))
}

fn vertex(coord: &Coord<f64>) -> Vertex {
    ([coord.x, coord.y], coord.z)
}
