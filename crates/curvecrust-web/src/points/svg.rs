//! SVG: the centres of circles and ellipses; without any, the ends of the segments of all that is
//! drawn.

use curvecrust::DVec2;
use curvecrust::curve::svg::value::{self, DAffine2, Length};
use curvecrust::curve::svg::{Drawing, check_bounds};
use roxmltree::{Document, Node, ParsingOptions};

/// Elements whose content is not drawn where it stands.
const NOT_DRAWN: [&str; 6] = ["defs", "symbol", "clipPath", "mask", "pattern", "marker"];

/// Reads the points that a document draws.
pub(super) fn read(text: &str) -> Result<Vec<DVec2>, String> {
    check_bounds(text).map_err(|why| why.to_string())?;
    let options = ParsingOptions {
        allow_dtd: true,
        ..ParsingOptions::default()
    };
    let document = Document::parse_with_options(text, options);
    let document = document.map_err(|why| format!("not XML: {why}"))?;
    if document.root_element().tag_name().name() != "svg" {
        return Err("this is XML, but not an SVG drawing".to_owned());
    }
    let round = |node: &Node<'_, '_>| matches!(node.tag_name().name(), "circle" | "ellipse");
    let is_drawn = |node: &Node<'_, '_>| {
        let mut names = node.ancestors().map(|node| node.tag_name().name());
        names.all(|name| !NOT_DRAWN.contains(&name))
    };
    let nodes = document.descendants().filter(round).filter(is_drawn);
    let centres: Vec<DVec2> = nodes.map(centre).collect::<Result<_, _>>()?;
    if !centres.is_empty() {
        return Ok(centres);
    }
    let drawing = Drawing::new(text).map_err(|why| why.to_string())?;
    Ok(ends(&drawing))
}

fn centre(node: Node<'_, '_>) -> Result<DVec2, String> {
    let length = |name: &str| match node.attribute(name).map(value::length) {
        None => Ok(0.0),
        Some(Ok(Length::Absolute(length))) => Ok(length),
        _ => Err(format!("a circle has no {name} that is a length")),
    };
    let mut centre = DVec2::new(length("cx")?, length("cy")?);
    for node in node
        .ancestors()
        .filter(|node| node.tag_name().name() != "svg")
    {
        let transform = node.attribute("transform").map(value::transform);
        let transform = transform.transpose().map_err(|why| why.to_string())?;
        let transform: DAffine2 = transform.unwrap_or_default();
        centre = transform.transform_point2(centre);
    }
    Ok(centre)
}

fn ends(drawing: &Drawing) -> Vec<DVec2> {
    let mut points: Vec<DVec2> = Vec::new();
    for path in drawing.components() {
        points.extend(path.segments().iter().map(|segment| segment.start()));
        let end = path.segments().last().filter(|_| !path.is_closed());
        points.extend(end.map(|segment| segment.end()));
    }
    points.dedup();
    points
}
