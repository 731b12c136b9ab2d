//! A curve that was loaded, and its samples; corners are samples.

use crate::error::Error;
use crate::message::Answer;
use curvecrust::curve::{SplitCurve, strands};
use curvecrust::evaluate::Reference;
use curvecrust::medial_axis::{MeasuredCurve, MedialAxis, measure_pieces, strokes_of};
use curvecrust::reconstruct::{HnnCrust, LeastDetour, Reconstructor};
use curvecrust::sampling::{Condition, Sampling, SplitOptions, sample_pieces, sample_split_with};
use serde::Deserialize;
use serde_json::json;

/// How exactly distances are computed, as a share of the extent.
const TOLERANCE: f64 = 1e-4;

/// Where a curve comes from.
#[derive(Deserialize)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub(super) enum Source {
    /// The text of an SVG document.
    Svg(String),
    /// The `d` of an SVG path.
    Path(String),
}

/// Which condition samples have to satisfy.
#[derive(Clone, Copy, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct SampleRequest {
    condition: Name,
    bound: f64,
    /// The Hausdorff limit, as a share of the extent.
    limit: Option<f64>,
}

/// The name of a condition.
#[derive(Clone, Copy, Deserialize)]
#[serde(rename_all = "kebab-case")]
enum Name {
    Epsilon,
    Rho,
}

/// A curve with all that its samples need.
#[derive(Debug)]
pub(super) struct Loaded {
    /// Cut where strokes touch or cross.
    split: SplitCurve,
    /// How many places it was cut at.
    cuts: usize,
    pieces: MeasuredCurve,
    /// The same dense points on whole strokes.
    strokes: MeasuredCurve,
    axis: MedialAxis,
    reference: Reference,
    decoder: &'static dyn Reconstructor,
}

impl Loaded {
    pub(super) fn new(source: &Source) -> Result<Self, Error> {
        let split = match source {
            Source::Svg(text) => SplitCurve::from_svg(text)?,
            Source::Path(d) => SplitCurve::from_path_data(d)?,
        };
        let (split, cuts, pieces) = measured(split)?;
        let strokes = strokes_of(&split, &pieces)?;
        let smooth = split.corners().is_empty() && split.components().iter().all(|c| c.closed);
        Ok(Self {
            axis: MedialAxis::new(strokes.dense())?,
            reference: Reference::of_curve(
                split.pieces(),
                0.1 * TOLERANCE * split.pieces().extent(),
            ),
            // No theorem covers corners and ends.
            decoder: if smooth {
                &HnnCrust::MUTUAL
            } else {
                &LeastDetour
            },
            split,
            cuts,
            pieces,
            strokes,
        })
    }

    /// The dense points with their lfs, and the medial axis.
    pub(super) fn describe(&self) -> Answer {
        let mut answer = Answer::default();
        let (low, high) = self.split.pieces().bounding_box();
        answer.value("box", [low.x, low.y, high.x, high.y]);
        answer.value("extent", self.split.pieces().extent());
        answer.value("corners", self.split.corners().len());
        answer.value("cuts", self.cuts);
        let dense = self.strokes.dense();
        answer.points("dense", dense.points().iter().copied());
        answer.array("lfs", self.strokes.lfs().values().iter().copied());
        let components = dense.components().iter();
        answer.indices(
            "components",
            components.flat_map(|c| [c.range.start, c.range.end, usize::from(c.closed)]),
        );
        let axis = self.axis.edges();
        answer.points("axis", axis.flat_map(|e| [e.segment.a, e.segment.b]));
        answer
    }

    /// Samples, the distance of their polygon, and what they attain.
    pub(super) fn sample(&self, request: SampleRequest) -> Result<Answer, Error> {
        let extent = self.split.pieces().extent();
        let condition = request.on(extent)?;
        let sampling = self.samples(condition, false)?;
        let samples = &sampling.samples;
        let mut answer = Answer::default();
        answer.points("samples", samples.points().iter().copied());
        let components = samples.components().iter();
        answer.indices(
            "components",
            components.flat_map(|c| [c.range.start, c.range.end, usize::from(c.closed)]),
        );
        if let Some(attained) = sampling.attained {
            answer.value("attained", attained.at_most);
        }
        let polygon = samples.manifold_boundary();
        let tolerance = TOLERANCE * extent;
        let points = samples.point_set()?;
        answer.value("decoder", self.decoder.info().name);
        answer.value("exact", self.decoder.reconstruct(&points) == polygon);
        let distances = self.reference.distances(&points, &polygon, tolerance);
        answer.value("hausdorff", distances.hausdorff.distance().upper);
        Ok(answer)
    }

    /// At the dense points that are there, which costs least; at more, if the bound needs them.
    fn samples(&self, condition: Condition, every_start: bool) -> Result<Sampling, Error> {
        let options = SplitOptions {
            every_start,
            ..SplitOptions::default()
        };
        match sample_pieces(&self.split, &self.pieces, condition, &options) {
            Ok(sampling) => Ok(sampling),
            Err(_) => Ok(sample_split_with(&self.split, condition, &options)?),
        }
    }

    /// The numbers of samples for the bounds of Table 2, and the fewest for rho < 0.9.
    pub(super) fn counts(&self) -> Result<Answer, Error> {
        let epsilon = |bound| Condition::epsilon(bound);
        let rho = Condition::rho(0.9)?;
        let count = |bound: &str, condition, every_start| {
            let sampling = self.samples(condition, every_start).ok();
            json!({ "bound": bound, "samples": sampling.map(|found| found.samples.len()) })
        };
        let mut answer = Answer::default();
        answer.value(
            "counts",
            [
                count("ε < 1/3", epsilon(1.0 / 3.0)?, false),
                count("ε < 0.47", epsilon(0.47)?, false),
                count("ρ < 0.9", rho, false),
                count("fewest, ρ < 0.9", rho, true),
            ],
        );
        Ok(answer)
    }
}

/// The local feature size of a curve, which is cut where strokes touch or cross, and the number of
/// such places.
fn measured(split: SplitCurve) -> Result<(SplitCurve, usize, MeasuredCurve), Error> {
    let touching = match measure_pieces(&split) {
        Ok(pieces) => return Ok((split, 0, pieces)),
        Err(error) if error.touch().is_some() => error,
        Err(error) => return Err(error.into()),
    };
    let cut = strands(&split)?;
    if cut.places.is_empty() {
        return Err(touching.into());
    }
    let pieces = measure_pieces(&cut.curve)?;
    Ok((cut.curve, cut.places.len(), pieces))
}

impl SampleRequest {
    fn on(self, extent: f64) -> Result<Condition, Error> {
        let condition = match self.condition {
            Name::Epsilon => Condition::epsilon(self.bound)?,
            Name::Rho => Condition::rho(self.bound)?,
        };
        Ok(match self.limit {
            None => condition,
            Some(share) => condition.with_hausdorff_limit(share * extent)?,
        })
    }
}
