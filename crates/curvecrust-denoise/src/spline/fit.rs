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
use super::knots::Row;
use super::nearest::{Samples, follow};
use super::penalty::{Penalty, Rough};
use super::spread::Spread;
use super::start::start;
use super::system::System;

/// Rounds of fitting: each moves the parameters and the weights to the last curve.
const ROUNDS: usize = 4;
/// Before this round a fit with creases may take any penalty, later one near the last.
const WIDE: usize = 2;
/// Residuals, in local sigma, from which on a point has no weight.
const TUKEY: f64 = 4.5;

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
