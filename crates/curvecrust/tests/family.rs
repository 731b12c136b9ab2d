//! What is published of the algorithms without a guarantee by the local feature size, on curves for
//! which it holds.
#![allow(clippy::unwrap_used, reason = "a test may panic")]

use curvecrust::evaluate::EdgeComparison;
use curvecrust::geometry::{DVec2, EdgeSet, PointSet, Random};
use curvecrust::medial_axis::measure;
use curvecrust::reconstruct::{
    Alpha, ConservativeRho, alpha_shape, connect2d, conservative_crust, discur, gathan, gathan_g,
    is_shortest_tour, normalised_mesh, peel, shortest_tour, sig_connect2d, spanning_tree,
};
use curvecrust::sampling::{Condition, SampledCurve, sample_at_dense_points};
use curvecrust_testing::fixtures;
use curvecrust_testing::planted::consecutive_edges;

type Algorithm = (&'static str, fn(&PointSet) -> EdgeSet);

/// The fixtures as one closed curve each, sampled under a condition.
fn samplings(condition: Condition) -> Vec<(String, SampledCurve)> {
    let curves = fixtures::curves().into_iter();
    let measured = curves.map(|(name, curve)| (name, measure(&curve).unwrap()));
    let closed = measured
        .filter(|(_, measured)| measured.dense().components().iter().all(|part| part.closed));
    closed
        .map(|(name, measured)| (name, sample_at_dense_points(&measured, condition).samples))
        .collect()
}

fn is_exact(sampled: &SampledCurve, found: &EdgeSet) -> bool {
    EdgeComparison::new(&sampled.manifold_boundary(), found).is_exact()
}

fn assert_exact(samplings: &[(String, SampledCurve)], algorithms: &[Algorithm]) {
    for (curve, sampled) in samplings {
        let points = sampled.point_set().unwrap();
        for (name, algorithm) in algorithms {
            assert!(is_exact(sampled, &algorithm(&points)), "{name} on {curve}");
        }
    }
}

#[test]
fn densely_sampled_closed_curves_are_returned() {
    let several: &[Algorithm] = &[
        ("gathan-like", gathan),
        ("gathan-g-like", gathan_g),
        ("sig-connect2d", sig_connect2d),
        ("peel", peel),
        ("normalised-mesh", normalised_mesh),
        ("conservative-crust", |points| {
            conservative_crust(points, ConservativeRho::LEAST)
        }),
    ];
    let dense = samplings(Condition::epsilon(0.2).unwrap());
    assert!(dense.len() >= 15);
    assert_exact(&dense, several);
}

/// Published for Connect2D; for the tour where the curve is dense and benign.
#[test]
fn single_closed_curves_are_returned_below_an_epsilon_of_a_half() {
    let mut single = samplings(Condition::epsilon(0.5).unwrap());
    single.retain(|(_, sampled)| sampled.components().len() == 1);
    assert!(single.len() >= 8);
    assert_exact(
        &single,
        &[("connect2d", connect2d), ("shortest-tour", shortest_tour)],
    );
}

/// Each closed curve of the fixtures by itself.
#[test]
fn tours_of_dense_samples_are_proven_the_shortest() {
    for epsilon in [0.3, 0.4, 0.5] {
        for (curve, sampled) in samplings(Condition::epsilon(epsilon).unwrap()) {
            for part in sampled.components() {
                let part = sampled.points()[part.range.clone()].to_vec();
                let points = PointSet::new(part).unwrap();
                let tour = shortest_tour(&points);
                assert_eq!(tour, consecutive_edges(points.len(), true), "{curve}");
                assert!(is_shortest_tour(&points, &tour), "{curve}, {epsilon}");
            }
        }
    }
}

/// Points along a circle, `turn` of it, at steps that differ by up to a factor.
fn arc(count: usize, turn: f64, uneven: f64, seed: u64) -> Vec<DVec2> {
    let mut random = Random::new(seed);
    let steps: Vec<f64> = (0..count).map(|_| random.between(1.0, uneven)).collect();
    let sum: f64 = steps.iter().sum();
    let mut angle = 0.0;
    let at = steps.into_iter().map(|step| {
        angle += turn * std::f64::consts::TAU * step / sum;
        DVec2::from_angle(angle)
    });
    at.collect()
}

/// No two points that are not consecutive are as near as consecutive ones.
#[test]
fn the_spanning_tree_of_an_open_curve_is_its_path() {
    for seed in 0..20 {
        let points = PointSet::new(arc(60, 0.8, 1.9, seed)).unwrap();
        assert_eq!(
            spanning_tree(&points),
            consecutive_edges(60, false),
            "{seed}"
        );
    }
}

#[test]
fn open_arcs_stay_open() {
    for seed in 0..20 {
        let points = PointSet::new(arc(80, 0.75, 1.5, seed)).unwrap();
        let open = consecutive_edges(80, false);
        let conservative = conservative_crust(&points, ConservativeRho::LEAST);
        assert_eq!(conservative, open, "conservative-crust {seed}");
    }
}

/// Even spacing: below sin(pi / 8) of the radius for the normalised mesh, below twice an alpha that
/// is below the radius for alpha-shapes.
#[test]
fn evenly_sampled_circles_are_returned() {
    for count in [17, 20, 50, 333] {
        let points = PointSet::new(arc(count, 1.0, 1.0, 0)).unwrap();
        let ring = consecutive_edges(count, true);
        assert_eq!(normalised_mesh(&points), ring, "normalised-mesh {count}");
        let own = Alpha::of(&points).unwrap();
        for alpha in [own, Alpha::new(0.2).unwrap(), Alpha::new(0.9).unwrap()] {
            assert_eq!(alpha_shape(&points, alpha), ring, "{alpha} {count}");
        }
    }
}

/// "Each chain is split where people see a gap": beyond 2.05 spacings.
#[test]
fn discur_splits_even_chains_at_2_05_spacings() {
    for (gap, edges) in [(1.5, 39), (2.04, 39), (2.06, 38), (5.0, 38)] {
        let at = |i: i32| f64::from(i) + if i < 20 { 0.0 } else { gap - 1.0 };
        let row = (0..40).map(|i| DVec2::new(at(i), 0.0)).collect();
        assert_eq!(discur(&PointSet::new(row).unwrap()).len(), edges, "{gap}");
    }
}
