//! Maximal discs of a smooth curve itself: tangent at one place, touching another, holding none.
//!
//! The centres of maximal discs are the medial axis (H. Blum 1967). The disc that is tangent at p,
//! on the side of the normal n, and passes through x has the radius |x - p|^2 / (2 n.(x - p)). The
//! other place where the maximal disc touches the curve makes this least. It is found by halving
//! spans of the curve, of which those outside of the best disc so far fall away, and by Newton's
//! method where a span is nearly straight.
//!
//! Only discs that are small beside the radius of curvature at p are of interest here. The curve
//! next to p, which touches the disc at p, is left out: it stays outside of all discs smaller than
//! its least radius of curvature.

use curvecrust_curve::{Curve, CurveParam, DenseCurve};
use curvecrust_geometry::DVec2;
use rstar::primitives::{GeomWithData, Rectangle};
use rstar::{AABB, RTree};

use crate::span::{Span, segment};

/// A disc that is tangent to a curve at a place that is known, and holds none of it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct MaximalDisc {
    pub(crate) radius: f64,
    /// The other place where it touches the curve; `None` if it is not maximal, but as large as it
    /// was looked for.
    pub(crate) touches: Option<CurveParam>,
}

/// A curve as spans, from which maximal discs are found.
pub(crate) struct MaximalDiscs<'a> {
    curve: &'a Curve,
    dense: &'a DenseCurve,
    /// The boxes of the spans, each with its first dense point.
    boxes: RTree<GeomWithData<Rectangle<[f64; 2]>, usize>>,
}

/// Discs are sought up to this share of the limit first, ...
const SMALL: f64 = 1e-2;
/// ... and then in steps that grow by this factor.
const GROWTH: f64 = 4.0;
/// Newton's method stops after so many steps; from a straight span it takes about four.
const STEPS: usize = 12;
/// A span is nearly straight if its sagitta is at most this share of the radius of the disc.
const STRAIGHT: f64 = 0.02;
/// Spans are halved no more often than this.
const HALVINGS: u32 = 48;

impl<'a> MaximalDiscs<'a> {
    /// The spans between dense points, each of which turns by less than half a radian.
    pub(crate) fn new(curve: &'a Curve, dense: &'a DenseCurve) -> Self {
        let mut discs = Self {
            curve,
            dense,
            boxes: RTree::new(),
        };
        let spans = (0..dense.len()).filter(|&i| dense.next(i).is_some());
        let boxed = |i: usize| {
            let span = discs.span(i);
            let (chord, sagitta) = (span.chord(), DVec2::splat(span.sagitta()));
            let low = chord.a.min(chord.b) - sagitta;
            let high = chord.a.max(chord.b) + sagitta;
            GeomWithData::new(Rectangle::from_corners(low.to_array(), high.to_array()), i)
        };
        discs.boxes = RTree::bulk_load(spans.map(boxed).collect());
        discs
    }

    /// The span after a dense point.
    fn span(&self, i: usize) -> Span<'a> {
        let params = self.dense.params();
        Span::new(
            self.curve,
            params[i],
            params[self.dense.next(i).unwrap_or(i)],
        )
    }

    /// The maximal disc at a place, on the left of the curve or on its right, or one of the radius
    /// `limit` or of the least radius of curvature around the place, if the maximal one is larger.
    pub(crate) fn at(&self, place: CurveParam, left: bool, limit: f64) -> MaximalDisc {
        let own = self.around(place);
        let radii = own.iter().flatten().map(|&i| self.span(i).least_radius());
        let limit = radii.fold(limit, f64::min);
        let bezier = segment(self.curve, place);
        let (p, tangent) = (bezier.point(place.t), bezier.tangent(place.t));
        let normal = if left {
            tangent.perp()
        } else {
            -tangent.perp()
        };
        // Most discs that are found are small, and few spans are near them.
        let mut radius = SMALL * limit;
        loop {
            let search = Search {
                p,
                normal,
                radius,
                touches: None,
            };
            let disc = self.smallest(search, own);
            if disc.touches.is_some() || radius >= limit {
                return disc;
            }
            radius = (GROWTH * radius).min(limit);
        }
    }

    /// The smallest disc that touches a span other than the own ones.
    fn smallest(&self, mut search: Search, own: [Option<usize>; 3]) -> MaximalDisc {
        let centre = search.centre();
        let reach = DVec2::splat(search.radius);
        let disc = AABB::from_corners((centre - reach).to_array(), (centre + reach).to_array());
        let near = self.boxes.locate_in_envelope_intersecting(disc);
        let mut near: Vec<usize> = near.map(|span| span.data).collect();
        near.retain(|&i| !own.contains(&Some(i)));
        near.sort_unstable();
        for &i in &near {
            search.try_at(i, self.span(i).from, self.span(i));
        }
        for &i in &near {
            search.try_along(i, self.span(i));
        }
        MaximalDisc {
            radius: search.radius,
            touches: search.touches.map(|(i, t)| self.place(i, t)),
        }
    }

    /// The spans at a place, before and after it.
    fn around(&self, place: CurveParam) -> [Option<usize>; 3] {
        let params = self.dense.params();
        let after = params.partition_point(|&param| param <= place);
        let at = after.saturating_sub(1);
        [self.dense.previous(at), Some(at), self.dense.next(at)]
    }

    /// The place at a parameter of the segment of a dense point; ends of segments are the starts of
    /// the next ones.
    fn place(&self, i: usize, t: f64) -> CurveParam {
        let at = self.dense.params()[i];
        let path = &self.curve.components()[at.component as usize];
        let last = at.segment as usize + 1 == path.segments().len();
        if t < 1.0 || (last && !path.is_closed()) {
            CurveParam { t, ..at }
        } else {
            let segment = if last { 0 } else { at.segment + 1 };
            CurveParam {
                segment,
                t: 0.0,
                ..at
            }
        }
    }
}

/// The smallest disc so far that is tangent at a point.
struct Search {
    p: DVec2,
    normal: DVec2,
    radius: f64,
    /// A dense point, and a parameter of its segment.
    touches: Option<(usize, f64)>,
}

impl Search {
    fn centre(&self) -> DVec2 {
        self.p + self.normal * self.radius
    }

    /// Takes the disc that passes through the curve at a parameter, if it is no larger.
    fn try_at(&mut self, i: usize, t: f64, span: Span<'_>) {
        let d = span.segment.point(t) - self.p;
        let height = self.normal.dot(d);
        if height <= 0.0 {
            return;
        }
        let radius = d.length_squared() / (2.0 * height);
        // Near the least value all are equal up to rounding: what is tried last is most precise.
        if radius <= self.radius * (1.0 + 1e-12) {
            self.radius = self.radius.min(radius);
            self.touches = Some((i, t));
        }
    }

    /// Takes the smallest disc that passes through a span, if it is no larger.
    fn try_along(&mut self, i: usize, whole: Span<'_>) {
        let mut open = vec![(whole, 0)];
        while let Some((span, halvings)) = open.pop() {
            let (chord, sagitta) = (span.chord(), span.sagitta());
            let centre = self.centre();
            if chord.distance(centre) > self.radius + sagitta {
                continue;
            }
            if sagitta <= STRAIGHT * self.radius || halvings == HALVINGS {
                let along = chord.b - chord.a;
                let share = (centre - chord.a).dot(along) / along.length_squared();
                let start = span.from + share.clamp(0.0, 1.0) * (span.to - span.from);
                self.try_at(i, self.least(start, whole), whole);
            } else {
                let [first, second] = span.halves();
                self.try_at(i, second.from, second);
                open.extend([(second, halvings + 1), (first, halvings + 1)]);
            }
        }
    }

    /// The parameter in a span where the radius is least, by Newton's method.
    fn least(&self, start: f64, span: Span<'_>) -> f64 {
        let mut t = start;
        for _ in 0..STEPS {
            let d = span.segment.point(t) - self.p;
            let first = span.segment.derivative(t);
            let second = span.segment.second_derivative(t);
            let (squared, height) = (d.length_squared(), self.normal.dot(d));
            // The derivative of the radius, times what is positive, and the derivative of that.
            let slope = 2.0 * d.dot(first) * height - squared * self.normal.dot(first);
            let change = 2.0 * (first.length_squared() + d.dot(second)) * height
                - squared * self.normal.dot(second);
            if change <= 0.0 {
                break;
            }
            let next = (t - slope / change).clamp(span.from, span.to);
            if (next - t).abs() <= f64::EPSILON {
                return next;
            }
            t = next;
        }
        t
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "a test may panic")]

    use super::*;

    /// The definition, at many points of the curve that are not next to the place.
    fn by_definition(curve: &Curve, place: CurveParam, left: bool, limit: f64) -> f64 {
        let bezier = segment(curve, place);
        let (p, tangent) = (bezier.point(place.t), bezier.tangent(place.t));
        let normal = if left {
            tangent.perp()
        } else {
            -tangent.perp()
        };
        let dense = DenseCurve::per_segment(curve, 2000).unwrap();
        let others = dense.points().iter().zip(dense.params()).filter(|(_, at)| {
            let apart = f64::from(at.segment) + at.t - f64::from(place.segment) - place.t;
            at.component != place.component || apart.abs() > 0.3
        });
        let radius = |(&x, _): (&DVec2, _)| {
            let (d, height) = (x - p, normal.dot(x - p));
            if height > 0.0 {
                d.length_squared() / (2.0 * height)
            } else {
                f64::INFINITY
            }
        };
        others.map(radius).fold(limit, f64::min)
    }

    #[test]
    fn discs_are_maximal_and_touch() {
        let d =
            "M 0 0 C 2 1 4 -1 6 0 C 8 1 10 -1 12 0 M 0 .1 C 2 1.2 4 -.8 6 .2 C 8 1.2 10 -1 12 1";
        let curve = Curve::from_path_data(d).unwrap();
        let spans = DenseCurve::per_segment(&curve, 16).unwrap();
        let discs = MaximalDiscs::new(&curve, &spans);
        let limit = 0.5;
        let mut found = 0;
        for place in DenseCurve::per_segment(&curve, 37).unwrap().params() {
            for left in [true, false] {
                let truth = by_definition(&curve, *place, left, limit);
                let disc = discs.at(*place, left, limit);
                let Some(touches) = disc.touches else {
                    assert!(truth >= 0.999 * limit, "{place:?} {left}: {truth}");
                    continue;
                };
                found += 1;
                assert!(
                    (disc.radius / truth - 1.0).abs() < 1e-3,
                    "{place:?} {left}: {truth}"
                );
                // The other place has the same disc.
                let at = segment(&curve, touches).point(touches.t);
                let p = segment(&curve, *place).point(place.t);
                let back = [true, false].map(|left| discs.at(touches, left, limit));
                let back = back.iter().find(|back| {
                    let there = back.touches.map(|at| segment(&curve, at).point(at.t));
                    there.is_some_and(|there| there.distance(p) < 1e-9)
                });
                let is_end = [0.0, 12.0].contains(&at.x);
                assert!(is_end || back.is_some_and(|b| (b.radius - disc.radius).abs() < 1e-12));
            }
        }
        assert!(found > 50, "{found}");
    }
}
