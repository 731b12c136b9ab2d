//! Curves from an SVG document, and how finely they are discretised.

use crate::args;
use crate::console::Console;
use crate::input::{self, Source};
use anyhow::{Context, anyhow};
use curvecrust::curve::svg::{Drawing, Selection};
use curvecrust::curve::{Curve, CurveError, SplitCurve};
use curvecrust::geometry::Progress;
use curvecrust::medial_axis::{Discretisation, MeasureOptions, MeasuredCurve, measure_with};
use curvecrust::sampling::Condition;
use std::path::PathBuf;

/// The largest gap between dense points, as a share of lfs.
const GAP: f64 = 0.02;
/// The same, as a share of the bound of a condition.
const GAP_TO_BOUND: f64 = 0.05;

/// A document with curves.
#[derive(Debug)]
pub(super) struct CurveSource {
    path: PathBuf,
    selection: Selection,
    /// `None`: as finely as the lfs and the condition ask for.
    discretisation: Option<Discretisation>,
}

impl From<args::Curve> for CurveSource {
    fn from(args: args::Curve) -> Self {
        let per_segment = args.per_segment.map(Discretisation::PerSegment);
        let adaptive = args
            .gap
            .map(|gap_to_lfs| Discretisation::Adaptive { gap_to_lfs });
        Self {
            path: args.path,
            selection: args.strokes.into(),
            discretisation: per_segment.or(adaptive),
        }
    }
}

impl CurveSource {
    /// A document whose curves are discretised as finely as needed.
    pub(super) fn of(path: PathBuf, selection: Selection) -> Self {
        Self {
            path,
            selection,
            discretisation: None,
        }
    }

    /// How messages name it.
    pub(super) fn name(&self) -> String {
        input::name(&self.path)
    }

    /// The discretisation that was asked for, if any.
    pub(super) fn discretisation(&self) -> Option<Discretisation> {
        self.discretisation
    }

    /// Reads smooth curves.
    pub(super) fn read(&self, console: &Console) -> anyhow::Result<Curve> {
        Curve::from_drawing(&self.drawing(console)?).with_context(|| self.name())
    }

    /// Reads smooth curves; where only corners are wrong, the error names the option that helps.
    pub(super) fn read_or_advise_split(&self, console: &Console) -> anyhow::Result<Curve> {
        let read = Curve::from_drawing(&self.drawing(console)?).map_err(|error| {
            if has_only_corners(&error) {
                anyhow!("{error}: pass --corners split")
            } else {
                error.into()
            }
        });
        read.with_context(|| self.name())
    }

    /// Reads curves, split at their corners, with gaps up to a share of the drawing joined.
    pub(super) fn read_split(&self, snap: f64, console: &Console) -> anyhow::Result<SplitCurve> {
        let drawing = self.drawing(console)?;
        SplitCurve::from_drawing(&drawing, snap).with_context(|| self.name())
    }

    /// Reads what is drawn, and tells of what draws nothing.
    fn drawing(&self, console: &Console) -> anyhow::Result<Drawing> {
        let drawing = Drawing::selected(&self.text()?, &self.selection);
        let drawing = drawing.with_context(|| self.name())?;
        if let Some(first) = drawing.points().next() {
            let (count, verb) = match drawing.points().len() {
                1 => (
                    String::from("a subpath of a single point"),
                    "draws nothing and is",
                ),
                count => (
                    format!("{count} elements with subpaths of a single point"),
                    "draw nothing and are",
                ),
            };
            console.note(format_args!(
                "{}: {count}, which {verb} left out: {first}",
                self.name()
            ));
        }
        Ok(drawing)
    }

    fn text(&self) -> anyhow::Result<String> {
        let name = self.name();
        let bytes = Source::open(&self.path)
            .and_then(Source::into_bytes)
            .with_context(|| format!("cannot read {name}"))?;
        String::from_utf8(bytes).with_context(|| format!("{name} is no SVG document"))
    }

    /// Measures the local feature size of curves that were read, finely enough for a condition.
    pub(super) fn measure(
        &self,
        curve: &Curve,
        condition: Option<Condition>,
        console: &Console,
    ) -> anyhow::Result<MeasuredCurve> {
        let finest = condition.map_or(GAP, |c| GAP.min(GAP_TO_BOUND * c.bound().value()));
        let adaptive = Discretisation::Adaptive { gap_to_lfs: finest };
        let discretisation = self.discretisation.unwrap_or(adaptive);
        let measured = console.during("measuring the local feature size", |progress| {
            let options = MeasureOptions {
                discretisation,
                progress: Progress::new(progress),
                ..MeasureOptions::default()
            };
            measure_with(curve, &options)
        });
        measured.with_context(|| self.name())
    }
}

/// Whether all is well but for corners, which [`Curve`] finds last.
fn has_only_corners(error: &CurveError) -> bool {
    match error {
        CurveError::Corners(_) => true,
        CurveError::InElement { error, .. } => has_only_corners(error),
        _ => false,
    }
}
