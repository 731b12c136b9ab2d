//! Paths and basic shapes as components.

use glam::DVec2;
use roxmltree::Node;

use super::attributes::{Along, coordinate, length, numbers, refused, size, unsupported};
use super::space::Space;
use crate::arc::Arc;
use crate::component::Component;
use crate::error::CurveError;
use crate::path_data::{self, Pen};

/// What an element draws, in the user space of the root element.
pub(super) fn components(node: Node<'_, '_>, space: Space) -> Result<Vec<Component>, CurveError> {
    let name = node.tag_name().name();
    let is_shape = matches!(
        name,
        "path" | "circle" | "ellipse" | "rect" | "line" | "polyline" | "polygon"
    );
    match (is_shape, space.is_shown()) {
        (true, true) => {}
        (true, false) => {
            let message = "it is hidden (display or visibility): show it, or remove it";
            return Err(unsupported(message));
        }
        (false, true) => {
            let message = "it is no curve: convert it to a path, or remove it";
            return Err(unsupported(message));
        }
        (false, false) => return Ok(Vec::new()),
    }
    let components = match name {
        "path" => path_data::parse(node.attribute("d").unwrap_or_default())?,
        "circle" => {
            let r = size(node, "r", Along::Diagonal, &space)?;
            ellipse(centre(node, &space)?, DVec2::splat(r))
        }
        "ellipse" => {
            let (rx, ry) = radii(node, &space)?;
            let (Some(rx), Some(ry)) = (rx, ry) else {
                let message = "is missing: give the ellipse a radius, or remove it";
                return Err(refused(node, "rx", message));
            };
            if rx <= 0.0 || ry <= 0.0 {
                let name = if rx <= 0.0 { "rx" } else { "ry" };
                return Err(refused(node, name, "must be positive: correct it"));
            }
            ellipse(centre(node, &space)?, DVec2::new(rx, ry))
        }
        "rect" => rect(node, &space)?,
        "line" => {
            let at = |x, y| {
                Ok::<_, CurveError>(DVec2::new(
                    coordinate(node, x, Along::Width, &space)?,
                    coordinate(node, y, Along::Height, &space)?,
                ))
            };
            let mut pen = Pen::default();
            pen.move_to(at("x1", "y1")?);
            pen.line_to(at("x2", "y2")?);
            pen.finish()
        }
        _ => polyline(node, name == "polygon")?,
    };
    let in_root = |c: &Component| c.map(|p| space.to_root(p));
    Ok(components.iter().map(in_root).collect())
}

fn centre(node: Node<'_, '_>, space: &Space) -> Result<DVec2, CurveError> {
    Ok(DVec2::new(
        coordinate(node, "cx", Along::Width, space)?,
        coordinate(node, "cy", Along::Height, space)?,
    ))
}

/// The radii of an ellipse or a rectangle; one that is missing is as the other.
fn radii(node: Node<'_, '_>, space: &Space) -> Result<(Option<f64>, Option<f64>), CurveError> {
    let rx = length(node, "rx", Along::Width, space)?;
    let ry = length(node, "ry", Along::Height, space)?;
    for (name, radius) in [("rx", rx), ("ry", ry)] {
        if radius.is_some_and(|r| r < 0.0) {
            return Err(refused(node, name, "must not be negative: correct it"));
        }
    }
    Ok((rx.or(ry), ry.or(rx)))
}

/// From the right end of the x axis towards positive y, as SVG 2 has it.
fn ellipse(centre: DVec2, radii: DVec2) -> Vec<Component> {
    let mut pen = Pen::default();
    let mut from = centre + DVec2::new(radii.x, 0.0);
    pen.move_to(from);
    for towards in [DVec2::Y, DVec2::NEG_X, DVec2::NEG_Y, DVec2::X] {
        let to = centre + towards * radii;
        pen.arc_to(&quarter(from, to, radii));
        from = to;
    }
    pen.close();
    pen.finish()
}

fn quarter(from: DVec2, to: DVec2, radii: DVec2) -> Arc {
    Arc {
        from,
        to,
        radii,
        rotation_deg: 0.0,
        large: false,
        sweep: true,
    }
}

/// From the left end of the upper side towards positive x, as SVG 2 has it.
fn rect(node: Node<'_, '_>, space: &Space) -> Result<Vec<Component>, CurveError> {
    let low = DVec2::new(
        coordinate(node, "x", Along::Width, space)?,
        coordinate(node, "y", Along::Height, space)?,
    );
    let size = DVec2::new(
        size(node, "width", Along::Width, space)?,
        size(node, "height", Along::Height, space)?,
    );
    let (rx, ry) = radii(node, space)?;
    let radii = DVec2::new(rx.unwrap_or(0.0), ry.unwrap_or(0.0)).min(size / 2.0);
    let high = low + size;
    // The ends of the straight parts, which rounding must not turn round.
    let a = low + radii;
    let b = (high - radii).max(a);
    let sides = [
        [DVec2::new(a.x, low.y), DVec2::new(b.x, low.y)],
        [DVec2::new(high.x, a.y), DVec2::new(high.x, b.y)],
        [DVec2::new(b.x, high.y), DVec2::new(a.x, high.y)],
        [DVec2::new(low.x, b.y), DVec2::new(low.x, a.y)],
    ];
    let mut pen = Pen::default();
    pen.move_to(sides[0][0]);
    for (k, [_, end]) in sides.into_iter().enumerate() {
        let [next, _] = sides[(k + 1) % 4];
        pen.line_to(end);
        pen.arc_to(&quarter(end, next, radii));
    }
    pen.close();
    Ok(pen.finish())
}

fn polyline(node: Node<'_, '_>, closed: bool) -> Result<Vec<Component>, CurveError> {
    let numbers = numbers(node, "points")?;
    let (points, rest) = numbers.as_chunks::<2>();
    if !rest.is_empty() {
        let message = "has an odd number of coordinates: give pairs";
        return Err(refused(node, "points", message));
    }
    let mut pen = Pen::default();
    let mut points = points.iter().map(|&[x, y]| DVec2::new(x, y));
    if let Some(first) = points.next() {
        pen.move_to(first);
        points.for_each(|p| pen.line_to(p));
        if closed {
            pen.close();
        }
    }
    Ok(pen.finish())
}
