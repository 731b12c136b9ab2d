//! What makes a chain of Béziers a smooth curve: no cusps inside, no corners at the joins.

use curvecrust_geometry::Component;
use glam::DVec2;
use kurbo::common::solve_cubic;

use crate::bezier::CubicBezier;
use crate::error::{Corner, CurveError};

/// Joins below this angle are made smooth, others are corners.
const CORNER_DEGREES: f64 = 1.0;

/// Joins below this angle, in radians, are as smooth as rounding lets them be.
const SMOOTH: f64 = 1e-13;

/// Below this angle, in radians, a join of which neither side can turn is left as it is.
const NEARLY_SMOOTH: f64 = 1e-9;

/// A segment has a cusp where its speed falls below this fraction of its longest control arm: SVG
/// is written with 6 digits or more, and a cusp survives them about so well.
const CUSP_SPEED: f64 = 1e-5;

/// Near an end without a handle, where the speed is zero without a cusp, cusps are not looked for.
const CUSP_MARGIN: f64 = 1e-4;

/// Finds the cusps inside of segments: the minima of |B'|², where B'·B'' = 0, that are about 0.
pub(crate) fn check_cusps(component: usize, segments: &[CubicBezier]) -> Result<(), CurveError> {
    for (segment, bezier) in segments.iter().enumerate() {
        if let Some(t) = cusp(bezier) {
            return Err(CurveError::Cusp {
                component,
                segment,
                t,
                at: bezier.point(t),
            });
        }
    }
    Ok(())
}

fn cusp(bezier: &CubicBezier) -> Option<f64> {
    let arms = bezier.arms();
    let longest = arms.iter().map(|a| a.length()).fold(0.0, f64::max);
    let [a, b, c] = arms.map(|arm| arm / longest);
    // B'(t) / 3 = a + 2 q t + r t².
    let (q, r) = (b - a, a - 2.0 * b + c);
    let stationary = solve_cubic(
        a.dot(q),
        a.dot(r) + 2.0 * q.dot(q),
        3.0 * q.dot(r),
        r.dot(r),
    );
    let from = if a == DVec2::ZERO { CUSP_MARGIN } else { 0.0 };
    let to = if c == DVec2::ZERO {
        1.0 - CUSP_MARGIN
    } else {
        1.0
    };
    stationary
        .into_iter()
        .filter(|&t| t > from && t < to)
        .find(|&t| (a + 2.0 * q * t + r * t * t).length() < CUSP_SPEED)
}

/// Finds the corners, and turns the handles at all other joins into one line. Where neither handle
/// can turn, also a small angle is a corner.
pub(crate) fn smooth_joins(
    component: usize,
    segments: &mut [CubicBezier],
    closed: bool,
) -> Vec<Corner> {
    let mut corners = Vec::new();
    for bezier in segments.iter_mut() {
        give_handles_to_straight(bezier);
    }
    let order = Component {
        range: 0..segments.len(),
        closed,
    };
    for segment in order.range.clone() {
        let Some(before) = order.previous(segment) else {
            continue;
        };
        let (incoming, outgoing) = (&segments[before], &segments[segment]);
        let at = outgoing.start();
        let angle = angle_between(incoming.end_handle(), outgoing.start_handle());
        let angle_deg = angle.to_degrees();
        if angle_deg >= CORNER_DEGREES {
            corners.push(Corner {
                component,
                segment,
                angle_deg,
                at,
            });
            continue;
        }
        if angle <= SMOOTH {
            continue;
        }
        let Some(direction) = common_direction(incoming, outgoing) else {
            if angle <= NEARLY_SMOOTH {
                continue;
            }
            corners.push(Corner {
                component,
                segment,
                angle_deg,
                at,
            });
            continue;
        };
        if can_turn(&segments[before]) {
            segments[before] = turned_start(&segments[before].reversed(), -direction).reversed();
        }
        if can_turn(&segments[segment]) {
            segments[segment] = turned_start(&segments[segment], direction);
        }
    }
    corners
}

/// Whether a corner is one only because neither of its handles can turn.
pub(crate) fn is_small(corner: &Corner) -> bool {
    corner.angle_deg < CORNER_DEGREES
}

/// A segment whose handles both have no length is straight; it gets the handles of a line.
fn give_handles_to_straight(bezier: &mut CubicBezier) {
    let [p0, p1, p2, p3] = bezier.control_points();
    let has_no_handle = match p1 {
        _ if p1 == p0 => p2 == p0 || p2 == p3,
        _ => p1 == p3 && p2 == p3,
    };
    if has_no_handle && p0 != p3 {
        *bezier = CubicBezier::line(p0, p3);
    }
}

/// The direction that both handles at a join can take: the mean, or that of the one that cannot
/// turn.
fn common_direction(incoming: &CubicBezier, outgoing: &CubicBezier) -> Option<DVec2> {
    let into = incoming.end_handle().normalize_or_zero();
    let out = outgoing.start_handle().normalize_or_zero();
    match (can_turn(incoming), can_turn(outgoing)) {
        (true, true) => Some((into + out).normalize_or_zero()),
        (true, false) => Some(out),
        (false, true) => Some(into),
        (false, false) => None,
    }
}

/// Whether the tangents at both ends have a control point each: if one handle has no length, the
/// other's control point gives both tangents, and turning it for one end would spoil the other.
fn can_turn(bezier: &CubicBezier) -> bool {
    let [first, _, last] = bezier.arms();
    first != DVec2::ZERO && last != DVec2::ZERO
}

/// The segment with its start handle turned to a direction.
fn turned_start(bezier: &CubicBezier, direction: DVec2) -> CubicBezier {
    let [p0, p1, p2, p3] = bezier.control_points();
    let handle = direction * (p1 - p0).length();
    CubicBezier::new([p0, p0 + handle, p2, p3])
}

/// The angle from 0 to π between two vectors; precise near 0.
fn angle_between(u: DVec2, v: DVec2) -> f64 {
    let (u, v) = (u.normalize_or_zero(), v.normalize_or_zero());
    u.perp_dot(v).abs().atan2(u.dot(v))
}
