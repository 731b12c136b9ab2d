//! The curves of an SVG document, and what is measured on them.

use crate::args;
use crate::console::Console;
use crate::input::{self, Source};
use anyhow::{Context, anyhow};
use curvecrust::curve::{Curve, SplitCurve};
use curvecrust::geometry::Progress;
use curvecrust::medial_axis::{Discretisation, MeasureOptions, MeasuredCurve, measure_with};
use curvecrust::sampling::{Bound, Condition};
use std::path::Path;

/// Reads the curves of a document.
pub(super) fn read(path: &Path) -> anyhow::Result<Curve> {
    Curve::from_svg(&text(path)?).with_context(|| input::name(path))
}

/// The same, for a command that could split them: where corners are all that is wrong, it says how.
pub(super) fn read_or_say_split(path: &Path) -> anyhow::Result<Curve> {
    let text = text(path)?;
    let read = Curve::from_svg(&text).map_err(|error| match SplitCurve::from_svg(&text) {
        Ok(_) => anyhow!("{error}: pass --corners split"),
        Err(_) => error.into(),
    });
    read.with_context(|| input::name(path))
}

/// Reads the curves of a document, split at their corners.
pub(super) fn read_split(path: &Path) -> anyhow::Result<SplitCurve> {
    SplitCurve::from_svg(&text(path)?).with_context(|| input::name(path))
}

fn text(path: &Path) -> anyhow::Result<String> {
    let name = input::name(path);
    let bytes = Source::open(path)
        .and_then(Source::into_bytes)
        .with_context(|| format!("cannot read {name}"))?;
    String::from_utf8(bytes).with_context(|| format!("{name} is no SVG document"))
}

/// The largest gap between dense points, as a share of lfs.
const GAP: f64 = 0.02;
/// The same, as a share of the bound of a condition.
const GAP_TO_BOUND: f64 = 0.05;

/// Measures the local feature size of curves that were read, finely enough for a condition.
pub(super) fn measured(
    args: &args::Curve,
    curve: &Curve,
    condition: Option<Condition>,
    console: &Console,
) -> anyhow::Result<MeasuredCurve> {
    let finest = condition.map_or(GAP, |c| GAP.min(GAP_TO_BOUND * c.bound().value()));
    let discretisation = match args.per_segment {
        Some(points) => Discretisation::PerSegment(points),
        None => Discretisation::Adaptive {
            gap_to_lfs: args.gap.unwrap_or(finest),
        },
    };
    let measured = console.during("measuring the local feature size", |progress| {
        let options = MeasureOptions {
            discretisation,
            progress: Progress::new(progress),
            ..MeasureOptions::default()
        };
        measure_with(curve, &options)
    });
    measured.with_context(|| input::name(&args.path))
}

/// The condition that was typed, if any, with a length for a share of the curve's extent.
pub(super) fn condition(
    args: &args::Condition,
    curve: &Curve,
) -> anyhow::Result<Option<Condition>> {
    let condition = match (args.rho, args.epsilon) {
        (Some(rho), _) => Condition::rho(rho)?,
        (None, Some(epsilon)) => Condition::epsilon(epsilon)?,
        (None, None) => return Ok(None),
    };
    Ok(Some(match args.max_distance {
        None => condition,
        Some(limit) => condition.with_hausdorff_limit(limit.of_extent(curve.extent()))?,
    }))
}

/// The name of a condition, and its bound.
pub(super) fn bound(condition: Condition) -> (&'static str, f64) {
    let name = match condition.bound() {
        Bound::Epsilon(_) => "epsilon",
        Bound::Rho(_) => "rho",
    };
    (name, condition.bound().value())
}
