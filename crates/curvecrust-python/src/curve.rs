//! Curves, from drawings or through points.

use crate::arrays::{self, Arrays};
use crate::errors::value_error;
use curvecrust::DVec2;
use curvecrust::curve::svg::Drawing;
use curvecrust::curve::{BezierPath, CubicBezier, DenseCurve, SplitCurve};
use curvecrust::geometry::PointSet;
use numpy::PyReadonlyArray2;
use pyo3::prelude::*;
use pyo3::types::PyDict;

/// Curves that may have corners.
#[pyclass(frozen, module = "curvecrust._curvecrust")]
pub(crate) struct Curve {
    pub(crate) split: SplitCurve,
}

#[pymethods]
impl Curve {
    /// From a document; gaps up to a share of the drawing are joined.
    #[staticmethod]
    fn from_svg(py: Python<'_>, text: &str, snap: f64) -> PyResult<Self> {
        if !(0.0..=1.0).contains(&snap) {
            return Err(value_error(format!(
                "snap is {snap}: give a share between 0 and 1"
            )));
        }
        let split = py.detach(|| SplitCurve::from_drawing(&Drawing::new(text)?, snap));
        split.map(|split| Self { split }).map_err(value_error)
    }

    /// From the data of a path.
    #[staticmethod]
    fn from_path(py: Python<'_>, d: &str) -> PyResult<Self> {
        let split = py.detach(|| SplitCurve::from_path_data(d));
        split.map(|split| Self { split }).map_err(value_error)
    }

    /// Through points in order.
    #[staticmethod]
    fn from_points(points: PyReadonlyArray2<'_, f64>, closed: bool) -> PyResult<Self> {
        let points = PointSet::new(arrays::points(&points)?).map_err(value_error)?;
        let least = if closed { 3 } else { 2 };
        if points.len() < least {
            let kind = if closed { "a closed" } else { "an open" };
            let message = format!("{kind} curve goes through {least} points at least");
            return Err(value_error(format!("{message}, not {}", points.len())));
        }
        let path = BezierPath::new(through(points.points(), closed), closed);
        let split = SplitCurve::snapping(vec![path], 0.0).map_err(value_error)?;
        Ok(Self { split })
    }

    /// Whether each of the curves is closed.
    #[getter]
    fn closed(&self) -> Vec<bool> {
        self.split.components().iter().map(|c| c.closed).collect()
    }

    /// The larger side of the bounding box.
    #[getter]
    fn extent(&self) -> f64 {
        self.split.pieces().extent()
    }

    /// Rows of corners.
    fn corners<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let corners = self.split.corners().iter();
        Arrays::new(py)
            .with_rows("at", corners.clone().map(|corner| corner.at.to_array()))?
            .with("degrees", corners.map(|corner| corner.angle_deg).collect())
            .map(Arrays::finish)
    }

    /// Points along all pieces, as many on each segment as asked for, and where each piece begins.
    fn polylines<'py>(&self, py: Python<'py>, per_segment: u32) -> PyResult<Bound<'py, PyDict>> {
        let pieces = self.split.pieces();
        let dense = DenseCurve::per_segment(pieces, per_segment).map_err(value_error)?;
        let components = dense.components().iter();
        let points = dense.points().iter();
        Arrays::new(py)
            .with_rows("points", points.map(|p| p.to_array()))?
            .with(
                "starts",
                arrays::ints(components.clone().map(|c| c.range.start)),
            )?
            .with("closed", components.map(|c| c.closed).collect())
            .map(Arrays::finish)
    }
}

/// Cubic Béziers between consecutive points, with the tangents of the circle through each point and
/// its neighbours, and handles of a third of the chord.
fn through(points: &[DVec2], closed: bool) -> Vec<CubicBezier> {
    let count = points.len();
    let tangent = |at: usize| {
        let is_end = !closed && (at == 0 || at + 1 == count);
        if is_end && count == 2 {
            return (points[1] - points[0]).normalize();
        }
        let middle = if is_end { at.clamp(1, count - 2) } else { at };
        let before = points[(middle + count - 1) % count];
        let (here, after) = (points[middle], points[(middle + 1) % count]);
        let (back, on) = (here - before, after - here);
        // The tangents of the circle at the three points.
        let [a, b] = [back.normalize(), on.normalize()];
        let straight = a * on.length() + b * back.length();
        let here = straight.try_normalize().unwrap_or(a.perp());
        let mirrored = |chord: DVec2| 2.0 * here.dot(chord) * chord - here;
        match is_end {
            false => here,
            true if at == 0 => mirrored(a),
            true => mirrored(b),
        }
    };
    let segments = if closed { count } else { count - 1 };
    (0..segments)
        .map(|from| {
            let to = (from + 1) % count;
            let (p, q) = (points[from], points[to]);
            let third = p.distance(q) / 3.0;
            CubicBezier::new([p, p + third * tangent(from), q - third * tangent(to), q])
        })
        .collect()
}
