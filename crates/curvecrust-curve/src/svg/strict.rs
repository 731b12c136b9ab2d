//! What browsers pass over in silence is refused here: malformed attributes, geometry in CSS,
//! references to nothing.

use roxmltree::{Attribute, Node};
use svgtypes::{AspectRatio, ViewBox};

use super::SVG;
use super::value::{self, Length};
use crate::error::CurveError;

const XLINK: &str = "http://www.w3.org/1999/xlink";

/// Elements that draw, or that hold what can be drawn; `defs` by reference.
const DRAWING: &[&str] = &[
    "svg", "g", "a", "switch", "defs", "symbol", "use", "path", "circle", "ellipse", "rect",
    "line", "polyline", "polygon",
];

/// Elements that draw by themselves.
const SHAPES: &[&str] = &[
    "path", "circle", "ellipse", "rect", "line", "polyline", "polygon",
];

/// Properties that move or change a shape when they are set in CSS, where they are not read.
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

pub(super) fn refused(attribute: &Attribute<'_, '_>, message: impl Into<String>) -> CurveError {
    CurveError::Attribute {
        name: attribute.name().to_owned(),
        value: attribute.value().to_owned(),
        message: message.into(),
    }
}

/// Whether an element draws, or may hold what does.
pub(super) fn is_drawing(node: Node<'_, '_>) -> bool {
    let tag = node.tag_name();
    matches!(tag.namespace(), None | Some(SVG)) && DRAWING.contains(&tag.name())
}

/// Whether an element of those that draw is a shape.
pub(super) fn is_shape(node: Node<'_, '_>) -> bool {
    SHAPES.contains(&node.tag_name().name())
}

/// What a `use` element refers to.
pub(super) fn link<'a, 'input>(node: Node<'a, 'input>) -> Option<Attribute<'a, 'input>> {
    let in_xlink = |a: &Attribute<'_, '_>| (a.namespace(), a.name()) == (Some(XLINK), "href");
    let plain = node.attributes().find(|a| is_plain(a, "href"));
    plain.or_else(|| node.attributes().find(in_xlink))
}

/// Refuses style sheets that set geometry.
pub(super) fn check_sheets(root: Node<'_, '_>) -> Result<(), CurveError> {
    for node in root.descendants().filter(|n| n.has_tag_name("style")) {
        let sheet: String = node.descendants().filter_map(|n| n.text()).collect();
        if let Some(name) = geometry_in_css(&sheet) {
            let what = format!("it sets {name}, {ATTRIBUTES_ONLY}");
            return Err(unsupported(what).within(label(node)));
        }
    }
    Ok(())
}

/// Checks of the attributes of elements.
pub(super) struct Check {
    /// Whether the document has a size, which percentages refer to.
    is_sized: bool,
}

impl Check {
    pub(super) fn of(root: Node<'_, '_>) -> Self {
        let absolute = |name| {
            let length = root.attribute(name).map(value::length);
            matches!(length, Some(Ok(Length::Absolute(_))))
        };
        Self {
            is_sized: root.has_attribute("viewBox") || absolute("width") && absolute("height"),
        }
    }

    pub(super) fn element(&self, node: Node<'_, '_>) -> Result<(), CurveError> {
        for attribute in node.attributes() {
            self.attribute(node, attribute)?;
        }
        check_size(node)
    }

    fn attribute(
        &self,
        node: Node<'_, '_>,
        attribute: Attribute<'_, '_>,
    ) -> Result<(), CurveError> {
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
        let Some(length) = length.filter(|length| is_small(length.sign())) else {
            return Err("is not a length: give a number below 1e38".to_owned());
        };
        let is_root = node.parent_element().is_none();
        if matches!(length, Length::OfFont(_)) && !is_root {
            let message = "is in units of a font, which has no size here: give a number";
            return Err(message.to_owned());
        }
        if matches!(length, Length::Percent(_)) && !self.is_sized && !is_root {
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
    let is_small = transform.to_cols_array().into_iter().all(is_small);
    let determinant = transform.matrix2.determinant();
    if is_small && determinant.abs() >= f64::MIN_POSITIVE {
        Ok(())
    } else {
        Err("scales to nothing, or beyond 1e38: correct it".to_owned())
    }
}

fn check_points(value: &str) -> Result<(), String> {
    let points = value::points(value).map_err(|error| error.to_string())?;
    let mut numbers = points.iter().flat_map(|p| p.to_array());
    match numbers.find(|&number| !is_small(number)) {
        None => Ok(()),
        Some(number) => Err(format!("has the number {number:e}: keep below 1e38")),
    }
}

fn check_view_box(value: &str) -> Result<(), String> {
    let view = value.parse::<ViewBox>().ok();
    match view.filter(|v| [v.x, v.y, v.w, v.h].into_iter().all(is_small)) {
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

/// Whether sums and products of numbers like this one stay far from infinity.
fn is_small(number: f64) -> bool {
    number.abs() <= 1e38
}
