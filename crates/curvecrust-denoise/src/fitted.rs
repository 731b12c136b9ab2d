//! Fitted curves, and where each point belongs.

use glam::DVec2;

use curvecrust_geometry::EdgeSet;

/// The curves that points scatter about, and to which of them each point belongs.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct Fitted {
    /// The curves, those with the most points first; none if the points form no curve.
    pub curves: Vec<FittedCurve>,
    /// For each point its place on a curve; `None` for an outlier.
    pub places: Vec<Option<Place>>,
    /// The edges of least detour through the points that are no outliers, if these are clean: they
    /// lie on their curves, which then join them by straight pieces. `None` if points are noisy.
    pub edges: Option<EdgeSet>,
}

/// A place on a fitted curve.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Place {
    /// The position of the curve in [`Fitted::curves`].
    pub curve: usize,
    /// The position of the cubic in [`FittedCurve::cubics`], plus the parameter in it, from 0 to 1.
    pub parameter: f64,
    /// The distance of the point from there.
    pub distance: f64,
}

/// A smooth curve of cubic Béziers, and how sure it is.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct FittedCurve {
    /// The control points of each cubic. Each starts where the last one ends; of a closed curve the
    /// last ends where the first starts, and it runs counter-clockwise.
    pub cubics: Vec<[DVec2; 4]>,
    /// Whether the curve is closed.
    pub closed: bool,
    /// Where it has corners: the position in `cubics` of each cubic that starts at one, ascending.
    /// Everywhere else it is smooth. None for clean points, whose straight pieces meet at an angle
    /// at every joint.
    pub corners: Vec<usize>,
    /// The standard deviation of the points from the curve at each joint: at the start of every
    /// cubic, and at the end of the last. 0 for clean points.
    pub sigma: Vec<f64>,
    /// The standard error of the curve itself across its direction, at each joint. The curve that
    /// the points come from is within twice this width for about 19 of 20 places, where it is
    /// smooth. 0 for clean points.
    pub standard_error: Vec<f64>,
    /// The number of points that belong to it.
    pub points: usize,
}

impl Fitted {
    /// Whether the points that are no outliers lie on their curves.
    #[must_use]
    pub fn is_clean(&self) -> bool {
        self.edges.is_some()
    }

    /// The indices of the points that belong to a curve, ascending.
    #[must_use]
    pub fn inliers(&self) -> Vec<usize> {
        let places = self.places.iter().enumerate();
        places.filter_map(|(i, p)| p.map(|_| i)).collect()
    }

    /// The indices of the points that belong to no curve, ascending.
    #[must_use]
    pub fn outliers(&self) -> Vec<usize> {
        let places = self.places.iter().enumerate();
        places
            .filter_map(|(i, p)| p.is_none().then_some(i))
            .collect()
    }

    /// The root mean square of the curves' deviations, each as often as it has points; 0 without
    /// curves.
    #[must_use]
    pub fn sigma(&self) -> f64 {
        let (mut sum, mut count) = (0.0, 0.0);
        for curve in &self.curves {
            let points = curve.points as f64;
            sum += curve.deviation().powi(2) * points;
            count += points;
        }
        if count > 0.0 {
            (sum / count).sqrt()
        } else {
            0.0
        }
    }
}

impl FittedCurve {
    /// The root mean square of the deviation of the points along the curve.
    #[must_use]
    pub fn deviation(&self) -> f64 {
        let squares: f64 = self.sigma.iter().map(|s| s * s).sum();
        (squares / self.sigma.len().max(1) as f64).sqrt()
    }

    /// The corners as places, in order along the curve.
    #[must_use]
    pub fn corner_places(&self) -> Vec<DVec2> {
        let cubics = self.corners.iter().filter_map(|&k| self.cubics.get(k));
        cubics.map(|cubic| cubic[0]).collect()
    }

    /// The place at a parameter as [`Place::parameter`] counts it, clamped to the curve; the origin
    /// if it has no cubic.
    #[must_use]
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "clamped to the number of cubics"
    )]
    pub fn point(&self, parameter: f64) -> DVec2 {
        let Some(last) = self.cubics.len().checked_sub(1) else {
            return DVec2::ZERO;
        };
        let t = parameter.clamp(0.0, self.cubics.len() as f64);
        let piece = (t.floor() as usize).min(last);
        place(self.cubics[piece], t - piece as f64)
    }

    /// Points in order along the curve whose polyline is nowhere farther from it than a tolerance
    /// above 0; see [`polyline`].
    #[must_use]
    pub fn polyline(&self, tolerance: f64) -> Vec<DVec2> {
        polyline(&self.cubics, self.closed, tolerance)
    }
}

/// Points in order along cubics end to end, whose polyline is nowhere farther from them than a
/// tolerance above 0. Closed ones do not repeat their first point.
///
/// Source of the number of points: G. Wang, 1984, after L. Goldman, *Graphics Gems*.
///
/// ```
/// use curvecrust_denoise::polyline;
/// use curvecrust_geometry::DVec2;
///
/// let line = [(0.0, 0.0), (1.0, 0.0), (2.0, 0.0), (3.0, 0.0)].map(DVec2::from);
/// assert_eq!(polyline(&[line], false, 0.1), [line[0], line[3]]);
/// ```
#[must_use]
pub fn polyline(cubics: &[[DVec2; 4]], closed: bool, tolerance: f64) -> Vec<DVec2> {
    let mut places: Vec<DVec2> = cubics.first().map(|c| c[0]).into_iter().collect();
    for &cubic in cubics {
        let [a, b, c, d] = cubic;
        let bend = (a - 2.0 * b + c).length().max((b - 2.0 * c + d).length());
        let wanted = (0.75 * bend / tolerance).sqrt().ceil();
        // A tolerance below the digits of the points asks for no more than is useful.
        let steps = if wanted.is_finite() {
            wanted.clamp(1.0, 1024.0)
        } else {
            1.0
        };
        let mut step = 1.0;
        while step <= steps {
            places.push(place(cubic, step / steps));
            step += 1.0;
        }
    }
    if closed {
        places.pop();
    }
    places
}

fn place([a, b, c, d]: [DVec2; 4], t: f64) -> DVec2 {
    let s = 1.0 - t;
    s * s * s * a + 3.0 * s * s * t * b + 3.0 * s * t * t * c + t * t * t * d
}
