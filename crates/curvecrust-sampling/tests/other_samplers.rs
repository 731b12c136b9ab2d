//! Uniform and uneven sampling, noise and outliers.
#![allow(clippy::unwrap_used, reason = "a test, its helpers included")]

use curvecrust_curve::Curve;
use curvecrust_geometry::DVec2;
use curvecrust_medial_axis::{Discretisation, MeasureOptions, MeasuredCurve, measure_with};
use curvecrust_sampling::{
    Condition, Noise, NoiseShape, NoiseSize, Outliers, SAMPLE_LIMIT, SamplingError, UnevenOptions,
    sample, sample_unevenly, sample_unevenly_with, sample_uniformly, with_noise, with_outliers,
};

fn by(curve: &Curve, discretisation: Discretisation) -> MeasuredCurve {
    let options = MeasureOptions {
        discretisation,
        ..MeasureOptions::default()
    };
    measure_with(curve, &options).unwrap()
}

/// A stadium and an arch beside it.
fn curves() -> MeasuredCurve {
    let d = "M 0 0 H 4 A 1 1 0 0 1 4 2 H 0 A 1 1 0 0 1 0 0 Z M 10 0 C 10 4 16 4 16 0";
    let curve = Curve::from_path_data(d).unwrap();
    by(&curve, Discretisation::Adaptive { gap_to_lfs: 0.01 })
}

#[test]
fn uniform_samples_are_as_far_apart_as_asked_for() {
    let measured = curves();
    let sampled = sample_uniformly(&measured, 0.25).unwrap().samples;
    for component in sampled.components() {
        let points = &sampled.points()[component.range.clone()];
        for pair in points.windows(2) {
            assert!((pair[0].distance(pair[1]) - 0.25).abs() < 0.05);
        }
    }
    let [stadium, arch] = sampled.components() else {
        panic!()
    };
    // 8 + 2 pi is 57.1 steps; both ends of the arch are samples.
    assert_eq!(stadium.range.len(), 57);
    assert_eq!(sampled.points()[arch.range.end - 1], DVec2::new(16.0, 0.0));
    let coarse = sample_uniformly(&measured, 1e9).unwrap();
    assert_eq!(
        coarse
            .samples
            .components()
            .iter()
            .map(|c| c.range.len())
            .collect::<Vec<_>>(),
        [3, 2]
    );
    // No more than dense points, each once.
    let fine = sample_uniformly(&measured, 1e-4).unwrap();
    assert_eq!(
        fine.samples.dense_indices(),
        (0..measured.dense().len()).collect::<Vec<_>>()
    );
    assert!(matches!(
        sample_uniformly(&measured, 1e-7),
        Err(SamplingError::TooMany { .. })
    ));
    assert!(
        sample_uniformly(&measured, 0.0).is_err() && sample_uniformly(&measured, f64::NAN).is_err()
    );
}

/// A line of as many steps as there may be samples, and a line a little longer than that.
#[test]
fn as_many_uniform_samples_as_allowed_are_taken() {
    let curve = Curve::from_path_data("M 0 0 H 10000000").unwrap();
    let line = by(&curve, Discretisation::PerSegment(2));
    let sampled = sample_uniformly(&line, 1e7 / SAMPLE_LIMIT as f64).unwrap();
    // Each dense point once.
    assert_eq!(
        sampled.samples.dense_indices(),
        (0..line.dense().len()).collect::<Vec<_>>()
    );
    assert_eq!(
        sample_uniformly(&line, 1e7 / (SAMPLE_LIMIT + 1) as f64),
        Err(SamplingError::TooMany {
            what: "the step",
            value: 1e7 / (SAMPLE_LIMIT + 1) as f64,
            count: SAMPLE_LIMIT + 1,
        })
    );
}

/// By definition: the dense points that are nearest to equally spaced places, the earlier of two.
#[test]
fn uniform_samples_are_the_points_nearest_to_their_places() {
    let measured = curves();
    let (dense, mut expected) = (measured.dense(), Vec::new());
    for step in [3.1, 0.4, 0.013, 0.004] {
        expected.clear();
        for component in dense.components() {
            let range = component.range.clone();
            let mut along = vec![0.0];
            let mut at = range.start;
            while let Some(next) = dense.next(at).filter(|_| along.len() <= range.len()) {
                let length =
                    along[along.len() - 1] + dense.points()[at].distance(dense.points()[next]);
                along.push(length);
                at = next;
            }
            let length = along[along.len() - 1];
            let parts = (length / step)
                .round()
                .max(if component.closed { 3.0 } else { 1.0 });
            let mut k = 0.0;
            while k < parts + f64::from(u8::from(!component.closed)) {
                let place = length * k / parts;
                let off = |i: &usize| (along[*i] - place).abs();
                let nearest = (0..along.len())
                    .min_by(|i, j| off(i).total_cmp(&off(j)))
                    .unwrap();
                if nearest < range.len() {
                    expected.push(range.start + nearest);
                }
                k += 1.0;
            }
        }
        expected.dedup();
        assert_eq!(
            sample_uniformly(&measured, step)
                .unwrap()
                .samples
                .dense_indices(),
            expected,
            "{step}"
        );
    }
}

#[test]
fn uneven_samples_satisfy_the_condition() {
    let measured = curves();
    for condition in [
        Condition::rho(0.9).unwrap(),
        Condition::epsilon(0.47)
            .unwrap()
            .with_hausdorff_limit(0.01)
            .unwrap(),
    ] {
        let greedy = sample(&measured, condition).unwrap();
        let by = |fraction, seed| {
            sample_unevenly_with(&measured, condition, &UnevenOptions { fraction, seed })
        };
        assert_eq!(by(1.0, 3).unwrap(), greedy);
        let halves = sample_unevenly(&measured, condition).unwrap();
        assert_eq!(halves, by(0.5, 0).unwrap());
        let uneven = by(0.3, 3).unwrap();
        assert!(uneven.attained.unwrap().at_most < condition.bound().value());
        assert!(uneven.samples.len() > greedy.samples.len());
        assert_eq!(uneven, by(0.3, 3).unwrap());
        assert_ne!(uneven, by(0.3, 4).unwrap());
        for bad in [0.0, 1.1, f64::NAN] {
            assert!(by(bad, 0).is_err());
        }
    }
}

#[test]
fn noise_has_its_size() {
    let measured = curves();
    let sampled = sample_uniformly(&measured, 1e-4).unwrap();
    let moved = |shape, size| {
        let seed = 5;
        let noisy = with_noise(&sampled, Noise { shape, size, seed }).unwrap();
        let by: Vec<f64> = noisy
            .iter()
            .zip(sampled.samples.points())
            .map(|(p, q)| p.distance(*q))
            .collect();
        let mean_square = by.iter().map(|d| d * d).sum::<f64>() / by.len() as f64;
        (by.iter().copied().fold(0.0, f64::max), mean_square)
    };
    // The extent is about 17: -1 to 16.
    let (most, mean_square) = moved(NoiseShape::Disc, NoiseSize::OfExtent(0.01));
    assert!(0.168 < most && most < 0.1701);
    assert!((mean_square / (0.17f64.powi(2) / 2.0) - 1.0).abs() < 0.1);
    let (_, mean_square) = moved(NoiseShape::Gaussian, NoiseSize::OfExtent(0.01));
    assert!((mean_square / (0.17f64.powi(2) * 2.0) - 1.0).abs() < 0.1);
    let (most, _) = moved(NoiseShape::Disc, NoiseSize::OfLfs(0.0));
    assert!(most <= 0.0);
    let noise = Noise {
        shape: NoiseShape::Disc,
        size: NoiseSize::OfLfs(-1.0),
        ..Noise::default()
    };
    assert!(with_noise(&sampled, noise).is_err());
}

#[test]
fn outliers_come_after_the_points() {
    let points = [DVec2::ZERO, DVec2::new(2.0, 1.0)];
    let outliers = |count, margin| Outliers {
        count,
        margin,
        seed: 9,
    };
    let all = with_outliers(&points, outliers(1000, 0.5)).unwrap();
    assert_eq!((all.len(), &all[..2]), (1002, &points[..]));
    let (low, high) = (DVec2::splat(-1.0), DVec2::new(3.0, 2.0));
    assert!(all.iter().all(|&p| p.clamp(low, high) == p));
    assert!(all.iter().any(|p| p.x < -0.9) && all.iter().any(|p| p.y > 1.9));
    assert!(with_outliers(&[], outliers(5, 0.5)).unwrap().is_empty());
    assert!(with_outliers(&points, outliers(5, f64::NAN)).is_err());
}
