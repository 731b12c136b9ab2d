//! Effective bounds against closed forms, and what a check finds and refuses.
#![allow(clippy::unwrap_used, reason = "a test, its helpers included")]

mod common;

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use common::arch;
use curvecrust_curve::analytic::{Circle, Stadium};
use curvecrust_curve::{Curve, CurveParam, DenseCurve};
use curvecrust_geometry::{Component, DVec2};
use curvecrust_medial_axis::{
    Discretisation, Estimator, MeasureOptions, MeasuredCurve, measure_with,
};
use curvecrust_sampling::{
    Bound, ClosingInterval, Condition, PlacedSamples, Placement, SampledCurve, SamplingError,
    check, effective_epsilon, effective_rho, sample, sample_at_dense_points,
};
use curvecrust_testing::fixtures;

fn measured(dense: DenseCurve) -> MeasuredCurve {
    MeasuredCurve::new(dense, Estimator::Voronoi).unwrap()
}

fn by(curve: &Curve, discretisation: Discretisation) -> MeasuredCurve {
    let options = MeasureOptions {
        discretisation,
        ..MeasureOptions::default()
    };
    measure_with(curve, &options).unwrap()
}

fn effective(measured: &MeasuredCurve, points: &[DVec2]) -> [f64; 2] {
    let placed = PlacedSamples::project(measured, points, 1e-5)
        .unwrap()
        .samples;
    let epsilon = effective_epsilon(measured, &placed).unwrap();
    let rho = effective_rho(measured, &placed).unwrap();
    for found in [epsilon, rho] {
        assert!(found.bound <= found.at_most && found.at_most < found.bound + 1e-2);
        assert!(found.deviation <= found.deviation_at_most);
    }
    [epsilon.bound, rho.bound]
}

fn assert_near(found: [f64; 2], expected: f64) {
    for value in found {
        assert!((value - expected).abs() < 1e-6, "{value} for {expected}");
    }
}

#[test]
fn circles_have_closed_forms() {
    for radius in [1.0, 7.3] {
        let circle = measured(Circle::new(radius).unwrap().dense(1500).unwrap());
        for n in [1u32, 2, 3, 5, 7, 12] {
            let at = |i: u32| radius * DVec2::from_angle(0.1 + TAU * f64::from(i) / f64::from(n));
            let samples: Vec<_> = (0..n).map(at).collect();
            let expected = 2.0 * (PI / f64::from(2 * n)).sin();
            assert_near(effective(&circle, &samples), expected);
        }
    }
}

#[test]
fn stadiums_have_closed_forms() {
    let (length, radius) = (3.0, 1.0);
    let dense = Stadium::new(length, radius).unwrap().dense(2500).unwrap();
    let stadium = measured(dense);
    // Both half circles in k parts, both straight sides in m.
    for (k, m) in [(3u32, 4u32), (4, 3), (2, 2)] {
        let mut samples = Vec::new();
        for side in [1.0, -1.0] {
            let centre = DVec2::new(side * length / 2.0, 0.0);
            samples.extend((0..=k).map(|i| {
                let angle = -FRAC_PI_2 + PI * f64::from(i) / f64::from(k);
                centre + side * radius * DVec2::from_angle(angle)
            }));
            samples.extend((1..m).map(|i| {
                let x = length * (f64::from(i) / f64::from(m) - 0.5);
                DVec2::new(x, side * radius)
            }));
        }
        let arc = 2.0 * (PI / f64::from(4 * k)).sin();
        let straight = length / f64::from(2 * m) / radius;
        assert_near(effective(&stadium, &samples), arc.max(straight));
    }
}

/// The largest epsilon or rho of the intervals between samples, by definition, at dense points and
/// of those that are to hold: all but closing intervals that are reported not to.
fn at_dense_points(measured: &MeasuredCurve, sampled: &SampledCurve, bound: Bound) -> f64 {
    let (points, lfs) = (measured.dense().points(), measured.lfs());
    let mut worst = 0.0f64;
    for (index, component) in sampled.components().iter().enumerate() {
        let samples = &sampled.dense_indices()[component.range.clone()];
        let mut closing = sampled.closing_intervals().iter();
        let closes = closing.any(|c| c.component == index && c.holds);
        let next = samples
            .iter()
            .skip(1)
            .chain(&samples[..usize::from(closes)]);
        for (&from, &to) in samples.iter().zip(next) {
            let mut inside = vec![from];
            while inside.last() != Some(&to) {
                inside.push(measured.dense().next(inside[inside.len() - 1]).unwrap());
            }
            let reach = inside
                .iter()
                .map(|&i| lfs.at(i))
                .fold(f64::INFINITY, f64::min);
            for i in inside {
                let [a, b] = [from, to].map(|s| points[s].distance(points[i]));
                let unit = match bound {
                    Bound::Epsilon(_) => lfs.at(i),
                    Bound::Rho(_) => reach,
                };
                worst = worst.max(a.min(b) / unit);
            }
        }
    }
    worst
}

#[test]
fn samplers_attain_their_bounds() {
    const GAP: f64 = 0.02;
    for (name, curve) in fixtures::curves() {
        let measured = by(&curve, Discretisation::Adaptive { gap_to_lfs: GAP });
        for b in [0.9, 0.47] {
            for condition in [Condition::rho(b).unwrap(), Condition::epsilon(b).unwrap()] {
                let certified = sample(&measured, condition).unwrap();
                let attained = certified.attained.unwrap().bound;
                assert!(certified.samples.len() >= 20);
                assert!(
                    0.9 * b < attained && attained <= b,
                    "{name} {condition:?} {attained}"
                );

                // The other one is certain at dense points.
                let sampled = sample_at_dense_points(&measured, condition).samples;
                let attained = at_dense_points(&measured, &sampled, condition.bound());
                assert!(
                    0.9 * b < attained && attained < b,
                    "{name} {condition:?} {attained}"
                );
                // What it says of the points between.
                let between = match condition.bound() {
                    Bound::Epsilon(_) => b + (1.0 + b) * GAP / (2.0 - GAP),
                    Bound::Rho(_) => b,
                };
                let placed = PlacedSamples::of(&measured, &sampled).unwrap();
                let verdict = check(&measured, &placed, condition);
                let closing = sampled.closing_intervals();
                for found in &verdict.violations {
                    let [before, after] = found.interval.samples;
                    let fails = |c: &ClosingInterval| {
                        c.component == found.interval.component && !c.holds && after < before
                    };
                    assert!(
                        found.bound < between || closing.iter().any(fails),
                        "{name} {condition:?} {found:?}"
                    );
                }
                let attained = verdict.worst.unwrap().bound;
                assert!(0.9 * b < attained && verdict.holds() == (attained < b));
            }
        }
    }
}

#[test]
fn every_violated_interval_is_listed() {
    let arch = arch();
    let rho = Condition::rho(0.3).unwrap();
    let placed = PlacedSamples::of(&arch, &sample(&arch, rho).unwrap().samples).unwrap();
    assert!(check(&arch, &placed, rho).certain);
    let n = placed.placements().len();

    // Without its second and its last sample.
    let mut fewer = placed.placements().to_vec();
    fewer.pop();
    fewer.remove(1);
    let fewer = PlacedSamples::new(&arch, fewer).unwrap();
    let verdict = check(&arch, &fewer, rho);
    let intervals: Vec<_> = verdict
        .violations
        .iter()
        .map(|v| v.interval.samples)
        .collect();
    assert_eq!(intervals, [[Some(0), Some(1)], [Some(n - 3), None]]);
    assert!(!verdict.holds() && !verdict.certain);

    let none = PlacedSamples::new(&arch, Vec::new()).unwrap();
    let verdict = check(&arch, &none, rho);
    assert_eq!(verdict.violations[0].interval.samples, [None, None]);
    assert!(verdict.violations[0].bound.is_infinite());

    let limited = rho.with_hausdorff_limit(1e-3).unwrap();
    let verdict = check(&arch, &placed, limited);
    assert_eq!(verdict.violations.len(), n - 1);
    assert!(
        verdict
            .violations
            .iter()
            .all(|v| v.bound < 0.3 && v.deviation >= 1e-3)
    );
}

#[test]
fn a_closed_curve_may_begin_anywhere_but_once() {
    let circle = measured(Circle::new(1.0).unwrap().dense(100).unwrap());
    let place = |dense| Placement {
        point: circle.dense().points()[dense],
        dense,
        t: 0.0,
    };
    let begins = |at: [usize; 4]| PlacedSamples::new(&circle, at.map(place).to_vec());
    let turned = begins([250, 350, 50, 150]).unwrap();
    let bound = effective_epsilon(&circle, &turned).unwrap().bound;
    assert!((bound - 2.0 * (PI / 8.0).sin()).abs() < 1e-4);
    for bad in [
        [250, 350, 50, 250],
        [250, 350, 50, 300],
        [250, 50, 150, 100],
        [250, 250, 0, 1],
    ] {
        assert!(
            matches!(begins(bad), Err(SamplingError::OutOfOrder { .. })),
            "{bad:?}"
        );
    }
}

/// Found by fuzzing: between two infinite lfs was NaN, and no sample was near enough to it.
#[test]
fn a_straight_line_needs_no_samples_between_its_ends() {
    let line = Curve::from_path_data("M 0 0 H 3").unwrap();
    let measured = by(&line, Discretisation::PerSegment(3));
    let ends = [DVec2::ZERO, DVec2::new(3.0, 0.0)];
    let inner = [DVec2::new(0.4, 0.0), DVec2::new(1.7, 0.0)];
    for samples in [ends, inner] {
        let placed = PlacedSamples::project(&measured, &samples, 0.0)
            .unwrap()
            .samples;
        let worst = effective_epsilon(&measured, &placed).unwrap();
        assert!(worst.bound <= 0.0);
        // The first of equals.
        let first = if samples == ends {
            [Some(0), Some(1)]
        } else {
            [None, Some(0)]
        };
        assert_eq!(worst.interval.samples, first);
        let verdict = check(&measured, &placed, Condition::rho(0.1).unwrap());
        assert!(verdict.holds() && verdict.certain);
    }
}

/// Nothing of it is between samples, but all of it is a sample.
#[test]
fn a_point_is_a_curve() {
    let at = DVec2::new(2.0, 3.0);
    let start = CurveParam {
        component: 0,
        segment: 0,
        t: 0.0,
    };
    let component = Component {
        range: 0..1,
        closed: false,
    };
    let dense = DenseCurve::new(vec![at], vec![start], vec![component]).unwrap();
    let measured = measured(dense);
    let placement = Placement {
        point: at,
        dense: 0,
        t: 0.0,
    };
    let placed = PlacedSamples::new(&measured, vec![placement]).unwrap();
    let attained = effective_epsilon(&measured, &placed).unwrap();
    assert_eq!(attained.interval.samples, [Some(0), None]);
    assert!(attained.bound <= 0.0 && attained.at == at);
}

/// On another dense curve than they were placed on, samples lie anywhere or nowhere.
#[test]
fn samples_of_another_curve_do_no_harm() {
    let circle = |points| measured(Circle::new(1.0).unwrap().dense(points).unwrap());
    let from_path = |d: &str| {
        let curve = Curve::from_path_data(d).unwrap();
        by(&curve, Discretisation::PerSegment(40))
    };
    let two = "M 0 0 C 0 4 4 4 4 0 S 0 -4 0 0 Z M 9 0 C 9 4 13 4 13 0 S 9 -4 9 0 Z";
    let curves = [
        circle(400),
        circle(30),
        from_path(two),
        from_path("M 0 0 C 3 1 6 -1 9 0 S 15 1 18 0"),
    ];
    let condition = Condition::epsilon(0.9).unwrap();
    for (i, own) in curves.iter().enumerate() {
        let end = own.dense().len() - 1;
        let at = |dense: usize| Placement {
            point: own.dense().points()[dense],
            dense,
            t: 0.0,
        };
        // Around the seam, in the last component.
        let component = own.dense().components().last().unwrap();
        let mut places = vec![at(end)];
        if component.closed {
            places.push(at(component.range.start + 3));
        }
        let samples = PlacedSamples::new(own, places).unwrap();
        for (j, other) in curves.iter().enumerate() {
            let verdict = check(other, &samples, condition);
            assert!(!verdict.holds(), "{i} on {j}");
            assert!(effective_epsilon(other, &samples).unwrap().dense < other.dense().len());
            assert!(effective_rho(other, &samples).is_some());
        }
    }
}

/// A bound and a limit that are attained do not hold, the next larger doubles do.
#[test]
fn conditions_are_strict() {
    let circle = measured(Circle::new(1.0).unwrap().dense(90).unwrap());
    let seven = (0..7).map(|i| DVec2::from_angle(0.1 + TAU * f64::from(i) / 7.0));
    let seven: Vec<_> = seven.collect();
    let samples = PlacedSamples::project(&circle, &seven, 1e-2)
        .unwrap()
        .samples;
    let violations = |bound, limit| {
        let condition = Condition::epsilon(bound).unwrap();
        let condition = condition.with_hausdorff_limit(limit).unwrap();
        check(&circle, &samples, condition).violations
    };
    let all = violations(1e-9, 2.0);
    assert_eq!(all.len(), 7);
    let bound = all.iter().map(|a| a.bound).fold(0.0, f64::max);
    let deviation = all.iter().map(|a| a.deviation).fold(0.0, f64::max);
    assert!(!violations(bound, 2.0).is_empty());
    assert!(violations(bound.next_up(), 2.0).is_empty());
    assert!(!violations(0.99, deviation).is_empty());
    assert!(violations(0.99, deviation.next_up()).is_empty());
}
