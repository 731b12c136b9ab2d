//! Smooth curves of points that scatter about them.

use crate::arrays::{self, Arrays, int};
use crate::errors::value_error;
use crate::reconstruct::{Input, shape};
use crate::work::Run;
use curvecrust::DVec2;
use curvecrust::denoise::{Fitted, FittedCurve, Options, denoise_with};
use numpy::PyReadonlyArray2;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use std::num::{NonZeroU32, NonZeroUsize};

/// What a caller says beside the points.
#[derive(FromPyObject)]
pub(crate) struct Arguments {
    #[pyo3(item)]
    closed: Option<bool>,
    #[pyo3(item)]
    curves: Option<NonZeroU32>,
    #[pyo3(item)]
    sigma: Option<f64>,
    #[pyo3(item)]
    merge_within: Option<f64>,
    #[pyo3(item)]
    threads: Option<NonZeroUsize>,
}

/// Curves that points scatter about, and where each point belongs.
#[pyfunction]
pub(crate) fn fit<'py>(
    py: Python<'py>,
    points: PyReadonlyArray2<'py, f64>,
    arguments: Arguments,
) -> PyResult<Bound<'py, PyDict>> {
    let points = arrays::points(&points)?;
    let count = points.len();
    let run = Run {
        py,
        threads: arguments.threads,
        progress: None,
    };
    let options = Options {
        shape: shape(arguments.closed),
        curves: arguments.curves,
        sigma: arguments.sigma,
    };
    let (input, fitted) = run.work(move |_| {
        let input = Input::new(points, arguments.merge_within)?;
        let fitted = denoise_with(&input.points, &options).map_err(value_error)?;
        Ok((input, fitted))
    })?;
    curves(py, &input, &fitted, count)
}

/// For each cubic of a curve, whether it starts at a corner.
fn starts_at_corner(curve: &FittedCurve) -> impl Iterator<Item = bool> {
    (0..curve.cubics.len()).map(|i| curve.corners.binary_search(&i).is_ok())
}

fn curves<'py>(
    py: Python<'py>,
    input: &Input,
    fitted: &Fitted,
    count: usize,
) -> PyResult<Bound<'py, PyDict>> {
    let all = || fitted.curves.iter();
    let controls: Vec<DVec2> = all().flat_map(|c| &c.cubics).flatten().copied().collect();
    let mut offsets = vec![0];
    for curve in all() {
        offsets.push(offsets[offsets.len() - 1] + int(curve.cubics.len()));
    }
    let places: Vec<_> = (0..count)
        .map(|row| fitted.places[input.id(row).index()])
        .collect();
    let edges: Vec<_> = fitted
        .edges
        .iter()
        .flat_map(|edges| edges.edges())
        .map(|edge| edge.ends().map(|v| input.row(v)))
        .collect();
    let number = |value: Option<f64>| value.unwrap_or(f64::NAN);
    Arrays::new(py)
        .with_rows("controls", controls.iter().map(|p| p.to_array()))?
        .with("offsets", offsets)?
        .with("closed", all().map(|c| c.closed).collect())?
        .with("at_corner", all().flat_map(starts_at_corner).collect())?
        .with("counts", all().map(|c| int(c.points)).collect())?
        .with("sigmas", all().flat_map(|c| &c.sigma).copied().collect())?
        .with(
            "standard_errors",
            all().flat_map(|c| &c.standard_error).copied().collect(),
        )?
        .with(
            "curve_of",
            places
                .iter()
                .map(|place| place.map_or(-1, |place| int(place.curve)))
                .collect(),
        )?
        .with(
            "parameters",
            places
                .iter()
                .map(|p| number(p.map(|p| p.parameter)))
                .collect(),
        )?
        .with(
            "distances",
            places
                .iter()
                .map(|p| number(p.map(|p| p.distance)))
                .collect(),
        )?
        .with_rows("edges", edges.into_iter())?
        .with_value("sigma", fitted.sigma())?
        .with_value("clean", fitted.is_clean())
        .map(Arrays::finish)
}

/// Places in order along cubics end to end, nowhere farther from them than the tolerance.
#[pyfunction]
pub(crate) fn polyline<'py>(
    py: Python<'py>,
    controls: PyReadonlyArray2<'py, f64>,
    closed: bool,
    tolerance: f64,
) -> PyResult<Bound<'py, PyDict>> {
    let controls = arrays::points(&controls)?;
    let cubics = controls.chunks_exact(4).map(|c| [c[0], c[1], c[2], c[3]]);
    let places = curvecrust::denoise::polyline(&cubics.collect::<Vec<_>>(), closed, tolerance);
    Arrays::new(py)
        .with_rows("points", places.iter().map(|p| p.to_array()))
        .map(Arrays::finish)
}
