//! Curves fitted to points that scatter: total, finite, each point accounted for, and the same
//! whatever the order of the points.

#![no_main]

use curvecrust::DVec2;
use curvecrust::denoise::{Fitted, denoise};
use curvecrust::geometry::{PointSet, Random};
use curvecrust_fuzz::NearlyDegenerate;
use libfuzzer_sys::fuzz_target;

/// Points about each given one: few are taken as clean.
const COPIES: usize = 3;

fuzz_target!(|input: (NearlyDegenerate, u8)| {
    let (NearlyDegenerate(given), scatter) = input;
    let points = scattered(&given, f64::from(scatter) / 64.0);
    let Ok(merged) = PointSet::merging_duplicates(points) else {
        return;
    };
    let points = merged.points;
    let fitted = denoise(&points);
    check(&points, &fitted);
    let reversed: Vec<DVec2> = points.points().iter().rev().copied().collect();
    let other = denoise(&PointSet::new(reversed).unwrap());
    if !fitted.is_clean() {
        assert_eq!(fitted.curves, other.curves);
        assert!(other.places.iter().rev().eq(&fitted.places));
    }
});

/// The points as they are, or some about each, by a share of the distance to the one before.
fn scattered(given: &[DVec2], share: f64) -> Vec<DVec2> {
    let mut random = Random::new(1);
    let mut points = given.to_vec();
    for pair in given.windows(2) {
        let deviation = share * pair[0].distance(pair[1]);
        if share > 0.0 && deviation.is_finite() {
            points.extend(
                (0..COPIES)
                    .map(|_| pair[1] + deviation * DVec2::new(random.normal(), random.normal())),
            );
        }
    }
    points
}

fn check(points: &PointSet, fitted: &Fitted) {
    assert_eq!(fitted.places.len(), points.len());
    let mut counts = vec![0; fitted.curves.len()];
    for place in fitted.places.iter().flatten() {
        counts[place.curve] += 1;
        assert!(place.distance >= 0.0 && place.parameter >= 0.0);
        let last = fitted.curves[place.curve].cubics.len() as f64;
        assert!(place.parameter <= last);
    }
    for (curve, count) in fitted.curves.iter().zip(counts) {
        assert_eq!(curve.points, count);
        assert_eq!(curve.sigma.len(), curve.cubics.len() + 1);
        assert_eq!(curve.standard_error.len(), curve.cubics.len() + 1);
        assert!(curve.cubics.iter().flatten().all(|p| p.is_finite()));
        assert!(
            curve
                .sigma
                .iter()
                .chain(&curve.standard_error)
                .all(|s| *s >= 0.0)
        );
        for pair in curve.cubics.windows(2) {
            assert_eq!(pair[0][3], pair[1][0]);
        }
        if let (true, [first, .., last]) = (curve.closed, &*curve.cubics) {
            assert_eq!(last[3], first[0]);
        }
    }
}
