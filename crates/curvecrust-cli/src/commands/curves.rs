//! The curves of an SVG document, and what is measured on them.

use crate::args;
use crate::console::Console;
use crate::input::{self, Source};
use anyhow::Context;
use curvecrust::curve::Curve;
use curvecrust::medial_axis::{Discretisation, Estimator, Measured, measure};
use std::path::Path;

/// Reads the curves of a document.
pub(super) fn read(path: &Path) -> anyhow::Result<Curve> {
    let name = input::name(path);
    let bytes = Source::open(path)
        .and_then(Source::into_bytes)
        .with_context(|| format!("cannot read {name}"))?;
    let text = String::from_utf8(bytes).with_context(|| format!("{name} is no SVG document"))?;
    Curve::from_svg(&text).with_context(|| name)
}

/// Measures the local feature size of curves that were read.
pub(super) fn measured(
    args: &args::Curve,
    curve: &Curve,
    console: &Console,
) -> anyhow::Result<Measured> {
    let discretisation = match args.per_segment {
        Some(points) => Discretisation::PerSegment(points),
        None => Discretisation::Adaptive {
            gap_to_lfs: args.gap,
        },
    };
    let measured = console.during("measuring the local feature size", || {
        measure(curve, discretisation, Estimator::Voronoi)
    });
    measured.with_context(|| input::name(&args.path))
}
