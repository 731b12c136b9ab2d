//! The second walk over a document: where each shape is drawn, and how often.

use std::collections::HashMap;

use glam::{DAffine2, DVec2};
use roxmltree::{Node, NodeId};
use svgtypes::{Align, AspectRatio, ViewBox};

use super::css::Sheets;
use super::selection::Selection;
use super::shapes::{Lengths, Shape, Shapes};
use super::strict::{is_drawing, is_shape, label, link, unsupported};
use super::value;
use super::walk::ById;
use super::{MAX_SEGMENTS, SVG};
use crate::bezier_path::BezierPath;
use crate::error::CurveError;

/// The language of those who look at drawings, for `switch`.
const LANGUAGE: &str = "en";

/// Lays out a document that is known to be sound.
pub(super) struct Layout<'a, 'input, 'm> {
    pub(super) by_id: &'m ById<'a, 'input>,
    pub(super) sheets: &'m Sheets<'a>,
    pub(super) selection: &'m Selection,
    pub(super) shapes: Shapes,
    pub(super) marks: HashMap<NodeId, Mark>,
    pub(super) drawn: Drawn<'a, 'input>,
}

/// What is drawn, in the order of drawing.
#[derive(Default)]
pub(super) struct Drawn<'a, 'input> {
    /// The components, each with the element that draws it.
    pub(super) components: Vec<(Node<'a, 'input>, BezierPath)>,
    /// The elements that have subpaths without a length, as often as they are drawn.
    pub(super) points: Vec<Node<'a, 'input>>,
    /// The elements without a paint that are left out, as often as they are used.
    pub(super) unpainted: Vec<Node<'a, 'input>>,
    /// Components that have no paint, by their indices.
    without_paint: Vec<usize>,
    segments: usize,
}

impl Drawn<'_, '_> {
    /// Leaves out what has no paint, where something has one: a document without any paint is for
    /// its lines alone.
    fn leave_out_unpainted(&mut self) {
        if self.without_paint.len() == self.components.len() {
            return;
        }
        let mut without_paint = self.without_paint.iter().copied().peekable();
        let (mut index, unpainted) = (0, &mut self.unpainted);
        self.components.retain(|(node, _)| {
            let leave_out = without_paint.next_if_eq(&index).is_some();
            if leave_out && unpainted.last() != Some(node) {
                unpainted.push(*node);
            }
            index += 1;
            !leave_out
        });
    }
}

/// What an element says of itself, wherever it is used.
#[derive(Clone, Copy)]
pub(super) struct Mark {
    is_drawn: bool,
    is_visible: Option<bool>,
    paints: [Option<bool>; 2],
    is_selected: bool,
    transform: DAffine2,
}

/// Where an element is drawn.
#[derive(Clone, Copy)]
struct Place {
    to_root: DAffine2,
    /// The size of the viewport, if it has one.
    size: Option<DVec2>,
    is_visible: bool,
    /// Whether insides and outlines have a paint, or at least none that is `none`.
    paints: [bool; 2],
    is_selected: bool,
}

impl<'a, 'input> Layout<'a, 'input, '_> {
    /// Draws what is inside of the root element, in the coordinates there.
    pub(super) fn document(
        mut self,
        root: Node<'a, 'input>,
    ) -> Result<Drawn<'a, 'input>, CurveError> {
        let lengths = Lengths {
            node: root,
            size: None,
        };
        let given = || {
            Some(DVec2::new(
                lengths.get("width").ok()??,
                lengths.get("height").ok()??,
            ))
        };
        let place = Place {
            to_root: DAffine2::IDENTITY,
            size: view_box(root)
                .map(|view| DVec2::new(view.w, view.h))
                .or_else(given),
            is_visible: true,
            // An outline that nobody spoke of may have been forgotten.
            paints: [true, true],
            is_selected: self.selection.select.is_empty(),
        };
        let mark = self.mark(root);
        if mark.is_drawn {
            let inside = Place {
                to_root: DAffine2::IDENTITY,
                ..place.marked(mark)
            };
            self.children(root, inside)?;
        }
        self.drawn.leave_out_unpainted();
        Ok(self.drawn)
    }

    fn children(&mut self, node: Node<'a, 'input>, place: Place) -> Result<(), CurveError> {
        for child in node.children() {
            self.element(child, place)?;
        }
        Ok(())
    }

    fn element(&mut self, node: Node<'a, 'input>, place: Place) -> Result<(), CurveError> {
        if !is_drawing(node) {
            return Ok(());
        }
        let mark = self.mark(node);
        if !mark.is_drawn {
            return Ok(());
        }
        let place = place.marked(mark);
        match node.tag_name().name() {
            "g" | "a" => self.children(node, place),
            "switch" => match node.children().find(is_first_choice) {
                Some(child) => self.element(child, place),
                None => Ok(()),
            },
            "svg" => self.nested(node, place, [None; 2]),
            "use" => self.used(node, place),
            _ if is_shape(node) && place.is_visible && place.is_selected => self
                .shape(node, place)
                .map_err(|error| error.within(label(node))),
            _ => Ok(()),
        }
    }

    /// What a `use` element refers to, which may be nothing where it is not selected.
    fn used(&mut self, node: Node<'a, 'input>, place: Place) -> Result<(), CurveError> {
        let id = link(node).and_then(|link| link.value().strip_prefix('#'));
        let Some(&target) = id.and_then(|id| self.by_id.get(id)) else {
            return Ok(());
        };
        let here = |error: CurveError| error.within(label(node));
        let lengths = Lengths {
            node,
            size: place.size,
        };
        let at = lengths.point("x", "y").map_err(here)?;
        let place = place.moved(DAffine2::from_translation(at));
        match target.tag_name().name() {
            "svg" | "symbol" if is_drawing(target) => {
                let width = lengths.get("width").map_err(here)?;
                let height = lengths.get("height").map_err(here)?;
                let mark = self.mark(target);
                // A symbol is displayed where it is used, and nowhere else.
                if mark.is_drawn
                    || target.has_tag_name((SVG, "symbol")) && !self.is_excluded(target)
                {
                    return self.nested(target, place.marked(mark), [width, height]);
                }
                Ok(())
            }
            _ => self.element(target, place),
        }
    }

    /// What is in an `svg` or a `symbol` element, of a size that a `use` element may give.
    fn nested(
        &mut self,
        node: Node<'a, 'input>,
        place: Place,
        [width, height]: [Option<f64>; 2],
    ) -> Result<(), CurveError> {
        let here = |error: CurveError| error.within(label(node));
        let lengths = Lengths {
            node,
            size: place.size,
        };
        let is_svg = node.has_tag_name((SVG, "svg"));
        let own = |name: &str| if is_svg { lengths.get(name) } else { Ok(None) };
        let (own_width, own_height) = (own("width").map_err(here)?, own("height").map_err(here)?);
        let width = width.or(own_width).or(place.size.map(|size| size.x));
        let height = height.or(own_height).or(place.size.map(|size| size.y));
        let size = width.zip(height).map(DVec2::from);
        let at = if is_svg {
            lengths.point("x", "y").map_err(here)?
        } else {
            DVec2::ZERO
        };
        let mut inside = place.moved(DAffine2::from_translation(at));
        inside.size = size;
        if let Some(view) = view_box(node) {
            let Some(size) = size else {
                let what = "it has a viewBox without a size: give it a width and a height";
                return Err(here(unsupported(what)));
            };
            inside = inside.moved(fitted(view, size, node));
            inside.size = Some(DVec2::new(view.w, view.h));
        }
        self.children(node, inside)
    }

    fn shape(&mut self, node: Node<'a, 'input>, place: Place) -> Result<(), CurveError> {
        let within;
        let shape = match self.shapes.get(&node.id()) {
            Some(shape) => shape,
            None => {
                within = Shape::within(node, place.size)?;
                &within
            }
        };
        if shape.has_points {
            self.drawn.points.push(node);
        }
        let drawn = &mut self.drawn;
        drawn.segments += (shape.components.iter().map(|c| c.segments().len())).sum::<usize>();
        if drawn.segments > MAX_SEGMENTS {
            return Err(unsupported(format!(
                "it has more than {MAX_SEGMENTS} segments, each drawn once per use: simplify it"
            )));
        }
        for component in &shape.components {
            if place.paints == [false; 2] {
                drawn.without_paint.push(drawn.components.len());
            }
            let placed = component.map(|p| place.to_root.transform_point2(p));
            drawn.components.push((node, placed));
        }
        Ok(())
    }

    fn is_excluded(&self, node: Node<'_, '_>) -> bool {
        self.selection.excludes(node)
    }

    /// Style, names and transforms are looked at once, however often an element is used.
    fn mark(&mut self, node: Node<'a, 'input>) -> Mark {
        if let Some(&mark) = self.marks.get(&node.id()) {
            return mark;
        }
        let style = self.sheets.of_element(node);
        let transform = value::transform(node.attribute("transform").unwrap_or_default());
        let mark = Mark {
            is_drawn: style.is_displayed && may_be_seen(node) && !self.is_excluded(node),
            is_visible: style.is_visible,
            paints: style.paints,
            is_selected: self.selection.selects(node),
            // Whether it can be read was checked before.
            transform: transform.unwrap_or_default(),
        };
        self.marks.insert(node.id(), mark);
        mark
    }
}

impl Place {
    fn moved(self, inside: DAffine2) -> Self {
        Self {
            to_root: self.to_root * inside,
            ..self
        }
    }

    fn marked(self, mark: Mark) -> Self {
        Self {
            is_visible: mark.is_visible.unwrap_or(self.is_visible),
            paints: [0, 1].map(|of| mark.paints[of].unwrap_or(self.paints[of])),
            is_selected: self.is_selected || mark.is_selected,
            ..self.moved(mark.transform)
        }
    }
}

/// Whether conditions on the reader of a document hold.
fn may_be_seen(node: Node<'_, '_>) -> bool {
    let speaks = |languages: &str| {
        let mut languages = languages.split(',').map(str::trim);
        languages.any(|l| l.split('-').next() == Some(LANGUAGE))
    };
    node.attribute("requiredExtensions")
        .is_none_or(str::is_empty)
        && node.attribute("systemLanguage").is_none_or(speaks)
}

/// Whether a child of `switch` is the one to draw, if none before it is.
fn is_first_choice(node: &Node<'_, '_>) -> bool {
    let is_graphic = is_drawing(*node) || matches!(node.tag_name().name(), "text" | "image");
    is_graphic && may_be_seen(*node)
}

fn view_box(node: Node<'_, '_>) -> Option<ViewBox> {
    node.attribute("viewBox")?.parse().ok()
}

/// Fits a view into a viewport of a size, as `preserveAspectRatio` says.
fn fitted(view: ViewBox, size: DVec2, node: Node<'_, '_>) -> DAffine2 {
    let ratio = node.attribute("preserveAspectRatio").unwrap_or_default();
    let ratio = ratio.parse::<AspectRatio>().unwrap_or_default();
    let (low, extent) = (DVec2::new(view.x, view.y), DVec2::new(view.w, view.h));
    let both = size / extent;
    let scale = match (ratio.align, ratio.slice) {
        (Align::None, _) => both,
        (_, false) => DVec2::splat(both.min_element()),
        (_, true) => DVec2::splat(both.max_element()),
    };
    let left_over = size - scale * extent;
    let share = match ratio.align {
        Align::None | Align::XMinYMin => DVec2::new(0.0, 0.0),
        Align::XMidYMin => DVec2::new(0.5, 0.0),
        Align::XMaxYMin => DVec2::new(1.0, 0.0),
        Align::XMinYMid => DVec2::new(0.0, 0.5),
        Align::XMidYMid => DVec2::new(0.5, 0.5),
        Align::XMaxYMid => DVec2::new(1.0, 0.5),
        Align::XMinYMax => DVec2::new(0.0, 1.0),
        Align::XMidYMax => DVec2::new(0.5, 1.0),
        Align::XMaxYMax => DVec2::new(1.0, 1.0),
    };
    DAffine2::from_scale_angle_translation(scale, 0.0, share * left_over - scale * low)
}
