//! What is known of a reconstruction from samples that the program took.

use curvecrust::curve::Curve;
use curvecrust::reconstruct::{
    Guarantee, HnnCrust, LeastDetour, Reconstructor, SamplingBound, Standing,
};
use curvecrust::sampling::{Bound, Condition, SampledCurve};
use serde::Serialize;

/// How it is known that the samples can be reconstructed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub(super) enum Guaranteed {
    /// The condition is proven to suffice for HNN-Crust on smooth closed curves, as these are.
    Theorem,
    /// Least detour was run, and returned exactly the polygon of the samples.
    Running,
    /// Least detour was run, and returned other edges.
    Not,
}

impl Guaranteed {
    /// What is known of samples of smooth curves.
    pub(super) fn of_smooth(curve: &Curve, condition: Condition, samples: &SampledCurve) -> Self {
        let is_closed = curve.components().iter().all(|path| path.is_closed());
        let guarantees = HnnCrust::MUTUAL.info().guarantees;
        if is_closed && guarantees.iter().any(|g| is_proven(g, condition.bound())) {
            return Self::Theorem;
        }
        let returned = samples
            .point_set()
            .is_ok_and(|points| LeastDetour.reconstruct(&points) == samples.manifold_boundary());
        Self::of_run(returned)
    }

    /// What a run of least detour tells.
    pub(super) fn of_run(is_exact: bool) -> Self {
        if is_exact { Self::Running } else { Self::Not }
    }

    /// The end of a line about samples.
    pub(super) fn ending(self) -> &'static str {
        match self {
            Self::Theorem => "; HNN-Crust is proven to return exactly their polygon",
            Self::Running => "; least detour returns exactly their polygon",
            Self::Not => "; least detour does not return their polygon",
        }
    }
}

/// Whether the condition is one of those for which the guarantee is proven.
fn is_proven(guarantee: &Guarantee, asked: Bound) -> bool {
    let (claimed, asked) = match (guarantee.claimed, asked) {
        (SamplingBound::Rho(claimed), Bound::Rho(asked))
        | (SamplingBound::Epsilon(claimed), Bound::Epsilon(asked)) => (claimed, asked),
        _ => return false,
    };
    let proven = match guarantee.standing {
        Standing::Proven => claimed,
        Standing::ProvenBelow(proven) => proven,
        Standing::Refuted { proven_below, .. } => proven_below,
        _ => return false,
    };
    asked <= proven
}
