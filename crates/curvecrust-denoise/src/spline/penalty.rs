//! The penalty on the roughness of a spline: a derivative in each interval.

use glam::DVec2;

use super::banded::Banded;
use super::knots::Knots;
use crate::robust::median;

/// The power by which the penalty yields where the curve bends much.
const YIELD: f64 = 1.5;

/// What is rough about a curve.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Rough {
    /// Its second derivative: a straight line is smooth.
    Bends,
    /// Its third derivative: a parabola is smooth too.
    Changes,
}

/// The squares of a derivative in each interval, weighted. Across a crease nothing is rough.
pub(super) struct Penalty<'a> {
    knots: &'a Knots,
    rough: Rough,
    /// By interval.
    weights: Vec<f64>,
}

impl<'a> Penalty<'a> {
    pub(super) fn new(knots: &'a Knots, rough: Rough) -> Self {
        Self {
            knots,
            rough,
            weights: vec![1.0; knots.intervals],
        }
    }

    pub(super) fn matrix(&self) -> Banded {
        let mut matrix = Banded::zero(self.knots.controls(), self.knots.closed);
        for (j, &weight) in self.weights.iter().enumerate() {
            for row in self.rows(j) {
                matrix.add_outer(self.knots.columns(j), row, weight);
            }
        }
        matrix
    }

    /// What is rough in an interval, as rows for its control points.
    fn rows(&self, j: usize) -> impl Iterator<Item = [f64; 4]> + use<> {
        let (seconds, thirds) = (self.knots.seconds(j), self.knots.thirds(j));
        let rows = match self.rough {
            Rough::Bends => [Some(seconds[0]), Some(seconds[1])],
            Rough::Changes => [Some(thirds), None],
        };
        rows.into_iter().flatten()
    }

    /// Yields where the curve is rough, so that a corner does not set the smoothing of
    /// the rest.
    pub(super) fn adapt(&mut self, controls: &[DVec2]) {
        // Bends are penalised of curves with creases, whose sides are even.
        if self.rough == Rough::Bends {
            return;
        }
        let difference = |j: usize| {
            let columns = self.knots.columns(j);
            let size = |row: [f64; 4]| {
                let terms = columns.iter().zip(row);
                terms.map(|(&c, w)| controls[c] * w).sum::<DVec2>().length()
            };
            self.rows(j).map(size).fold(0.0, f64::max)
        };
        let sizes: Vec<f64> = (0..self.weights.len()).map(difference).collect();
        let count = sizes.len();
        let at = |i: usize, step: isize| match i.checked_add_signed(step) {
            Some(j) if j < count => sizes[j],
            Some(_) if self.knots.closed => sizes[0],
            None if self.knots.closed => sizes[count - 1],
            _ => sizes[i],
        };
        let smooth: Vec<f64> = (0..count)
            .map(|i| 0.25 * at(i, -1) + 0.5 * sizes[i] + 0.25 * at(i, 1))
            .collect();
        let usual = median(&mut smooth.clone()).max(f64::MIN_POSITIVE.sqrt());
        let weight = |size: f64| (usual / (size + usual)).powf(YIELD);
        let mean = smooth.iter().map(|&s| weight(s).ln()).sum::<f64>() / count.max(1) as f64;
        self.weights = smooth.iter().map(|&s| weight(s) / mean.exp()).collect();
    }
}
