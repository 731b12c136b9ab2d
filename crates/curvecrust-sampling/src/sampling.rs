//! What every sampler returns, and the options that samplers share.

use curvecrust_geometry::Progress;
use curvecrust_medial_axis::MeasuredCurve;

use crate::arcs::Arcs;
use crate::check::{self, Attained};
use crate::condition::{Bound, Condition};
use crate::placed::PlacedSamples;
use crate::sampled_curve::SampledCurve;

/// Samples of a curve, and what they were chosen by. The docs of each sampler say what it
/// guarantees.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Sampling {
    /// The samples, in the order of the curve.
    pub samples: SampledCurve,
    /// The dense points that the samples were chosen from, with their lfs.
    pub measured: MeasuredCurve,
    /// The condition that was asked for; `None` of samplers that take none.
    pub condition: Option<Condition>,
    /// The largest epsilon that the samples attain if the condition bounds epsilon, otherwise the
    /// largest rho, and where. `None` for a curve without points.
    pub attained: Option<Attained>,
}

/// Options of samplers that take a condition.
#[derive(Clone, Copy, Debug, Default)]
pub struct SampleOptions<'a> {
    /// Hears how many dense points are done, of how many.
    pub progress: Progress<'a>,
}

impl Sampling {
    /// Samples that are dense points of the measured curve, in its order, with those of each of its
    /// components.
    pub(crate) fn new(
        measured: &MeasuredCurve,
        arcs: &[Arcs],
        samples: SampledCurve,
        condition: Option<Condition>,
    ) -> Self {
        let placed = PlacedSamples::at_dense_points(&samples);
        let kind = condition.map_or(Bound::Rho(1.0), Condition::bound);
        Self {
            attained: check::attained(arcs, &placed, kind),
            samples,
            measured: measured.clone(),
            condition,
        }
    }
}
