//! SVG: the centres of all circles and ellipses; without any, the vertices of paths, polygons,
//! polylines and lines, without their handles. Coordinates are those inside the root element.

use super::flaw::shown;
use super::{Flaw, Place, Problem, in_range};
use curvecrust::DVec2;
use curvecrust::curve::svg::{MAX_EXPANSION, expansion};
use roxmltree::{Document, Node, ParsingOptions};
use std::str::FromStr;
use svgtypes::{Length, LengthUnit, PathParser, PathSegment, PointsParser, Transform};

/// Elements whose content is not drawn where it stands, and what is no shape.
const NOT_DRAWN: &[&str] = &[
    "defs", "symbol", "clipPath", "mask", "pattern", "marker", "metadata", "title", "desc",
];

/// Levels of elements inside the root.
const DEEPEST: usize = 128;

pub(super) fn read(bytes: &[u8]) -> Result<Vec<DVec2>, Flaw> {
    let text = str::from_utf8(bytes).map_err(|_| Problem::NotSvg)?;
    if expansion(text) > MAX_EXPANSION {
        return Err(Problem::Entities(MAX_EXPANSION).into());
    }
    let options = ParsingOptions {
        allow_dtd: true,
        ..ParsingOptions::default()
    };
    let document = Document::parse_with_options(text, options).map_err(|error| {
        let at = error.pos();
        Problem::Xml(error.to_string()).at(Place::Column(at.row.into(), at.col as usize))
    })?;
    let root = document.root_element();
    if root.tag_name().name() != "svg" {
        return Err(Problem::NotSvg.into());
    }
    let mut drawing = Drawing::default();
    for child in root.children() {
        drawing.collect(child, Transform::default(), DEEPEST)?;
    }
    if drawing.centres.is_empty() && drawing.vertices.is_empty() {
        return Err(Problem::NoShapes.into());
    }
    Ok(if drawing.centres.is_empty() {
        drawing.vertices
    } else {
        drawing.centres
    })
}

#[derive(Default)]
struct Drawing {
    centres: Vec<DVec2>,
    vertices: Vec<DVec2>,
}

impl Drawing {
    /// Takes what an element draws that holds at most `levels` of others in each other.
    fn collect(&mut self, node: Node<'_, '_>, outer: Transform, levels: usize) -> Result<(), Flaw> {
        let name = node.tag_name().name();
        if !node.is_element() || NOT_DRAWN.contains(&name) || is_hidden(node) {
            return Ok(());
        }
        let inner: Transform = attribute(node, "transform")?.unwrap_or_default();
        let to_root = compose(outer, inner);
        let place = |p: DVec2| {
            let p = apply(to_root, p);
            let value = |v: f64| in_range(v, || v.to_string()).map_err(|e| e.at(place_of(node)));
            Ok::<_, Flaw>(DVec2::new(value(p.x)?, value(p.y)?))
        };
        match name {
            "circle" | "ellipse" => {
                let centre = DVec2::new(length(node, "cx")?, length(node, "cy")?);
                self.centres.push(place(centre)?);
            }
            "line" => {
                let start = DVec2::new(length(node, "x1")?, length(node, "y1")?);
                let end = DVec2::new(length(node, "x2")?, length(node, "y2")?);
                self.vertices.extend([place(start)?, place(end)?]);
            }
            "polyline" | "polygon" => {
                let points = PointsParser::from(node.attribute("points").unwrap_or_default());
                for (x, y) in points {
                    self.vertices.push(place(DVec2::new(x, y))?);
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
    let length: Length = attribute(node, name)?.unwrap_or_default();
    let factor = match length.unit {
        LengthUnit::None | LengthUnit::Px => 1.0,
        LengthUnit::In => 96.0,
        LengthUnit::Cm => 96.0 / 2.54,
        LengthUnit::Mm => 96.0 / 25.4,
        LengthUnit::Pt => 4.0 / 3.0,
        LengthUnit::Pc => 16.0,
        LengthUnit::Em | LengthUnit::Ex | LengthUnit::Percent => return Err(malformed(node, name)),
    };
    Ok(length.number * factor)
}

fn attribute<T: FromStr>(node: Node<'_, '_>, name: &str) -> Result<Option<T>, Flaw> {
    let parse = |text: &str| text.trim().parse().map_err(|_| malformed(node, name));
    node.attribute(name).map(parse).transpose()
}

fn malformed(node: Node<'_, '_>, name: &str) -> Flaw {
    let found = shown(node.attribute(name).unwrap_or_default().as_bytes());
    let name = name.to_owned();
    Problem::Attribute { name, found }.at(place_of(node))
}

fn place_of(node: Node<'_, '_>) -> Place {
    let at = node.document().text_pos_at(node.range().start);
    Place::Column(at.row.into(), at.col as usize)
}

fn apply(t: Transform, p: DVec2) -> DVec2 {
    DVec2::new(t.a * p.x + t.c * p.y + t.e, t.b * p.x + t.d * p.y + t.f)
}

/// First `inner`, then `outer`.
fn compose(outer: Transform, inner: Transform) -> Transform {
    let linear = |x, y| apply(outer, DVec2::new(x, y)) - DVec2::new(outer.e, outer.f);
    let (x, y) = (linear(inner.a, inner.b), linear(inner.c, inner.d));
    let origin = apply(outer, DVec2::new(inner.e, inner.f));
    Transform::new(x.x, x.y, y.x, y.y, origin.x, origin.y)
}
