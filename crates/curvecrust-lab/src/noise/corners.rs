//! Corners that are found, missed, and where there are none.

use std::ops::Range;

use curvecrust::geometry::DVec2;
use rayon::prelude::*;

use super::curves::{Truth, curves};
use super::sample::{Sample, sample};
use super::{CELL, Cell, Draws, fit, is_fair};
use crate::table::Field;

/// Curves of straight sides.
const CORNERED: [&str; 3] = ["square", "star", "poly"];
/// Curves without a corner.
const SMOOTH: [&str; 7] = [
    "circle", "ellipse", "fourierA", "fourierB", "rings", "sine", "spiral",
];
/// A corner found within this many deviations and spacings of a true one is that one.
const REACH: [f64; 2] = [4.0, 3.0];

pub(super) const HEADER: [&str; 8] = [
    "points",
    "inputs",
    "corners",
    "found %",
    "median",
    "95 %",
    "within 2 %",
    "false a curve",
];

/// What was found in one input.
#[derive(Default)]
struct Found {
    /// The distance of each true corner from the one found for it, in deviations.
    distances: Vec<f64>,
    truth: usize,
    beside: usize,
    curves: usize,
}

/// The rows for curves with corners and without.
pub(super) fn rows(draws: &Draws<'_>, mut add: impl FnMut(Vec<Field>)) -> anyhow::Result<()> {
    for n in [300, 1000] {
        for sigma in [0.2, 0.5, 1.0] {
            let cornered = CORNERED.map(|name| (name, vec![name]));
            for (what, names) in cornered.into_iter().chain([("smooth", SMOOTH.to_vec())]) {
                let what = format!("{n}, sigma {sigma}, {what}");
                if what.starts_with(draws.rows) {
                    add(row(&names, n, sigma, &draws.seeds, what)?);
                }
            }
        }
    }
    Ok(())
}

fn row(
    names: &[&'static str],
    n: usize,
    sigma: f64,
    seeds: &Range<u64>,
    what: String,
) -> anyhow::Result<Vec<Field>> {
    let mut found: Vec<Found> = Vec::new();
    for &name in names {
        for held in [false, true] {
            let cell = Cell {
                name,
                held,
                n,
                sigma,
                ..CELL
            };
            let truth = curves(name, held)?;
            if !is_fair(&cell, &truth) {
                continue;
            }
            let corners: Vec<DVec2> = truth.iter().flat_map(corners).collect();
            let one = |seed: u64| compared(&corners, truth.len(), &sample(&cell, &truth, seed));
            let all = seeds.clone().into_par_iter().map(one);
            found.extend(all.collect::<anyhow::Result<Vec<Found>>>()?);
        }
    }
    let mut distances: Vec<f64> = found.iter().flat_map(|f| f.distances.clone()).collect();
    distances.sort_by(f64::total_cmp);
    let truth: usize = found.iter().map(|f| f.truth).sum();
    let share = |count: usize| match truth {
        0 => Field::Missing,
        _ => Field::Share(count as f64 / truth as f64),
    };
    let rank = |percent: usize| match distances.len() {
        0 => Field::Missing,
        count => Field::rounded(distances[(count * percent / 100).min(count - 1)], 3),
    };
    let beside: usize = found.iter().map(|f| f.beside).sum();
    let curves: usize = found.iter().map(|f| f.curves).sum();
    Ok(vec![
        what.into(),
        found.len().into(),
        truth.into(),
        share(distances.len()),
        rank(50),
        rank(95),
        share(distances.iter().filter(|&&d| d <= 2.0).count()),
        Field::rounded(beside as f64 / curves.max(1) as f64, 3),
    ])
}

/// The vertices of a coarse polygon; a dense polyline is smooth.
fn corners(truth: &Truth) -> Vec<DVec2> {
    match truth.points.len() < 20 {
        true => truth.points.clone(),
        false => Vec::new(),
    }
}

fn compared(corners: &[DVec2], curves: usize, sample: &Sample) -> anyhow::Result<Found> {
    let fitted = fit(sample)?;
    let places = fitted.curves.iter().flat_map(|c| c.corner_places());
    let mut places: Vec<DVec2> = places.collect();
    let mut found = Found {
        truth: corners.len(),
        curves,
        ..Found::default()
    };
    let reach = REACH[0] * sample.sigma + REACH[1] * sample.spacing;
    for corner in corners {
        let nearest = (0..places.len()).min_by(|&i, &j| {
            let [a, b] = [i, j].map(|k| places[k].distance(*corner));
            a.total_cmp(&b)
        });
        if let Some(i) = nearest.filter(|&i| places[i].distance(*corner) <= reach) {
            let distance = places.swap_remove(i).distance(*corner);
            found.distances.push(distance / sample.sigma);
        }
    }
    found.beside = places.len();
    Ok(found)
}
