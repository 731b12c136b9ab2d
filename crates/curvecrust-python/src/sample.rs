//! Curves to samples.

use crate::arrays::{Arrays, int};
use crate::curve::Curve;
use crate::errors::value_error;
use crate::work::{Progressed, Run};
use curvecrust::curve::SplitCurve;
use curvecrust::geometry::Progress;
use curvecrust::sampling::{
    Condition, DecodeOptions, DeviationLimit, SampleOptions, Sampling, VerifyOptions,
    sample_curve_with, sample_decoded_with, sample_fewest_with, sample_verified_with,
};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use std::num::NonZeroUsize;

/// How a curve is to be sampled.
#[derive(FromPyObject)]
pub(crate) struct Asked {
    #[pyo3(item)]
    rho: Option<f64>,
    #[pyo3(item)]
    epsilon: Option<f64>,
    #[pyo3(item)]
    max_distance: Option<f64>,
    #[pyo3(item)]
    count: String,
    #[pyo3(item)]
    threads: Option<NonZeroUsize>,
}

impl Asked {
    /// Whether there is no condition.
    pub(crate) fn is_none(&self) -> bool {
        self.rho.is_none() && self.epsilon.is_none() && self.max_distance.is_none()
    }

    /// Either of the two conditions; which of them is given is checked before.
    pub(crate) fn condition(&self) -> PyResult<Condition> {
        let condition = match (self.rho, self.epsilon) {
            (Some(rho), None) => Condition::rho(rho),
            (None, Some(epsilon)) => Condition::epsilon(epsilon),
            _ => return Err(value_error("give either rho or epsilon")),
        };
        let condition = condition.map_err(value_error)?;
        match self.max_distance {
            Some(limit) => condition.with_hausdorff_limit(limit).map_err(value_error),
            None => Ok(condition),
        }
    }
}

/// Samples, and whether least detour returns their polygon, if that was asked.
struct Sampled {
    sampling: Sampling,
    is_decoded: Option<bool>,
}

/// Samples of curves, as sparse as a condition allows.
#[pyfunction]
pub(crate) fn sample<'py>(
    py: Python<'py>,
    curve: &Bound<'py, Curve>,
    asked: Asked,
    progress: Option<Bound<'py, PyAny>>,
) -> PyResult<Bound<'py, PyDict>> {
    let condition = asked.condition()?;
    let split = curve.get().split.clone();
    let run = Run {
        py,
        threads: asked.threads,
        progress: progress.as_ref(),
    };
    let Sampled {
        sampling,
        is_decoded,
    } = run.work(move |progress| chosen(&split, condition, &asked.count, progress))?;
    let samples = &sampling.samples;
    let components = samples.components().iter();
    let starts = components.clone().map(|c| int(c.range.start));
    let edges = samples.manifold_boundary();
    let edges = edges.edges().iter();
    Arrays::new(py)
        .with_rows("points", samples.points().iter().map(|p| p.to_array()))?
        .with("offsets", starts.chain([int(samples.len())]).collect())?
        .with("closed", components.map(|c| c.closed).collect())?
        .with_rows(
            "edges",
            edges.map(|edge| edge.ends().map(|v| int(v.index()))),
        )?
        .with_value("attained", sampling.attained.map(|a| (a.bound, a.at_most)))?
        .with_value("is_decoded", is_decoded)
        .map(Arrays::finish)
}

fn chosen(
    split: &SplitCurve,
    condition: Condition,
    count: &str,
    progress: &Progressed,
) -> PyResult<Sampled> {
    let report = |done, total| progress.report(done, total);
    let progress = Progress::new(&report);
    let options = SampleOptions { progress };
    if !split.corners().is_empty() {
        if count != "greedy" {
            return Err(value_error(
                "curves with corners can only be sampled with count='greedy'",
            ));
        }
        let options = DecodeOptions {
            sampling: options,
            ..DecodeOptions::default()
        };
        let decoded = sample_decoded_with(split, condition, &options).map_err(value_error)?;
        return Ok(Sampled {
            sampling: decoded.sampling,
            is_decoded: Some(decoded.is_exact),
        });
    }
    let greedy = sample_curve_with(split.pieces(), condition, &options).map_err(value_error)?;
    let sampling = match count {
        "greedy" => Ok(greedy),
        "fewest" => sample_fewest_with(&greedy.measured, condition, &options),
        "verified" => {
            let default = VerifyOptions::default();
            let limit = condition.hausdorff_limit();
            let options = VerifyOptions {
                deviation: limit.map_or(default.deviation, DeviationLimit::Length),
                progress,
                ..default
            };
            sample_verified_with(&greedy, &options)
        }
        other => {
            let names = "'greedy', 'fewest' or 'verified'";
            return Err(value_error(format!(
                "count is '{other}', but must be {names}"
            )));
        }
    };
    Ok(Sampled {
        sampling: sampling.map_err(value_error)?,
        is_decoded: None,
    })
}
