//! How good fitted curves are: topology, and distances both ways.

use curvecrust::denoise::Fitted;
use curvecrust::geometry::DVec2;
use rstar::primitives::{GeomWithData, Line};
use rstar::{PointDistance, RTree};

use super::curves::{Truth, length, measured, place};
use super::sample::Sample;

#[derive(Clone, Debug, Default)]
pub(super) struct Score {
    pub(super) right: bool,
    /// Root mean square and largest distance from the fitted curves to the truth.
    pub(super) rms: f64,
    pub(super) max: f64,
    /// Largest distance from the truth to the fitted curves.
    pub(super) back: f64,
    pub(super) kept: f64,
    pub(super) found: f64,
}

type Segments = RTree<GeomWithData<Line<[f64; 2]>, usize>>;

/// Places at equal steps, and the segments with the number of their curve.
#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "numbers of points and steps, rounded"
)]
fn dense(curves: &[Truth], step: f64) -> (Vec<DVec2>, Segments) {
    let (mut places, mut items) = (Vec::new(), Vec::new());
    for (k, truth) in curves.iter().enumerate() {
        let (points, lengths) = measured(truth);
        let whole = lengths[lengths.len() - 1];
        let steps = (whole / step).ceil().max(1.0);
        for i in 0..=steps as usize {
            places.push(place(&points, &lengths, whole * i as f64 / steps));
        }
        for pair in points.windows(2).filter(|pair| pair[0] != pair[1]) {
            let line = Line::new(pair[0].to_array(), pair[1].to_array());
            items.push(GeomWithData::new(line, k));
        }
    }
    (places, RTree::bulk_load(items))
}

fn nearest(tree: &Segments, p: DVec2) -> (usize, f64) {
    match tree.nearest_neighbor(p.to_array()) {
        Some(item) => (item.data, item.geom().distance_2(&p.to_array()).sqrt()),
        None => (0, f64::INFINITY),
    }
}

pub(super) fn score(truth: &[Truth], sample: &Sample, fitted: &Fitted) -> Score {
    let whole: f64 = truth.iter().map(length).sum();
    let step = whole / 3000.0;
    let found: Vec<Truth> = fitted
        .curves
        .iter()
        .map(|c| Truth {
            points: c.polyline(step / 100.0),
            closed: c.closed,
        })
        .filter(|c| c.points.len() >= 2)
        .collect();
    let share = |wanted: bool| {
        let pairs = sample
            .inlier
            .iter()
            .zip(&fitted.places)
            .filter(|(i, _)| **i == wanted);
        let (hit, all) = pairs.fold((0.0, 0.0), |(hit, all), (_, place)| {
            (
                hit + f64::from(u8::from(place.is_some() == wanted)),
                all + 1.0,
            )
        });
        if all > 0.0 { hit / all } else { f64::NAN }
    };
    let mut score = Score {
        kept: share(true),
        found: share(false),
        ..Score::default()
    };
    if found.is_empty() {
        return score;
    }
    let (true_places, true_tree) = dense(truth, step);
    let (places, tree) = dense(&found, step);
    let apart: Vec<f64> = places.iter().map(|&p| nearest(&true_tree, p).1).collect();
    score.rms = (apart.iter().map(|d| d * d).sum::<f64>() / apart.len() as f64).sqrt();
    score.max = apart.iter().copied().fold(0.0, f64::max);
    let back: Vec<f64> = true_places.iter().map(|&p| nearest(&tree, p).1).collect();
    score.back = back.iter().copied().fold(0.0, f64::max);
    let tolerance = (3.0 * sample.sigma).max(2.5 * sample.spacing).max(0.01);
    let covered = back.iter().filter(|&&d| d < tolerance).count() as f64 / back.len() as f64;
    let total: f64 = found.iter().map(length).sum();
    let big: Vec<&Truth> = found.iter().filter(|c| length(c) > 0.05 * total).collect();
    let mut kinds: Vec<(usize, bool)> = big
        .iter()
        .map(|c| {
            let mut votes = vec![0; truth.len()];
            for &p in &c.points {
                votes[nearest(&true_tree, p).0] += 1;
            }
            let owner = (0..votes.len()).max_by_key(|&k| votes[k]).unwrap_or(0);
            (owner, c.closed)
        })
        .collect();
    kinds.sort_unstable();
    let wanted: Vec<(usize, bool)> = truth.iter().map(|t| t.closed).enumerate().collect();
    score.right = kinds == wanted && covered > 0.9 && total < 1.5 * whole;
    score
}
