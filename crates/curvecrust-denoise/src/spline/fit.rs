//! A penalised spline through scattered points: smoothing by generalised cross validation,
//! Tukey's weights, and parameters that follow the curve.
//!
//! Sources: P. Eilers, B. Marx, *Flexible Smoothing with B-splines and Penalties*, Statistical
//! Science 1996; P. Craven, G. Wahba, *Smoothing Noisy Data with Spline Functions*, 1979.

use glam::DVec2;

use curvecrust_geometry::Interrupt;

use super::banded::Banded;
use super::basis::{Row, Spline, controls_of, row};
use super::guide::Guide;
use super::nearest::{Samples, follow};
use super::spread::Spread;
use crate::robust::median;

/// Rounds of fitting: each moves the parameters and the weights to the last curve.
const ROUNDS: usize = 4;
/// What a degree of freedom counts in cross validation. 1 fits some of the noise now and then.
const FREEDOM: f64 = 1.4;
/// The power by which the penalty yields where the curve bends much.
const YIELD: f64 = 1.5;
/// Logarithms to base 10 of the penalties tried, in steps of one half.
const PENALTIES: std::ops::RangeInclusive<i32> = -6..=14;
/// Every so many of them are tried first.
const COARSE: usize = 4;
/// Residuals, in local sigma, from which on a point has no weight.
const TUKEY: f64 = 4.5;
/// Keeps unknowns that neither a point nor the penalty holds.
const RIDGE: f64 = 1e-9;

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

/// The third differences of the control points, weighted.
struct Penalty {
    closed: bool,
    unknowns: usize,
    weights: Vec<f64>,
}

const THIRD: [f64; 4] = [-1.0, 3.0, -3.0, 1.0];

impl Penalty {
    fn new(unknowns: usize, closed: bool) -> Self {
        let rows = if closed { unknowns } else { unknowns - 3 };
        Self {
            closed,
            unknowns,
            weights: vec![1.0; rows],
        }
    }

    fn columns(&self, start: usize) -> [usize; 4] {
        [0, 1, 2, 3].map(|a| (start + a) % self.unknowns)
    }

    fn matrix(&self) -> Banded {
        let mut matrix = Banded::zero(self.unknowns, self.closed);
        for (start, &weight) in self.weights.iter().enumerate() {
            matrix.add_outer(self.columns(start), THIRD, weight);
        }
        matrix
    }

    /// Yields where third differences are large, so that a corner does not set the smoothing of
    /// the rest.
    fn adapt(&mut self, controls: &[DVec2]) {
        let difference = |start: usize| {
            let columns = self.columns(start);
            let terms = columns.iter().zip(THIRD);
            terms.map(|(&c, w)| controls[c] * w).sum::<DVec2>().length()
        };
        let sizes: Vec<f64> = (0..self.weights.len()).map(difference).collect();
        let count = sizes.len();
        let at = |i: usize, step: isize| match i.checked_add_signed(step) {
            Some(j) if j < count => sizes[j],
            Some(_) if self.closed => sizes[0],
            None if self.closed => sizes[count - 1],
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

/// Fits a spline to points that belong to a guide. Their deviation from the curve may be known.
pub(crate) fn fit(guide: &Guide, points: &[DVec2], sigma: Option<f64>) -> Option<Fit> {
    let (mut spline, closed) = (start(guide)?, guide.closed);
    let intervals = spline.intervals();
    let unknowns = controls_of(intervals, closed);
    let mut penalty = Penalty::new(unknowns, closed);
    let mut samples = Samples::of(&spline);
    let mut parameters: Vec<f64> = samples.nearest_of_all(points);
    let mut weights = vec![1.0; points.len()];
    let mut last: Option<Fit> = None;
    let mut level: Option<i32> = None;
    let interrupt = Interrupt::current();
    for round in 0..ROUNDS {
        interrupt.check();
        if round > 0 {
            penalty.adapt(&spline.controls);
            follow(&samples, points, &mut parameters);
        }
        let rows: Vec<Row> = parameters
            .iter()
            .map(|&t| row(t, intervals, closed))
            .collect();
        let system = System::new(&rows, points, &weights, unknowns, closed);
        let best = system.best(&penalty.matrix(), &spline, level)?;
        level = Some(best.level);
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

/// A spline near the polyline of the guide.
#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "a number of intervals, of which there are as many as vertices allow"
)]
fn start(guide: &Guide) -> Option<Spline> {
    let count = guide.vertices.len();
    let mut places = guide.vertices.clone();
    let mut spacing = guide.spacing.clone();
    if guide.closed {
        places.push(*places.first()?);
        spacing.push(*spacing.first()?);
    }
    let mut tau = vec![0.0];
    for i in 1..places.len() {
        let step = places[i].distance(places[i - 1]) / (0.5 * (spacing[i] + spacing[i - 1]));
        tau.push(tau[i - 1] + step);
    }
    let length = *tau.last()?;
    if !(length > 0.0 && length.is_finite()) {
        return None;
    }
    let least = if guide.closed { 4 } else { 2 };
    // More than a few intervals a vertex serve nobody.
    let intervals = (length.ceil().min(4.0 * count as f64) as usize).max(least);
    let unknowns = controls_of(intervals, guide.closed);
    let samples = 8 * intervals;
    let (mut rows, mut along) = (Vec::new(), Vec::new());
    let mut edge = 0;
    for i in 0..=samples {
        if guide.closed && i == samples {
            break;
        }
        let share = i as f64 / samples as f64 * length;
        while edge + 2 < tau.len() && tau[edge + 1] < share {
            edge += 1;
        }
        let gap = tau[edge + 1] - tau[edge];
        let part = if gap > 0.0 {
            (share - tau[edge]) / gap
        } else {
            0.0
        };
        along.push(places[edge].lerp(places[edge + 1], part.clamp(0.0, 1.0)));
        rows.push(row(i as f64 / 8.0, intervals, guide.closed));
    }
    let weights = vec![1.0; rows.len()];
    let system = System::new(&rows, &along, &weights, unknowns, guide.closed);
    let penalty = Penalty::new(unknowns, guide.closed).matrix();
    let controls = system
        .normal
        .plus(1e-2, &penalty, RIDGE)
        .factor()
        .solve(system.right);
    Some(Spline {
        controls,
        closed: guide.closed,
    })
}

/// The normal equations without penalty.
struct System<'a> {
    rows: &'a [Row],
    points: &'a [DVec2],
    weights: &'a [f64],
    normal: Banded,
    right: Vec<DVec2>,
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
    fn new(
        rows: &'a [Row],
        points: &'a [DVec2],
        weights: &'a [f64],
        unknowns: usize,
        closed: bool,
    ) -> Self {
        let mut normal = Banded::zero(unknowns, closed);
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
