//! Cubic Bézier segments.

use glam::DVec2;
use kurbo::{CubicBez, Point, Shape};

/// A cubic Bézier segment, `B(t)` for t in [0, 1], given by its four control points.
///
/// Straight segments and quadratics are cubics too, see [`CubicBezier::line`] and
/// [`CubicBezier::quadratic`].
///
/// ```
/// use curvecrust_curve::CubicBezier;
/// use glam::DVec2;
///
/// let line = CubicBezier::line(DVec2::ZERO, DVec2::new(3.0, 0.0));
/// assert_eq!(line.point(0.5), DVec2::new(1.5, 0.0));
/// assert_eq!(line.derivative(0.5), DVec2::new(3.0, 0.0));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CubicBezier {
    control: [DVec2; 4],
}

impl CubicBezier {
    /// The segment from `control[0]` to `control[3]`.
    #[must_use]
    pub fn new(control: [DVec2; 4]) -> Self {
        Self { control }
    }

    /// The straight segment from `a` to `b`, run through at constant speed.
    #[must_use]
    pub fn line(a: DVec2, b: DVec2) -> Self {
        let third = (b - a) / 3.0;
        Self::new([a, a + third, b - third, b])
    }

    /// The quadratic segment with the control points `a`, `b`, `c`, exactly (but for rounding).
    #[must_use]
    pub fn quadratic(a: DVec2, b: DVec2, c: DVec2) -> Self {
        // A handle that has no length keeps none.
        let two_thirds = |from: DVec2| from + (b - from) * (2.0 / 3.0);
        Self::new([a, two_thirds(a), two_thirds(c), c])
    }

    /// The control points, from start to end.
    #[must_use]
    pub fn control_points(&self) -> [DVec2; 4] {
        self.control
    }

    /// The start, `B(0)`.
    #[must_use]
    pub fn start(&self) -> DVec2 {
        self.control[0]
    }

    /// The end, `B(1)`.
    #[must_use]
    pub fn end(&self) -> DVec2 {
        self.control[3]
    }

    /// The point `B(t)`; at 0 and 1 exactly the start and the end.
    #[must_use]
    pub fn point(&self, t: f64) -> DVec2 {
        let [p0, p1, p2, p3] = self.control;
        let s = 1.0 - t;
        p0 * (s * s * s) + p1 * (3.0 * s * s * t) + p2 * (3.0 * s * t * t) + p3 * (t * t * t)
    }

    /// The point at t by Bernstein polynomials, all in single precision.
    pub(crate) fn point_in_single(&self, t: f64) -> DVec2 {
        let [p0, p1, p2, p3] = self.control.map(DVec2::as_vec2);
        #[expect(
            clippy::cast_possible_truncation,
            reason = "rounded, as is everything here"
        )]
        let t = t as f32;
        let u = 1.0 - t;
        let p =
            p0 * (u * u * u) + p1 * (3.0 * u * u * t) + p2 * (3.0 * u * t * t) + p3 * (t * t * t);
        p.as_dvec2()
    }

    /// The derivative `B'(t)`.
    #[must_use]
    pub fn derivative(&self, t: f64) -> DVec2 {
        let [a, b, c] = self.arms();
        let s = 1.0 - t;
        (a * (s * s) + b * (2.0 * s * t) + c * (t * t)) * 3.0
    }

    /// The second derivative `B''(t)`.
    #[must_use]
    pub fn second_derivative(&self, t: f64) -> DVec2 {
        let [a, b, c] = self.arms();
        ((b - a) * (1.0 - t) + (c - b) * t) * 6.0
    }

    /// The unit tangent at t, in the direction of growing t.
    ///
    /// At an end whose control arm has no length it is the limit of the tangents inside. Zero for
    /// a segment of zero length, and at a cusp.
    #[must_use]
    pub fn tangent(&self, t: f64) -> DVec2 {
        let direction = if t <= 0.0 {
            self.start_handle()
        } else if t >= 1.0 {
            self.end_handle()
        } else {
            self.derivative(t)
        };
        direction.normalize_or_zero()
    }

    /// The smallest box around the segment itself, not around its control points: its lower left
    /// and upper right corner.
    #[must_use]
    pub fn bounding_box(&self) -> (DVec2, DVec2) {
        let [p0, p1, p2, p3] = self.control.map(|p| Point::new(p.x, p.y));
        let bounds = CubicBez::new(p0, p1, p2, p3).bounding_box();
        (
            DVec2::new(bounds.x0, bounds.y0),
            DVec2::new(bounds.x1, bounds.y1),
        )
    }

    /// The part from one parameter to a later one; its ends are exactly the points there.
    pub(crate) fn part(&self, from: f64, to: f64) -> Self {
        let third = (to - from) / 3.0;
        let (start, end) = (self.point(from), self.point(to));
        let (out, into) = (self.derivative(from) * third, self.derivative(to) * third);
        Self::new([start, start + out, end - into, end])
    }

    /// Whether the segment is a single point.
    pub(crate) fn is_point(&self) -> bool {
        self.control.iter().all(|&p| p == self.control[0])
    }

    /// The differences of consecutive control points.
    pub(crate) fn arms(&self) -> [DVec2; 3] {
        let [p0, p1, p2, p3] = self.control;
        [p1 - p0, p2 - p1, p3 - p2]
    }

    /// From the start to the first control point that differs from it.
    pub(crate) fn start_handle(&self) -> DVec2 {
        let [p0, p1, p2, p3] = self.control;
        let other = [p1, p2, p3].into_iter().find(|&p| p != p0).unwrap_or(p0);
        other - p0
    }

    /// From the last control point that differs from the end to the end.
    pub(crate) fn end_handle(&self) -> DVec2 {
        -self.reversed().start_handle()
    }

    /// The same segment from end to start.
    pub(crate) fn reversed(&self) -> Self {
        let [p0, p1, p2, p3] = self.control;
        Self::new([p3, p2, p1, p0])
    }

    /// The segment up to t = 1/2, and from there.
    /// With another end near its own. The handle goes along, so that the tangent stays; one without
    /// length keeps none.
    pub(crate) fn ending_at(&self, end: DVec2) -> Self {
        let [p0, p1, p2, p3] = self.control_points();
        let moved = |p: DVec2, other: DVec2| if p == p3 { end } else { other };
        Self::new([p0, moved(p1, p1), moved(p2, p2 + end - p3), end])
    }

    pub(crate) fn halves(&self) -> [Self; 2] {
        let [p0, p1, p2, p3] = self.control;
        let [a, b, c] = [p0.midpoint(p1), p1.midpoint(p2), p2.midpoint(p3)];
        let (ab, bc) = (a.midpoint(b), b.midpoint(c));
        let middle = ab.midpoint(bc);
        [[p0, a, ab, middle], [middle, bc, c, p3]].map(Self::new)
    }

    pub(crate) fn map(&self, f: impl Fn(DVec2) -> DVec2) -> Self {
        Self::new(self.control.map(f))
    }
}

/// The common bounding box of segments.
pub(crate) fn bounds<'a>(segments: impl IntoIterator<Item = &'a CubicBezier>) -> (DVec2, DVec2) {
    let empty = (DVec2::INFINITY, DVec2::NEG_INFINITY);
    segments
        .into_iter()
        .map(CubicBezier::bounding_box)
        .fold(empty, |a, b| (a.0.min(b.0), a.1.max(b.1)))
}
