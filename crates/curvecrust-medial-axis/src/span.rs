//! The curve between two neighbouring dense points.

use curvecrust_curve::{CubicBezier, Curve, CurveParam};
use curvecrust_geometry::Segment;

/// A part of one segment of the curve, between two of its parameters.
#[derive(Clone, Copy)]
pub(crate) struct Span<'a> {
    pub(crate) segment: &'a CubicBezier,
    pub(crate) from: f64,
    pub(crate) to: f64,
}

/// The segment of a place.
pub(crate) fn segment(curve: &Curve, at: CurveParam) -> &CubicBezier {
    &curve.components()[at.component as usize].segments()[at.segment as usize]
}

impl<'a> Span<'a> {
    /// From one place to the next: the end of a segment has the parameter of the next one's start.
    pub(crate) fn new(curve: &'a Curve, from: CurveParam, to: CurveParam) -> Self {
        let is_within = to.segment == from.segment && to.t > from.t;
        Self {
            segment: segment(curve, from),
            from: from.t,
            to: if is_within { to.t } else { 1.0 },
        }
    }

    pub(crate) fn chord(self) -> Segment {
        Segment::new(self.segment.point(self.from), self.segment.point(self.to))
    }

    /// The length of the curve, by Simpson's rule.
    pub(crate) fn length(self) -> f64 {
        let middle = f64::midpoint(self.from, self.to);
        let [a, b, c] = [self.from, middle, self.to].map(|t| self.segment.derivative(t).length());
        (self.to - self.from) * (a + 4.0 * b + c) / 6.0
    }

    /// An upper bound of the distance of the curve to its chord.
    pub(crate) fn sagitta(self) -> f64 {
        // The second derivative changes linearly: it is largest at an end.
        let [from, to] = [self.from, self.to].map(|t| self.segment.second_derivative(t));
        let width = self.to - self.from;
        from.length().max(to.length()) * width * width / 8.0
    }

    /// The radius of curvature at a parameter: infinite where the curve does not bend or its
    /// parameter stands still.
    pub(crate) fn radius(self, t: f64) -> f64 {
        1.0 / curvature(self.segment, t).abs()
    }

    /// The least radius of curvature at the ends and in the middle.
    pub(crate) fn least_radius(self) -> f64 {
        let middle = self.radius(f64::midpoint(self.from, self.to));
        self.radius(self.from).min(middle).min(self.radius(self.to))
    }

    pub(crate) fn halves(self) -> [Self; 2] {
        let middle = f64::midpoint(self.from, self.to);
        [
            Self { to: middle, ..self },
            Self {
                from: middle,
                ..self
            },
        ]
    }
}

/// Signed: positive where the curve turns left; 0 where its parameter stands still.
pub(crate) fn curvature(bezier: &CubicBezier, t: f64) -> f64 {
    let (first, second) = (bezier.derivative(t), bezier.second_derivative(t));
    let curvature = first.perp_dot(second) / first.length().powi(3);
    if curvature.is_finite() {
        curvature
    } else {
        0.0
    }
}
