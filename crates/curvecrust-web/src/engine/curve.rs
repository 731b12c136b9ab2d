//! A smooth curve that was loaded, and its samples.

use crate::drawing;
use crate::error::Error;
use crate::message::Answer;
use curvecrust::curve::Curve;
use curvecrust::evaluate::Reference;
use curvecrust::medial_axis::{MeasuredCurve, MedialAxis, measure};
use curvecrust::reconstruct::{HnnCrust, Reconstructor};
use curvecrust::sampling::{Condition, Sampling, sample, sample_curve, sample_fewest};
use serde::{Deserialize, Serialize};

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

/// Which samples are wanted.
#[derive(Clone, Copy, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Wanted {
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

/// The number of samples for one bound, as in Table 2 of the paper.
#[derive(Serialize)]
struct Count {
    bound: &'static str,
    samples: Option<usize>,
}

/// A curve with all that its samples need.
#[derive(Debug)]
pub(super) struct Loaded {
    curve: Curve,
    measured: MeasuredCurve,
    axis: MedialAxis,
    reference: Reference,
}

impl Loaded {
    pub(super) fn new(source: &Source) -> Result<Self, Error> {
        let curve = match source {
            Source::Svg(text) => drawing::curve(text).map_err(Error::File)?,
            Source::Path(d) => Curve::from_path_data(d)?,
        };
        let measured = measure(&curve)?;
        Ok(Self {
            axis: MedialAxis::new(measured.dense())?,
            reference: Reference::of_curve(&curve, 0.1 * TOLERANCE * curve.extent()),
            curve,
            measured,
        })
    }

    /// The dense points with their lfs, and the medial axis.
    pub(super) fn describe(&self) -> Answer {
        let mut answer = Answer::default();
        let (low, high) = self.curve.bounding_box();
        answer.value("box", [low.x, low.y, high.x, high.y]);
        answer.value("extent", self.curve.extent());
        let dense = self.measured.dense();
        answer.points("dense", dense.points().iter().copied());
        answer.array("lfs", self.measured.lfs().values().iter().copied());
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
    pub(super) fn sample(&self, wanted: Wanted) -> Result<Answer, Error> {
        let condition = wanted.on(&self.curve)?;
        let sampling = self.greedy(condition)?;
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
        let tolerance = TOLERANCE * self.curve.extent();
        let points = samples.point_set()?;
        let found = HnnCrust::MUTUAL.reconstruct(&points);
        answer.value("exact", found == polygon);
        let distances = self.reference.distances(&points, &polygon, tolerance);
        answer.value("hausdorff", distances.hausdorff.distance().upper);
        Ok(answer)
    }

    /// At the dense points that are there, which costs least; at more, if the bound needs them.
    fn greedy(&self, condition: Condition) -> Result<Sampling, Error> {
        match sample(&self.measured, condition) {
            Ok(sampling) => Ok(sampling),
            Err(_) => Ok(sample_curve(&self.curve, condition)?),
        }
    }

    /// The numbers of samples for the bounds of Table 2, and the fewest for rho < 0.9.
    pub(super) fn counts(&self) -> Result<Answer, Error> {
        let epsilon = |bound| Condition::epsilon(bound);
        let rho = Condition::rho(0.9)?;
        let greedy = |condition| {
            let sampling = self.greedy(condition);
            sampling.map(|sampling| sampling.samples.len()).ok()
        };
        let fewest = sample_fewest(&self.measured, rho);
        let count = |bound, samples| Count { bound, samples };
        let mut answer = Answer::default();
        answer.value(
            "counts",
            [
                count("ε < 1/3", greedy(epsilon(1.0 / 3.0)?)),
                count("ε < 0.47", greedy(epsilon(0.47)?)),
                count("ρ < 0.9", greedy(rho)),
                count(
                    "fewest, ρ < 0.9",
                    fewest.map(|found| found.samples.len()).ok(),
                ),
            ],
        );
        Ok(answer)
    }
}

impl Wanted {
    fn on(self, curve: &Curve) -> Result<Condition, Error> {
        let condition = match self.condition {
            Name::Epsilon => Condition::epsilon(self.bound)?,
            Name::Rho => Condition::rho(self.bound)?,
        };
        Ok(match self.limit {
            None => condition,
            Some(share) => condition.with_hausdorff_limit(share * curve.extent())?,
        })
    }
}
