//! The condition that samples have to satisfy.

use crate::args::{self, Distance};
use curvecrust::curve::Curve;
use curvecrust::sampling::{Bound, Condition};

/// A condition, before the extent of the curve is known.
#[derive(Clone, Copy, Debug)]
pub(super) struct Requirement {
    condition: Condition,
    /// No curve point may be farther than this from the chord between its two samples.
    max_distance: Option<Distance>,
}

impl Requirement {
    /// The condition that was asked for, if any.
    pub(super) fn new(args: &args::Condition) -> anyhow::Result<Option<Self>> {
        let condition = match (args.rho, args.epsilon) {
            (Some(rho), _) => Condition::rho(rho)?,
            (None, Some(epsilon)) => Condition::epsilon(epsilon)?,
            (None, None) => return Ok(None),
        };
        Ok(Some(Self {
            condition,
            max_distance: args.max_distance,
        }))
    }

    /// The condition on a curve, with a length for a share of its extent.
    pub(super) fn on(&self, curve: &Curve) -> anyhow::Result<Condition> {
        Ok(match self.max_distance {
            None => self.condition,
            Some(limit) => self
                .condition
                .with_hausdorff_limit(limit.of_extent(curve.extent()))?,
        })
    }
}

/// The name of a condition, and its bound.
pub(super) fn name_and_bound(condition: Condition) -> (&'static str, f64) {
    let name = match condition.bound() {
        Bound::Epsilon(_) => "epsilon",
        Bound::Rho(_) => "rho",
    };
    (name, condition.bound().value())
}
