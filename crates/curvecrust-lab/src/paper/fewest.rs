//! Computes the rows of the block after the paper's tables.

use super::measure::{CONVERGED, Run};
use super::models::Model;
use super::rows::{FewestRow, VerifiedCounts};
use anyhow::Context;
use curvecrust::medial_axis::MeasuredCurve;
use curvecrust::reconstruct::{HnnCrust, hnn_crust};
use curvecrust::sampling::{
    Condition, DeviationLimit, Sampling, VerifyOptions, sample, sample_fewest, sample_verified_with,
};
use rayon::prelude::*;

/// The Hausdorff limit, as a fraction of the larger extent.
const LIMIT: f64 = 0.01;
const SEED: u64 = 1;

/// Three rows a model.
pub(crate) fn rows(models: &[Model], rounds: usize) -> anyhow::Result<Vec<FewestRow>> {
    let of_model = |model: &Model| {
        let measured = Run::Voronoi(CONVERGED).measure(model)?;
        of_model(model, &measured, rounds).with_context(|| model.name.to_owned())
    };
    let rows: Vec<_> = models
        .par_iter()
        .map(of_model)
        .collect::<anyhow::Result<_>>()?;
    Ok(rows.into_iter().flatten().collect())
}

fn of_model(
    model: &Model,
    measured: &MeasuredCurve,
    rounds: usize,
) -> anyhow::Result<[FewestRow; 3]> {
    let rho = Condition::rho(0.9)?;
    let row = |name, condition, verified| -> anyhow::Result<FewestRow> {
        Ok(FewestRow {
            model: model.name,
            condition: name,
            greedy: sample(measured, condition)?.samples.len(),
            fewest: sample_fewest(measured, condition)?.samples.len(),
            verified,
        })
    };
    let (verified, epsilon) = rayon::join(
        || verified(model, measured, rho, rounds),
        || {
            Ok::<_, anyhow::Error>([
                row("eps < 0.47", Condition::epsilon(0.47)?, None)?,
                row("eps < 1/3", Condition::epsilon(1.0 / 3.0)?, None)?,
            ])
        },
    );
    let [first, second] = epsilon?;
    Ok([row("rho < 0.9", rho, Some(verified?))?, first, second])
}

fn verified(
    model: &Model,
    measured: &MeasuredCurve,
    rho: Condition,
    rounds: usize,
) -> anyhow::Result<VerifiedCounts> {
    let limit = LIMIT * model.curve.extent();
    let start = sample(measured, rho)?;
    let near = sample(measured, rho.with_hausdorff_limit(limit)?)?;
    let runs = [
        (&start, DeviationLimit::OfLfs(1.0)),
        (&near, DeviationLimit::Length(limit)),
        (&start, DeviationLimit::None),
    ];
    let run = |(start, deviation): (&Sampling, DeviationLimit)| {
        let options = VerifyOptions {
            algorithm: &HnnCrust::MUTUAL,
            deviation,
            rounds,
            seed: SEED,
            ..VerifyOptions::default()
        };
        let found = sample_verified_with(start, &options)?;
        let exact = hnn_crust(&found.samples.point_set()?) == found.samples.manifold_boundary();
        Ok((found.samples.len(), exact))
    };
    let found: Vec<(usize, bool)> = runs
        .into_par_iter()
        .map(run)
        .collect::<anyhow::Result<_>>()?;
    Ok(VerifiedCounts {
        within_lfs: found[0].0,
        within_percent: found[1].0,
        no_limit: found[2].0,
        rounds,
        reconstructed: found.iter().all(|f| f.1),
    })
}
