//! Curves to samples.

use crate::arrays::{Arrays, int};
use crate::curve::Curve;
use crate::errors::value_error;
use crate::work::{Progressed, Run};
use curvecrust::DVec2;
use curvecrust::curve::{SplitCurve, strands};
use curvecrust::geometry::Progress;
use curvecrust::reconstruct::{HnnCrust, LeastDetour, Reconstructor};
use curvecrust::sampling::{
    Condition, DecodeOptions, SampleOptions, Sampling, SamplingError, SplitOptions, VerifyOptions,
    on_strokes, sample_curve_with, sample_decoded_with, sample_fewest_with, sample_verified_with,
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
    strokes: String,
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
    strokes: &'static str,
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
        strokes,
    } = run.work(move |progress| chosen(split, condition, &asked, progress))?;
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
        .with_value("is_decoded", is_decoded)?
        .with_value("strokes", strokes)
        .map(Arrays::finish)
}

/// Samples of all strokes together; where they touch, of what is left of them when they are cut
/// there, or of each by itself, as was asked.
fn chosen(
    split: SplitCurve,
    condition: Condition,
    asked: &Asked,
    progress: &Progressed,
) -> PyResult<Sampled> {
    let count = one_of("count", &asked.count, &["greedy", "fewest", "verified"])?;
    let names = &["auto", "together", "cut", "apart"];
    let strokes = one_of("strokes", &asked.strokes, names)?;
    let report = |done, total| progress.report(done, total);
    let progress = Progress::new(&report);
    if matches!(strokes, "auto" | "together") {
        let together = if split.corners().is_empty() {
            smooth(&split, condition, count, progress)
        } else {
            decoded(&split, condition, count, progress)
        };
        if strokes == "together"
            || !together
                .as_ref()
                .is_err_and(|error| error.touch().is_some())
        {
            return together.map_err(value_error);
        }
    }
    if strokes != "apart" {
        let cut = cut(&split, condition, count, progress);
        if strokes == "cut" || cut.is_ok() {
            return cut;
        }
    }
    if count == "verified" {
        let message = "strokes apart cannot be sampled with count='verified'";
        return Err(value_error(message));
    }
    decoded(&split.apart(), condition, count, progress).map_err(value_error)
}

/// Samples of strokes that are cut where they touch.
fn cut(
    split: &SplitCurve,
    condition: Condition,
    count: &str,
    progress: Progress<'_>,
) -> PyResult<Sampled> {
    let cut = strands(split).map_err(value_error)?;
    let sampled = decoded(&cut.curve, condition, count, progress).map_err(value_error)?;
    Ok(match cut.places[..] {
        [] => sampled,
        _ => Sampled {
            strokes: "cut",
            ..sampled
        },
    })
}

/// The argument, if it is one of the names.
fn one_of<'a>(argument: &str, value: &'a str, names: &[&str]) -> PyResult<&'a str> {
    if names.contains(&value) {
        return Ok(value);
    }
    let names = names.join("', '");
    Err(value_error(format!(
        "{argument} is '{value}', but must be one of '{names}'"
    )))
}

/// Samples of every smooth piece, put together.
fn decoded(
    split: &SplitCurve,
    condition: Condition,
    count: &str,
    progress: Progress<'_>,
) -> Result<Sampled, SamplingError> {
    let decoder: &dyn Reconstructor = match count {
        "verified" => &HnnCrust::MUTUAL,
        _ => &LeastDetour,
    };
    let options = DecodeOptions {
        decoder,
        sampling: SplitOptions {
            every_start: count != "greedy",
            progress,
        },
    };
    let mut found = sample_decoded_with(split, condition, &options)?;
    if count == "verified" {
        let corners: Vec<DVec2> = split.corners().iter().map(|corner| corner.at).collect();
        let start = on_strokes(split, &found.sampling)?;
        found.sampling = verified(&start, condition, &corners, progress)?;
    }
    Ok(Sampled {
        sampling: found.sampling,
        is_decoded: Some(found.is_exact),
        strokes: if split.is_apart() {
            "apart"
        } else {
            "together"
        },
    })
}

/// As few samples as HNN-Crust still returns, with those at some places.
fn verified(
    start: &Sampling,
    condition: Condition,
    fixed: &[DVec2],
    progress: Progress<'_>,
) -> Result<Sampling, SamplingError> {
    let options = VerifyOptions {
        fixed,
        progress,
        ..VerifyOptions::of(condition)
    };
    sample_verified_with(start, &options)
}

/// Samples of curves without corners.
fn smooth(
    split: &SplitCurve,
    condition: Condition,
    count: &str,
    progress: Progress<'_>,
) -> Result<Sampled, SamplingError> {
    let options = SampleOptions { progress };
    let greedy = sample_curve_with(split.pieces(), condition, &options)?;
    let sampling = match count {
        "fewest" => sample_fewest_with(&greedy.measured, condition, &options)?,
        "verified" => verified(&greedy, condition, &[], progress)?,
        _ => greedy,
    };
    Ok(Sampled {
        sampling,
        is_decoded: None,
        strokes: "together",
    })
}
