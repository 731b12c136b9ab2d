//! SVG: the centres of circles; without any, the vertices of polygons and polylines; without
//! those, the ends of the segments of paths.

use crate::drawing::{self, is_in_place, number};
use curvecrust::DVec2;
use curvecrust::curve::SplitCurve;
use roxmltree::Document;

/// Reads the points that a document draws.
pub(super) fn read(text: &str) -> Result<Vec<DVec2>, String> {
    let document = drawing::parse(text)?;
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
    if points.is_empty() {
        return ends(&document);
    }
    Ok(points)
}

fn vertices(list: &str) -> Result<Vec<DVec2>, String> {
    let words = list.split([',', ' ', '\n', '\t', '\r']);
    let words = words.filter(|word| !word.is_empty());
    let numbers: Result<Vec<f64>, _> = words.map(str::parse).collect();
    let numbers = numbers.map_err(|_| "a polygon has points that are not numbers".to_owned())?;
    let pairs = numbers.chunks_exact(2);
    Ok(pairs.map(|pair| DVec2::new(pair[0], pair[1])).collect())
}

fn ends(document: &Document<'_>) -> Result<Vec<DVec2>, String> {
    let mut points: Vec<DVec2> = Vec::new();
    for d in drawing::paths(document)? {
        let split = SplitCurve::from_path_data(&d).map_err(|why| why.to_string())?;
        for path in split.pieces().components() {
            let starts = path.segments().iter().map(|segment| segment.start());
            points.extend(starts);
            let end = path.segments().last().filter(|_| !path.is_closed());
            // The end of a piece is the start of the next one, where they meet at a corner.
            points.extend(end.map(|segment| segment.end()));
        }
    }
    points.dedup();
    Ok(points)
}
