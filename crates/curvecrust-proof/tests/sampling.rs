//! The bounds of sampling conditions against closed forms and against dense points.

use curvecrust_proof::{ClosedSpline, Interval, SampledSplines, SamplingCondition};
use proptest::prelude::*;
use std::f64::consts::TAU;

const CONDITIONS: [SamplingCondition; 2] = [SamplingCondition::Epsilon, SamplingCondition::Rho];

/// A spline that is nearly a circle of radius 1, with samples at equal steps from (1, 0) on.
fn circle(control: usize, samples: usize) -> SampledSplines {
    let step = TAU / control as f64;
    // The spline's point at a knot is nearer to the centre than the control point.
    let radius = 3.0 / (2.0 + step.cos());
    // Segment 0 starts near its second control point.
    let at = |i: usize| (step * (i as f64 - 1.0)).sin_cos();
    let control = (0..control)
        .map(|i| [radius * at(i).1, radius * at(i).0])
        .collect::<Vec<_>>();
    let every = control.len() / samples;
    SampledSplines {
        samples: vec![(0..samples).map(|i| (i * every, 0.0)).collect()],
        splines: vec![ClosedSpline { control }],
    }
}

#[test]
fn samples_of_a_circle() {
    for samples in [4, 5, 8] {
        let circle = circle(120, samples);
        // The middle between two samples is farthest, lfs is 1.
        let exact = 2.0 * (TAU / (4.0 * samples as f64)).sin();
        for condition in CONDITIONS {
            assert!(circle.prove(condition, exact + 2e-3, 1e-4).is_ok());
            assert!(circle.prove(condition, exact - 1e-3, 1e-4).is_err());
        }
    }
}

#[test]
fn two_circles_have_an_axis_between_them() {
    let mut two = circle(40, 8);
    let second = circle(40, 8);
    let right = |[x, y]: &[f64; 2]| [x + 2.2, *y];
    let control = second.splines[0].control.iter().map(right).collect();
    two.splines.push(ClosedSpline { control });
    two.samples.extend(second.samples);
    // The sample at (1, 0) is 0.1 from the axis; between it and the next one the worst point p has
    // |p s| = 2 sin(a/2) and lfs 1.1 - cos a.
    let worst = (1..1000).map(|i| TAU / 16.0 * f64::from(i) / 1000.0);
    let worst = worst.map(|a| 2.0 * (a / 2.0).sin() / (1.1 - a.cos()).min(1.0));
    let exact = worst.fold(0.0, f64::max);
    assert!(exact > 1.0);
    assert!(
        two.prove(SamplingCondition::Epsilon, exact + 0.01, 1e-4)
            .is_ok()
    );
    assert!(
        two.prove(SamplingCondition::Epsilon, exact - 0.01, 1e-4)
            .is_err()
    );
}

/// Dense points of a segment.
const PER: usize = 40;

fn between(a: [f64; 2], b: [f64; 2]) -> f64 {
    (a[0] - b[0]).hypot(a[1] - b[1])
}

/// Centres of the smallest balls that touch a polygon at one of its points and meet another one.
fn centres(points: &[[f64; 2]]) -> Vec<[f64; 2]> {
    let n = points.len();
    let mut centres = Vec::new();
    for (i, p) in points.iter().enumerate() {
        let (before, after) = (points[(i + n - 1) % n], points[(i + 1) % n]);
        let length = between(before, after);
        let normal = [
            (before[1] - after[1]) / length,
            (after[0] - before[0]) / length,
        ];
        let bend = |q: &[f64; 2]| {
            let rise = normal[0] * (q[0] - p[0]) + normal[1] * (q[1] - p[1]);
            2.0 * rise / between(*p, *q).powi(2)
        };
        let bends = points.iter().filter(|q| between(*p, **q) > 0.0).map(bend);
        let [least, most] = bends.fold([0.0_f64; 2], |[a, b], x| [a.min(x), b.max(x)]);
        let curved = [least, most].into_iter().filter(|bend| *bend != 0.0);
        centres.extend(curved.map(|bend| [p[0] + normal[0] / bend, p[1] + normal[1] / bend]));
    }
    centres
}

/// The epsilon and the rho that samples in the middles of segments attain at dense points.
fn attained(spline: &ClosedSpline, every: usize) -> [f64; 2] {
    let place = |i: usize| {
        let point = spline.point(i / PER, (i % PER) as f64 / PER as f64);
        point.map(Interval::middle)
    };
    let points: Vec<[f64; 2]> = (0..spline.len() * PER).map(place).collect();
    let centres = centres(&points);
    let lfs = |p: [f64; 2]| {
        let distances = centres.iter().map(|centre| between(p, *centre));
        distances.fold(f64::INFINITY, f64::min)
    };
    let (n, step) = (points.len(), every * PER);
    let (mut epsilon, mut rho) = (0.0_f64, 0.0_f64);
    for start in (PER / 2..n).step_by(step) {
        let ends = [points[start], points[(start + step) % n]];
        let (mut far, mut reach) = (0.0_f64, f64::INFINITY);
        for i in start..=start + step {
            let p = points[i % n];
            let distance = between(p, ends[0]).min(between(p, ends[1]));
            epsilon = epsilon.max(distance / lfs(p));
            far = far.max(distance);
            reach = reach.min(lfs(p));
        }
        rho = rho.max(far / reach);
    }
    [epsilon, rho]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(12))]

    /// What is proven is not contradicted by dense points, and it is not far from them.
    #[test]
    fn bounds_enclose_those_of_dense_points(
        radii in prop::collection::vec(0.7..1.3_f64, 8),
        every in 1_usize..3,
    ) {
        let at = |(i, r): (usize, &f64)| {
            let (sine, cosine) = (TAU * i as f64 / 8.0).sin_cos();
            [r * cosine, r * sine]
        };
        let control: Vec<[f64; 2]> = radii.iter().enumerate().map(at).collect();
        let spline = ClosedSpline { control };
        let shown = attained(&spline, every);
        let samples = (0..8).step_by(every).map(|segment| (segment, 0.5)).collect();
        let sampled = SampledSplines {
            splines: vec![spline],
            samples: vec![samples],
        };
        for (condition, shown) in CONDITIONS.into_iter().zip(shown) {
            prop_assert!(sampled.prove(condition, 0.97 * shown, 1e-3).is_err());
            prop_assert!(sampled.prove(condition, 1.05 * shown, 1e-5).is_ok());
        }
    }
}

#[test]
fn text_comes_back() {
    let circle = circle(12, 4);
    assert_eq!(circle.to_string().parse(), Ok(circle));
    for wrong in [
        "control 0 0",
        "spline\ncontrol 0",
        "spline\ncontrol 0 0\nsample 0 0",
    ] {
        assert!(wrong.parse::<SampledSplines>().is_err(), "{wrong}");
    }
}
