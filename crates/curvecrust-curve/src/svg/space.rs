//! Where an element stands: its transform to the user space of the root, and what it inherits.

use glam::DVec2;
use kurbo::{Affine, Point};
use roxmltree::Node;
use svgtypes::{Align, AspectRatio, TransformListParser, TransformListToken, ViewBox};

use super::attributes::{Along, coordinate, length, property, refused};
use crate::error::CurveError;

/// The coordinates that the content of an element is written in.
#[derive(Clone, Copy)]
pub(super) struct Space {
    to_root: Affine,
    /// The size that percentages refer to, if there is one.
    pub(super) viewport: Option<DVec2>,
    displayed: bool,
    visible: bool,
}

impl Space {
    /// The user space of the root element.
    pub(super) fn of_root(root: Node<'_, '_>) -> Result<Self, CurveError> {
        let mut space = Self {
            to_root: Affine::IDENTITY,
            viewport: None,
            displayed: true,
            visible: true,
        };
        if root.has_attribute("transform") {
            let message = "of the root is not supported: put it on a <g> inside";
            return Err(refused(root, "transform", message));
        }
        space = space.inside(root)?;
        let absolute = |name| {
            root.attribute(name)
                .filter(|text| !text.trim_end().ends_with('%'))
                .and_then(|_| length(root, name, Along::Width, &space).transpose())
                .transpose()
        };
        space.viewport = match view_box(root)? {
            Some(ViewBox { w, h, .. }) => Some(DVec2::new(w, h)),
            None => absolute("width")?
                .zip(absolute("height")?)
                .map(|(w, h)| DVec2::new(w, h)),
        };
        Ok(space)
    }

    /// The space of an element: with its transform, and hidden if it is.
    pub(super) fn inside(mut self, node: Node<'_, '_>) -> Result<Self, CurveError> {
        self.to_root *= transform(node)?;
        self.displayed &= property(node, "display") != Some("none");
        match property(node, "visibility") {
            Some("hidden" | "collapse") => self.visible = false,
            Some("visible") => self.visible = true,
            _ => {}
        }
        Ok(self)
    }

    /// The space shifted by the `x` and `y` of an element.
    pub(super) fn shifted(mut self, node: Node<'_, '_>) -> Result<Self, CurveError> {
        let x = coordinate(node, "x", Along::Width, &self)?;
        let y = coordinate(node, "y", Along::Height, &self)?;
        self.to_root *= Affine::translate((x, y));
        Ok(self)
    }

    /// The space inside of a nested `svg` or a `symbol`; the `use` element that refers to it may
    /// give it another size.
    pub(super) fn of_viewport(
        self,
        node: Node<'_, '_>,
        user: Option<Node<'_, '_>>,
    ) -> Result<Self, CurveError> {
        let mut space = self.shifted(node)?;
        let size_of = |name, along, whole: Option<f64>| {
            let sized = user.into_iter().chain([node]);
            for node in sized.filter(|n| n.has_attribute(name)) {
                if let Some(value) = length(node, name, along, &self)? {
                    return match value > 0.0 {
                        true => Ok(Some(value)),
                        false => Err(refused(node, name, "must be positive: correct it")),
                    };
                }
            }
            Ok(whole)
        };
        let whole = self.viewport;
        let size = size_of("width", Along::Width, whole.map(|s| s.x))?
            .zip(size_of("height", Along::Height, whole.map(|s| s.y))?)
            .map(|(w, h)| DVec2::new(w, h));
        let Some(view) = view_box(node)? else {
            space.viewport = size;
            return Ok(space);
        };
        let Some(size) = size else {
            let message = "needs a size: give the element a width and a height";
            return Err(refused(node, "viewBox", message));
        };
        space.to_root *= fit(node, view, size)?;
        space.viewport = Some(DVec2::new(view.w, view.h));
        Ok(space)
    }

    /// Whether a shape here would be drawn.
    pub(super) fn is_shown(&self) -> bool {
        self.displayed && self.visible
    }

    /// The point in the user space of the root element.
    pub(super) fn to_root(self, p: DVec2) -> DVec2 {
        let Point { x, y } = self.to_root * Point::new(p.x, p.y);
        DVec2::new(x, y)
    }
}

fn view_box(node: Node<'_, '_>) -> Result<Option<ViewBox>, CurveError> {
    let parse = |text: &str| {
        text.parse::<ViewBox>().map_err(|_| {
            let message = "must be four numbers, the last two positive: correct it";
            refused(node, "viewBox", message)
        })
    };
    node.attribute("viewBox").map(parse).transpose()
}

/// The map of a `viewBox` into a viewport of a size, by `preserveAspectRatio`.
fn fit(node: Node<'_, '_>, view: ViewBox, size: DVec2) -> Result<Affine, CurveError> {
    let ratio = match node.attribute("preserveAspectRatio").map(str::trim) {
        None => "xMidYMid",
        Some(text) => text,
    };
    let Ok(AspectRatio { align, slice, .. }) = ratio.parse() else {
        let message = "is not an alignment of SVG: correct it";
        return Err(refused(node, "preserveAspectRatio", message));
    };
    let full = size / DVec2::new(view.w, view.h);
    let scale = match (align, slice) {
        (Align::None, _) => full,
        (_, false) => DVec2::splat(full.min_element()),
        (_, true) => DVec2::splat(full.max_element()),
    };
    let share = match align {
        Align::None | Align::XMinYMin => (0.0, 0.0),
        Align::XMidYMin => (0.5, 0.0),
        Align::XMaxYMin => (1.0, 0.0),
        Align::XMinYMid => (0.0, 0.5),
        Align::XMidYMid => (0.5, 0.5),
        Align::XMaxYMid => (1.0, 0.5),
        Align::XMinYMax => (0.0, 1.0),
        Align::XMidYMax => (0.5, 1.0),
        Align::XMaxYMax => (1.0, 1.0),
    };
    let free = (size - scale * DVec2::new(view.w, view.h)) * DVec2::from(share);
    Ok(Affine::translate((free.x, free.y))
        * Affine::scale_non_uniform(scale.x, scale.y)
        * Affine::translate((-view.x, -view.y)))
}

fn transform(node: Node<'_, '_>) -> Result<Affine, CurveError> {
    let text = node.attribute("transform").unwrap_or_default();
    if text.trim() == "none" {
        return Ok(Affine::IDENTITY);
    }
    let mut whole = Affine::IDENTITY;
    for token in TransformListParser::from(text) {
        let token = token.map_err(|error| {
            let message = format!("is no list of transforms: {error}");
            refused(node, "transform", message)
        })?;
        whole *= match token {
            TransformListToken::Matrix { a, b, c, d, e, f } => Affine::new([a, b, c, d, e, f]),
            TransformListToken::Translate { tx, ty } => Affine::translate((tx, ty)),
            TransformListToken::Scale { sx, sy } => Affine::scale_non_uniform(sx, sy),
            TransformListToken::Rotate { angle } => rotation(angle),
            TransformListToken::SkewX { angle } => Affine::skew(angle.to_radians().tan(), 0.0),
            TransformListToken::SkewY { angle } => Affine::skew(0.0, angle.to_radians().tan()),
        };
    }
    Ok(whole)
}

/// The rotation by an angle in degrees; exact for quarter turns.
fn rotation(degrees: f64) -> Affine {
    let quarters = (degrees / 90.0).round();
    let rest = DVec2::from_angle((degrees - quarters * 90.0).to_radians());
    let turned = match quarters.rem_euclid(4.0) {
        q if q < 0.5 => rest,
        q if q < 1.5 => rest.perp(),
        q if q < 2.5 => -rest,
        _ => -rest.perp(),
    };
    Affine::new([turned.x, turned.y, -turned.y, turned.x, 0.0, 0.0])
}
