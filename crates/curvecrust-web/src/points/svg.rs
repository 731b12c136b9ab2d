//! SVG: the centres of circles; without any, the vertices of polygons and polylines; without
//! those, the ends of the segments of paths.

use curvecrust::DVec2;
use curvecrust::curve::SplitCurve;
use curvecrust::curve::svg::check_bounds;
use roxmltree::{Document, Node};

/// Reads the points that a document draws.
pub(super) fn read(text: &str) -> Result<Vec<DVec2>, String> {
    check_bounds(text).map_err(|why| why.to_string())?;
    let document = Document::parse(text).map_err(|why| format!("not XML: {why}"))?;
    if document.root_element().tag_name().name() != "svg" {
        return Err("this is XML, but not an SVG drawing".to_owned());
    }
    let shapes = |names: &'static [&str]| {
        let nodes = document.descendants();
        nodes.filter(move |node| names.contains(&node.tag_name().name()))
    };
    let mut points = Vec::new();
    for node in shapes(&["circle", "ellipse"]) {
        is_in_place(node)?;
        points.push(DVec2::new(number(node, "cx")?, number(node, "cy")?));
    }
    if points.is_empty() {
        for node in shapes(&["polyline", "polygon"]) {
            is_in_place(node)?;
            points.extend(vertices(node.attribute("points").unwrap_or_default())?);
        }
    }
    if points.is_empty() && shapes(&["path", "line", "rect"]).next().is_some() {
        return ends(text);
    }
    Ok(points)
}

/// The page moves no points: a moved circle would be taken for another.
fn is_in_place(node: Node<'_, '_>) -> Result<(), String> {
    if node.ancestors().any(|node| node.has_attribute("transform")) {
        return Err("its points are moved by a transform: apply it, or use the program".to_owned());
    }
    Ok(())
}

fn number(node: Node<'_, '_>, name: &str) -> Result<f64, String> {
    let text = node.attribute(name).unwrap_or("0").trim();
    let number = text.trim_end_matches("px").parse::<f64>().ok();
    let finite = number.filter(|number| number.is_finite());
    finite.ok_or_else(|| format!("a circle has the {name} {:.20?}, not a number", text))
}

fn vertices(list: &str) -> Result<Vec<DVec2>, String> {
    let words = list
        .split([',', ' ', '\n', '\t', '\r'])
        .filter(|word| !word.is_empty());
    let numbers: Result<Vec<f64>, _> = words.map(str::parse).collect();
    let numbers = numbers.map_err(|_| "a polygon has points that are not numbers".to_owned())?;
    Ok(numbers
        .chunks_exact(2)
        .map(|pair| DVec2::new(pair[0], pair[1]))
        .collect())
}

fn ends(text: &str) -> Result<Vec<DVec2>, String> {
    let split = SplitCurve::from_svg(text).map_err(|why| why.to_string())?;
    let mut points: Vec<DVec2> = Vec::new();
    for path in split.pieces().components() {
        let starts = path.segments().iter().map(|segment| segment.start());
        let end = path.segments().last().filter(|_| !path.is_closed());
        points.extend(starts.chain(end.map(|segment| segment.end())));
    }
    Ok(points)
}
