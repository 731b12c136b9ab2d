//! Curves whose local feature size has a closed form: oracles for everything that estimates it.
//!
//! Their dense points lie on the exact curve, not on cubics near it. They are centred at the
//! origin; closed curves run counter-clockwise (y up).
//!
//! | curve | medial axis | lfs |
//! |---|---|---|
//! | [`Circle`] | its centre | its radius |
//! | [`Stadium`] | its core segment | its radius |
//! | [`Ellipse`] | the major axis between ±(a² - b²)/a | distance to that segment |
//! | [`ParallelSegments`] | the line midway | half their distance |
//! | [`ConcentricCircles`] | the circle midway, and the centre | the nearer of the two |

mod part;

use curvecrust_geometry::Segment;
use glam::DVec2;

use crate::dense::DenseCurve;
use crate::error::{AnalyticError, DenseError};
use part::{Part, dense, quarters, spacing};

/// The circle of a radius.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Circle {
    radius: f64,
}

impl Circle {
    /// The circle of a radius.
    ///
    /// # Errors
    /// If the radius is not positive.
    pub fn new(radius: f64) -> Result<Self, AnalyticError> {
        Ok(Self {
            radius: positive("radius", radius)?,
        })
    }

    /// The points at `per_quarter` equal angles in each quarter, from the positive x axis.
    ///
    /// # Errors
    /// If `per_quarter` is 0, or the points are too many.
    pub fn dense(&self, per_quarter: u32) -> Result<DenseCurve, DenseError> {
        dense(&[&quarters(DVec2::splat(self.radius))], true, per_quarter)
    }

    /// The local feature size at any point of the circle.
    #[must_use]
    pub fn lfs(&self, _p: DVec2) -> f64 {
        self.radius
    }
}

/// Two half circles joined by straight sides: the points at `radius` from a core segment, which
/// has a length and lies on the x axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stadium {
    length: f64,
    radius: f64,
}

impl Stadium {
    /// The stadium of a core of some length and a radius.
    ///
    /// # Errors
    /// If the length of the core or the radius is not positive.
    pub fn new(length: f64, radius: f64) -> Result<Self, AnalyticError> {
        Ok(Self {
            length: positive("length", length)?,
            radius: positive("radius", radius)?,
        })
    }

    /// `per_quarter` points in each quarter circle, from the left end of the lower side; those of
    /// the sides are as far apart or nearer.
    ///
    /// # Errors
    /// If `per_quarter` is 0, or the points are too many.
    pub fn dense(&self, per_quarter: u32) -> Result<DenseCurve, DenseError> {
        let core = DVec2::new(self.length / 2.0, 0.0);
        let down = DVec2::new(0.0, -self.radius);
        let spacing = spacing(self.radius, per_quarter)?;
        let [first, second, third, fourth] = quarters(DVec2::splat(self.radius));
        let right = |part: Part| part.shifted(core);
        let left = |part: Part| part.shifted(-core);
        let parts = [
            Part::straight(down - core, down + core, spacing),
            right(fourth),
            right(first),
            Part::straight(core - down, -core - down, spacing),
            left(second),
            left(third),
        ];
        dense(&[&parts], true, per_quarter)
    }

    /// The local feature size at any point of the stadium.
    #[must_use]
    pub fn lfs(&self, _p: DVec2) -> f64 {
        self.radius
    }
}

/// The ellipse with the half axes `a` along x and `b` along y, where `a >= b`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ellipse {
    a: f64,
    b: f64,
}

impl Ellipse {
    /// The ellipse of two half axes.
    ///
    /// # Errors
    /// If a half axis is not positive, or `a < b`.
    pub fn new(a: f64, b: f64) -> Result<Self, AnalyticError> {
        let (a, b) = (positive("a", a)?, positive("b", b)?);
        if a < b {
            return Err(AnalyticError::Order {
                first: "a",
                first_value: a,
                second: "b",
                second_value: b,
                relation: "not be smaller",
            });
        }
        Ok(Self { a, b })
    }

    /// The points `(a cos u, b sin u)` at `per_quarter` equal steps of u in each quarter, from the
    /// positive x axis.
    ///
    /// # Errors
    /// If `per_quarter` is 0, or the points are too many.
    pub fn dense(&self, per_quarter: u32) -> Result<DenseCurve, DenseError> {
        dense(&[&quarters(DVec2::new(self.a, self.b))], true, per_quarter)
    }

    /// The local feature size at a point of the ellipse.
    ///
    /// ```
    /// use curvecrust_curve::analytic::Ellipse;
    /// use glam::DVec2;
    ///
    /// let ellipse = Ellipse::new(2.0, 1.0)?;
    /// assert_eq!(ellipse.lfs(DVec2::new(2.0, 0.0)), 0.5); // b²/a, the radius of curvature
    /// assert_eq!(ellipse.lfs(DVec2::new(0.0, 1.0)), 1.0);
    /// # Ok::<(), curvecrust_curve::AnalyticError>(())
    /// ```
    #[must_use]
    pub fn lfs(&self, p: DVec2) -> f64 {
        // (a² - b²)/a, without the cancellation.
        let end = DVec2::new((self.a - self.b) * (1.0 + self.b / self.a), 0.0);
        Segment::new(-end, end).distance(p)
    }
}

/// Two segments of equal length along x, straight above each other at a distance.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ParallelSegments {
    length: f64,
    distance: f64,
}

impl ParallelSegments {
    /// Two segments of a length, at a distance.
    ///
    /// # Errors
    /// If the length or the distance is not positive.
    pub fn new(length: f64, distance: f64) -> Result<Self, AnalyticError> {
        Ok(Self {
            length: positive("length", length)?,
            distance: positive("distance", distance)?,
        })
    }

    /// Both segments from left to right, the lower one first; open. Points are at most as far apart
    /// as `per_quarter` points in the quarter of a circle that touches both lines.
    ///
    /// # Errors
    /// If `per_quarter` is 0, or the points are too many.
    pub fn dense(&self, per_quarter: u32) -> Result<DenseCurve, DenseError> {
        let spacing = spacing(self.distance / 2.0, per_quarter)?;
        let end = DVec2::new(self.length / 2.0, 0.0);
        let up = DVec2::new(0.0, self.distance / 2.0);
        let side = |y: DVec2| [Part::straight(y - end, y + end, spacing)];
        dense(&[&side(-up), &side(up)], false, per_quarter)
    }

    /// The local feature size at any point of the segments.
    #[must_use]
    pub fn lfs(&self, _p: DVec2) -> f64 {
        self.distance / 2.0
    }
}

/// Two circles about the origin.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ConcentricCircles {
    outer: f64,
    inner: f64,
}

impl ConcentricCircles {
    /// The circles of two radii.
    ///
    /// # Errors
    /// If a radius is not positive, or the outer one is not the larger.
    pub fn new(outer: f64, inner: f64) -> Result<Self, AnalyticError> {
        let (outer, inner) = (positive("outer", outer)?, positive("inner", inner)?);
        if outer <= inner {
            return Err(AnalyticError::Order {
                first: "outer",
                first_value: outer,
                second: "inner",
                second_value: inner,
                relation: "be larger",
            });
        }
        Ok(Self { outer, inner })
    }

    /// Both circles as [`Circle::dense`] has them, the outer one first.
    ///
    /// # Errors
    /// If `per_quarter` is 0, or the points are too many.
    pub fn dense(&self, per_quarter: u32) -> Result<DenseCurve, DenseError> {
        let [outer, inner] = [self.outer, self.inner].map(|r| quarters(DVec2::splat(r)));
        dense(&[&outer, &inner], true, per_quarter)
    }

    /// The local feature size at a point of either circle, the one nearer to `p`.
    #[must_use]
    pub fn lfs(&self, p: DVec2) -> f64 {
        let half_gap = (self.outer - self.inner) / 2.0;
        if p.length() > f64::midpoint(self.outer, self.inner) {
            half_gap
        } else {
            half_gap.min(self.inner)
        }
    }
}

fn positive(name: &'static str, value: f64) -> Result<f64, AnalyticError> {
    // Far inside the magnitudes of points, so that sums and squares are too.
    if (1e-30..=1e50).contains(&value) {
        Ok(value)
    } else {
        Err(AnalyticError::NotPositive { name, value })
    }
}
