//! Well-known text, by the crate of that name: the points of all geometries, one after the other in
//! the text, without their heights; the vertices of lines and polygons on request.

use super::{Flaw, Place, PointList, Problem, in_double_range, opened, quoted};
use curvecrust::DVec2;
use std::str::FromStr;
use wkt::Wkt;
use wkt::types::{Coord, LineString};

/// Levels of brackets: the crate reads what is inside by recursion.
const DEEPEST: i32 = 64;

pub(super) fn read(bytes: &[u8], vertices: bool) -> Result<PointList, Flaw> {
    let text = str::from_utf8(bytes).map_err(|_| Problem::NotWkt)?;
    let mut found = Found {
        points: Vec::new(),
        has_heights: false,
        vertices,
        line: 0,
    };
    for (line, text) in geometries(text)? {
        found.line = line;
        let problem = |message: &str| Problem::Wkt(message.to_owned()).at(Place::Line(line));
        let geometry = Wkt::<f64>::from_str(without_srid(text)).map_err(problem)?;
        found.collect(&geometry)?;
    }
    Ok(PointList::with_heights(found.points, found.has_heights))
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

/// Without the reference system that PostGIS puts in front.
fn without_srid(text: &str) -> &str {
    match text.split_once(';') {
        Some((start, rest)) if start.to_ascii_uppercase().starts_with("SRID=") => rest,
        _ => text,
    }
}

struct Found {
    points: Vec<DVec2>,
    has_heights: bool,
    /// Whether vertices count as points.
    vertices: bool,
    line: u64,
}

impl Found {
    fn collect(&mut self, geometry: &Wkt<f64>) -> Result<(), Flaw> {
        match geometry {
            Wkt::Point(point) => point.coord().map_or(Ok(()), |c| self.take(c)),
            Wkt::MultiPoint(many) => {
                let coords = many.points().iter().filter_map(|point| point.coord());
                coords.into_iter().try_for_each(|c| self.take(c))
            }
            Wkt::GeometryCollection(many) => {
                many.geometries().iter().try_for_each(|g| self.collect(g))
            }
            Wkt::LineString(_)
            | Wkt::MultiLineString(_)
            | Wkt::Polygon(_)
            | Wkt::MultiPolygon(_)
                if !self.vertices =>
            {
                let name = format!("{geometry}");
                let name = name.split(|c: char| !c.is_ascii_alphabetic()).next();
                let problem = Problem::Geometry(quoted(name.unwrap_or_default().as_bytes()));
                Err(problem.at(Place::Line(self.line)))
            }
            Wkt::LineString(line) => self.take_line(line),
            Wkt::MultiLineString(many) => many
                .line_strings()
                .iter()
                .try_for_each(|l| self.take_line(l)),
            Wkt::Polygon(polygon) => polygon.rings().iter().try_for_each(|r| self.take_line(r)),
            Wkt::MultiPolygon(many) => {
                let mut rings = many.polygons().iter().flat_map(|p| p.rings());
                rings.try_for_each(|ring| self.take_line(ring))
            }
        }
    }

    /// The vertices of a line, of a closed one the first once.
    fn take_line(&mut self, line: &LineString<f64>) -> Result<(), Flaw> {
        let is_same = |a: &Coord<f64>, b: &Coord<f64>| (a.x, a.y) == (b.x, b.y);
        let mut coords = opened(line.coords(), is_same).iter();
        coords.try_for_each(|coord| self.take(coord))
    }

    fn take(&mut self, coord: &Coord<f64>) -> Result<(), Flaw> {
        let value = |v: f64| in_double_range(v).map_err(|e| e.at(Place::Line(self.line)));
        self.points
            .push(DVec2::new(value(coord.x)?, value(coord.y)?));
        self.has_heights |= coord.z.is_some();
        Ok(())
    }
}
