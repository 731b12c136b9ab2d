//! Curves as dense points, each with its parameter.

use curvecrust_geometry::{Component, PointSet};
use glam::DVec2;

use crate::bezier::CubicBezier;
use crate::curve::{Curve, CurveParam, flushed_to_zero};
use crate::error::{DENSE_LIMIT, DenseError};

/// Points of curves in order along them, dense enough to stand for the curves.
///
/// # Guarantees
/// - Coordinates are zero or within the magnitudes of a [`PointSet`]; there are at most
///   [`DENSE_LIMIT`] points. Points may be equal.
/// - The components cover all points, in order, and each holds at least one.
/// - `params()[i].component` is the component of point i; parameters grow along each component.
///
/// ```
/// use curvecrust_curve::{Curve, DenseCurve};
///
/// let curve = Curve::from_path_data("M 0 0 C 0 4 6 4 6 0")?;
/// let dense = DenseCurve::per_segment(&curve, 300)?;
/// assert_eq!(dense.len(), 301);
/// assert_eq!(dense.points()[300], curve.components()[0].segments()[0].end());
/// assert_eq!((dense.previous(300), dense.next(300)), (Some(299), None));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct DenseCurve {
    points: Vec<DVec2>,
    params: Vec<CurveParam>,
    components: Vec<Component>,
}

impl DenseCurve {
    /// Takes points with their parameters, component by component.
    ///
    /// # Errors
    /// The first point or component that breaks a guarantee.
    pub fn new(
        points: Vec<DVec2>,
        params: Vec<CurveParam>,
        components: Vec<Component>,
    ) -> Result<Self, DenseError> {
        at_most_limit(points.len() as u64)?;
        if points.len() != params.len() {
            return Err(DenseError::Lengths {
                points: points.len(),
                other: params.len(),
                what: "parameters",
            });
        }
        let in_range =
            |p: &DVec2| p.is_finite() && p.abs().max_element() <= PointSet::MAX_MAGNITUDE;
        if let Some(index) = points.iter().position(|p| !in_range(p)) {
            let at = points[index];
            return Err(DenseError::Coordinate { index, at });
        }
        check_ranges(&components, points.len())?;
        check_params(&params, &components)?;
        Ok(Self {
            points: points.into_iter().map(flushed_to_zero).collect(),
            params,
            components,
        })
    }

    /// A fixed number of points per cubic segment, at t = i/n for i = 0 .. n-1, and the end point
    /// of an open component.
    ///
    /// The paper (SGP 2016, Section 8.2) subsamples cubic Béziers very densely, without a number;
    /// the program of its authors takes 300 points a segment.
    ///
    /// # Errors
    /// If n is 0, or the points would be more than [`DENSE_LIMIT`].
    pub fn per_segment(curve: &Curve, n: u32) -> Result<Self, DenseError> {
        Self::at_equal_steps(curve, n, CubicBezier::point)
    }

    /// The same as [`per_segment`](Self::per_segment), in the arithmetic of the paper's authors:
    /// control points and the Bernstein polynomials in single precision. The points carry noise of
    /// 1e-7 of their coordinates.
    ///
    /// # Errors
    /// As [`per_segment`](Self::per_segment); and [`DenseError::Coordinate`] if a coordinate is too
    /// large for single precision.
    pub fn per_segment_in_single(curve: &Curve, n: u32) -> Result<Self, DenseError> {
        Self::at_equal_steps(curve, n, CubicBezier::point_in_single)
    }

    fn at_equal_steps(
        curve: &Curve,
        n: u32,
        point: impl Fn(&CubicBezier, f64) -> DVec2,
    ) -> Result<Self, DenseError> {
        if n == 0 {
            return Err(DenseError::NoPieces { index: 0 });
        }
        let segments = |c: &crate::bezier_path::BezierPath| c.segments().len() as u64;
        let total = curve.components().iter().map(segments).sum::<u64>();
        at_most_limit(total.saturating_mul(u64::from(n)))?;
        let mut builder = Builder::default();
        for (component, whole) in (0u32..).zip(curve.components()) {
            builder.component(whole.is_closed(), |push| {
                let segments = whole.segments();
                for (segment, bezier) in (0u32..).zip(segments) {
                    let mut push_at = |t| {
                        let at = CurveParam {
                            component,
                            segment,
                            t,
                        };
                        push(point(bezier, t), at);
                    };
                    for i in 0..n {
                        push_at(f64::from(i) / f64::from(n));
                    }
                    if !whole.is_closed() && segment as usize + 1 == segments.len() {
                        push_at(1.0);
                    }
                }
            });
        }
        builder.finish()
    }

    /// Cuts the gap after point i into `pieces[i]` parts, uniformly in t; 1 leaves it as it is.
    ///
    /// Points that are there stay, bit by bit. Nothing follows the last point of an open
    /// component: its number is not looked at, save that it must not be 0.
    ///
    /// # Errors
    /// If `pieces` has not one number per point, one is 0, the points would be more than
    /// [`DENSE_LIMIT`], or a parameter does not belong to the curve.
    pub fn refined(&self, curve: &Curve, pieces: &[u32]) -> Result<Self, DenseError> {
        if pieces.len() != self.len() {
            return Err(DenseError::Lengths {
                points: self.len(),
                other: pieces.len(),
                what: "numbers of pieces",
            });
        }
        if let Some(index) = pieces.iter().position(|&p| p == 0) {
            return Err(DenseError::NoPieces { index });
        }
        let parts = |i: usize| self.next(i).map_or(1, |_| pieces[i]);
        at_most_limit((0..self.len()).map(|i| u64::from(parts(i))).sum())?;
        self.check_curve(curve)?;
        let mut builder = Builder::default();
        for (whole, component) in curve.components().iter().zip(&self.components) {
            let segments = whole.segments();
            builder.component(component.closed, |push| {
                for i in component.range.clone() {
                    let start = self.params[i];
                    push(self.points[i], start);
                    let Some(end) = self.next(i).map(|j| self.params[j]) else {
                        continue;
                    };
                    for k in 1..pieces[i] {
                        let share = f64::from(k) / f64::from(pieces[i]);
                        let at = between(start, end, share, segments.len());
                        push(segments[at.segment as usize].point(at.t), at);
                    }
                }
            });
        }
        builder.finish()
    }

    /// The points, component by component in order along the curve.
    #[must_use]
    pub fn points(&self) -> &[DVec2] {
        &self.points
    }

    /// The parameter of each point.
    #[must_use]
    pub fn params(&self) -> &[CurveParam] {
        &self.params
    }

    /// The components, as ranges of points.
    #[must_use]
    pub fn components(&self) -> &[Component] {
        &self.components
    }

    /// The number of points.
    #[must_use]
    pub fn len(&self) -> usize {
        self.points.len()
    }

    /// Whether there is no point.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.points.is_empty()
    }

    /// The point after point i along its component, in O(1); `None` at an open end.
    ///
    /// The only point of a closed component follows itself.
    #[must_use]
    pub fn next(&self, i: usize) -> Option<usize> {
        self.component_around(i)?.next(i)
    }

    /// The point before point i along its component, in O(1); `None` at an open end.
    #[must_use]
    pub fn previous(&self, i: usize) -> Option<usize> {
        self.component_around(i)?.previous(i)
    }

    /// The index of the component of point i, in O(1).
    ///
    /// # Panics
    /// If there is no point i, as indexing does.
    #[must_use]
    pub fn component_of(&self, i: usize) -> usize {
        self.params[i].component as usize
    }

    fn component_around(&self, i: usize) -> Option<&Component> {
        let param = self.params.get(i)?;
        self.components.get(param.component as usize)
    }

    fn check_curve(&self, curve: &Curve) -> Result<(), DenseError> {
        let belongs = |p: &CurveParam| {
            let component = curve.components().get(p.component as usize);
            let dense = &self.components[p.component as usize];
            component.is_some_and(|c| {
                c.is_closed() == dense.closed && (p.segment as usize) < c.segments().len()
            })
        };
        match self.params.iter().position(|p| !belongs(p)) {
            Some(index) => Err(DenseError::Param { index }),
            None => Ok(()),
        }
    }
}

/// Collects points component by component.
#[derive(Default)]
pub(crate) struct Builder {
    points: Vec<DVec2>,
    params: Vec<CurveParam>,
    components: Vec<Component>,
}

impl Builder {
    /// Adds the component whose points `fill` pushes.
    pub(crate) fn component(
        &mut self,
        closed: bool,
        fill: impl FnOnce(&mut dyn FnMut(DVec2, CurveParam)),
    ) {
        let start = self.points.len();
        fill(&mut |point, param| {
            self.points.push(point);
            self.params.push(param);
        });
        let range = start..self.points.len();
        self.components.push(Component { range, closed });
    }

    pub(crate) fn finish(self) -> Result<DenseCurve, DenseError> {
        DenseCurve::new(self.points, self.params, self.components)
    }
}

pub(crate) fn at_most_limit(count: u64) -> Result<(), DenseError> {
    if count > DENSE_LIMIT as u64 {
        return Err(DenseError::TooMany { count });
    }
    Ok(())
}

/// The parameter at a share of the way from one to the next, over the ends of segments and round
/// the end of a closed component.
fn between(start: CurveParam, end: CurveParam, share: f64, segments: usize) -> CurveParam {
    let mut ahead = f64::from(end.segment) - f64::from(start.segment);
    if end <= start {
        ahead += segments as f64;
    }
    let t = start.t + (ahead + end.t - start.t) * share;
    // `t` in units of segments from the start of `start.segment`; a gap seldom leaves the first.
    let mut at = CurveParam { t, ..start };
    while at.t >= 1.0 && (at.segment as usize + 1 < segments || end <= start) {
        at.t -= 1.0;
        at.segment = if at.segment as usize + 1 < segments {
            at.segment + 1
        } else {
            0
        };
    }
    at
}

fn check_ranges(components: &[Component], points: usize) -> Result<(), DenseError> {
    let mut end = 0;
    for (component, Component { range, .. }) in components.iter().enumerate() {
        if range.start != end || range.is_empty() || range.end > points {
            return Err(DenseError::Range { component });
        }
        end = range.end;
    }
    if end != points {
        let component = components.len();
        return Err(DenseError::Range { component });
    }
    Ok(())
}

fn check_params(params: &[CurveParam], components: &[Component]) -> Result<(), DenseError> {
    for (component, Component { range, .. }) in components.iter().enumerate() {
        for index in range.clone() {
            let param = params[index];
            let sound = (0.0..=1.0).contains(&param.t)
                && param.component as usize == component
                && (index == range.start || params[index - 1] < param);
            if !sound {
                return Err(DenseError::Param { index });
            }
        }
    }
    Ok(())
}
