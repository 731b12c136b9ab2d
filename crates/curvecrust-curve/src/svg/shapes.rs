//! Shapes as paths, in their own coordinates and in double precision; circles, ellipses and rounded
//! corners by the same arcs as in path data.

use std::collections::HashMap;

use glam::DVec2;
use roxmltree::{Node, NodeId};

use super::strict::refused;
use super::value::{self, Length};
use crate::bezier_path::BezierPath;
use crate::error::CurveError;
use crate::path_data::{self, Pen};

/// What an element draws.
#[derive(Debug)]
pub(super) struct Shape {
    /// The subpaths that have a length.
    pub(super) components: Vec<BezierPath>,
    /// Whether there are others, which draw nothing.
    pub(super) has_points: bool,
}

/// The shapes that do not depend on a viewport.
pub(super) type Shapes = HashMap<NodeId, Shape>;

impl From<Pen> for Shape {
    fn from(pen: Pen) -> Self {
        pen.finish().into()
    }
}

impl From<Vec<BezierPath>> for Shape {
    fn from(mut components: Vec<BezierPath>) -> Self {
        let count = components.len();
        components.retain(|c| !c.segments().is_empty());
        Self {
            has_points: components.len() < count,
            components,
        }
    }
}

impl Shape {
    /// The shape of an element that looks the same in each viewport, and may be long to read.
    pub(super) fn anywhere(node: Node<'_, '_>) -> Result<Option<Self>, CurveError> {
        let points = || value::points(node.attribute("points").unwrap_or_default());
        Ok(match node.tag_name().name() {
            "path" => {
                let d = node.attribute("d").unwrap_or_default();
                Some(path_data::parse(d)?.into())
            }
            // Whether the points can be read was checked before.
            "polyline" => Some(polyline(&points().unwrap_or_default(), false)),
            "polygon" => Some(polyline(&points().unwrap_or_default(), true)),
            _ => None,
        })
    }

    /// The shape of an element in a viewport of a size, which percentages refer to.
    pub(super) fn within(node: Node<'_, '_>, size: Option<DVec2>) -> Result<Self, CurveError> {
        let lengths = Lengths { node, size };
        let mut pen = Pen::default();
        match node.tag_name().name() {
            "circle" => {
                let r = lengths.get("r")?.unwrap_or_default();
                ellipse(&mut pen, lengths.point("cx", "cy")?, DVec2::splat(r));
            }
            "ellipse" => {
                let radii = lengths.radii()?.unwrap_or_default();
                ellipse(&mut pen, lengths.point("cx", "cy")?, radii);
            }
            "line" => {
                pen.move_to(lengths.point("x1", "y1")?);
                pen.line_to(lengths.point("x2", "y2")?);
            }
            "rect" => {
                let (low, extent) = (lengths.point("x", "y")?, lengths.point("width", "height")?);
                let radii = lengths.radii()?.filter(|radii| radii.min_element() > 0.0);
                let radii = radii.unwrap_or_default();
                rect(&mut pen, low, extent, radii.min(extent / 2.0));
            }
            _ => {}
        }
        Ok(pen.into())
    }
}

fn polyline(points: &[DVec2], closed: bool) -> Shape {
    let mut pen = Pen::default();
    if let Some((&first, rest)) = points.split_first() {
        pen.move_to(first);
        for &p in rest {
            pen.line_to(p);
        }
        if closed {
            pen.close();
        }
    }
    pen.into()
}

/// From the right, towards positive y.
fn ellipse(pen: &mut Pen, centre: DVec2, radii: DVec2) {
    let at = |x: f64, y: f64| centre + radii * DVec2::new(x, y);
    pen.move_to(at(1.0, 0.0));
    for to in [at(0.0, 1.0), at(-1.0, 0.0), at(0.0, -1.0), at(1.0, 0.0)] {
        pen.quarter_to(radii, to);
    }
    pen.close();
}

/// From the start of the side that is at the smaller y.
fn rect(pen: &mut Pen, low: DVec2, extent: DVec2, radii: DVec2) {
    let high = low + extent;
    let (inner_low, inner_high) = (low + radii, high - radii);
    pen.move_to(DVec2::new(inner_low.x, low.y));
    pen.line_to(DVec2::new(inner_high.x, low.y));
    pen.quarter_to(radii, DVec2::new(high.x, inner_low.y));
    pen.line_to(DVec2::new(high.x, inner_high.y));
    pen.quarter_to(radii, DVec2::new(inner_high.x, high.y));
    pen.line_to(DVec2::new(inner_low.x, high.y));
    pen.quarter_to(radii, DVec2::new(low.x, inner_high.y));
    pen.line_to(DVec2::new(low.x, inner_low.y));
    pen.quarter_to(radii, DVec2::new(inner_low.x, low.y));
    pen.close();
}

/// The lengths of an element, in user units.
pub(super) struct Lengths<'a, 'input> {
    pub(super) node: Node<'a, 'input>,
    /// Of the viewport; `None` if its size is not given.
    pub(super) size: Option<DVec2>,
}

impl Lengths<'_, '_> {
    /// A length; `None` if it is not given or `auto`.
    pub(super) fn get(&self, name: &str) -> Result<Option<f64>, CurveError> {
        let mut attributes = self.node.attributes();
        let plain = attributes.find(|a| a.namespace().is_none() && a.name() == name);
        let Some(attribute) = plain.filter(|a| a.value() != "auto") else {
            return Ok(None);
        };
        match (value::length(attribute.value()), self.size) {
            (Ok(Length::Absolute(length)), _) => Ok(Some(length)),
            (Ok(Length::Percent(percent)), Some(size)) => {
                let whole = match name {
                    "x" | "x1" | "x2" | "cx" | "rx" | "width" => size.x,
                    "y" | "y1" | "y2" | "cy" | "ry" | "height" => size.y,
                    _ => size.length() / f64::sqrt(2.0),
                };
                Ok(Some(percent / 100.0 * whole))
            }
            _ => {
                let message = "is a part of a size that is not known here: give a number";
                Err(refused(&attribute, message))
            }
        }
    }

    /// A point, or an extent; its coordinates are 0 where not given.
    pub(super) fn point(&self, x: &str, y: &str) -> Result<DVec2, CurveError> {
        let (x, y) = (self.get(x)?, self.get(y)?);
        Ok(DVec2::new(x.unwrap_or_default(), y.unwrap_or_default()))
    }

    /// The radii of an ellipse or of corners; of which one that is not given is as the other.
    fn radii(&self) -> Result<Option<DVec2>, CurveError> {
        let (x, y) = (self.get("rx")?, self.get("ry")?);
        Ok(x.or(y).zip(y.or(x)).map(DVec2::from))
    }
}
