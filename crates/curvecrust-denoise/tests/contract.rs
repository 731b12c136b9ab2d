//! What holds for any points: clean ones, degenerate ones, ones that form no curve.
#![allow(clippy::unwrap_used, reason = "a test, its helpers included")]

use std::f64::consts::TAU;

use curvecrust_curve::DenseCurve;
use curvecrust_denoise::{DenoiseError, Fitted, Options, denoise, denoise_with};
use curvecrust_geometry::{DVec2, PointSet, Random};
use curvecrust_reconstruct::{Shape, least_detour};
use curvecrust_testing::fixtures;
use proptest::prelude::*;

fn set(points: Vec<DVec2>) -> PointSet {
    PointSet::new(points).unwrap()
}

/// Points that scatter about a circle of radius 1, and others all over a square.
fn ring(n: usize, sigma: f64, outliers: usize, seed: u64) -> Vec<DVec2> {
    let mut random = Random::new(seed);
    let mut points: Vec<DVec2> = (0..n)
        .map(|_| {
            let angle = random.between(0.0, TAU);
            let error = DVec2::new(random.normal(), random.normal());
            DVec2::from_angle(angle) + sigma * error
        })
        .collect();
    let mut place = || random.between(-1.3, 1.3);
    points.extend((0..outliers).map(|_| DVec2::new(place(), place())));
    points
}

/// The control points of all curves, as bits.
fn bits(fitted: &Fitted) -> Vec<[u64; 2]> {
    let cubics = fitted.curves.iter().flat_map(|c| &c.cubics).flatten();
    cubics.map(|p| p.to_array().map(f64::to_bits)).collect()
}

#[test]
fn clean_points_give_the_edges_of_least_detour() {
    for name in ["bunny", "fish", "target", "violin"] {
        let dense = DenseCurve::per_segment(&fixtures::curve(name), 12).unwrap();
        let points = set(dense.points().to_vec());
        let fitted = denoise(&points);
        assert_eq!(fitted.edges, Some(least_detour(&points)), "{name}");
        assert!(fitted.is_clean() && fitted.outliers().is_empty());
        assert!(fitted.sigma() <= 0.0);
    }
}

/// Points that scatter about the square between (0, 0) and (1, 1), 80 a side.
fn square(sigma: f64, seed: u64) -> Vec<DVec2> {
    let mut random = Random::new(seed);
    let corners = [DVec2::ZERO, DVec2::X, DVec2::ONE, DVec2::Y];
    let along = (0..320_u32).map(|i| {
        let side = i as usize / 80;
        let place = corners[side].lerp(corners[(side + 1) % 4], f64::from(i % 80) / 80.0);
        place + sigma * DVec2::new(random.normal(), random.normal())
    });
    along.collect()
}

#[test]
fn corners_of_a_square_are_found() {
    for (sigma, seed) in [(0.003, 1), (0.006, 2), (0.006, 3)] {
        let fitted = denoise(&set(square(sigma, seed)));
        let [curve] = &*fitted.curves else {
            panic!("one curve");
        };
        let found = curve.corners.iter().map(|i| curve.cubics[*i][0]);
        let mut found: Vec<DVec2> = found.collect();
        found.sort_by_key(|p| (p.x > 0.5, p.y > 0.5));
        let known = [DVec2::ZERO, DVec2::Y, DVec2::X, DVec2::ONE];
        assert_eq!(found.len(), known.len(), "{found:?}");
        for (found, known) in found.into_iter().zip(known) {
            assert!(found.distance(known) < 3.0 * sigma, "{found} for {known}");
        }
    }
    for seed in 1..4 {
        let fitted = denoise(&set(ring(300, 0.02, 0, seed)));
        assert!(fitted.curves.iter().all(|curve| curve.corners.is_empty()));
    }
}

#[test]
fn a_ring_is_found_within_its_error() {
    for (n, sigma, outliers) in [(300, 0.02, 0), (300, 0.06, 20), (1000, 0.05, 100)] {
        let points = ring(n, sigma, outliers, 7);
        let fitted = denoise(&set(points.clone()));
        let [curve] = &*fitted.curves else {
            panic!("one curve");
        };
        assert!(curve.closed && !fitted.is_clean());
        assert!(
            (0.75..1.3).contains(&(fitted.sigma() / sigma)),
            "{}",
            fitted.sigma()
        );
        let line = curve.polyline(1e-3);
        let squares: f64 = line.iter().map(|p| (p.length() - 1.0).powi(2)).sum();
        let rms = (squares / line.len() as f64).sqrt();
        assert!(rms < 0.45 * sigma, "{n} {sigma}: {rms}");
        // The curve runs counter-clockwise.
        let next = line.iter().cycle().skip(1);
        assert!(
            line.iter()
                .zip(next)
                .map(|(a, b)| a.perp_dot(*b))
                .sum::<f64>()
                > 0.0
        );
        // Every point is where its place says, and has the distance that it says.
        for (p, place) in points.iter().zip(&fitted.places) {
            let Some(place) = place else { continue };
            let on = fitted.curves[place.curve].point(place.parameter);
            assert!((on.distance(*p) - place.distance).abs() < 0.01, "{p} {on}");
        }
    }
}

/// Points that scatter by so many spacings that no neighbourhood is a stroke leave a hole.
#[test]
fn a_ring_of_much_noise_is_one_ring() {
    for (n, spacings) in [(100, 0.2), (100, 2.0), (200, 4.0), (1000, 4.0)] {
        let sigma = spacings * TAU / n as f64;
        let fitted = denoise(&set(ring(n, sigma, 0, 2)));
        let [curve] = &*fitted.curves else {
            panic!("{n} {spacings}: {} curves", fitted.curves.len());
        };
        assert!(curve.closed, "{n} {spacings}");
    }
}

#[test]
fn scale_order_and_threads_make_no_difference() {
    let points = ring(200, 0.05, 10, 3);
    let fitted = denoise(&set(points.clone()));
    let large = points.iter().map(|&p| p * 1024.0).collect();
    let large = denoise(&set(large));
    let scaled: Vec<[u64; 2]> = fitted.curves[0]
        .cubics
        .iter()
        .flatten()
        .map(|p| (*p * 1024.0).to_array().map(f64::to_bits))
        .collect();
    assert_eq!(bits(&large), scaled);
    let reversed: Vec<DVec2> = points.iter().rev().copied().collect();
    let found = denoise(&set(reversed));
    assert_eq!(bits(&found), bits(&fitted));
    assert!(found.places.iter().rev().eq(&fitted.places));
    let one = rayon::ThreadPoolBuilder::new()
        .num_threads(1)
        .build()
        .unwrap();
    assert_eq!(one.install(|| denoise(&set(points))), fitted);
}

/// The last digits of sums decide whether points scatter that are ulps apart.
#[test]
fn points_a_few_ulps_apart_are_the_same_in_any_order() {
    for seed in 0..40 {
        let mut random = Random::new(seed);
        let mut ulps = || 1.0 + f64::EPSILON * random.between(0.0, 40.0).floor();
        let points: Vec<DVec2> = (0..40).map(|_| DVec2::new(ulps(), 3.0 * ulps())).collect();
        let points = PointSet::merging_duplicates(points).unwrap().points;
        let fitted = denoise(&points);
        let reversed = points.points().iter().rev().copied().collect();
        let other = denoise(&set(reversed));
        assert_eq!(fitted.is_clean(), other.is_clean(), "{seed}");
        if !fitted.is_clean() {
            assert_eq!(bits(&fitted), bits(&other), "{seed}");
        }
    }
}

/// An arc whose end is a rounding error beyond a knot has no cubic there, and no point is on it.
#[test]
fn places_are_on_the_cubics() {
    // A ring of a few ulps, and three points afar.
    let points = [
        (4.304788882405838e-42, -2.8698592549372254e-42),
        (1.4349296274686127e-42, -8.609577764811676e-42),
        (-5.739718509874451e-42, 3.587324068671532e-42),
        (1.4349296274686052e-42, -8.609577764811676e-42),
        (1.434929627468606e-42, -8.60957776481168e-42),
        (1.4349296274686084e-42, -8.609577764811682e-42),
        (1.4349296274686117e-42, -8.609577764811684e-42),
        (1.4349296274686152e-42, -8.609577764811684e-42),
        (1.4349296274686184e-42, -8.609577764811681e-42),
        (1.43492962746862e-42, -8.609577764811677e-42),
        (1.43492962746862e-42, -8.609577764811675e-42),
        (1.4349296274686184e-42, -8.609577764811671e-42),
        (1.4349296274686152e-42, -8.609577764811668e-42),
        (1.4349296274686117e-42, -8.609577764811668e-42),
        (1.4349296274686084e-42, -8.60957776481167e-42),
        (1.434929627468606e-42, -8.609577764811672e-42),
    ];
    let points = points.map(DVec2::from).to_vec();
    let points = PointSet::merging_duplicates(points).unwrap().points;
    let fitted = denoise(&points);
    assert!(!fitted.is_clean());
    for place in fitted.places.iter().flatten() {
        let cubics = fitted.curves[place.curve].cubics.len();
        assert!(
            (0.0..=cubics as f64).contains(&place.parameter),
            "{place:?}"
        );
    }
}

/// Of many points some stand for those about them.
#[test]
fn many_points_give_one_ring_in_any_order() {
    let points = ring(6000, 0.01, 300, 4);
    let fitted = denoise(&set(points.clone()));
    assert!(matches!(&*fitted.curves, [curve] if curve.closed));
    for place in fitted.curves[0].polyline(1e-4) {
        assert!((place.length() - 1.0).abs() < 0.01, "{place}");
    }
    let reversed = points.into_iter().rev().collect();
    assert_eq!(bits(&denoise(&set(reversed))), bits(&fitted));
}

#[test]
fn points_all_over_the_place_form_no_curve() {
    for n in [300, 1000] {
        for seed in 0..4 {
            let mut random = Random::new(seed);
            let square = (0..n)
                .map(|_| DVec2::new(random.unit(), random.unit()))
                .collect();
            let fitted = denoise(&set(square));
            assert!(fitted.curves.is_empty() && !fitted.is_clean(), "{n} {seed}");
            assert_eq!(fitted.outliers().len(), n);
        }
    }
}

#[test]
fn what_is_known_is_kept_or_refused() {
    let points = set(ring(200, 0.05, 0, 3));
    let open = Options {
        shape: Some(Shape::Open),
        ..Options::default()
    };
    assert!(
        denoise_with(&points, &open)
            .unwrap()
            .curves
            .iter()
            .all(|c| !c.closed)
    );
    let known = Options {
        sigma: Some(0.05),
        ..Options::default()
    };
    let sigma = denoise_with(&points, &known).unwrap().sigma();
    assert!((sigma - 0.05).abs() < 1e-12);
    let wrong = Options {
        sigma: Some(f64::NAN),
        ..Options::default()
    };
    let error = denoise_with(&points, &wrong).unwrap_err();
    assert!(matches!(error, DenoiseError::Sigma { .. }), "{error}");
}

#[test]
fn degenerate_points_have_an_answer() {
    assert!(denoise(&set(Vec::new())).curves.is_empty());
    assert!(denoise(&set(vec![DVec2::ONE])).curves.is_empty());
    for scale in [1e-30, 1.0, 1e30] {
        let line = set((0..40)
            .map(|i| DVec2::new(f64::from(i), 3.0) * scale)
            .collect());
        let [curve] = &*denoise(&line).curves else {
            panic!("one curve");
        };
        assert!(!curve.closed);
    }
    for n in 1..8 {
        let few = denoise(&set(ring(n, 0.2, 0, 5)));
        assert_eq!(few.places.len(), n);
    }
    // A stack of points nearly equal, and one far away.
    let mut stack: Vec<DVec2> = (0..30)
        .map(|i| DVec2::splat(f64::from(i) * 1e-15))
        .collect();
    stack.push(DVec2::new(1e9, 0.0));
    assert_eq!(denoise(&set(stack)).places.len(), 31);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]
    #[test]
    fn hard_points_never_panic(
        cells in prop::collection::hash_set((0i8..12, 0i8..12), 0..60),
        stretch in prop::sample::select(vec![1.0, 1e-9, 1e12]),
        shift in prop::sample::select(vec![0.0, 1e6]),
    ) {
        let mut cells: Vec<_> = cells.into_iter().collect();
        cells.sort_unstable();
        let point = |(x, y): (i8, i8)| DVec2::new(f64::from(x) * stretch + shift, f64::from(y));
        let points = set(cells.into_iter().map(point).collect());
        let fitted = denoise(&points);
        prop_assert_eq!(fitted.places.len(), points.len());
        let finite = fitted.curves.iter().flat_map(|c| c.cubics.iter().flatten());
        prop_assert!(finite.into_iter().all(|p| p.is_finite()));
    }
}
