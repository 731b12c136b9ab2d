//! Each counterexample of the fixtures: what its samples satisfy, three times over, and that the
//! algorithm fails on them.
#![allow(clippy::unwrap_used, reason = "a test, its helpers included")]

use curvecrust::curve::Curve;
use curvecrust::medial_axis::{Discretisation, MeasureOptions, measure_with};
use curvecrust::reconstruct::{HnnCrust, Reconstructor};
use curvecrust::sampling::{Bound, Condition, PlacedSamples, check};
use curvecrust_lab::counterexamples::{Dense, ProvenSamples, all};

/// A bound that is this much larger or smaller is not what the samples attain.
const APART: f64 = 1.01;

fn with(bound: Bound, factor: f64) -> Bound {
    match bound {
        Bound::Epsilon(value) => Bound::Epsilon(factor * value),
        Bound::Rho(value) => Bound::Rho(factor * value),
    }
}

#[test]
fn algorithms_fail_on_samples_of_proven_bounds() {
    let all = all().unwrap();
    for name in [
        "hnn-crust",
        "nn-crust",
        "crust",
        "beta-skeleton",
        "one-step-crust",
    ] {
        let conditions = all.iter().filter(|one| one.algorithm == name).count();
        assert_eq!(conditions, 2, "{name}");
    }
    for one in all {
        let found = one
            .reconstructor()
            .unwrap()
            .reconstruct(&one.samples.points().unwrap());
        assert_ne!(found, one.samples.truth(), "{}", one.name());
        assert!(one.samples.prove().is_ok(), "{}", one.name());
        let less = ProvenSamples {
            bound: with(one.samples.bound, 1.0 / 1.02),
            ..one.samples.clone()
        };
        assert!(
            less.prove().is_err(),
            "{}: the bound is no more than it has to be",
            one.name()
        );
    }
}

/// By the Voronoi diagram of dense points of the curve as a drawing, as a user would.
#[test]
fn check_agrees() {
    for one in all().unwrap() {
        let curve = Curve::from_path_data(&one.samples.path_data()).unwrap();
        let options = MeasureOptions {
            discretisation: Discretisation::Adaptive { gap_to_lfs: 0.002 },
            ..Default::default()
        };
        let measured = measure_with(&curve, &options).unwrap();
        let points = one.samples.points().unwrap();
        let placed = PlacedSamples::project(&measured, points.points(), 1e-4).unwrap();
        let condition = match with(one.samples.bound, APART) {
            Bound::Epsilon(value) => Condition::epsilon(value).unwrap(),
            Bound::Rho(value) => Condition::rho(value).unwrap(),
        };
        let verdict = check(&measured, &placed.samples, condition);
        assert!(
            verdict.holds() && verdict.certain,
            "{}: {verdict:?}",
            one.name()
        );
        let worst = verdict.worst.unwrap().bound;
        assert!(
            worst > one.samples.bound.value() / APART.powi(2),
            "{}: {worst}",
            one.name()
        );
    }
}

/// By balls that touch the curve, with its exact normals: a computation apart from the others.
#[test]
fn touching_balls_agree() {
    for one in all().unwrap() {
        let control = one.samples.control();
        // The search had 120 points a segment, on curves of few segments.
        let segments: usize = control.iter().map(Vec::len).sum();
        let per_segment = (10_000 / segments).next_power_of_two();
        let dense = Dense::new(&control, per_segment).unwrap();
        let nearest = |(component, (segment, at)): (usize, (usize, f64))| {
            let first = dense.components()[component].range.start + segment * per_segment;
            let parameter = |i: &usize| *i as f64 / per_segment as f64;
            let step = (0..per_segment).rfind(|i| parameter(i) <= at).unwrap();
            first + step
        };
        let placed = one
            .samples
            .sampled
            .samples
            .iter()
            .enumerate()
            .map(|(component, samples)| {
                let places = samples.iter().map(|sample| nearest((component, *sample)));
                places.collect::<Vec<_>>()
            });
        let attained = dense.attained(&placed.collect::<Vec<_>>(), one.samples.bound);
        let ratio = attained / one.samples.bound.value();
        assert!(
            (1.0 / APART.powi(2)..APART).contains(&ratio),
            "{}: {attained}",
            one.name()
        );
    }
}

/// No counterexample is below what is proven of HNN-Crust.
#[test]
fn none_contradicts_the_theorem() {
    for one in all().unwrap() {
        if one.algorithm != HnnCrust::MUTUAL.info().name {
            continue;
        }
        let least = match one.samples.bound {
            Bound::Epsilon(_) => 0.4703,
            Bound::Rho(_) => 0.888,
        };
        assert!(one.samples.bound.value() > least);
    }
}
