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
