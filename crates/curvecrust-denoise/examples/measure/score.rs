//! How good fitted curves are: topology, and distances both ways.

use curvecrust_denoise::Fitted;
use curvecrust_geometry::DVec2;
use rstar::RTree;
use rstar::primitives::GeomWithData;

use crate::curves::{Truth, length, measured, place};
use crate::sample::Sample;

#[derive(Clone, Debug, Default)]
pub struct Score {
    pub right: bool,
    pub curves: usize,
    /// Root mean square and largest distance from the fitted curves to the truth.
    pub rms: f64,
    pub max: f64,
    /// Largest distance from the truth to the fitted curves.
    pub back: f64,
    pub kept: f64,
    pub found: f64,
}

type Places = RTree<GeomWithData<[f64; 2], usize>>;

/// Places at equal steps, with the number of their curve.
fn dense(curves: &[Truth], step: f64) -> (Vec<DVec2>, Places) {
    let (mut places, mut items) = (Vec::new(), Vec::new());
    for (k, truth) in curves.iter().enumerate() {
        let (points, lengths) = measured(truth);
        let whole = lengths[lengths.len() - 1];
        let steps = (whole / step).ceil().max(1.0);
        for i in 0..=steps as usize {
            let p = place(&points, &lengths, whole * i as f64 / steps);
            places.push(p);
            items.push(GeomWithData::new(p.to_array(), k));
        }
    }
    (places, RTree::bulk_load(items))
}

fn nearest(tree: &Places, p: DVec2) -> (usize, f64) {
    let item = tree.nearest_neighbor(p.to_array()).unwrap();
    (item.data, p.distance(DVec2::from(*item.geom())))
}

pub fn score(truth: &[Truth], sample: &Sample, fitted: &Fitted) -> Score {
    let whole: f64 = truth.iter().map(length).sum();
    let step = whole / 3000.0;
    let found: Vec<Truth> = fitted
        .curves
        .iter()
        .map(|c| Truth { points: c.polyline(step / 20.0), closed: c.closed })
        .filter(|c| c.points.len() >= 2)
        .collect();
    let share = |wanted: bool| {
        let pairs = sample.inlier.iter().zip(&fitted.places).filter(|(i, _)| **i == wanted);
        let (hit, all) = pairs.fold((0.0, 0.0), |(hit, all), (_, place)| {
            (hit + f64::from(u8::from(place.is_some() == wanted)), all + 1.0)
        });
        if all > 0.0 { hit / all } else { f64::NAN }
    };
    let mut score = Score { curves: found.len(), kept: share(true), found: share(false), ..Score::default() };
    if found.is_empty() {
        return score;
    }
    let (true_places, true_tree) = dense(truth, step / 2.0);
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
            let owner = (0..votes.len()).max_by_key(|&k| votes[k]).unwrap();
            (owner, c.closed)
        })
        .collect();
    kinds.sort_unstable();
    let wanted: Vec<(usize, bool)> = truth.iter().map(|t| t.closed).enumerate().collect();
    score.right = kinds == wanted && covered > 0.9 && total < 1.5 * whole;
    score
}
