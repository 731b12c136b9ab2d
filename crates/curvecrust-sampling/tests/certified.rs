//! Certified samplings, re-checked by other means at a finer discretisation.
#![allow(clippy::unwrap_used, reason = "a test, its helpers included")]

use std::f64::consts::TAU;
use std::sync::Mutex;

use curvecrust_curve::{Curve, DenseCurve};
use curvecrust_geometry::{Progress, Random, Segment};
use curvecrust_medial_axis::{
    Discretisation, Estimator, LocalFeatureSize, MeasureOptions, MeasuredCurve, MedialAxis,
    MedialAxisError, measure_with,
};
use curvecrust_sampling::{
    Bound, Condition, PlacedSamples, SampleOptions, SampledCurve, SamplingError, check, sample,
    sample_at_dense_points, sample_curve, sample_curve_with,
};
use curvecrust_testing::curves::random_closed;
use curvecrust_testing::fixtures;
use rayon::prelude::*;

/// How many times finer the checker looks.
const FINER: u32 = 10;

/// Points of a curve, ten times as dense as those that were sampled and these among them, with
/// their lfs.
struct Fine {
    dense: DenseCurve,
    lfs: LocalFeatureSize,
}

impl Fine {
    /// lfs as the sampler had it: distances to the medial axis of the points that were sampled.
    fn by_the_same_axis(curve: &Curve, measured: &MeasuredCurve) -> Self {
        let axis = MedialAxis::new(measured.dense()).unwrap();
        let dense = finer(curve, measured);
        let lfs = LocalFeatureSize::new(&dense, &axis);
        Self { dense, lfs }
    }

    /// lfs as it is, ten times as precisely: distances to the medial axis of the finer points.
    fn by_its_own_axis(curve: &Curve, measured: &MeasuredCurve) -> Self {
        let anew = MeasuredCurve::new(finer(curve, measured), Estimator::Voronoi).unwrap();
        Self {
            dense: anew.dense().clone(),
            lfs: anew.lfs().clone(),
        }
    }
}

fn finer(curve: &Curve, measured: &MeasuredCurve) -> DenseCurve {
    let pieces = vec![FINER; measured.dense().len()];
    measured.dense().refined(curve, &pieces).unwrap()
}

fn measured(curve: &Curve, gap_to_lfs: f64) -> MeasuredCurve {
    by(curve, Discretisation::Adaptive { gap_to_lfs }).unwrap()
}

fn by(curve: &Curve, discretisation: Discretisation) -> Result<MeasuredCurve, MedialAxisError> {
    let options = MeasureOptions {
        discretisation,
        ..MeasureOptions::default()
    };
    measure_with(curve, &options)
}

/// The definitions, point by point. Returns the largest ratio of a length to what it has to be
/// below: of distance and bound, and of distance to the polygon and limit.
fn brute_force(fine: &Fine, sampled: &SampledCurve, condition: Condition) -> [f64; 2] {
    let (points, lfs) = (fine.dense.points(), &fine.lfs);
    let mut worst = [0.0f64; 2];
    for (component, samples) in fine.dense.components().iter().zip(sampled.components()) {
        let range = component.range.clone();
        let places: Vec<usize> = samples
            .range
            .clone()
            .map(|s| {
                let param = sampled.params()[s];
                let here = &fine.dense.params()[range.clone()];
                let at = here.partition_point(|p| *p < param);
                assert_eq!(here[at], param);
                range.start + at
            })
            .collect();
        let mut ends: Vec<(usize, usize)> = places.windows(2).map(|w| (w[0], w[1])).collect();
        let (first, last) = (places[0], places[places.len() - 1]);
        if component.closed {
            ends.push((last, first + range.len()));
        } else {
            assert_eq!((first, last + 1), (range.start, range.end));
        }
        for (from, to) in ends {
            let inside = (from..=to).map(|i| range.start + (i - range.start) % range.len());
            let reach = inside
                .clone()
                .map(|i| lfs.at(i))
                .fold(f64::INFINITY, f64::min);
            let [s0, s1] =
                [from, range.start + (to - range.start) % range.len()].map(|i| points[i]);
            for i in inside {
                let nearer = points[i].distance(s0).min(points[i].distance(s1));
                let allowed = match condition.bound() {
                    Bound::Epsilon(epsilon) => epsilon * lfs.at(i),
                    Bound::Rho(rho) => rho * reach,
                };
                // For epsilon any sample would do: then this is more than is asked for.
                worst[0] = worst[0].max(nearer / allowed);
                if let Some(limit) = condition.hausdorff_limit() {
                    let off = Segment::new(s0, s1).distance(points[i]);
                    worst[1] = worst[1].max(off / limit);
                }
            }
        }
    }
    worst
}

fn conditions(extent: f64) -> [Condition; 5] {
    let (rho, epsilon) = (
        Condition::rho(0.9).unwrap(),
        Condition::epsilon(0.47).unwrap(),
    );
    [
        rho,
        epsilon,
        Condition::rho(0.3).unwrap(),
        rho.with_hausdorff_limit(0.003 * extent).unwrap(),
        epsilon.with_hausdorff_limit(0.01 * extent).unwrap(),
    ]
}

/// Samples and re-checks; returns the largest ratio of brute force, and how many more samples than
/// those tested at dense points.
fn recheck(name: &str, curve: &Curve, measured: &MeasuredCurve, fine: &Fine) -> [f64; 2] {
    let mut worst = [0.0f64; 2];
    for condition in conditions(curve.extent()) {
        let certified = sample(measured, condition).unwrap();
        let attained = certified.attained.unwrap();
        assert!(
            attained.at_most < condition.bound().value(),
            "{name} {condition:?} {attained:?}"
        );
        let ratios = brute_force(fine, &certified.samples, condition);
        assert!(
            ratios[0].max(ratios[1]) < 1.0,
            "{name} {condition:?}: {ratios:?}"
        );
        let at_dense_points = sample_at_dense_points(measured, condition).samples.len();
        let share = certified.samples.len() as f64 / at_dense_points as f64;
        worst = [worst[0].max(ratios[0]).max(ratios[1]), worst[1].max(share)];
    }
    worst
}

#[test]
fn fixtures_hold_at_every_point() {
    fixtures::curves().par_iter().for_each(|(name, curve)| {
        // The axis of the very points that are sampled.
        let measured = measured(curve, 0.02);
        let measured = MeasuredCurve::new(measured.dense().clone(), Estimator::Voronoi).unwrap();
        let fine = Fine::by_the_same_axis(curve, &measured);
        let [_, share] = recheck(name, curve, &measured, &fine);
        assert!(
            share < 1.1,
            "{name}: {share} times the samples of dense points"
        );
    });
}

#[test]
fn fixtures_hold_by_lfs_measured_anew() {
    // What lfs is wrong by at gaps of 0.02 is less than what is left of the bound between dense
    // points.
    fixtures::curves().par_iter().for_each(|(name, curve)| {
        let measured = measured(curve, 0.02);
        let fine = Fine::by_its_own_axis(curve, &measured);
        recheck(name, curve, &measured, &fine);
    });
}

#[test]
fn random_curves_hold_at_every_point() {
    let mut random = Random::new(20160);
    let mut curves = Vec::new();
    let mut refused = 0;
    while curves.len() < 200 {
        let curve = random_closed(&mut random);
        let discretisation = Discretisation::Adaptive { gap_to_lfs: 0.1 };
        match by(&curve, discretisation) {
            Ok(_) => curves.push(curve),
            Err(_) => refused += 1,
        }
    }
    assert!(refused < 200, "{refused} curves cross");
    let worst = curves.par_iter().enumerate().map(|(i, curve)| {
        let measured = measured(curve, 0.06);
        let fine = Fine::by_its_own_axis(curve, &measured);
        recheck(&format!("curve {i}"), curve, &measured, &fine)
    });
    let worst = worst.reduce(|| [0.0; 2], |a, b| [a[0].max(b[0]), a[1].max(b[1])]);
    assert!(
        worst[0] > 0.99,
        "the checker looks at what matters: {worst:?}"
    );
}

#[test]
fn what_cannot_be_certified_is_refused() {
    let curve = Curve::from_path_data("M 0 0 H 4 A 1 1 0 0 1 4 2 H 0 A 1 1 0 0 1 0 0 Z").unwrap();
    let coarse = by(&curve, Discretisation::PerSegment(8)).unwrap();
    let rho = Condition::rho(0.9).unwrap();
    let Err(SamplingError::TooCoarse { gap, lfs, .. }) = sample(&coarse, rho) else {
        panic!("a gap of half the lfs");
    };
    assert!((gap - 0.5).abs() < 1e-6 && lfs < 1.1);

    let limited = |limit| rho.with_hausdorff_limit(limit).unwrap();
    let certified = sample_curve(&curve, limited(1e-6)).unwrap();
    assert!(certified.samples.len() > 1000);
    // Without one dense point for each sample, and with one for many: whatever asks for too many is
    // named.
    for (condition, name, least) in [
        (limited(1e-16), "the Hausdorff limit", 1e7),
        (Condition::rho(1e-7).unwrap(), "rho", 1e7),
        (Condition::epsilon(1e-9).unwrap(), "epsilon", 1e9),
        (Condition::rho(2e-6).unwrap(), "rho", 1e6),
        (Condition::rho(f64::MIN_POSITIVE).unwrap(), "rho", 1e18),
    ] {
        let refused = sample_curve(&curve, condition).unwrap_err();
        let SamplingError::TooMany { what, value, count } = refused else {
            panic!("{condition:?}: {refused}");
        };
        assert_eq!(what, name);
        let says = match count {
            u64::MAX => String::from("more than 10^19"),
            count => format!("about {count}"),
        };
        assert!(count as f64 > least && refused.to_string().contains(&says));
        let limit = condition.hausdorff_limit();
        assert!((value - limit.unwrap_or(condition.bound().value())).abs() <= 0.0);
    }
    // A stadium of length 8 + 2 pi and lfs 1.
    let asked = sample(&coarse, Condition::rho(1e-7).unwrap()).unwrap_err();
    let SamplingError::TooMany { count, .. } = asked else {
        panic!("{asked}");
    };
    assert!(
        (count as f64 / ((8.0 + TAU) / 2e-7) - 1.0).abs() < 0.03,
        "{count}"
    );
}

#[test]
fn progress_ends_where_all_is_done() {
    let curve = Curve::from_path_data("M 0 0 C 0 4 6 4 6 0").unwrap();
    let heard = Mutex::new(Vec::new());
    let listener = |done, of| heard.lock().unwrap().push((done, of));
    let options = SampleOptions {
        progress: Progress::new(&listener),
    };
    let rho = Condition::rho(0.9).unwrap();
    let sampling = sample_curve_with(&curve, rho, &options).unwrap();
    assert_eq!(sampling, sample_curve(&curve, rho).unwrap());
    let heard = heard.into_inner().unwrap();
    let points = sampling.measured.dense().len();
    assert_eq!(heard.last(), Some(&(points, points)));
    assert!(heard.len() > 2 && heard.is_sorted());
    assert!(heard.iter().all(|(done, of)| done <= of));
}

/// Gaps are 0.02 of lfs at most, and 0.05 of the bound times lfs: where that is enough, no finer.
#[test]
fn curves_are_as_fine_as_the_bound_asks_for() {
    let curve = Curve::from_path_data("M 0 0 C 0 4 6 4 6 0").unwrap();
    for (bound, wanted) in [(0.9, 0.02), (0.1, 0.005)] {
        let condition = Condition::epsilon(bound).unwrap();
        let measured = sample_curve(&curve, condition).unwrap().measured;
        let (points, lfs) = (measured.dense().points(), measured.lfs().values());
        let gaps = points.windows(2).map(|pair| pair[0].distance(pair[1]));
        let shares = gaps.zip(lfs).map(|(gap, lfs)| gap / lfs);
        let largest = shares.fold(0.0, f64::max);
        assert!(
            0.5 * wanted < largest && largest < 1.02 * wanted,
            "{bound}: {largest}"
        );
    }
}

/// Two long strands near to each other: gaps grow to 0.1 of the bound times lfs, which costs few
/// samples; and these hold by lfs at gaps of 0.02.
#[test]
fn many_dense_points_are_farther_apart() {
    let ellipse =
        |rx: f64, ry: f64| format!("M {rx} 0 A {rx} {ry} 0 1 1 -{rx} 0 A {rx} {ry} 0 1 1 {rx} 0 Z");
    let curve = Curve::from_path_data(&(ellipse(40.0, 20.0) + &ellipse(39.96, 19.96))).unwrap();
    let rho = Condition::rho(0.9).unwrap();
    let few = sample_curve(&curve, rho).unwrap();
    let fine = measured(&curve, 0.02);
    assert!(3 * few.measured.dense().len() < 2 * fine.dense().len());
    let fewer = sample(&fine, rho).unwrap().samples.len();
    assert!(100 * few.samples.len() < 105 * fewer);
    let placed = PlacedSamples::project(&fine, few.samples.points(), 1e-6).unwrap();
    let verdict = check(&fine, &placed.samples, rho);
    assert!(verdict.holds() && verdict.certain, "{:?}", verdict.worst);
}
