//! What is known of a reconstruction from samples that the program took.

use curvecrust::curve::Curve;
use curvecrust::geometry::Component;
use curvecrust::reconstruct::{Guarantee, HnnCrust, Reconstructor, SamplingBound, Standing};
use curvecrust::sampling::{Bound, Condition};
use serde::Serialize;

/// How it is known that the samples can be reconstructed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub(super) enum Guaranteed {
    /// The condition is proven to suffice for HNN-Crust on smooth closed curves, as these are.
    Theorem,
    /// An algorithm was run, and returned exactly the polygon of the samples.
    Running,
    /// An algorithm was run, and returned other edges.
    Not,
}

impl Guaranteed {
    /// Whether HNN-Crust is proven to return the polygon of samples that keep a condition.
    pub(super) fn is_by_theorem(curve: &Curve, condition: Condition) -> bool {
        let is_closed = curve.components().iter().all(|path| path.is_closed());
        let guarantees = HnnCrust::MUTUAL.info().guarantees;
        is_closed && guarantees.iter().any(|g| is_proven(g, condition.bound()))
    }

    /// What a run of an algorithm tells.
    pub(super) fn of_run(is_exact: bool) -> Self {
        if is_exact { Self::Running } else { Self::Not }
    }
}

/// That some curves are open, which the theorems are not about; `None` if none are.
pub(super) fn open_curves(curves: &[Component]) -> Option<String> {
    let open = curves.iter().filter(|curve| !curve.closed);
    match open.count() {
        0 => None,
        1 => Some("1 curve is open, which no theorem covers".to_owned()),
        count => Some(format!("{count} curves are open, which no theorem covers")),
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
        Standing::Refuted { proven_below, .. } => proven_below,
        _ => return false,
    };
    asked <= proven
}
