//! The normal equations of a fit, and the penalty that cross validation chooses.

use glam::DVec2;

use super::banded::Banded;
use super::basis::Spline;
use super::knots::{Knots, Row};

/// What a degree of freedom counts in cross validation. 1 fits some of the noise now and then.
const FREEDOM: f64 = 1.4;
/// Logarithms to base 10 of the penalties tried, in steps of one half.
const PENALTIES: std::ops::RangeInclusive<i32> = -6..=14;
/// Every fourth of them is tried first.
const COARSE: usize = 4;
/// Keeps unknowns that neither a point nor the penalty holds.
pub(super) const RIDGE: f64 = 1e-9;

/// The normal equations without penalty.
pub(super) struct System<'a> {
    rows: &'a [Row],
    points: &'a [DVec2],
    weights: &'a [f64],
    pub(super) normal: Banded,
    pub(super) right: Vec<DVec2>,
}

/// A solution.
pub(super) struct Best {
    pub(super) level: i32,
    score: f64,
    pub(super) controls: Vec<DVec2>,
    pub(super) freedom: f64,
    pub(super) residuals: Vec<f64>,
    pub(super) covariance: Banded,
}

impl<'a> System<'a> {
    pub(super) fn new(
        rows: &'a [Row],
        points: &'a [DVec2],
        weights: &'a [f64],
        knots: &Knots,
    ) -> Self {
        let unknowns = knots.controls();
        let mut normal = Banded::zero(unknowns, knots.closed);
        let mut right = vec![DVec2::ZERO; unknowns];
        for ((row, &p), &weight) in rows.iter().zip(points).zip(weights) {
            normal.add_outer(row.columns, row.weights, weight);
            for (&c, w) in row.columns.iter().zip(row.weights) {
                right[c] += weight * w * p;
            }
        }
        Self {
            rows,
            points,
            weights,
            normal,
            right,
        }
    }

    /// The penalty of the least cross validation, near that of the last round, if there was one.
    ///
    /// It falls and then rises with the penalty, nearly always: coarse steps first, finer ones
    /// about the best.
    pub(super) fn best(&self, penalty: &Banded, last: &Spline, level: Option<i32>) -> Option<Best> {
        let normals: Vec<DVec2> = self
            .rows
            .iter()
            .map(|row| row.tangent(&last.controls).normalize_or_zero().perp())
            .collect();
        let try_at = |level: i32| {
            PENALTIES
                .contains(&level)
                .then(|| self.at(level, penalty, &normals))
                .filter(|best| best.score.is_finite())
        };
        let coarse: Vec<i32> = match level {
            None => PENALTIES.step_by(COARSE).collect(),
            Some(level) => vec![level - 2, level, level + 2],
        };
        let better = |a: Best, b: Best| if b.score < a.score { b } else { a };
        let mut best = coarse.iter().filter_map(|&l| try_at(l)).reduce(better)?;
        for step in [2, 1] {
            let middle = best.level;
            for level in [middle - step, middle + step] {
                if step == 2 && coarse.contains(&level) {
                    continue;
                }
                if let Some(found) = try_at(level) {
                    best = better(best, found);
                }
            }
        }
        Some(best)
    }

    fn at(&self, level: i32, penalty: &Banded, normals: &[DVec2]) -> Best {
        let strength = 10f64.powf(f64::from(level) / 2.0);
        let factor = self.normal.plus(strength, penalty, RIDGE).factor();
        let controls = factor.solve(self.right.clone());
        let covariance = factor.inverse();
        let freedom = covariance.trace_of_product(&self.normal);
        let place = self.rows.iter().map(|row| row.point(&controls));
        let apart = self.points.iter().zip(place).map(|(&p, q)| p - q);
        let residuals: Vec<f64> = apart.zip(normals).map(|(r, n)| r.dot(*n)).collect();
        let total: f64 = self.weights.iter().sum();
        let squares: f64 = residuals
            .iter()
            .zip(self.weights)
            .map(|(r, w)| w * r * r)
            .sum();
        let left = 1.0 - FREEDOM * freedom / total;
        let score = if left > 1e-3 {
            squares / total / (left * left)
        } else {
            f64::INFINITY
        };
        Best {
            level,
            score,
            controls,
            freedom,
            residuals,
            covariance,
        }
    }
}
