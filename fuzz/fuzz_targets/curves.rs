//! Random Bézier chains: medial axis, lfs, every sampler, and what judges samples.

#![no_main]

use curvecrust::curve::{Curve, DenseCurve};
use curvecrust::evaluate::hausdorff;
use curvecrust::medial_axis::{
    Discretisation, Estimator, MeasureOptions, MeasuredCurve, measure_with,
};
use curvecrust::reconstruct::hnn_crust;
use curvecrust::sampling::{
    Condition, PlacedSamples, UnevenOptions, check, effective_epsilon, effective_rho, sample,
    sample_as_published, sample_at_dense_points, sample_curve, sample_fewest, sample_unevenly_with,
    sample_uniformly,
};
use curvecrust_fuzz::Chains;
use libfuzzer_sys::fuzz_target;

fuzz_target!(|input: (Chains, u8, bool)| {
    let (chains, bound, with_limit) = input;
    let Ok(curve) = Curve::from_path_data(&chains.0) else {
        return;
    };
    for estimator in [Estimator::Voronoi, Estimator::ShrinkingBall] {
        let options = MeasureOptions {
            discretisation: Discretisation::PerSegment(1 + u32::from(bound) % 40),
            estimator,
            ..MeasureOptions::default()
        };
        if let Ok(measured) = measure_with(&curve, &options) {
            judged(&curve, &measured, bound, with_limit);
        }
    }
    let dense = DenseCurve::per_segment_in_single(&curve, 20);
    if let Ok(measured) = dense.map(|dense| MeasuredCurve::new(dense, Estimator::ShrinkingBall)) {
        let _ = measured.map(|m| sample_as_published(&m, condition(&curve, bound, with_limit)));
    }
    // Curves that nearly touch have millions of dense points.
    let coarse = MeasureOptions {
        discretisation: Discretisation::Adaptive { gap_to_lfs: 0.5 },
        ..MeasureOptions::default()
    };
    if let Ok(coarse) = measure_with(&curve, &coarse)
        && coarse.dense().len() < 3000
    {
        if bound >= 64 {
            let _ = sample_curve(&curve, condition(&curve, bound, with_limit));
        }
        judged(&curve, &coarse, bound, with_limit);
    }
});

fn condition(curve: &Curve, bound: u8, with_limit: bool) -> Condition {
    let share = (f64::from(bound) + 0.5) / 256.0;
    let condition = if bound % 2 == 0 {
        Condition::epsilon(share).unwrap()
    } else {
        Condition::rho(share).unwrap()
    };
    if with_limit {
        condition
            .with_hausdorff_limit(0.01 * curve.extent())
            .unwrap()
    } else {
        condition
    }
}

/// What is measured is sane, and what is certified holds.
fn judged(curve: &Curve, measured: &MeasuredCurve, bound: u8, with_limit: bool) {
    let lfs = measured.lfs();
    assert_eq!(lfs.len(), measured.dense().len());
    assert!(lfs.values().iter().all(|&lfs| lfs >= 0.0));
    let condition = condition(curve, bound, with_limit);
    let certified = sample(measured, condition);
    let fewest = sample_fewest(measured, condition);
    if let (Ok(certified), Ok(fewest)) = (&certified, &fewest) {
        assert!(fewest.samples.len() <= certified.samples.len());
    }
    for samples in [certified, fewest].into_iter().flatten() {
        let samples = samples.samples;
        if let Ok(placed) = PlacedSamples::of(measured, &samples) {
            assert!(check(measured, &placed, condition).holds());
            let _ = effective_epsilon(measured, &placed);
            let _ = effective_rho(measured, &placed);
        }
        if let Ok(points) = samples.point_set() {
            let edges = hnn_crust(&points);
            let _ = hausdorff(curve, &points, &edges, 1e-3 * curve.extent());
            let _ = PlacedSamples::project(measured, points.points(), 1e-3 * curve.extent());
        }
    }
    let _ = sample_at_dense_points(measured, condition);
    let _ = sample_uniformly(measured, 0.1 * curve.extent());
    let uneven = UnevenOptions {
        seed: u64::from(bound),
        ..UnevenOptions::default()
    };
    let _ = sample_unevenly_with(measured, condition, &uneven);
}
