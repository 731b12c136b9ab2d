//! Attributes of SVG elements: lengths, lists of numbers, and the few properties that matter.

use roxmltree::Node;
use svgtypes::{Length, LengthUnit, NumberListParser};

use super::space::Space;
use crate::error::CurveError;

/// Properties that would move or change a shape if they were set in CSS.
const GEOMETRY: &[&str] = &[
    "transform",
    "transform-origin",
    "transform-box",
    "translate",
    "rotate",
    "scale",
    "offset-path",
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
    "zoom",
];

/// What a percentage is a percentage of.
#[derive(Clone, Copy)]
pub(super) enum Along {
    Width,
    Height,
    Diagonal,
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

/// The error for an attribute of an element, with its value.
pub(super) fn refused(node: Node<'_, '_>, name: &str, message: impl Into<String>) -> CurveError {
    CurveError::Attribute {
        name: name.to_owned(),
        value: node.attribute(name).unwrap_or_default().to_owned(),
        message: message.into(),
    }
}

/// The length in an attribute, in user units; `None` if it is missing or `auto`.
pub(super) fn length(
    node: Node<'_, '_>,
    name: &str,
    along: Along,
    space: &Space,
) -> Result<Option<f64>, CurveError> {
    let Some(text) = node.attribute(name).map(str::trim) else {
        return Ok(None);
    };
    if text == "auto" {
        return Ok(None);
    }
    let Ok(Length { number, unit }) = text.parse::<Length>() else {
        return Err(refused(node, name, "is not a length: give a finite number"));
    };
    // CSS: 96 user units to the inch.
    let unit = match unit {
        LengthUnit::None | LengthUnit::Px => 1.0,
        LengthUnit::In => 96.0,
        LengthUnit::Cm => 96.0 / 2.54,
        LengthUnit::Mm => 96.0 / 25.4,
        LengthUnit::Pt => 96.0 / 72.0,
        LengthUnit::Pc => 16.0,
        LengthUnit::Percent => match space.viewport {
            Some(size) => {
                let whole = match along {
                    Along::Width => size.x,
                    Along::Height => size.y,
                    Along::Diagonal => size.length() / f64::sqrt(2.0),
                };
                whole / 100.0
            }
            None => {
                let message = "is a part of a size that the root does not have: give it a viewBox";
                return Err(refused(node, name, message));
            }
        },
        LengthUnit::Em | LengthUnit::Ex => {
            let message = "depends on a font: give it in user units";
            return Err(refused(node, name, message));
        }
    };
    Ok(Some(number * unit))
}

/// The length in an attribute, or 0.
pub(super) fn coordinate(
    node: Node<'_, '_>,
    name: &str,
    along: Along,
    space: &Space,
) -> Result<f64, CurveError> {
    Ok(length(node, name, along, space)?.unwrap_or(0.0))
}

/// The length in an attribute that must be there and positive.
pub(super) fn size(
    node: Node<'_, '_>,
    name: &str,
    along: Along,
    space: &Space,
) -> Result<f64, CurveError> {
    match length(node, name, along, space)? {
        Some(value) if value > 0.0 => Ok(value),
        _ => Err(refused(
            node,
            name,
            "must be positive: correct it, or remove the element",
        )),
    }
}

/// All numbers of a list.
pub(super) fn numbers(node: Node<'_, '_>, name: &str) -> Result<Vec<f64>, CurveError> {
    let text = node.attribute(name).unwrap_or_default();
    NumberListParser::from(text)
        .collect::<Result<_, _>>()
        .map_err(|error| refused(node, name, format!("is no list of numbers: {error}")))
}

/// The value of a property, from `style` or else from the attribute of its name.
pub(super) fn property<'a>(node: Node<'a, '_>, name: &str) -> Option<&'a str> {
    let style = node.attribute("style").unwrap_or_default();
    let declared = style.split(';').rev().find_map(|declaration| {
        let (property, value) = declaration.split_once(':')?;
        property.trim().eq_ignore_ascii_case(name).then_some(value)
    });
    let value = declared.or_else(|| node.attribute(name))?;
    Some(value.trim().trim_end_matches("!important").trim_end())
}

/// Refuses geometry in the `style` attribute, and transforms about another origin.
pub(super) fn check_properties(node: Node<'_, '_>) -> Result<(), CurveError> {
    let style = node.attribute("style").unwrap_or_default();
    if let Some(name) = declared(style).find(|p| GEOMETRY.contains(&p.as_str())) {
        return Err(refused(
            node,
            "style",
            format!("sets {name}, which is read from attributes only: make it an attribute"),
        ));
    }
    if node.has_attribute("transform-origin") {
        let message = "is not supported: write the origin into transform";
        return Err(refused(node, "transform-origin", message));
    }
    Ok(())
}

/// Refuses style sheets that move, change or hide shapes.
pub(super) fn check_style_sheet(sheet: &str) -> Result<(), CurveError> {
    let matters = |p: &String| {
        GEOMETRY.contains(&p.as_str()) || matches!(p.as_str(), "display" | "visibility")
    };
    match declared(sheet).find(matters) {
        Some(name) => Err(unsupported(format!(
            "it sets {name}, which is not read from style sheets: make it an attribute"
        ))),
        None => Ok(()),
    }
}

/// The names in front of the colons of CSS, in lower case: all declared properties among them.
fn declared(css: &str) -> impl Iterator<Item = String> + '_ {
    css.split(['{', '}', ';']).filter_map(|declaration| {
        let (before, _) = declaration.split_once(':')?;
        let is_part = |c: char| c.is_alphanumeric() || c == '-' || c == '_';
        let name = before.trim_end().rsplit(|c| !is_part(c)).next()?;
        Some(name.to_ascii_lowercase())
    })
}
