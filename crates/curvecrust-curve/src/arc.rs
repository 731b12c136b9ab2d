//! Elliptical arcs of SVG as cubics.
//!
//! By the end point parametrisation of SVG 1.1, appendix F.6, worked out where the ellipse is the
//! unit circle.

use std::f64::consts::TAU;

use glam::DVec2;

use crate::bezier::CubicBezier;

/// Pieces per turn: a cubic that spans 1/16 turn is within 7e-8 of the radius of a circle.
const PIECES_PER_TURN: f64 = 16.0;

/// An arc as written in path data.
pub(crate) struct Arc {
    pub(crate) from: DVec2,
    pub(crate) to: DVec2,
    pub(crate) radii: DVec2,
    pub(crate) rotation_deg: f64,
    pub(crate) large: bool,
    pub(crate) sweep: bool,
}

impl Arc {
    /// The arc in pieces of at most 1/16 turn, from `from` to `to` exactly.
    ///
    /// Straight if a radius is 0, and nothing between equal points, as SVG has it. Radii that are
    /// too small to reach are scaled up.
    pub(crate) fn to_cubics(&self) -> Vec<CubicBezier> {
        let &Self { from, to, .. } = self;
        let radii = self.radii.abs();
        if from == to {
            return Vec::new();
        }
        if radii.min_element() <= 0.0 {
            return vec![CubicBezier::line(from, to)];
        }
        let axis = DVec2::from_angle((self.rotation_deg % 360.0).to_radians());
        let back = DVec2::new(axis.x, -axis.y);
        // The chord from the middle of the arc's ends, where the ellipse is the unit circle.
        let half = back.rotate((to - from) / 2.0) / radii;
        let scale = half.length().max(1.0);
        let (radii, half) = (radii * scale, half / scale);
        let across = (1.0 / half.length_squared() - 1.0).max(0.0).sqrt();
        // The small arc in the positive sense has its centre to the left of the chord.
        let side = if self.large == self.sweep { -1.0 } else { 1.0 };
        let centre = half.perp() * (across * side);
        let (first, last) = (-half - centre, half - centre);
        let turn = sweep_angle(first, last, self.sweep);
        let middle = from + (to - from) / 2.0;
        let on_plane = |p: DVec2| middle + axis.rotate((p + centre) * radii);
        pieces(first, turn, on_plane, from, to)
    }
}

/// The signed angle from one point of the unit circle to another, in the sense of the flag.
fn sweep_angle(first: DVec2, last: DVec2, positive: bool) -> f64 {
    let angle = first.perp_dot(last).atan2(first.dot(last));
    match (positive, angle < 0.0) {
        (true, true) => angle + TAU,
        (false, false) => angle - TAU,
        _ => angle,
    }
}

fn pieces(
    first: DVec2,
    turn: f64,
    on_plane: impl Fn(DVec2) -> DVec2,
    from: DVec2,
    to: DVec2,
) -> Vec<CubicBezier> {
    // A hair less than the whole, so that rounding does not add a piece to a quarter.
    let count = (turn.abs() / TAU * PIECES_PER_TURN - 1e-9).ceil().max(1.0);
    let step = turn / count;
    let arm = 4.0 / 3.0 * (step / 4.0).tan();
    let mut pieces = Vec::new();
    let mut radius = first;
    let mut start = from;
    let mut k = 1.0;
    // At most 16 times; not at all if the angle is not a number, which validation then reports.
    while k <= count {
        let next = DVec2::from_angle(step * k).rotate(first);
        let end = if k < count { on_plane(next) } else { to };
        pieces.push(CubicBezier::new([
            start,
            on_plane(radius + radius.perp() * arm),
            on_plane(next - next.perp() * arm),
            end,
        ]));
        (radius, start) = (next, end);
        k += 1.0;
    }
    pieces
}
