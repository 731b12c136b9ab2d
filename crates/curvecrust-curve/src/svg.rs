//! SVG documents: all paths and shapes, in double precision.
//!
//! [`Curve::from_svg`](crate::Curve::from_svg) reads the geometry of a document and nothing of its
//! paint: a path counts with or without fill and stroke. Coordinates are those of the user space of
//! the root element, which is what its content is written in; its `viewBox` and size only place
//! them on a page. `y` grows as in the document.
//!
//! - **Read**: `path` (by the strict grammar), `circle`, `ellipse`, `rect`, `line`, `polyline`,
//!   `polygon`; `g`, `a`, `switch`, nested `svg`, `use` of any of them and of `symbol`; `transform`,
//!   `viewBox`, `preserveAspectRatio`, lengths with absolute units or `%`.
//! - **Not part of the curve**: what SVG draws only by reference (`defs`, `symbol`, `clipPath`,
//!   `mask`, `marker`, `pattern`), descriptions, scripts, animations, and other namespaces. Clips
//!   and masks cut off nothing.
//! - **Refused**, because it would draw something that is lost or misplaced: shapes that are hidden
//!   (`display`, `visibility`), text and images, geometry set in CSS, `transform-origin`, `em` and
//!   `ex`, broken or circular references.
//!
//! usvg, which renders as browsers do, is not used: it computes in single precision, drops invisible
//! elements and shapes with errors, and cuts malformed path data short, all without saying so.

mod attributes;
mod shapes;
mod space;

use std::collections::HashMap;

use roxmltree::{Document, Node, NodeId, ParsingOptions};

use crate::component::Component;
use crate::curve::Curve;
use crate::dense::DENSE_LIMIT;
use crate::error::CurveError;
use attributes::{check_properties, check_style_sheet, label, unsupported};
use space::Space;

const SVG: &str = "http://www.w3.org/2000/svg";
const XLINK: &str = "http://www.w3.org/1999/xlink";

/// Elements within each other, `use` included.
const MAX_DEPTH: usize = 256;
/// Elements drawn, each once per `use`: few references can otherwise make very many of them.
const MAX_ELEMENTS: usize = 1_000_000;
/// Segments drawn: more than that cannot be discretised.
const MAX_SEGMENTS: usize = DENSE_LIMIT;

/// Elements of SVG that draw nothing where they stand.
const NOT_DRAWN: &[&str] = &[
    "defs",
    "symbol",
    "clipPath",
    "mask",
    "marker",
    "pattern",
    "linearGradient",
    "radialGradient",
    "solidcolor",
    "hatch",
    "filter",
    "font",
    "font-face",
    "color-profile",
    "cursor",
    "view",
    "title",
    "desc",
    "metadata",
    "style",
    "script",
    "animate",
    "animateColor",
    "animateMotion",
    "animateTransform",
    "set",
    "discard",
];

/// The curves of a document.
pub(crate) fn parse(document: &str) -> Result<Curve, CurveError> {
    let options = ParsingOptions {
        allow_dtd: true,
        ..ParsingOptions::default()
    };
    let document = Document::parse_with_options(document, options).map_err(|error| {
        let position = error.pos();
        let message = error.to_string();
        let suffix = format!(" at {position}");
        CurveError::Xml {
            line: position.row,
            column: position.col,
            message: message.strip_suffix(&suffix).unwrap_or(&message).to_owned(),
        }
    })?;
    let root = document.root_element();
    if !root.has_tag_name((SVG, "svg")) {
        let name = root.tag_name().name().to_owned();
        return Err(CurveError::NotSvg { name });
    }
    let mut walk = Walk::default();
    for node in root.descendants().filter(Node::is_element) {
        if let Some(id) = node.attribute("id") {
            // As in browsers, the first element of a name counts.
            walk.by_id.entry(id).or_insert(node);
        }
        if node.has_tag_name((SVG, "style")) {
            let sheet: String = node.descendants().filter_map(|n| n.text()).collect();
            check_style_sheet(&sheet).map_err(|e| e.within(label(node)))?;
        }
    }
    let space = Space::of_root(root).map_err(|e| e.within(label(root)))?;
    walk.children(root, space, 0)?;
    let (nodes, components): (Vec<_>, Vec<_>) = walk.components.into_iter().unzip();
    Curve::new(components).map_err(|error| match error.component().and_then(|c| nodes.get(c)) {
        Some(&node) => error.within(label(node)),
        None => error,
    })
}

/// The walk through what a document draws, in the order of drawing.
#[derive(Default)]
struct Walk<'a, 'input> {
    by_id: HashMap<&'a str, Node<'a, 'input>>,
    /// The components, each with the element that draws it.
    components: Vec<(Node<'a, 'input>, Component)>,
    /// The targets of the `use` elements around the present one.
    used: Vec<NodeId>,
    elements: usize,
    segments: usize,
}

impl<'a, 'input> Walk<'a, 'input> {
    fn children(
        &mut self,
        node: Node<'a, 'input>,
        space: Space,
        depth: usize,
    ) -> Result<(), CurveError> {
        for child in node.children().filter(Node::is_element) {
            self.element(child, space, depth + 1)?;
        }
        Ok(())
    }

    fn element(
        &mut self,
        node: Node<'a, 'input>,
        space: Space,
        depth: usize,
    ) -> Result<(), CurveError> {
        let name = node.tag_name().name();
        if node.tag_name().namespace() != Some(SVG) || NOT_DRAWN.contains(&name) {
            return Ok(());
        }
        let here = |error: CurveError| error.within(label(node));
        self.elements += 1;
        if depth > MAX_DEPTH || self.elements > MAX_ELEMENTS {
            let limit = format!("{MAX_DEPTH} levels or {MAX_ELEMENTS} elements");
            return Err(here(beyond(&limit)));
        }
        check_properties(node).map_err(here)?;
        let space = space.inside(node).map_err(here)?;
        match name {
            "g" | "a" => self.children(node, space, depth),
            "switch" => match node.children().find(|&child| is_chosen(child)) {
                Some(child) => self.element(child, space, depth + 1),
                None => Ok(()),
            },
            "svg" => {
                let space = space.of_viewport(node, None).map_err(here)?;
                self.children(node, space, depth)
            }
            "use" => self.reference(node, space, depth),
            _ => {
                let components = shapes::components(node, space).map_err(here)?;
                let segments = components.iter().map(|c| c.segments().len());
                self.segments += segments.sum::<usize>();
                if self.segments > MAX_SEGMENTS {
                    return Err(here(beyond(&format!("{MAX_SEGMENTS} segments"))));
                }
                self.components
                    .extend(components.into_iter().map(|c| (node, c)));
                Ok(())
            }
        }
    }

    /// Draws what a `use` element refers to.
    fn reference(
        &mut self,
        node: Node<'a, 'input>,
        space: Space,
        depth: usize,
    ) -> Result<(), CurveError> {
        let here = |error: CurveError| error.within(label(node));
        let link = node.attribute("href").or(node.attribute((XLINK, "href")));
        let link = link.unwrap_or_default().trim();
        let refuse = |message: &str| {
            here(CurveError::Attribute {
                name: "href".to_owned(),
                value: link.to_owned(),
                message: message.to_owned(),
            })
        };
        let target = link.strip_prefix('#').and_then(|id| self.by_id.get(id));
        let Some(&target) = target else {
            return Err(refuse(
                "is no element of the document: correct or remove it",
            ));
        };
        if self.used.contains(&target.id()) || node.ancestors().any(|a| a == target) {
            return Err(refuse("contains this element itself: correct or remove it"));
        }
        let space = space.shifted(node).map_err(here)?;
        self.used.push(target.id());
        let there = |error: CurveError| error.within(label(target));
        if target.has_tag_name((SVG, "symbol")) || target.has_tag_name((SVG, "svg")) {
            check_properties(target).map_err(there)?;
            let space = space.inside(target).map_err(there)?;
            let space = space.of_viewport(target, Some(node)).map_err(there)?;
            self.children(target, space, depth + 1)?;
        } else {
            self.element(target, space, depth + 1)?;
        }
        self.used.pop();
        Ok(())
    }
}

fn beyond(limit: &str) -> CurveError {
    unsupported(format!(
        "it is beyond the {limit} that are supported: simplify the document"
    ))
}

/// Whether a `switch` draws this child: the first without a condition, as its conditions ask for
/// languages and extensions.
fn is_chosen(child: Node<'_, '_>) -> bool {
    child.tag_name().namespace() == Some(SVG)
        && !child.has_attribute("requiredExtensions")
        && !child.has_attribute("systemLanguage")
        && !NOT_DRAWN.contains(&child.tag_name().name())
}
