//! How far points scatter about a curve, along it.

use super::basis::Spline;
use super::knots::wrapped;
use crate::robust::{NORMAL, median};

/// Neighbours on each side whose residuals give the spread at a point,
const SIDE: usize = 30;
/// but no more than this share of the points: else it cannot vary along a curve of few.
const SHARE: usize = 6;
/// Of fewer points the spread is the same everywhere.
const FEWEST: usize = 40;
/// How much the whole counts beside the neighbours, in points.
const SHRINK: f64 = 5.0;
/// The deviation is computed at every sixth point, and interpolated: windows overlap by far.
const STEP: usize = 6;
/// The most that the spread may differ from the whole.
const RANGE: f64 = 6.0;

/// The standard deviation of points about a curve, by the parameter.
#[derive(Clone, Debug)]
pub(crate) struct Spread {
    common: f64,
    /// Parameters, ascending, and the deviation at each; none if it is the same everywhere.
    local: Vec<(f64, f64)>,
    intervals: usize,
    closed: bool,
}

impl Spread {
    /// A deviation that is the same everywhere.
    pub(crate) fn known(sigma: f64, spline: &Spline) -> Self {
        Self {
            common: sigma,
            local: Vec::new(),
            intervals: spline.intervals(),
            closed: spline.closed(),
        }
    }

    pub(crate) fn of(parameters: &[f64], residuals: &[f64], freedom: f64, spline: &Spline) -> Self {
        let count = residuals.len();
        let mut sizes: Vec<f64> = residuals.iter().map(|r| r.abs()).collect();
        let middle = median(&mut sizes);
        let left = (count as f64 - freedom).max(1.0);
        let common = NORMAL * middle * (count as f64 / left).sqrt();
        let mut spread = Self::known(common, spline);
        if count > FEWEST && middle > 0.0 {
            let pairs = parameters.iter().zip(residuals);
            let mut along: Vec<(f64, f64)> = pairs
                .map(|(&t, r)| (wrapped(t, spread.intervals, spread.closed), r.abs()))
                .collect();
            along.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.total_cmp(&b.1)));
            spread.local = spread.smoothed(&along, middle);
        }
        spread
    }

    /// The spread at each of some residuals in order along the curve, of more than a window.
    fn smoothed(&self, along: &[(f64, f64)], middle: f64) -> Vec<(f64, f64)> {
        let count = along.len();
        let mirrored = |i: isize| -> usize {
            let last = count as isize - 1;
            let i = if self.closed {
                i.rem_euclid(count as isize)
            } else if i < 0 {
                -i
            } else if i > last {
                2 * last - i
            } else {
                i
            };
            usize::try_from(i.clamp(0, last)).unwrap_or(0)
        };
        let side = SIDE.min(count / SHARE);
        let mut window = vec![0.0; 2 * side + 1];
        let width = window.len() as f64;
        let common = self.common.ln();
        let last = !(count - 1).is_multiple_of(STEP);
        let at = (0..count).step_by(STEP).chain(last.then_some(count - 1));
        at.map(|i| {
            for (k, value) in window.iter_mut().enumerate() {
                *value = along[mirrored(i as isize + k as isize - side as isize)].1;
            }
            let here = self.common * median(&mut window) / middle;
            let here = here.clamp(self.common / RANGE, self.common * RANGE).ln();
            let shrunk = (here * width + common * SHRINK) / (width + SHRINK);
            (along[i].0, shrunk.exp())
        })
        .collect()
    }

    /// The deviation of the whole.
    pub(crate) fn common(&self) -> f64 {
        self.common
    }

    /// The deviation at a parameter.
    pub(crate) fn at(&self, t: f64) -> f64 {
        let (Some(first), Some(last)) = (self.local.first(), self.local.last()) else {
            return self.common;
        };
        let t = wrapped(t, self.intervals, self.closed);
        let after = self.local.partition_point(|&(u, _)| u < t);
        let between = |a: &(f64, f64), b: &(f64, f64), t: f64| {
            let gap = b.0 - a.0;
            let share = if gap > 0.0 { (t - a.0) / gap } else { 0.0 };
            a.1 + share.clamp(0.0, 1.0) * (b.1 - a.1)
        };
        let length = self.intervals as f64;
        match (
            after.checked_sub(1).map(|i| &self.local[i]),
            self.local.get(after),
        ) {
            (Some(a), Some(b)) => between(a, b, t),
            (None, Some(b)) if self.closed => between(&(last.0 - length, last.1), b, t),
            (Some(a), None) if self.closed => between(a, &(first.0 + length, first.1), t),
            (None, _) => first.1,
            (_, None) => last.1,
        }
    }
}
