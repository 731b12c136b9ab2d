//! The shapes of an SVG document, as path data.
//!
//! The page reads what stands in its place already: paths, circles, ellipses, polygons, polylines
//! and lines without transforms. It refuses the rest by name, and never shows another curve
//! instead. The library reads whole documents; it did so by usvg, which would have made half of the
//! module.

use curvecrust::curve::Curve;
use curvecrust::curve::svg::check_bounds;
use roxmltree::{Document, Node};

/// The smooth curves of a document.
pub(crate) fn curve(text: &str) -> Result<Curve, String> {
    // One path: to make curves of paths one by one and then of all would smooth joints twice.
    let mut all = String::new();
    for d in paths(&parse(text)?)? {
        let d = d.trim_start();
        if d.starts_with('m') {
            // It is absolute where a path begins.
            all += "M 0 0 ";
        }
        all += d;
        all.push(' ');
    }
    Curve::from_path_data(&all).map_err(|why| why.to_string())
}

/// A document that is bounded, and SVG.
pub(crate) fn parse(text: &str) -> Result<Document<'_>, String> {
    check_bounds(text).map_err(|why| why.to_string())?;
    let document = Document::parse(text).map_err(|why| format!("not XML: {why}"))?;
    if document.root_element().tag_name().name() != "svg" {
        return Err("this is XML, but not an SVG drawing".to_owned());
    }
    Ok(document)
}

/// The path data of every shape.
pub(crate) fn paths(document: &Document<'_>) -> Result<Vec<String>, String> {
    let mut paths = Vec::new();
    for node in document.descendants().filter(Node::is_element) {
        if let Some(d) = path_of(node)? {
            is_in_place(node)?;
            paths.push(d);
        }
    }
    Ok(paths)
}

fn path_of(node: Node<'_, '_>) -> Result<Option<String>, String> {
    let text = |name: &str| node.attribute(name).unwrap_or_default();
    Ok(match node.tag_name().name() {
        "path" => Some(text("d").to_owned()),
        "polygon" => Some(format!("M {} Z", text("points"))),
        "polyline" => Some(format!("M {}", text("points"))),
        "line" => {
            let [x1, y1, x2, y2] = ["x1", "y1", "x2", "y2"].map(|name| number(node, name));
            Some(format!("M {} {} L {} {}", x1?, y1?, x2?, y2?))
        }
        "circle" => Some(ellipse(node, number(node, "r")?, number(node, "r")?)?),
        "ellipse" => Some(ellipse(node, number(node, "rx")?, number(node, "ry")?)?),
        name @ ("rect" | "use" | "symbol" | "switch" | "text" | "image" | "defs" | "style") => {
            return Err(format!(
                "this drawing has the element {name}: the program reads it, this page does not"
            ));
        }
        _ => None,
    })
}

fn ellipse(node: Node<'_, '_>, rx: f64, ry: f64) -> Result<String, String> {
    let (x, y) = (number(node, "cx")?, number(node, "cy")?);
    let (left, right) = (x - rx, x + rx);
    Ok(format!(
        "M {right} {y} A {rx} {ry} 0 0 1 {left} {y} A {rx} {ry} 0 0 1 {right} {y} Z"
    ))
}

/// The page moves nothing: a moved shape would be taken for another.
pub(crate) fn is_in_place(node: Node<'_, '_>) -> Result<(), String> {
    if node.ancestors().any(|node| node.has_attribute("transform")) {
        return Err("this drawing has a transform: apply it, or use the program".to_owned());
    }
    Ok(())
}

/// A number of an element in user units; 0 if it is not given.
pub(crate) fn number(node: Node<'_, '_>, name: &str) -> Result<f64, String> {
    let text = node.attribute(name).unwrap_or("0").trim();
    let number = text.trim_end_matches("px").parse::<f64>().ok();
    let finite = number.filter(|number| number.is_finite());
    finite.ok_or_else(|| format!("an element has the {name} {text:.20?}, not a number"))
}
