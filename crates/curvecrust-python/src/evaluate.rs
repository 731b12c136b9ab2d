//! Edges against the truth.

use crate::arrays::{self, Arrays, int};
use crate::curve::Curve;
use crate::errors::value_error;
use crate::lfs::{measured_smooth, placed};
use crate::work::Run;
use curvecrust::evaluate::{Evaluation, Kind, METRICS, Output, Reference, Truth};
use curvecrust::geometry::{Edge, EdgeSet, PointId, PointSet};
use curvecrust::medial_axis::MeasuredCurve;
use curvecrust::sampling::Projected;
use numpy::PyReadonlyArray2;
use pyo3::prelude::*;
use pyo3::types::PyDict;

/// How exactly distances are computed, as a share of the extent.
const TOLERANCE: f64 = 1e-4;

/// Measures of edges between samples of a smooth curve, and which of them are missing and wrong.
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
        let measured = measured_smooth(&split)?;
        let placed = placed(&measured, points.points(), tolerance)?;
        let extent = split.pieces().extent();
        let truth = Truth {
            curve: &Reference::of_curve(split.pieces(), TOLERANCE * extent),
            boundary: &consecutive(&measured, &placed),
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

/// The edges between consecutive samples of each component.
fn consecutive(measured: &MeasuredCurve, placed: &Projected) -> EdgeSet {
    let components = placed.samples.components().iter();
    let dense = measured.dense().components();
    let edges = components.zip(dense).flat_map(|(range, component)| {
        let id = |sample: usize| PointId::new(placed.indices[sample]);
        let closing = component
            .closed
            .then(|| (range.end.saturating_sub(1), range.start));
        let open = range.clone().zip(range.clone().skip(1));
        let pairs = open.chain(closing.filter(|_| !range.is_empty()));
        pairs.filter_map(move |(i, j)| Edge::new(id(i)?, id(j)?))
    });
    EdgeSet::new(placed.indices.len(), edges)
}
