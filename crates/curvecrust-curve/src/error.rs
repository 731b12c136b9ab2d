//! What can be wrong with curves, documents and discretisations: the place, and what to do.

use curvecrust_geometry::PointSet;
use glam::DVec2;
use thiserror::Error;

/// The largest number of points of a [`DenseCurve`](crate::DenseCurve).
pub const DENSE_LIMIT: usize = 10_000_000;

/// Why path data, a document or components are not a [`Curve`](crate::Curve).
///
/// Components are counted in document order, segments from the start of their component, both from
/// 0 and without the segments of zero length.
#[derive(Clone, Debug, Error, PartialEq)]
#[non_exhaustive]
pub enum CurveError {
    /// There is nothing to make a curve of.
    #[error("there is no curve: draw at least one path or shape")]
    Empty,
    /// A component has no segment, or only segments of zero length.
    #[error("component {component} has no length: remove it")]
    ZeroLength {
        /// Index of the component.
        component: usize,
    },
    /// A coordinate of a control point is NaN or infinite.
    #[error(
        "component {component}, segment {segment} has the control point ({}, {}): \
         coordinates must be finite",
        at.x, at.y
    )]
    NotFinite {
        /// Index of the component.
        component: usize,
        /// Index of the segment.
        segment: usize,
        /// The control point.
        at: DVec2,
    },
    /// A coordinate is too large for the exact predicates.
    #[error(
        "component {component}, segment {segment} has the coordinate {value:e}: \
         scale the curve so that no coordinate exceeds {:e}",
        PointSet::MAX_MAGNITUDE
    )]
    Magnitude {
        /// Index of the component.
        component: usize,
        /// Index of the segment.
        segment: usize,
        /// The coordinate.
        value: f64,
    },
    /// A segment does not start where the one before it ends.
    #[error(
        "component {component}, segment {segment} starts at ({}, {}), but the one before it ends at \
         ({}, {}): join them, or make two components",
        start.x, start.y, end.x, end.y
    )]
    Gap {
        /// Index of the component.
        component: usize,
        /// Index of the segment; 0 for the gap between the ends of a closed component.
        segment: usize,
        /// Where the segment starts.
        start: DVec2,
        /// Where the segment before it ends.
        end: DVec2,
    },
    /// Segments meet at angles; every such place is named, in the order of the curve.
    #[error(
        "{}: curves must be smooth, so round {} off, or split the curve there",
        Corner::list(.0), if .0.len() == 1 { "it" } else { "them" }
    )]
    Corners(Vec<Corner>),
    /// Two segments meet at a small angle, and neither can be turned, since each has a handle of
    /// length zero.
    #[error(
        "component {component} has a corner of {angle_deg:e} degrees at the start of segment \
         {segment}, at ({}, {}), where two segments meet that have a handle of length zero: \
         draw these handles out",
        at.x, at.y
    )]
    NoHandle {
        /// Index of the component.
        component: usize,
        /// Index of the segment that starts at the corner.
        segment: usize,
        /// The angle between the tangents, in degrees.
        angle_deg: f64,
        /// The corner.
        at: DVec2,
    },
    /// The curve turns round on the spot inside a segment.
    #[error(
        "component {component}, segment {segment} has a cusp at t = {t:.6}, at ({}, {}): \
         curves must be smooth, so move its handles",
        at.x, at.y
    )]
    Cusp {
        /// Index of the component.
        component: usize,
        /// Index of the segment.
        segment: usize,
        /// The parameter of the cusp.
        t: f64,
        /// The cusp.
        at: DVec2,
    },
    /// Path data does not follow the grammar of SVG.
    #[error("path data is malformed at character {position}: {message}")]
    PathData {
        /// Position in the path data, in characters from 1; one past the end if it ends too early.
        position: usize,
        /// What is wrong there, and what to do.
        message: String,
    },
    /// The document is not well-formed XML.
    #[error("malformed XML at line {line}, column {column}: {message}")]
    Xml {
        /// The line, from 1.
        line: u32,
        /// The column, from 1.
        column: u32,
        /// What is wrong there.
        message: String,
    },
    /// The document is XML, but not SVG.
    #[error(
        "the root element is <{name}>: it must be <svg> with xmlns=\"http://www.w3.org/2000/svg\""
    )]
    NotSvg {
        /// Name of the root element.
        name: String,
    },
    /// An attribute has a value that cannot be used.
    #[error("{name}=\"{value}\" {message}")]
    Attribute {
        /// The attribute.
        name: String,
        /// Its value; empty if it is missing.
        value: String,
        /// What is wrong with it, and what to do.
        message: String,
    },
    /// The document holds something that cannot be read, or too much of it.
    #[error("{what}")]
    Unsupported {
        /// What it is, and what to do.
        what: String,
    },
    /// An element of a document is at fault.
    #[error("{element}: {error}")]
    InElement {
        /// The element: its name, its id if it has one, and its line.
        element: String,
        /// What is wrong with it.
        error: Box<Self>,
    },
}

/// How many corners a message names.
const NAMED: usize = 100;

/// Where two segments meet at an angle.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Corner {
    /// Index of the component.
    pub component: usize,
    /// Index of the segment that starts at the corner.
    pub segment: usize,
    /// The angle between the tangents, in degrees; 0 is smooth.
    pub angle_deg: f64,
    /// The corner.
    pub at: DVec2,
}

impl Corner {
    /// Corners in words, for a message; of very many the first ones.
    #[must_use]
    pub fn list(corners: &[Self]) -> String {
        let mut text = String::new();
        let mut last = None;
        for corner in corners.iter().take(NAMED) {
            let Self {
                component,
                segment,
                angle_deg,
                at,
            } = corner;
            text += &match last {
                None => format!("component {component} has a corner"),
                Some(last) if last == component => String::from(", one"),
                Some(_) => format!("; component {component} has one"),
            };
            text += &format!(
                " of {angle_deg:.3} degrees at the start of segment {segment}, at ({}, {})",
                at.x, at.y
            );
            last = Some(component);
        }
        if corners.len() > NAMED {
            text += &format!("; and {} more", corners.len() - NAMED);
        }
        text
    }
}

impl CurveError {
    /// A corner of a small angle, as an error.
    pub(crate) fn no_handle(corner: Corner) -> Self {
        let Corner {
            component,
            segment,
            angle_deg,
            at,
        } = corner;
        Self::NoHandle {
            component,
            segment,
            angle_deg,
            at,
        }
    }

    /// The component at fault, if it is one.
    pub(crate) fn component(&self) -> Option<usize> {
        match *self {
            Self::ZeroLength { component }
            | Self::NotFinite { component, .. }
            | Self::Magnitude { component, .. }
            | Self::Gap { component, .. }
            | Self::NoHandle { component, .. }
            | Self::Cusp { component, .. } => Some(component),
            Self::Corners(ref corners) => {
                let (first, rest) = corners.split_first()?;
                let together = rest.iter().all(|c| c.component == first.component);
                together.then_some(first.component)
            }
            _ => None,
        }
    }

    pub(crate) fn within(self, element: impl Into<String>) -> Self {
        Self::InElement {
            element: element.into(),
            error: Box::new(self),
        }
    }
}

/// Why points are not a [`DenseCurve`](crate::DenseCurve).
#[derive(Clone, Debug, Error, PartialEq)]
#[non_exhaustive]
pub enum DenseError {
    /// A segment, quarter or gap was to be cut into no piece at all.
    #[error("0 pieces at index {index}: every part of a curve needs at least 1")]
    NoPieces {
        /// Index of the gap; 0 if the number is that of all segments.
        index: usize,
    },
    /// There would be too many points.
    #[error("{count} dense points, but at most {DENSE_LIMIT} are supported: ask for fewer")]
    TooMany {
        /// The number of points asked for.
        count: u64,
    },
    /// Two lists that belong together differ in length.
    #[error("{points} points, but {other} {what}: give one for each")]
    Lengths {
        /// The number of points.
        points: usize,
        /// The number of the other things.
        other: usize,
        /// What they are.
        what: &'static str,
    },
    /// A coordinate is not finite, or outside of the range of a [`PointSet`].
    #[error("dense point {index} is ({}, {}), which is out of range: scale the curve", at.x, at.y)]
    Coordinate {
        /// Index of the point.
        index: usize,
        /// The point.
        at: DVec2,
    },
    /// Component ranges do not follow each other without gaps, are empty, or do not cover all
    /// points.
    #[error("component {component} does not start where the one before it ends, or holds no point")]
    Range {
        /// Index of the component, or the number of components if points are left over.
        component: usize,
    },
    /// A parameter is out of range, of another component, or not after the one before it.
    #[error(
        "dense point {index} has a parameter that its component or curve does not have, \
         or that does not come after that of the point before it"
    )]
    Param {
        /// Index of the point.
        index: usize,
    },
}

/// Why numbers are not the measures of an analytic curve.
#[derive(Clone, Debug, Error, PartialEq)]
#[non_exhaustive]
pub enum AnalyticError {
    /// A length is not positive, or so small or large that sums and squares might not be carried.
    #[error("{name} is {value}: it must be from 1e-30 to 1e50")]
    NotPositive {
        /// The measure.
        name: &'static str,
        /// Its value.
        value: f64,
    },
    /// Two lengths are in the wrong order.
    #[error("{first} is {first_value} and {second} {second_value}: the first must {relation}")]
    Order {
        /// The measure that is too small.
        first: &'static str,
        /// Its value.
        first_value: f64,
        /// The measure that is too large.
        second: &'static str,
        /// Its value.
        second_value: f64,
        /// What the first must be: `be larger` or `not be smaller`.
        relation: &'static str,
    },
}
