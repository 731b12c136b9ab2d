//! Edges against the truth.

use crate::arrays::{self, Arrays, int};
use crate::curve::Curve;
use crate::errors::value_error;
use crate::lfs::Strokes;
use crate::work::Run;
use curvecrust::evaluate::{Evaluation, Kind, METRICS, Output, Reference, Truth};
use curvecrust::geometry::{Edge, PointSet};
use curvecrust::sampling::PlacedSamples;
use numpy::PyReadonlyArray2;
use pyo3::prelude::*;
use pyo3::types::PyDict;

/// How exactly distances are computed, as a share of the extent.
const TOLERANCE: f64 = 1e-4;

/// Measures of edges between samples of a curve, and which of them are missing and wrong.
#[pyfunction]
pub(crate) fn evaluate<'py>(
    py: Python<'py>,
    curve: &Bound<'py, Curve>,
    samples: PyReadonlyArray2<'py, f64>,
    edges: PyReadonlyArray2<'py, i64>,
    tolerance: f64,
) -> PyResult<Bound<'py, PyDict>> {
    let split = curve.get().split.clone();
    let points = arrays::points(&samples)?;
    let edges = arrays::edges(&edges, points.len())?;
    let evaluation = Run::plain(py).work(move |_| {
        let points = PointSet::new(points).map_err(value_error)?;
        let strokes = Strokes::measure(split)?;
        let (split, measured) = (&strokes.split, strokes.whole()?);
        let placed = PlacedSamples::project(&measured, points.points(), tolerance);
        let placed = placed.map_err(value_error)?;
        let extent = split.pieces().extent();
        let truth = Truth {
            curve: &Reference::of_curve(split.pieces(), TOLERANCE * extent),
            boundary: &placed.manifold_boundary(&measured),
        };
        let output = Output {
            vertices: &points,
            edges: &edges,
            kind: Kind::Interpolating,
            seconds: None,
        };
        Ok(Evaluation::new(truth, output, TOLERANCE))
    })?;
    let metrics = PyDict::new(py);
    for metric in METRICS {
        let value = metric.of(&evaluation).map(|bounds| bounds.upper);
        if let Some(value) = value {
            metrics.set_item(metric.name, value)?;
        }
    }
    let pair = |edge: &Edge| edge.ends().map(|v| int(v.index()));
    let comparison = evaluation.comparison.as_ref();
    let (missing, wrong) =
        comparison.map_or((&[][..], &[][..]), |c| (&c.missing[..], &c.wrong[..]));
    Arrays::new(py)
        .with_value("metrics", metrics)?
        .with_rows("missing", missing.iter().map(pair))?
        .with_rows("wrong", wrong.iter().map(pair))
        .map(Arrays::finish)
}
