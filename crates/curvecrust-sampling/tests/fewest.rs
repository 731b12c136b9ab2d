//! The fewest samples of all starts, against every start and against all samplings.
#![allow(clippy::unwrap_used, reason = "a test, its helpers included")]

use std::sync::Mutex;

use curvecrust_curve::Curve;
use curvecrust_geometry::{Progress, Random};
use curvecrust_medial_axis::{Discretisation, MeasureOptions, MeasuredCurve, measure_with};
use curvecrust_sampling::{
    Condition, PlacedSamples, Placement, SampleOptions, check, sample, sample_fewest,
    sample_fewest_with,
};
use curvecrust_testing::curves::random_closed;
use curvecrust_testing::fixtures;

fn measured(curve: &Curve, gap_to_lfs: f64) -> Option<MeasuredCurve> {
    let options = MeasureOptions {
        discretisation: Discretisation::Adaptive { gap_to_lfs },
        ..MeasureOptions::default()
    };
    measure_with(curve, &options).ok()
}

/// Whether the interval between two dense points of the first component is certain to hold.
fn holds(measured: &MeasuredCurve, from: usize, to: usize, condition: Condition) -> bool {
    let n = measured.dense().components()[0].range.len();
    let place = |i: usize| Placement {
        point: measured.dense().points()[i % n],
        dense: i % n,
        t: 0.0,
    };
    // The intervals of the two samples: this is the one that begins at the first of them.
    let mut two = vec![place(from), place(to)];
    two.sort_by_key(|p| p.dense);
    let samples = PlacedSamples::new(measured, two).unwrap();
    let asks_nothing = Condition::epsilon(1e-9).unwrap();
    let all = match condition.bound() {
        curvecrust_sampling::Bound::Epsilon(_) => check(measured, &samples, asks_nothing),
        curvecrust_sampling::Bound::Rho(_) => {
            check(measured, &samples, Condition::rho(1e-9).unwrap())
        }
    };
    let this = all.violations.iter().find(|v| {
        let first = v.interval.samples[0].map(|s| samples.placements()[s].dense);
        first == Some(from % n) && (to % n != from % n)
    });
    let limit = condition.hausdorff_limit().unwrap_or(f64::INFINITY);
    this.is_some_and(|v| v.at_most < condition.bound().value() && v.deviation_at_most < limit)
}

/// The fewest samples of all samplings of a closed component, by definition: shortest round trips.
fn fewest_of_all(measured: &MeasuredCurve, condition: Condition) -> usize {
    let n = measured.dense().components()[0].range.len();
    let ok: Vec<Vec<bool>> = (0..n)
        .map(|from| {
            (0..n)
                .map(|step| step > 0 && holds(measured, from, from + step, condition))
                .collect()
        })
        .collect();
    let mut best = usize::MAX;
    for start in 0..n {
        let mut count = vec![usize::MAX; n + 1];
        count[0] = 0;
        for at in 0..n {
            if count[at] == usize::MAX {
                continue;
            }
            for next in at + 1..=n {
                if next - at < n && ok[(start + at) % n][next - at] {
                    count[next] = count[next].min(count[at] + 1);
                }
            }
        }
        best = best.min(count[n]);
    }
    best
}

#[test]
fn no_sampling_at_the_same_points_has_fewer() {
    let mut random = Random::new(7);
    let mut done = 0;
    while done < 6 {
        let curve = random_closed(&mut random);
        let Some(measured) = measured(&curve, 0.3).filter(|_| curve.components().len() == 1) else {
            continue;
        };
        if measured.dense().len() > 260 {
            continue;
        }
        for condition in [
            Condition::rho(0.9).unwrap(),
            Condition::epsilon(0.6).unwrap(),
        ] {
            let Ok(fewest) = sample_fewest(&measured, condition) else {
                continue;
            };
            assert_eq!(fewest.samples.len(), fewest_of_all(&measured, condition));
            done += 1;
        }
    }
}

#[test]
fn never_more_than_from_the_first_point() {
    let mut saved = 0;
    for (name, curve) in fixtures::curves() {
        let measured = measured(&curve, 0.05).unwrap();
        let rho = Condition::rho(0.9).unwrap();
        let limited = rho.with_hausdorff_limit(0.004 * curve.extent()).unwrap();
        for condition in [rho, Condition::epsilon(0.47).unwrap(), limited] {
            let first = sample(&measured, condition).unwrap().samples.len();
            let fewest = sample_fewest(&measured, condition).unwrap();
            let attained = fewest.attained.unwrap();
            assert!(attained.at_most < condition.bound().value(), "{name}");
            assert!(fewest.samples.len() <= first, "{name} {condition:?}");
            saved += first - fewest.samples.len();
        }
    }
    assert!(saved > 10, "{saved}");
}

/// The fewest samples of all samplings of an open curve that has both ends as samples.
fn fewest_of_open(measured: &MeasuredCurve, condition: Condition) -> usize {
    let n = measured.dense().len();
    let mut count = vec![usize::MAX; n];
    count[0] = 1;
    for at in 0..n {
        for next in at + 1..n {
            if count[at] < count[next] - 1 && holds(measured, at, next, condition) {
                count[next] = count[at] + 1;
            }
        }
    }
    count[n - 1]
}

/// Half waves of the given heights, from and to the axis.
fn wave(heights: &[f64]) -> Curve {
    let mut d = String::from("M 0 0");
    let mut x = 0.0;
    for (i, h) in heights.iter().enumerate() {
        // The same slope at every crossing of the axis.
        let (y, w) = (if i % 2 == 0 { *h } else { -h }, h.abs() * 20.0);
        d += &format!(" C {} {y} {} {y} {} 0", x + 0.35 * w, x + 0.65 * w, x + w);
        x += w;
    }
    Curve::from_path_data(&d).unwrap()
}

#[test]
fn greedy_is_not_optimal_with_a_limit() {
    let measured = measured(&wave(&[0.022, 0.012, 0.023, 0.023]), 0.04).unwrap();
    let rho = Condition::rho(0.9).unwrap();
    let counts = |condition| {
        let greedy = sample(&measured, condition).unwrap().samples.len();
        [greedy, fewest_of_open(&measured, condition)]
    };
    for condition in [rho, Condition::rho(0.1).unwrap()] {
        let [greedy, fewest] = counts(condition);
        assert_eq!(greedy, fewest);
    }
    let limited = rho.with_hausdorff_limit(0.015).unwrap();
    assert_eq!(counts(limited), [6, 4]);
}

#[test]
fn progress_is_reported_in_small_steps() {
    let curve = fixtures::curve("teaser");
    let measured = measured(&curve, 0.02).unwrap();
    let rho = Condition::rho(0.9).unwrap();
    for condition in [rho, rho.with_hausdorff_limit(0.1 * curve.extent()).unwrap()] {
        let heard = Mutex::new(Vec::new());
        let listener = |done, of| heard.lock().unwrap().push((done, of));
        let options = SampleOptions {
            progress: Progress::new(&listener),
        };
        let fewest = sample_fewest_with(&measured, condition, &options).unwrap();
        let total = measured.dense().len();
        let heard = heard.into_inner().unwrap();
        assert!(heard.iter().all(|&(_, of)| of == total));
        let done: Vec<usize> = heard.into_iter().map(|(done, _)| done).collect();
        assert!(done.is_sorted() && done[0] == 0 && done.last() == Some(&total));
        if condition == rho {
            // One step for each sample.
            let step = total / fewest.samples.len();
            assert!(
                done.windows(2).all(|pair| pair[1] - pair[0] <= 2 * step),
                "{done:?}"
            );
        }
    }
}
