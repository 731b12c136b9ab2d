//! A penalised spline through scattered points: smoothing by generalised cross validation,
//! Tukey's weights, and parameters that follow the curve.
//!
//! Sources: P. Eilers, B. Marx, *Flexible Smoothing with B-splines and Penalties*, Statistical
//! Science 1996; P. Craven, G. Wahba, *Smoothing Noisy Data with Spline Functions*, 1979.

use glam::DVec2;

use curvecrust_geometry::Interrupt;

use super::banded::Banded;
use super::basis::Spline;
use super::guide::Guide;
use super::knots::{Knots, Row};
use super::nearest::{Samples, follow};
use super::penalty::{Penalty, Rough};
use super::spread::Spread;
use super::start::start;

/// Rounds of fitting: each moves the parameters and the weights to the last curve.
const ROUNDS: usize = 4;
/// What a degree of freedom counts in cross validation. 1 fits some of the noise now and then.
const FREEDOM: f64 = 1.4;
/// Logarithms to base 10 of the penalties tried, in steps of one half.
const PENALTIES: std::ops::RangeInclusive<i32> = -6..=14;
/// Every so many of them are tried first.
const COARSE: usize = 4;
/// Before this round a fit with creases may take any penalty, later one near the last.
const WIDE: usize = 2;
/// Residuals, in local sigma, from which on a point has no weight.
const TUKEY: f64 = 4.5;
/// Keeps unknowns that neither a point nor the penalty holds.
pub(super) const RIDGE: f64 = 1e-9;

/// A fitted spline and what is known of it.
#[derive(Clone, Debug)]
pub(crate) struct Fit {
    pub(crate) spline: Spline,
    /// Degrees of freedom: how many free numbers describe each coordinate.
    pub(crate) freedom: f64,
    pub(crate) spread: Spread,
    /// The inverse of the normal matrix, in units of the square of the common sigma.
    covariance: Banded,
}

impl Fit {
    /// The standard error of the curve at a parameter.
    pub(crate) fn standard_error(&self, t: f64) -> f64 {
        let row = self.spline.row(t);
        let leverage = self.covariance.quadratic_form(row.columns, row.weights);
        self.spread.common() * leverage.max(0.0).sqrt()
    }
}

/// Fits a spline to points that belong to a guide. Their deviation from the curve may be known.
pub(crate) fn fit(
    guide: &Guide,
    points: &[DVec2],
    sigma: Option<f64>,
    rough: Rough,
) -> Option<Fit> {
    let mut spline = start(guide)?;
    let knots = spline.knots.clone();
    let mut penalty = Penalty::new(&knots, rough);
    let mut samples = Samples::of(&spline);
    let mut parameters: Vec<f64> = samples.nearest_of_all(points);
    let mut weights = vec![1.0; points.len()];
    let mut last: Option<Fit> = None;
    let mut level: Option<i32> = None;
    // Where corners meet moves the first parameters by much.
    let wide = if guide.even { WIDE } else { 0 };
    let interrupt = Interrupt::current();
    for round in 0..ROUNDS {
        interrupt.check();
        if round > 0 {
            penalty.adapt(&spline.controls);
            follow(&samples, points, &mut parameters);
        }
        let rows: Vec<Row> = parameters.iter().map(|&t| knots.row(t)).collect();
        let system = System::new(&rows, points, &weights, &knots);
        let best = system.best(&penalty.matrix(), &spline, level)?;
        level = (round >= wide).then_some(best.level);
        spline.controls = best.controls;
        let spread = match sigma {
            Some(sigma) => Spread::known(sigma, &spline),
            None => Spread::of(&parameters, &best.residuals, best.freedom, &spline),
        };
        for ((w, &r), &t) in weights.iter_mut().zip(&best.residuals).zip(&parameters) {
            let sigma = spread.at(t).max(f64::MIN_POSITIVE.sqrt());
            let z = r / (TUKEY * sigma);
            let tukey = if z.abs() < 1.0 {
                (1.0 - z * z).powi(2)
            } else {
                0.0
            };
            let tukey = if knots.is_at_crease(t) { 0.0 } else { tukey };
            *w = (tukey + 1e-6) * (spread.common() / sigma).powi(2);
        }
        samples = Samples::of(&spline);
        last = Some(Fit {
            spline: spline.clone(),
            freedom: best.freedom,
            spread,
            covariance: best.covariance,
        });
    }
    last
}

/// The normal equations without penalty.
pub(super) struct System<'a> {
    rows: &'a [Row],
    points: &'a [DVec2],
    weights: &'a [f64],
    pub(super) normal: Banded,
    pub(super) right: Vec<DVec2>,
}

struct Best {
    level: i32,
    score: f64,
    controls: Vec<DVec2>,
    freedom: f64,
    residuals: Vec<f64>,
    covariance: Banded,
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
    fn best(&self, penalty: &Banded, last: &Spline, level: Option<i32>) -> Option<Best> {
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
