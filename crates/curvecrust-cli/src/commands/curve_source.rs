//! Curves from an SVG document, and how finely they are discretised.

use crate::args::{self, Corners, StrokesOf};
use crate::console::Console;
use crate::input::{self, Source};
use crate::output::Number;
use anyhow::{Context, anyhow, bail};
use curvecrust::DVec2;
use curvecrust::curve::svg::{Drawing, ElementName, Selection};
use curvecrust::curve::{Curve, CurveError, SplitCurve, Strands, strands};
use curvecrust::geometry::Progress;
use curvecrust::medial_axis::{
    Discretisation, MeasureOptions, MeasurePiecesOptions, MeasuredCurve, MedialAxis,
    MedialAxisError, measure_axis, measure_pieces_with, measure_with, strokes_of,
};
use curvecrust::sampling::{Condition, SamplingError};
use std::cell::OnceCell;
use std::path::PathBuf;

/// The largest gap between dense points, as a share of lfs.
const GAP: f64 = 0.02;
/// The same, as a share of the bound of a condition.
const GAP_TO_BOUND: f64 = 0.05;

/// Elements that a message names.
const MOST_ELEMENTS: usize = 2;

/// A document with curves.
#[derive(Debug)]
pub(super) struct CurveSource {
    path: PathBuf,
    selection: Selection,
    corners: Corners,
    /// Longer gaps than this share of the drawing stay.
    snap: f64,
    /// `None`: as finely as the lfs and the condition ask for.
    discretisation: Option<Discretisation>,
    /// What was read, by which messages name elements.
    drawing: OnceCell<Drawing>,
}

/// Curves, and the local feature size along them.
pub(super) struct MeasuredStrokes {
    pub(super) split: SplitCurve,
    /// The smooth pieces.
    pub(super) pieces: MeasuredCurve,
    /// The strokes.
    pub(super) measured: MeasuredCurve,
    /// What was asked for on them.
    pub(super) condition: Option<Condition>,
}

impl From<args::Curve> for CurveSource {
    fn from(args: args::Curve) -> Self {
        let per_segment = args.per_segment.map(Discretisation::PerSegment);
        let adaptive = args
            .gap
            .map(|gap_to_lfs| Discretisation::Adaptive { gap_to_lfs });
        Self {
            discretisation: per_segment.or(adaptive),
            ..Self::of(args.path, args.strokes)
        }
    }
}

impl CurveSource {
    /// A document whose curves are discretised as finely as needed.
    pub(super) fn of(path: PathBuf, strokes: StrokesOf) -> Self {
        Self {
            path,
            selection: Selection {
                select: strokes.select,
                exclude: strokes.exclude,
            },
            corners: strokes.corners,
            snap: strokes.snap,
            discretisation: None,
            drawing: OnceCell::new(),
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

    /// Reads curves, split at their corners unless those are refused, and notes joined gaps.
    pub(super) fn read(&self, console: &Console) -> anyhow::Result<SplitCurve> {
        let drawing = self.drawing(console)?;
        let drawing = self.drawing.get_or_init(|| drawing);
        if self.corners == Corners::Refuse {
            let smooth = Curve::from_drawing(drawing).map_err(|error| {
                if has_only_corners(&error) {
                    anyhow!("{error}: pass --corners split")
                } else {
                    error.into()
                }
            });
            return Ok(smooth.with_context(|| self.name())?.into());
        }
        let split = SplitCurve::from_drawing(drawing, self.snap).with_context(|| self.name())?;
        self.tell_of_joined_gaps(&split, console);
        Ok(split)
    }

    fn tell_of_joined_gaps(&self, split: &SplitCurve, console: &Console) {
        let Some(first) = split.snapped().first() else {
            return;
        };
        let gaps = match split.snapped().len() {
            1 => String::from("a gap"),
            count => format!("{count} gaps"),
        };
        console.note(format_args!(
            "{}: {gaps} of at most {} % of the drawing joined, first at ({}, {})",
            self.name(),
            Number(100.0 * self.snap),
            Number(first.x),
            Number(first.y)
        ));
    }

    /// Whether strokes may be cut: not where corners are refused, which is for smooth curves alone.
    pub(super) fn splits(&self) -> bool {
        self.corners == Corners::Split
    }

    /// Cuts strokes where they touch or cross.
    pub(super) fn cut(&self, split: &SplitCurve) -> anyhow::Result<Strands> {
        strands(split).map_err(|error| self.named(error))
    }

    /// Tells where strokes were cut.
    pub(super) fn tell_of_cuts(&self, cut: &Strands, console: &Console) {
        let Some(first) = cut.places.first() else {
            return;
        };
        let places = match cut.places.len() {
            1 => String::from("in 1 place,"),
            count => format!("in {count} places, first"),
        };
        let elements = self.elements_at(*first);
        let elements = elements.map_or(String::new(), |elements| format!(" on {elements}"));
        let left_out = match cut.left_out.len() {
            0 => String::new(),
            1 => String::from("; 1 stroke that is shorter is left out"),
            count => format!("; {count} strokes that are shorter are left out"),
        };
        console.note(format_args!(
            "{}: strokes touch or cross {places} at ({}, {}){elements}: one runs through, others end {} \
             short{left_out}",
            self.name(),
            Number(first.x),
            Number(first.y),
            Number(cut.gap),
        ));
    }

    /// The elements that pass a place, for messages; `None` if there is none.
    fn elements_at(&self, place: DVec2) -> Option<String> {
        let elements = self.drawing.get()?.elements_at(place);
        let shown = elements.iter().take(MOST_ELEMENTS);
        let shown: Vec<String> = shown.map(ToString::to_string).collect();
        match elements.len().saturating_sub(MOST_ELEMENTS) {
            0 if shown.is_empty() => None,
            0 => Some(shown.join(" and ")),
            more => Some(format!("{} and {more} more", shown.join(", "))),
        }
    }

    /// An error with the name of the document, and the elements that are at fault if strokes touch.
    pub(super) fn named(&self, error: impl Into<anyhow::Error>) -> anyhow::Error {
        let error = error.into();
        let elements = touching(&error).and_then(|place| self.elements_at(place));
        let error = match elements {
            Some(elements) => error.context(elements),
            None => error,
        };
        error.context(self.name())
    }

    /// Reads what is drawn, and notes elements that draw nothing.
    fn drawing(&self, console: &Console) -> anyhow::Result<Drawing> {
        let drawing = Drawing::selected(&self.text()?, &self.selection);
        let drawing = drawing.with_context(|| self.name())?;
        let points = (
            "a subpath of a single point",
            "elements with subpaths of a single point",
        );
        let unpainted = (
            "an element with neither fill nor stroke",
            "elements with neither fill nor stroke",
        );
        self.tell_of_left_out(points, drawing.points(), console);
        self.tell_of_left_out(unpainted, drawing.unpainted(), console);
        Ok(drawing)
    }

    /// Tells of elements that draw nothing, called by a name for one and one for more.
    fn tell_of_left_out<'a>(
        &self,
        (one, more): (&str, &str),
        mut elements: impl ExactSizeIterator<Item = &'a ElementName>,
        console: &Console,
    ) {
        let count = elements.len();
        let Some(first) = elements.next() else {
            return;
        };
        let (what, verb) = match count {
            1 => (one.to_owned(), "draws nothing and is"),
            count => (format!("{count} {more}"), "draw nothing and are"),
        };
        console.note(format_args!(
            "{}: {what}, which {verb} left out: {first}",
            self.name()
        ));
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
        let options = self.options(condition);
        let measured = console.during("measuring the local feature size", |progress| {
            let progress = Progress::new(progress);
            measure_with(
                curve,
                &MeasureOptions {
                    progress,
                    ..options
                },
            )
        });
        measured.map_err(|error| self.named(error))
    }

    /// How smooth curves are measured, finely enough for a condition.
    fn options(&self, condition: Option<Condition>) -> MeasureOptions<'static> {
        let adaptive = Discretisation::Adaptive {
            gap_to_lfs: finest(condition),
        };
        MeasureOptions {
            discretisation: self.discretisation.unwrap_or(adaptive),
            ..MeasureOptions::default()
        }
    }

    /// Measures the local feature size of strokes that may have corners; where they touch, of what
    /// is left of them when they are cut there.
    pub(super) fn measure_strokes(
        &self,
        split: SplitCurve,
        condition: impl Fn(&SplitCurve) -> anyhow::Result<Option<Condition>>,
        console: &Console,
    ) -> anyhow::Result<MeasuredStrokes> {
        let asked = condition(&split)?;
        let error = match self.measure_pieces(&split, asked, console) {
            Ok(pieces) => return self.whole(split, pieces, asked),
            Err(error) => error,
        };
        if !self.splits() || touching(&error).is_none() {
            return Err(error);
        }
        let cut = self.cut(&split)?;
        let asked = condition(&cut.curve)?;
        let pieces = self.measure_pieces(&cut.curve, asked, console)?;
        self.tell_of_cuts(&cut, console);
        self.whole(cut.curve, pieces, asked)
    }

    /// The medial axis of strokes that may have corners; where they touch, of what is left of them
    /// when they are cut there.
    pub(super) fn measure_axis(
        &self,
        split: SplitCurve,
        console: &Console,
    ) -> anyhow::Result<(SplitCurve, MedialAxis)> {
        if split.is_smooth() {
            let options = self.options(None);
            let measured = console.during("measuring the medial axis", |progress| {
                let progress = Progress::new(progress);
                measure_axis(
                    split.pieces(),
                    &MeasureOptions {
                        progress,
                        ..options
                    },
                )
            });
            match measured {
                Ok((axis, _)) => return Ok((split, axis)),
                Err(error) if error.touch().is_some() && self.splits() => {}
                Err(error) => return Err(self.named(error)),
            }
        }
        let strokes = self.measure_strokes(split, |_| Ok(None), console)?;
        let axis = MedialAxis::new(strokes.measured.dense())?;
        Ok((strokes.split, axis))
    }

    fn whole(
        &self,
        split: SplitCurve,
        pieces: MeasuredCurve,
        condition: Option<Condition>,
    ) -> anyhow::Result<MeasuredStrokes> {
        let measured = strokes_of(&split, &pieces).with_context(|| self.name())?;
        Ok(MeasuredStrokes {
            split,
            pieces,
            measured,
            condition,
        })
    }

    fn measure_pieces(
        &self,
        split: &SplitCurve,
        condition: Option<Condition>,
        console: &Console,
    ) -> anyhow::Result<MeasuredCurve> {
        if split.is_smooth() {
            return self.measure(split.pieces(), condition, console);
        }
        let gap_to_lfs = match self.discretisation {
            None => finest(condition),
            Some(Discretisation::Adaptive { gap_to_lfs }) => gap_to_lfs,
            Some(Discretisation::PerSegment(_)) => bail!(
                "{}: curves with corners cannot be measured with --per-segment",
                self.name()
            ),
        };
        let measured = console.during("measuring the local feature size", |progress| {
            let options = MeasurePiecesOptions {
                gap_to_lfs,
                progress: Progress::new(progress),
                ..MeasurePiecesOptions::default()
            };
            measure_pieces_with(split, &options)
        });
        measured.map_err(|error| self.named(error))
    }
}

/// The largest gap between dense points as a share of lfs that a condition asks for.
fn finest(condition: Option<Condition>) -> f64 {
    condition.map_or(GAP, |c| GAP.min(GAP_TO_BOUND * c.bound().value()))
}

/// Where strokes touch or cross, if that is the error.
pub(super) fn touching(error: &anyhow::Error) -> Option<DVec2> {
    match error.downcast_ref::<SamplingError>() {
        Some(error) => error.touch(),
        None => error.downcast_ref::<MedialAxisError>()?.touch(),
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
