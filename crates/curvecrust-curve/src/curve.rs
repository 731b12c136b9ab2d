//! Smooth curves: chains of cubic Béziers that are known to be smooth.

use curvecrust_geometry::PointSet;
use glam::DVec2;

use crate::bezier::{CubicBezier, bounds};
use crate::bezier_path::BezierPath;
use crate::error::{Corner, CurveError};
use crate::svg::Drawing;
use crate::{path_data, smooth};

/// A place on a [`Curve`]; ordered along the curve.
///
/// The end of one segment and the start of the next are the same point under two names; the
/// discretisations use the start, save at the end of an open component.
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
pub struct CurveParam {
    /// Index of the component.
    pub component: u32,
    /// Index of the segment in the component.
    pub segment: u32,
    /// Parameter in the segment, in [0, 1].
    pub t: f64,
}

/// Smooth curves of the plane: one or more open or closed components.
///
/// # Guarantees
/// - There is at least one component, and each has positive length.
/// - Every coordinate of a control point is finite, and within [`PointSet::MAX_MAGNITUDE`] as
///   given.
/// - No segment is a single point; each starts where the one before it ends, and the last of a
///   closed component ends where the first starts.
/// - The tangent is continuous: it is the same on both sides of every join (up to rounding), and no
///   segment has a cusp inside.
///
/// That components cross or touch, themselves or each other, is for the medial axis to find.
///
/// # Joins that are nearly smooth
/// Drawn and rounded paths seldom have joins that are exactly smooth. Angles below 1 degree are
/// taken away: both handles are turned to their mean direction, with their lengths and all end
/// points kept. Else the medial axis would grow a branch into each tiny corner, and the local
/// feature size would go to zero there, the more so the finer the discretisation. A handle of
/// length zero has no direction of its own; its segment stays, and the other one takes the whole
/// turn.
///
/// ```
/// use curvecrust_curve::{Curve, CurveError};
///
/// let arch = Curve::from_path_data("M 0 0 C 0 4 6 4 6 0")?;
/// assert_eq!(arch.extent(), 6.0);
/// assert!(!arch.components()[0].is_closed());
///
/// let hook = Curve::from_path_data("M 0 0 H 1 V 1");
/// assert!(matches!(hook, Err(CurveError::Corners(corners)) if corners[0].segment == 1));
/// # Ok::<(), CurveError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Curve {
    components: Vec<BezierPath>,
}

impl Curve {
    /// Takes components in their order, checks them and makes their joins exactly smooth.
    ///
    /// Segments without length are left out, coordinates below [`PointSet::MIN_MAGNITUDE`] are
    /// taken as 0, and straight segments without handles get those of [`CubicBezier::line`].
    ///
    /// # Errors
    /// The first component, in it the first segment or join, that breaks a guarantee;
    /// [`CurveError::Empty`]; or, if all else is well, [`CurveError::Corners`] with every corner,
    /// which [`SplitCurve`](crate::SplitCurve) takes.
    pub fn new(components: Vec<BezierPath>) -> Result<Self, CurveError> {
        let (components, corners) = checked(&components)?;
        // A small angle is only left where no handle can take it away.
        match corners.iter().find(|corner| smooth::is_small(corner)) {
            Some(&corner) => Err(CurveError::no_handle(corner)),
            None if corners.is_empty() => Ok(Self { components }),
            None => Err(CurveError::Corners(corners)),
        }
    }

    /// Components that are smooth already.
    pub(crate) fn of_pieces(components: Vec<BezierPath>) -> Self {
        Self { components }
    }

    /// The curve of an SVG path string (the `d` attribute), in double precision.
    ///
    /// Each subpath that draws something is a component. It is closed by `Z` (with a straight
    /// segment if there is a gap), or if its ends meet within 1e-6 of its extent; the end is then
    /// put on the start. A `M` without a segment after it draws nothing and is no component.
    /// Nor is a subpath of a single point. Elliptical arcs become cubics within 1e-10 of their
    /// larger radius; the curvature of a circle is right within 1e-6.
    ///
    /// # Errors
    /// [`CurveError::PathData`] with the position, or what [`Curve::new`] finds.
    pub fn from_path_data(d: &str) -> Result<Self, CurveError> {
        Self::new(path_data::drawn(d)?)
    }

    /// The curves of an SVG document: all paths and shapes that it draws, in document order and in
    /// the user space of the root element, whatever their paint.
    ///
    /// See [`svg`](crate::svg) for what is read and how exactly, and what is refused.
    ///
    /// # Errors
    /// [`CurveError::Xml`], [`CurveError::NotSvg`], [`CurveError::Unsupported`], what
    /// [`Curve::new`] finds, or any of these as [`CurveError::InElement`] where one element is at
    /// fault.
    pub fn from_svg(document: &str) -> Result<Self, CurveError> {
        Self::from_drawing(&Drawing::new(document)?)
    }

    /// The strokes of a drawing, which have to be smooth.
    ///
    /// # Errors
    /// Those of [`Curve::new`], which name the element.
    pub fn from_drawing(drawing: &Drawing) -> Result<Self, CurveError> {
        let curve = Self::new(drawing.components().to_vec());
        curve.map_err(|error| drawing.with_element(error))
    }

    /// The components, in the order in which they were given.
    #[must_use]
    pub fn components(&self) -> &[BezierPath] {
        &self.components
    }

    /// The smallest box around the curve, not around its control points: its corners with the
    /// smallest and the largest coordinates.
    #[must_use]
    pub fn bounding_box(&self) -> (DVec2, DVec2) {
        bounds(self.components.iter().flat_map(BezierPath::segments))
    }

    /// The larger side of the bounding box; positive.
    #[must_use]
    pub fn extent(&self) -> f64 {
        let (low, high) = self.bounding_box();
        (high - low).max_element()
    }

    /// The point at a parameter.
    ///
    /// # Panics
    /// If the curve has no such component or segment.
    #[must_use]
    pub fn point(&self, at: CurveParam) -> DVec2 {
        self.segment(at).point(at.t)
    }

    /// The unit tangent at a parameter, in the direction of the curve; the limit of the tangents
    /// inside the segment where a control arm has no length.
    ///
    /// # Panics
    /// If the curve has no such component or segment.
    #[must_use]
    pub fn tangent(&self, at: CurveParam) -> DVec2 {
        self.segment(at).tangent(at.t)
    }

    fn segment(&self, at: CurveParam) -> &CubicBezier {
        &self.components[at.component as usize].segments()[at.segment as usize]
    }
}

/// Components that are sound and smooth but for the corners.
pub(crate) fn checked(
    components: &[BezierPath],
) -> Result<(Vec<BezierPath>, Vec<Corner>), CurveError> {
    if components.is_empty() {
        return Err(CurveError::Empty);
    }
    let mut corners = Vec::new();
    let mut check = |(index, component): (usize, &BezierPath)| {
        let mut segments = validated(index, component)?;
        let found = smooth::smooth_joins(index, &mut segments, component.is_closed());
        corners.extend(found);
        smooth::check_cusps(index, &segments)?;
        Ok(BezierPath::new(segments, component.is_closed()))
    };
    let components = components.iter().enumerate().map(&mut check);
    Ok((components.collect::<Result<_, _>>()?, corners))
}

/// The segments of a component, once their coordinates and ends are known to be sound.
fn validated(index: usize, component: &BezierPath) -> Result<Vec<CubicBezier>, CurveError> {
    for (segment, bezier) in component.segments().iter().enumerate() {
        let [p0, p1, p2, p3] = bezier.control_points();
        // Ends first: the handles of lines and arcs are in no file.
        for at in [p0, p3, p1, p2] {
            if !at.is_finite() {
                return Err(CurveError::NotFinite {
                    component: index,
                    segment,
                    at,
                });
            }
            if let Some(value) = [at.x, at.y]
                .into_iter()
                .find(|v| v.abs() > PointSet::MAX_MAGNITUDE)
            {
                return Err(CurveError::Magnitude {
                    component: index,
                    segment,
                    value,
                });
            }
        }
    }
    let carried = component.segments().iter().map(|s| s.map(flushed_to_zero));
    let segments: Vec<_> = carried.filter(|s| !s.is_point()).collect();
    let Some(last) = segments.last() else {
        return Err(CurveError::ZeroLength { component: index });
    };
    let mut end = if component.is_closed() {
        last.end()
    } else {
        segments[0].start()
    };
    for (segment, bezier) in segments.iter().enumerate() {
        let start = bezier.start();
        if start != end {
            return Err(CurveError::Gap {
                component: index,
                segment,
                start,
                end,
            });
        }
        end = bezier.end();
    }
    Ok(segments)
}

/// Coordinates that exact predicates cannot tell from 0 become 0.
pub(crate) fn flushed_to_zero(p: DVec2) -> DVec2 {
    let carried = |v: f64| {
        if v.abs() < PointSet::MIN_MAGNITUDE {
            0.0
        } else {
            v
        }
    };
    DVec2::new(carried(p.x), carried(p.y))
}
