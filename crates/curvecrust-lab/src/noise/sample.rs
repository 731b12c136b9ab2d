//! Points that scatter about curves.

use std::f64::consts::TAU;

use curvecrust::geometry::{DVec2, Random};

use super::curves::{Truth, length, measured, place};
use crate::figure::bounds;

#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Density {
    Uniform,
    /// Five times as dense at one place as at another.
    Varying,
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Noise {
    Gauss,
    /// A deviation that varies by a factor of five along the curve.
    Varying,
    /// Uniform in direction and distance up to sigma.
    Disc,
}

#[derive(Clone, Copy, Debug)]
pub(super) struct Cell {
    pub(super) name: &'static str,
    pub(super) held: bool,
    pub(super) n: usize,
    /// In mean spacings.
    pub(super) sigma: f64,
    /// Outliers, as a share of the other points.
    pub(super) outliers: f64,
    pub(super) density: Density,
    pub(super) noise: Noise,
}

pub(super) struct Sample {
    pub(super) points: Vec<DVec2>,
    pub(super) inlier: Vec<bool>,
    pub(super) sigma: f64,
    pub(super) spacing: f64,
}

#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "numbers of points and steps, rounded"
)]
pub(super) fn sample(cell: &Cell, curves: &[Truth], seed: u64) -> Sample {
    let mut random = Random::new(seed * 7919 + cell.n as u64 + (cell.sigma * 1e4) as u64);
    let whole: f64 = curves.iter().map(length).sum();
    let spacing = whole / cell.n as f64;
    let sigma = cell.sigma * spacing;
    let mut counts: Vec<usize> = curves
        .iter()
        .map(|c| (length(c) / spacing + 0.5) as usize)
        .collect();
    let rest: usize = counts[1..].iter().sum();
    counts[0] = cell.n - rest;
    let mut points = Vec::new();
    for (truth, count) in curves.iter().zip(counts) {
        let (places, lengths) = measured(truth);
        let own = lengths[lengths.len() - 1];
        for _ in 0..count {
            let share = match cell.density {
                Density::Uniform => random.unit(),
                Density::Varying => loop {
                    let u = random.unit();
                    if random.between(0.0, 5.0) < 1.0 + 2.0 * (1.0 + (TAU * u).cos()) {
                        break u;
                    }
                },
            };
            let p = place(&places, &lengths, share * own);
            let local = match cell.noise {
                Noise::Varying => sigma * (5f64.ln() * 0.5 * (TAU * share).sin()).exp(),
                _ => sigma,
            };
            let error = match cell.noise {
                Noise::Disc => random.unit() * DVec2::from_angle(random.between(0.0, TAU)),
                _ => DVec2::new(random.normal(), random.normal()),
            };
            points.push((p + local * error, true));
        }
    }
    let all: Vec<DVec2> = points.iter().map(|p| p.0).collect();
    let (low, high) = bounds(&all);
    for _ in 0..(cell.outliers * cell.n as f64).round() as usize {
        let p = DVec2::new(random.between(low.x, high.x), random.between(low.y, high.y));
        points.push((p, false));
    }
    random.shuffle(&mut points);
    Sample {
        points: points.iter().map(|p| p.0).collect(),
        inlier: points.iter().map(|p| p.1).collect(),
        sigma,
        spacing,
    }
}
