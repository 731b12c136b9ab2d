//! Medial axis, local feature size, and what given samples attain.

use crate::arrays::{self, Arrays, int};
use crate::curve::Curve;
use crate::errors::value_error;
use crate::sample::Asked;
use crate::work::Run;
use curvecrust::curve::SplitCurve;
use curvecrust::medial_axis::{MeasuredCurve, MedialAxis, measure, measure_pieces};
use curvecrust::sampling::{
    Attained, PlacedSamples, Projected, check as check_samples, effective_epsilon, effective_rho,
};
use numpy::PyReadonlyArray2;
use pyo3::prelude::*;
use pyo3::types::PyDict;

/// Dense points of the curve and their lfs.
fn measured(split: &SplitCurve) -> PyResult<MeasuredCurve> {
    if split.corners().is_empty() {
        measure(split.pieces()).map_err(value_error)
    } else {
        measure_pieces(split).map_err(value_error)
    }
}

/// Dense points of a curve without corners.
pub(crate) fn measured_smooth(split: &SplitCurve) -> PyResult<MeasuredCurve> {
    match split.corners() {
        [] => measured(split),
        [corner, ..] => Err(value_error(format!(
            "the curve has a corner at ({}, {}), where its local feature size is 0: this is for \
             smooth curves",
            corner.at.x, corner.at.y
        ))),
    }
}

/// The samples in the order of the curve.
pub(crate) fn placed(
    measured: &MeasuredCurve,
    points: &[curvecrust::DVec2],
    tolerance: f64,
) -> PyResult<Projected> {
    PlacedSamples::project(measured, points, tolerance).map_err(value_error)
}

/// Dense points of a curve and the lfs of each.
#[pyfunction]
pub(crate) fn lfs<'py>(py: Python<'py>, curve: &Bound<'py, Curve>) -> PyResult<Bound<'py, PyDict>> {
    let split = curve.get().split.clone();
    let run = Run::plain(py);
    let measured = run.work(move |_| measured(&split))?;
    Arrays::new(py)
        .with_rows(
            "points",
            measured.dense().points().iter().map(|p| p.to_array()),
        )?
        .with("lfs", measured.lfs().values().to_vec())
        .map(Arrays::finish)
}

/// The pieces of the medial axis of a smooth curve, with the radius of the disc at both ends.
#[pyfunction]
pub(crate) fn medial_axis<'py>(
    py: Python<'py>,
    curve: &Bound<'py, Curve>,
) -> PyResult<Bound<'py, PyDict>> {
    let split = curve.get().split.clone();
    let (points, edges) = Run::plain(py).work(move |_| {
        let measured = measured_smooth(&split)?;
        let axis = MedialAxis::new(measured.dense()).map_err(value_error)?;
        Ok((
            measured.dense().points().to_vec(),
            axis.edges().collect::<Vec<_>>(),
        ))
    })?;
    let ends = |edge: &curvecrust::medial_axis::AxisEdge| [edge.segment.a, edge.segment.b];
    let radii = |edge| ends(edge).map(|end| end.distance(points[edge.sites[0]]));
    Arrays::new(py)
        .with_rows("starts", edges.iter().map(|edge| ends(edge)[0].to_array()))?
        .with_rows("ends", edges.iter().map(|edge| ends(edge)[1].to_array()))?
        .with_rows("radii", edges.iter().map(radii))?
        .with_rows("sites", edges.iter().map(|edge| edge.sites.map(int)))?
        .with_rows("points", points.iter().map(|p| p.to_array()))
        .map(Arrays::finish)
}

/// What samples attain, and whether a condition holds for them if one is given.
#[pyfunction]
pub(crate) fn check<'py>(
    py: Python<'py>,
    curve: &Bound<'py, Curve>,
    samples: PyReadonlyArray2<'py, f64>,
    asked: Asked,
    tolerance: f64,
) -> PyResult<Bound<'py, PyDict>> {
    let split = curve.get().split.clone();
    let points = arrays::points(&samples)?;
    let condition = if asked.is_none() {
        None
    } else {
        Some(asked.condition()?)
    };
    let (placed, epsilon, rho, verdict) = Run::plain(py).work(move |_| {
        let measured = measured_smooth(&split)?;
        let placed = placed(&measured, &points, tolerance)?;
        let epsilon = effective_epsilon(&measured, &placed.samples);
        let rho = effective_rho(&measured, &placed.samples);
        let verdict = condition.map(|c| check_samples(&measured, &placed.samples, c));
        Ok((placed, epsilon, rho, verdict))
    })?;
    let bounds = |found: &Attained| (found.bound, found.at_most);
    let row = |sample: Option<usize>| sample.map_or(-1, |sample| int(placed.indices[sample]));
    let found = verdict.iter().flat_map(|verdict| &verdict.violations);
    let found: Vec<&Attained> = found.collect();
    Arrays::new(py)
        .with(
            "order",
            placed.indices.iter().map(|&index| int(index)).collect(),
        )?
        .with_value("epsilon", epsilon.as_ref().map(bounds))?
        .with_value("rho", rho.as_ref().map(bounds))?
        .with_value("holds", verdict.as_ref().map(|verdict| verdict.holds()))?
        .with_value("certain", verdict.as_ref().map(|verdict| verdict.certain))?
        .with_rows("between", found.iter().map(|a| a.interval.samples.map(row)))?
        .with_rows("at", found.iter().map(|a| a.at.to_array()))?
        .with("values", found.iter().map(|a| a.bound).collect())
        .map(Arrays::finish)
}
