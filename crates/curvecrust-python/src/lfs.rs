//! Medial axis, local feature size, and what given samples attain.

use crate::arrays::{self, Arrays, int};
use crate::curve::Curve;
use crate::errors::value_error;
use crate::sample::Asked;
use crate::work::Run;
use curvecrust::curve::{SplitCurve, strands};
use curvecrust::medial_axis::{
    MeasureOptions, MeasuredCurve, MedialAxis, MedialAxisError, measure, measure_axis,
    measure_pieces, strokes_of,
};
use curvecrust::sampling::{
    Attained, check as check_samples, effective_epsilon, effective_rho, project_on_pieces,
};
use numpy::PyReadonlyArray2;
use pyo3::prelude::*;
use pyo3::types::PyDict;

/// Strokes, which are what is left of the curves where they are cut.
pub(crate) struct Strokes {
    pub(crate) split: SplitCurve,
    /// Dense points of the smooth pieces, with their lfs.
    pub(crate) pieces: MeasuredCurve,
}

impl Strokes {
    /// Measures curves; where they touch or cross, what is left of them when they are cut there.
    pub(crate) fn measure(split: SplitCurve) -> PyResult<Self> {
        let pieces = match measured(&split) {
            Err(error) if error.touch().is_some() => {
                let split = strands(&split).map_err(value_error)?.curve;
                let pieces = measured(&split).map_err(value_error)?;
                return Ok(Self { split, pieces });
            }
            measured => measured.map_err(value_error)?,
        };
        Ok(Self { split, pieces })
    }

    /// Dense points of the strokes: a corner is one of them.
    pub(crate) fn whole(&self) -> PyResult<MeasuredCurve> {
        strokes_of(&self.split, &self.pieces).map_err(value_error)
    }
}

/// The medial axis, and the dense points that it is of.
fn axis_of(split: SplitCurve) -> PyResult<(MedialAxis, MeasuredCurve)> {
    if split.is_smooth() {
        match measure_axis(split.pieces(), &MeasureOptions::default()) {
            Err(error) if error.touch().is_some() => {}
            found => return found.map_err(value_error),
        }
    }
    let measured = Strokes::measure(split)?.whole()?;
    let axis = MedialAxis::new(measured.dense()).map_err(value_error)?;
    Ok((axis, measured))
}

fn measured(split: &SplitCurve) -> Result<MeasuredCurve, MedialAxisError> {
    if split.is_smooth() {
        measure(split.pieces())
    } else {
        measure_pieces(split)
    }
}

/// Dense points of a curve and the lfs of each.
#[pyfunction]
pub(crate) fn lfs<'py>(py: Python<'py>, curve: &Bound<'py, Curve>) -> PyResult<Bound<'py, PyDict>> {
    let split = curve.get().split.clone();
    let run = Run::plain(py);
    let measured = run.work(move |_| Ok(Strokes::measure(split)?.pieces))?;
    Arrays::new(py)
        .with_rows(
            "points",
            measured.dense().points().iter().map(|p| p.to_array()),
        )?
        .with("lfs", measured.lfs().values().to_vec())
        .map(Arrays::finish)
}

/// The pieces of the medial axis, with the radius of the disc at both ends.
#[pyfunction]
pub(crate) fn medial_axis<'py>(
    py: Python<'py>,
    curve: &Bound<'py, Curve>,
) -> PyResult<Bound<'py, PyDict>> {
    let split = curve.get().split.clone();
    let (points, edges) = Run::plain(py).work(move |_| {
        let (axis, measured) = axis_of(split)?;
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
        let Strokes { split, pieces } = Strokes::measure(split)?;
        let placed = project_on_pieces(&split, &pieces, &points, tolerance).map_err(value_error)?;
        let epsilon = effective_epsilon(&placed.measured, &placed.samples);
        let rho = effective_rho(&placed.measured, &placed.samples);
        let verdict = condition.map(|c| check_samples(&placed.measured, &placed.samples, c));
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
