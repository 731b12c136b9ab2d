//! SVG: the centres of all circles and ellipses; without any, the vertices of paths, polygons,
//! polylines and lines, without their handles. Coordinates are those inside the root element.

use super::{Flaw, Place, PointList, Problem, in_double_range, quoted};
use curvecrust::DVec2;
use curvecrust::curve::svg::check_bounds;
use curvecrust::curve::svg::value::{self, DAffine2, Length, ValueError};
use roxmltree::{Document, Node, ParsingOptions};
use svgtypes::{PathParser, PathSegment};

/// Elements whose content is not drawn where it stands, and what is no shape.
const NOT_DRAWN: &[&str] = &[
    "defs", "symbol", "clipPath", "mask", "pattern", "marker", "metadata", "title", "desc",
];

/// Levels of elements inside the root.
const DEEPEST: usize = 128;

pub(super) fn read(bytes: &[u8]) -> Result<PointList, Flaw> {
    let text = str::from_utf8(bytes).map_err(|_| Problem::NotSvg)?;
    let document = document(text)?;
    let root = document.root_element();
    if root.tag_name().name() != "svg" {
        return Err(Problem::NotSvg.into());
    }
    let mut drawing = Drawing::default();
    for child in root.children() {
        drawing.collect(child, DAffine2::IDENTITY, DEEPEST)?;
    }
    if drawing.centres.is_empty() && drawing.vertices.is_empty() {
        return Err(Problem::NoShapes.into());
    }
    let points = if drawing.centres.is_empty() {
        drawing.vertices
    } else {
        drawing.centres
    };
    Ok(points.into())
}

/// The elements of a document that is not out of proportion.
pub(super) fn document(text: &str) -> Result<Document<'_>, Flaw> {
    check_bounds(text).map_err(|error| Problem::Markup(error.to_string()))?;
    let options = ParsingOptions {
        allow_dtd: true,
        ..ParsingOptions::default()
    };
    Document::parse_with_options(text, options).map_err(|error| {
        let at = error.pos();
        Problem::Xml(error.to_string()).at(Place::Column(at.row.into(), at.col as usize))
    })
}

#[derive(Default)]
struct Drawing {
    centres: Vec<DVec2>,
    vertices: Vec<DVec2>,
}

impl Drawing {
    /// Takes what an element draws that holds at most `levels` of others in each other.
    fn collect(&mut self, node: Node<'_, '_>, outer: DAffine2, levels: usize) -> Result<(), Flaw> {
        let name = node.tag_name().name();
        if !node.is_element() || NOT_DRAWN.contains(&name) || is_hidden(node) {
            return Ok(());
        }
        let inner = attribute(node, "transform", value::transform)?;
        let to_root = outer * inner.unwrap_or_default();
        let place = |p: DVec2| {
            let p = to_root.transform_point2(p);
            let value = |v: f64| in_double_range(v).map_err(|e| e.at(place_of(node)));
            Ok::<_, Flaw>(DVec2::new(value(p.x)?, value(p.y)?))
        };
        match name {
            "circle" | "ellipse" => {
                let centre = DVec2::new(length(node, "cx")?, length(node, "cy")?);
                for name in ["r", "rx", "ry"] {
                    attribute(node, name, extent)?;
                }
                self.centres.push(place(centre)?);
            }
            "line" => {
                let start = DVec2::new(length(node, "x1")?, length(node, "y1")?);
                let end = DVec2::new(length(node, "x2")?, length(node, "y2")?);
                self.vertices.extend([place(start)?, place(end)?]);
            }
            "polyline" | "polygon" => {
                let points = attribute(node, "points", value::points)?;
                for p in points.unwrap_or_default() {
                    self.vertices.push(place(p)?);
                }
            }
            "path" => {
                for p in vertices(node)? {
                    self.vertices.push(place(p)?);
                }
            }
            "use" | "svg" => {
                return Err(Problem::Element(name.to_owned()).at(place_of(node)));
            }
            _ if levels == 0 => return Err(Problem::Deep(DEEPEST).at(place_of(node))),
            _ => {
                for child in node.children() {
                    self.collect(child, to_root, levels - 1)?;
                }
            }
        }
        Ok(())
    }
}

/// The start of every subpath, and the end of every segment that does not lead back to it.
fn vertices(node: Node<'_, '_>) -> Result<Vec<DVec2>, Flaw> {
    let mut vertices: Vec<DVec2> = Vec::new();
    let (mut at, mut start, mut first) = (DVec2::ZERO, DVec2::ZERO, 0);
    for segment in PathParser::from(node.attribute("d").unwrap_or_default()) {
        let segment = segment.map_err(|_| malformed(node, "d"))?;
        let from = at;
        let to =
            |abs: bool, x: f64, y: f64| DVec2::new(x, y) + if abs { DVec2::ZERO } else { from };
        at = match segment {
            PathSegment::MoveTo { abs, x, y }
            | PathSegment::LineTo { abs, x, y }
            | PathSegment::CurveTo { abs, x, y, .. }
            | PathSegment::SmoothCurveTo { abs, x, y, .. }
            | PathSegment::Quadratic { abs, x, y, .. }
            | PathSegment::SmoothQuadratic { abs, x, y }
            | PathSegment::EllipticalArc { abs, x, y, .. } => to(abs, x, y),
            PathSegment::HorizontalLineTo { abs, x } => DVec2::new(to(abs, x, 0.0).x, from.y),
            PathSegment::VerticalLineTo { abs, y } => DVec2::new(from.x, to(abs, 0.0, y).y),
            PathSegment::ClosePath { .. } => start,
        };
        match segment {
            PathSegment::ClosePath { .. } => {
                if vertices.len() > first + 1 && vertices.last() == Some(&start) {
                    vertices.pop();
                }
            }
            PathSegment::MoveTo { .. } => {
                (start, first) = (at, vertices.len());
                vertices.push(at);
            }
            _ => vertices.push(at),
        }
    }
    Ok(vertices)
}

fn is_hidden(node: Node<'_, '_>) -> bool {
    let style = node.attribute("style").unwrap_or_default();
    let styled = |name: &str, value: &str| {
        let declarations = style.split(';').filter_map(|d| d.split_once(':'));
        declarations
            .into_iter()
            .any(|(n, v)| n.trim() == name && v.trim() == value)
            || node.attribute(name) == Some(value)
    };
    styled("display", "none") || styled("visibility", "hidden")
}

/// A length in user units; 0 if it is not given.
fn length(node: Node<'_, '_>, name: &str) -> Result<f64, Flaw> {
    match attribute(node, name, value::length)? {
        None => Ok(0.0),
        Some(Length::Absolute(length)) => Ok(length),
        // The size of the page or of the font is not known here.
        Some(Length::Percent(_) | Length::OfFont(_)) => Err(malformed(node, name)),
    }
}

/// A length that is not negative; only whether it is one matters.
fn extent(value: &str) -> Result<(), ValueError> {
    match value {
        "auto" => Ok(()),
        _ if value::length(value)?.sign() < 0.0 => Err(ValueError::Length),
        _ => Ok(()),
    }
}

/// The value of an attribute, if it is there.
fn attribute<T>(
    node: Node<'_, '_>,
    name: &str,
    read: impl Fn(&str) -> Result<T, ValueError>,
) -> Result<Option<T>, Flaw> {
    let value = node.attribute(name).map(read).transpose();
    value.map_err(|error| match error {
        ValueError::Length => malformed(node, name),
        _ => {
            let (name, message) = (name.to_owned(), error.to_string());
            Problem::Value { name, message }.at(place_of(node))
        }
    })
}

fn malformed(node: Node<'_, '_>, name: &str) -> Flaw {
    let found = quoted(node.attribute(name).unwrap_or_default().as_bytes());
    let name = name.to_owned();
    Problem::Attribute { name, found }.at(place_of(node))
}

fn place_of(node: Node<'_, '_>) -> Place {
    let at = node.document().text_pos_at(node.range().start);
    Place::Column(at.row.into(), at.col as usize)
}
