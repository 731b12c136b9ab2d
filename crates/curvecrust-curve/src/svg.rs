//! SVG documents: what usvg says is drawn and where, with path data read in double precision.
//!
//! [`Curve::from_svg`](crate::Curve::from_svg) reads the geometry of a document and nothing of its
//! paint: a shape counts with or without fill and stroke, clips and masks cut off nothing, markers
//! and dashes are not drawn. Coordinates are those of the user space inside the root element, which
//! is what its content is written in; its `viewBox`, size and transform only place that on a page.
//! `y` grows as in the document.
//!
//! - **[usvg]** lays the document out: groups, `use`, `symbol`, `switch`, nested `svg`, transforms,
//!   units, style sheets, and the basic shapes. It computes in single precision (7 digits), and its
//!   circles, ellipses and rounded corners are cubics within 3e-4 of their radius.
//! - **`path` elements** are read by the strict grammar and in double precision, as by
//!   [`Curve::from_path_data`](crate::Curve::from_path_data). Only their transforms come from usvg.
//! - **Not part of the curve** is what SVG does not draw as a shape: hidden elements (`display`,
//!   `visibility`), what is drawn only by reference (`defs`, `clipPath`, `pattern`, ...), text and
//!   images. No file is ever opened.
//! - **Refused** is what usvg would leave out or misplace without saying so: attributes that are
//!   malformed or out of range, geometry in CSS, references to nothing.
//! - **Bounded**, for documents that nobody vouches for: the [`expansion`] of entities and their
//!   number, attributes of an element, declarations of style, levels of elements, elements and
//!   segments drawn, before any of it is laid out. Nothing outside of the document is ever read.

mod bounds;
mod entities;
mod strict;
mod style;
pub mod value;

use std::collections::{BTreeMap, HashMap};
use std::fmt::Write;

use glam::{DAffine2, DVec2};
use usvg::roxmltree::{Document, Node, ParsingOptions};
use usvg::tiny_skia_path::{PathSegment, Point};
use usvg::{ImageHrefResolver, Options, Tree};

use crate::bezier_path::BezierPath;
use crate::error::{CurveError, DENSE_LIMIT};
use crate::path_data::Pen;
pub use bounds::{MAX_ATTRIBUTES, MAX_ELEMENTS, MAX_ENTITIES, MAX_PREFIXES, check_bounds};
pub use entities::expansion;
use strict::{PathElement, label, unsupported};
pub use style::MAX_DECLARATIONS;

const SVG: &str = "http://www.w3.org/2000/svg";

/// The largest [`expansion`] of a document that is read: 16 MiB.
pub const MAX_EXPANSION: usize = 1 << 24;

/// Segments drawn: more than that cannot be discretised.
const MAX_SEGMENTS: usize = DENSE_LIMIT;

/// Lets usvg keep every shape, whatever its paint, and add none.
///
/// A sheet that is injected comes before all others, and of two `!important` declarations usvg
/// keeps the first. The background makes it put what is drawn into one group, which has the
/// transform of the root element to the page; as it has no stroke, it is told from the shapes.
const SHOW_SHAPES: &str = "* {
    fill: none !important; stroke: black !important; stroke-width: 1 !important;
    stroke-dasharray: none !important; stroke-opacity: 1 !important; opacity: 1 !important;
    marker: none !important; clip-path: none !important; mask: none !important;
    filter: none !important; overflow: visible !important; background-color: black !important;
}";

/// What `make` makes of the components of a document.
pub(crate) fn parse<T>(
    text: &str,
    make: impl FnOnce(Vec<BezierPath>) -> Result<T, CurveError>,
) -> Result<T, CurveError> {
    let document = parse_xml(text)?;
    let root = document.root_element();
    if !root.has_tag_name((SVG, "svg")) {
        let name = root.tag_name().name().to_owned();
        return Err(CurveError::NotSvg { name });
    }
    style::check(&document)?;
    let by_id = strict::by_id(&document);
    let paths = strict::paths(root, &by_id)?;
    bounds::check_elements(root, |id| by_id.get(id).map(Node::id))?;
    let tree = lay_out(&with_stand_ins(text, &paths))?;
    let mut drawing = Drawing {
        paths,
        by_id,
        components: Vec::new(),
        segments: 0,
    };
    if let [usvg::Node::Group(page)] = tree.root().children() {
        drawing.collect(page.children(), DAffine2::IDENTITY)?;
    }
    let (nodes, components): (Vec<_>, Vec<_>) = drawing.components.into_iter().unzip();
    make(components).map_err(|error| match error.component().and_then(|c| nodes.get(c)) {
        Some(&Some(node)) => error.within(label(node)),
        _ => error,
    })
}

fn parse_xml(text: &str) -> Result<Document<'_>, CurveError> {
    check_bounds(text)?;
    let options = ParsingOptions {
        allow_dtd: true,
        ..ParsingOptions::default()
    };
    Document::parse_with_options(text, options).map_err(|error| {
        let position = error.pos();
        let message = error.to_string();
        let suffix = format!(" at {position}");
        CurveError::Xml {
            line: position.row,
            column: position.col,
            message: message.strip_suffix(&suffix).unwrap_or(&message).to_owned(),
        }
    })
}

/// The document with the path data of its k-th path replaced by a stand-in, which is known by its
/// quadratic segment: none of the basic shapes has one.
///
/// Path data would else be rounded to single precision, with arcs within 3e-4 of their radius.
fn with_stand_ins(text: &str, paths: &[PathElement<'_, '_>]) -> String {
    let mut places = BTreeMap::new();
    for (k, path) in paths.iter().enumerate() {
        // Elements of an entity that is used twice stand in one place, and draw the same.
        places.entry(path.d.start).or_insert((path.d.end, k));
    }
    let mut copy = String::with_capacity(text.len());
    let mut done = 0;
    for (start, (end, k)) in places {
        copy += &text[done..start];
        // Writing to a string cannot fail.
        let _ = write!(copy, "M{k} 0q0 0 1 0");
        done = end;
    }
    copy + &text[done..]
}

fn lay_out(text: &str) -> Result<Tree, CurveError> {
    let options = Options {
        image_href_resolver: ImageHrefResolver {
            resolve_data: Box::new(|_, _, _| None),
            resolve_string: Box::new(|_, _| None),
        },
        style_sheet: Some(SHOW_SHAPES.to_owned()),
        ..Options::default()
    };
    Tree::from_str(text, &options).map_err(|error| match error {
        usvg::Error::InvalidSize => {
            unsupported("the root has no size: give it a width and a height, or a viewBox")
        }
        usvg::Error::ParsingFailed(usvg::roxmltree::Error::NodesLimitReached) => {
            bounds::too_many_elements()
        }
        other => unsupported(other.to_string()),
    })
}

/// What is drawn, in the order of drawing.
struct Drawing<'a, 'input> {
    paths: Vec<PathElement<'a, 'input>>,
    by_id: HashMap<&'a str, Node<'a, 'input>>,
    /// The components, each with the element that draws it, where that is known.
    components: Vec<(Option<Node<'a, 'input>>, BezierPath)>,
    segments: usize,
}

impl Drawing<'_, '_> {
    fn collect(&mut self, nodes: &[usvg::Node], to_root: DAffine2) -> Result<(), CurveError> {
        for node in nodes {
            match node {
                usvg::Node::Group(group) => {
                    let to_root = to_root * affine(group.transform());
                    self.collect(group.children(), to_root)?;
                }
                usvg::Node::Path(path) if path.is_visible() && path.stroke().is_some() => {
                    self.draw(path, to_root)?;
                }
                _ => {}
            }
        }
        Ok(())
    }

    fn draw(&mut self, path: &usvg::Path, to_root: DAffine2) -> Result<(), CurveError> {
        let stand_in = stand_in(path).and_then(|k| self.paths.get(k));
        let (node, components) = match stand_in {
            Some(element) => (Some(element.node), &element.components),
            None => (self.by_id.get(path.id()).copied(), &shape(path)),
        };
        self.segments += components.iter().map(|c| c.segments().len()).sum::<usize>();
        if self.segments > MAX_SEGMENTS {
            return Err(unsupported(format!(
                "it has more than {MAX_SEGMENTS} segments, each drawn once per use: simplify it"
            )));
        }
        let placed = components
            .iter()
            .map(|c| c.map(|p| to_root.transform_point2(p)));
        self.components.extend(placed.map(|c| (node, c)));
        Ok(())
    }
}

/// The index of the path element that a stand-in stands for.
fn stand_in(path: &usvg::Path) -> Option<usize> {
    let mut segments = path.data().segments();
    match (segments.next(), segments.next()) {
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "an index below 1e6, written by us"
        )]
        (Some(PathSegment::MoveTo(at)), Some(PathSegment::QuadTo(..))) => Some(at.x as usize),
        _ => None,
    }
}

/// The components of a basic shape, in its own coordinates.
fn shape(path: &usvg::Path) -> Vec<BezierPath> {
    let double = |p: Point| DVec2::new(p.x.into(), p.y.into());
    let mut pen = Pen::default();
    for segment in path.data().segments() {
        match segment {
            PathSegment::MoveTo(to) => pen.move_to(double(to)),
            PathSegment::LineTo(to) => pen.line_to(double(to)),
            PathSegment::QuadTo(middle, to) => pen.quadratic_to(double(middle), double(to)),
            PathSegment::CubicTo(first, second, to) => {
                pen.cubic_to(double(first), double(second), double(to));
            }
            PathSegment::Close => pen.close(),
        }
    }
    pen.finish()
}

fn affine(t: usvg::Transform) -> DAffine2 {
    DAffine2::from_cols_array(&[t.sx, t.ky, t.kx, t.sy, t.tx, t.ty].map(f64::from))
}
