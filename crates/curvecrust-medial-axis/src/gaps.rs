//! How far apart dense points may be.

use crate::error::MedialAxisError;

/// How many times farther apart than the dense points may be those that the axis is computed from,
/// ...
const AXIS_GAPS: f64 = 4.0;
/// ... but at most this fraction of their lfs apart: the error of the axis falls with the square.
const AXIS_RATIO: f64 = 0.05;
/// So many points are not many yet. What takes more are long strands near to each other, whose lfs
/// hardly changes from point to point.
const MANY: f64 = 250_000.0;

/// How long gaps between dense points may be, as fractions of lfs.
#[derive(Clone, Copy)]
pub(crate) struct Gaps {
    to_lfs: f64,
    /// Where points are many.
    of_many: f64,
}

impl Gaps {
    /// At most `to_lfs`; or `of_many`, if it is the larger one, where points are many.
    pub(crate) fn new(to_lfs: f64, of_many: f64) -> Result<Self, MedialAxisError> {
        if to_lfs > 0.0 && to_lfs <= 1.0 {
            let of_many = of_many.min(1.0).max(to_lfs);
            Ok(Self { to_lfs, of_many })
        } else {
            Err(MedialAxisError::GapToLfs(to_lfs))
        }
    }

    /// Those of the points that the axis is computed from.
    pub(crate) fn of_axis(self) -> Self {
        let to_lfs = self.to_lfs.max((AXIS_GAPS * self.to_lfs).min(AXIS_RATIO));
        let of_many = self.of_many.max(to_lfs);
        Self { to_lfs, of_many }
    }

    /// How many times as many points these gaps make as others.
    pub(crate) fn times_more_than(self, others: Self) -> f64 {
        others.to_lfs / self.to_lfs
    }

    /// The gap that is allowed on a curve whose length is `length_to_lfs` times lfs: large enough
    /// to make few points of it.
    pub(crate) fn allowed(self, length_to_lfs: f64) -> f64 {
        (length_to_lfs / MANY).max(self.to_lfs).min(self.of_many)
    }
}
