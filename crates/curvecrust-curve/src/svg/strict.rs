//! What usvg passes over in silence is refused here: malformed attributes, geometry in CSS,
//! references to nothing.

use std::collections::HashMap;
use std::ops::Range;

use svgtypes::{AspectRatio, ViewBox};
use usvg::roxmltree::{Attribute, Document, Node, NodeId};

use super::SVG;
use super::value::{self, Length};
use crate::bezier_path::BezierPath;
use crate::error::CurveError;
use crate::path_data;

const XLINK: &str = "http://www.w3.org/1999/xlink";

/// Elements within each other, `use` included; usvg needs stack for each.
const MAX_DEPTH: usize = 128;

/// Elements that draw, or that hold what can be drawn; `defs` by reference.
const DRAWING: &[&str] = &[
    "svg", "g", "a", "switch", "defs", "symbol", "use", "path", "circle", "ellipse", "rect",
    "line", "polyline", "polygon",
];

/// Properties that move or change a shape when they are set in CSS, which usvg does not read there,
/// or not as CSS has them.
const GEOMETRY: &[&str] = &[
    "transform",
    "translate",
    "rotate",
    "scale",
    "offset-path",
    "zoom",
    "d",
    "x",
    "y",
    "cx",
    "cy",
    "r",
    "rx",
    "ry",
    "width",
    "height",
];

/// A path element.
pub(super) struct PathElement<'a, 'input> {
    pub(super) node: Node<'a, 'input>,
    /// Where its path data stand in the text of the document.
    pub(super) d: Range<usize>,
    /// What it draws, in its own coordinates.
    pub(super) components: Vec<BezierPath>,
}

/// How messages name an element.
pub(super) fn label(node: Node<'_, '_>) -> String {
    let line = node.document().text_pos_at(node.range().start).row;
    let name = node.tag_name().name();
    match node.attribute("id") {
        Some(id) => format!("<{name} id=\"{id}\"> in line {line}"),
        None => format!("<{name}> in line {line}"),
    }
}

pub(super) fn unsupported(what: impl Into<String>) -> CurveError {
    CurveError::Unsupported { what: what.into() }
}

fn refused(attribute: &Attribute<'_, '_>, message: impl Into<String>) -> CurveError {
    CurveError::Attribute {
        name: attribute.name().to_owned(),
        value: attribute.value().to_owned(),
        message: message.into(),
    }
}

/// The elements by their names; as in browsers, the first of a name counts.
pub(super) fn by_id<'a, 'input>(
    document: &'a Document<'input>,
) -> HashMap<&'a str, Node<'a, 'input>> {
    let mut by_id = HashMap::new();
    for node in document.descendants() {
        if let Some(id) = node.attribute("id") {
            by_id.entry(id).or_insert(node);
        }
    }
    by_id
}

/// All path elements that may be drawn, once everything that may be drawn is known to be sound.
pub(super) fn paths<'a, 'input>(
    root: Node<'a, 'input>,
    by_id: &HashMap<&'a str, Node<'a, 'input>>,
) -> Result<Vec<PathElement<'a, 'input>>, CurveError> {
    for node in root.descendants().filter(|n| n.has_tag_name("style")) {
        let sheet: String = node.descendants().filter_map(|n| n.text()).collect();
        if let Some(name) = geometry_in_css(&sheet) {
            let what = format!("it sets {name}, {ATTRIBUTES_ONLY}");
            return Err(unsupported(what).within(label(node)));
        }
    }
    let absolute = |name| root.attribute(name).is_some_and(|v| !v.ends_with('%'));
    let mut walk = Walk {
        by_id,
        sized: root.has_attribute("viewBox") || absolute("width") && absolute("height"),
        heights: HashMap::new(),
        paths: Vec::new(),
    };
    walk.element(root, 0)?;
    Ok(walk.paths)
}

struct Walk<'a, 'input, 'm> {
    by_id: &'m HashMap<&'a str, Node<'a, 'input>>,
    /// Whether the document has a size, which percentages refer to.
    sized: bool,
    /// How deep the elements seen so far are, `use` included; `None` while inside of them.
    heights: HashMap<NodeId, Option<usize>>,
    paths: Vec<PathElement<'a, 'input>>,
}

impl<'a, 'input> Walk<'a, 'input, '_> {
    /// Checks what an element draws, and returns how many levels that has.
    fn element(&mut self, node: Node<'a, 'input>, depth: usize) -> Result<usize, CurveError> {
        let tag = node.tag_name();
        let is_svg = matches!(tag.namespace(), None | Some(SVG));
        if !is_svg || !DRAWING.contains(&tag.name()) {
            return Ok(0);
        }
        let height = match self.heights.get(&node.id()) {
            Some(&height) => height.unwrap_or(0),
            None if depth > MAX_DEPTH => 0,
            None => {
                self.heights.insert(node.id(), None);
                let height = 1 + self.first_visit(node, depth)?;
                self.heights.insert(node.id(), Some(height));
                height
            }
        };
        if depth + height > MAX_DEPTH {
            let what = format!("it is more than {MAX_DEPTH} levels deep: simplify the document");
            return Err(unsupported(what).within(label(node)));
        }
        Ok(height)
    }

    fn first_visit(&mut self, node: Node<'a, 'input>, depth: usize) -> Result<usize, CurveError> {
        let here = |error: CurveError| error.within(label(node));
        for attribute in node.attributes() {
            self.check(node, attribute).map_err(here)?;
        }
        check_size(node).map_err(here)?;
        match node.tag_name().name() {
            "path" => {
                if let Some(d) = node.attributes().find(|a| is_plain(a, "d")) {
                    self.paths.push(PathElement {
                        node,
                        d: d.range_value(),
                        components: path_data::parse(d.value()).map_err(here)?,
                    });
                }
                Ok(0)
            }
            "use" => match self.target(node).map_err(here)? {
                Some(target) => self.element(target, depth + 1),
                None => Ok(0),
            },
            _ => {
                let mut height = 0;
                for child in node.children() {
                    height = height.max(self.element(child, depth + 1)?);
                }
                Ok(height)
            }
        }
    }

    /// The element that a `use` element refers to.
    fn target(&self, node: Node<'a, 'input>) -> Result<Option<Node<'a, 'input>>, CurveError> {
        let in_xlink = |a: &Attribute<'_, '_>| (a.namespace(), a.name()) == (Some(XLINK), "href");
        let plain = node.attributes().find(|a| is_plain(a, "href"));
        let Some(link) = plain.or_else(|| node.attributes().find(in_xlink)) else {
            return Ok(None);
        };
        let id = link.value().strip_prefix('#').unwrap_or_default();
        let message = match self.by_id.get(id) {
            None => "is no element of the document: correct or remove it",
            Some(target) if self.heights.get(&target.id()) == Some(&None) => {
                "contains this element itself: correct or remove it"
            }
            Some(&target) => return Ok(Some(target)),
        };
        Err(refused(&link, message))
    }

    fn check(&self, node: Node<'_, '_>, attribute: Attribute<'_, '_>) -> Result<(), CurveError> {
        let value = attribute.value();
        let checked = match (attribute.namespace(), attribute.name()) {
            (None, "style") => match geometry_in_css(value) {
                Some(name) => Err(format!("sets {name}, {ATTRIBUTES_ONLY}")),
                None => Ok(()),
            },
            (None, "transform") => check_transform(value),
            (None, "points") => check_points(value),
            (None, "viewBox") => check_view_box(value),
            (None, "preserveAspectRatio") => match value.parse::<AspectRatio>() {
                Ok(_) => Ok(()),
                Err(_) => Err("is not an alignment of SVG: correct it".to_owned()),
            },
            (
                None,
                name @ ("x" | "y" | "x1" | "y1" | "x2" | "y2" | "cx" | "cy" | "r" | "rx" | "ry"
                | "width" | "height"),
            ) => self.check_length(node, name, value),
            _ => Ok(()),
        };
        checked.map_err(|message| refused(&attribute, message))
    }

    fn check_length(&self, node: Node<'_, '_>, name: &str, value: &str) -> Result<(), String> {
        let is_extent = matches!(name, "r" | "rx" | "ry" | "width" | "height");
        if is_extent && value == "auto" {
            return Ok(());
        }
        let length = value::length(value).ok();
        let Some(length) = length.filter(|length| is_single(length.sign())) else {
            return Err("is not a length: give a number below 1e38".to_owned());
        };
        let is_root = node.parent_element().is_none();
        if matches!(length, Length::Percent(_)) && !self.sized && !is_root {
            let message = "is a part of a size that the root does not have: give it a viewBox";
            return Err(message.to_owned());
        }
        // Corners of a radius 0 are sharp, all else without an extent is not drawn.
        let may_vanish = matches!(name, "rx" | "ry") && !node.has_tag_name((SVG, "ellipse"));
        let sign = length.sign();
        if is_extent && sign <= 0.0 && !(may_vanish && sign == 0.0) {
            return Err("must be positive: correct it, or remove the element".to_owned());
        }
        Ok(())
    }
}

/// Refuses shapes without the attributes without which they are not drawn.
fn check_size(node: Node<'_, '_>) -> Result<(), CurveError> {
    let has = |name: &&&str| {
        node.attributes()
            .any(|a| is_plain(&a, name) && a.value() != "auto")
    };
    let (names, enough): (&[&str], _) = match node.tag_name().name() {
        "circle" => (&["r"], 1),
        "rect" => (&["width", "height"], 2),
        "ellipse" => (&["rx", "ry"], 1),
        _ => (&[], 0),
    };
    if names.iter().filter(has).count() < enough {
        return Err(unsupported(format!(
            "it has no size: give {}",
            names.join(" and ")
        )));
    }
    Ok(())
}

fn check_transform(value: &str) -> Result<(), String> {
    let transform = value::transform(value).map_err(|error| error.to_string())?;
    #[expect(clippy::cast_possible_truncation, reason = "as usvg does")]
    let [a, b, c, d, e, f] = transform.to_cols_array().map(|v| v as f32);
    match usvg::Transform::from_row(a, b, c, d, e, f).is_valid() {
        true => Ok(()),
        false => Err("scales to nothing, or beyond 1e38: correct it".to_owned()),
    }
}

fn check_points(value: &str) -> Result<(), String> {
    let points = value::points(value).map_err(|error| error.to_string())?;
    let mut numbers = points.iter().flat_map(|p| p.to_array());
    match numbers.find(|&number| !is_single(number)) {
        None => Ok(()),
        Some(number) => Err(format!("has the number {number:e}: keep below 1e38")),
    }
}

fn check_view_box(value: &str) -> Result<(), String> {
    let view = value.parse::<ViewBox>().ok();
    match view.filter(|v| [v.x, v.y, v.w, v.h].into_iter().all(is_single)) {
        Some(_) => Ok(()),
        None => Err("must be four numbers, the last two positive: correct it".to_owned()),
    }
}

const ATTRIBUTES_ONLY: &str = "which is read from attributes only: make it an attribute";

/// The first property that CSS sets of those that would have to be attributes.
fn geometry_in_css(css: &str) -> Option<&'static str> {
    css.split(['{', '}', ';']).find_map(|declaration| {
        let (before, _) = declaration.split_once(':')?;
        let is_part = |c: char| c.is_alphanumeric() || c == '-' || c == '_';
        let name = before.trim_end().rsplit(|c| !is_part(c)).next()?;
        GEOMETRY
            .iter()
            .find(|g| name.eq_ignore_ascii_case(g))
            .copied()
    })
}

/// Whether an attribute has this name, and no namespace.
fn is_plain(attribute: &Attribute<'_, '_>, name: &str) -> bool {
    attribute.name() == name && attribute.namespace().is_none()
}

/// Whether a number is in the range of single precision.
fn is_single(number: f64) -> bool {
    number.abs() <= f64::from(f32::MAX)
}
