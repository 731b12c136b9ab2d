//! How far apart dense points may be.

use crate::error::MedialAxisError;

/// The medial axis is computed from fewer points: their gaps may be this many times as long as
/// those of the dense points,
const AXIS_GAPS: f64 = 4.0;
/// but at most this fraction of lfs: the error of the axis falls with the square of the gap.
const AXIS_RATIO: f64 = 0.05;
/// Curves that take more points than this may have longer gaps. They are long strands near to each
/// other, whose lfs hardly changes from point to point.
const MANY: f64 = 250_000.0;

/// How long gaps between dense points may be, as fractions of lfs.
#[derive(Clone, Copy)]
pub(crate) struct GapLimits {
    to_lfs: f64,
    /// On curves that take many points.
    of_many: f64,
}

impl GapLimits {
    /// At most `to_lfs`; on curves that take many points `of_many`, if that is larger.
    pub(crate) fn new(to_lfs: f64, of_many: f64) -> Result<Self, MedialAxisError> {
        if to_lfs > 0.0 && to_lfs <= 1.0 {
            let of_many = of_many.min(1.0).max(to_lfs);
            Ok(Self { to_lfs, of_many })
        } else {
            Err(MedialAxisError::GapToLfs(to_lfs))
        }
    }

    /// The limits for the points that the axis is computed from.
    pub(crate) fn of_axis(self) -> Self {
        let to_lfs = self.to_lfs.max((AXIS_GAPS * self.to_lfs).min(AXIS_RATIO));
        let of_many = self.of_many.max(to_lfs);
        Self { to_lfs, of_many }
    }

    /// How many times as many points these limits ask for as others do.
    pub(crate) fn times_more_than(self, others: Self) -> f64 {
        others.to_lfs / self.to_lfs
    }

    /// The gap that is allowed on a curve whose length is `length_to_lfs` times lfs: large enough
    /// to make few points of it.
    pub(crate) fn allowed(self, length_to_lfs: f64) -> f64 {
        (length_to_lfs / MANY).max(self.to_lfs).min(self.of_many)
    }
}
