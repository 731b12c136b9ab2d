//! Closed-form local feature sizes against brute force, and dense points against equations.
#![allow(
    clippy::unwrap_used,
    reason = "clippy knows helpers of tests as tests in modules only"
)]
#![allow(clippy::float_cmp, reason = "closed forms that are exact")]

use std::f64::consts::{FRAC_PI_2, PI};

use curvecrust_curve::analytic::{Circle, ConcentricCircles, Ellipse, ParallelSegments, Stadium};
use curvecrust_curve::{AnalyticError, DenseCurve, DenseError};
use glam::DVec2;

/// The empty ball that touches at dense point i from one side, shrunk over all other points: its
/// centre is on the medial axis. At open ends the normal is that of the chord that is left.
fn medial_point(dense: &DenseCurve, i: usize, side: f64) -> Option<DVec2> {
    let p = dense.points()[i];
    let at = |j: Option<usize>| j.map_or(p, |j| dense.points()[j]);
    let normal = (at(dense.next(i)) - at(dense.previous(i)))
        .normalize()
        .perp()
        * side;
    let radius = |&q: &DVec2| {
        let height = normal.dot(q - p);
        (height > 1e-12).then(|| (q - p).length_squared() / (2.0 * height))
    };
    let least = dense.points().iter().filter_map(radius);
    least.reduce(f64::min).map(|r| p + normal * r)
}

/// Compares a closed form with the distance to the medial points found by brute force.
fn check(dense: &DenseCurve, lfs: impl Fn(DVec2) -> f64, tolerance: f64) {
    let medial: Vec<_> = (0..dense.len())
        .flat_map(|i| [1.0, -1.0].map(|side| medial_point(dense, i, side)))
        .flatten()
        .collect();
    for &p in dense.points() {
        let distances = medial.iter().map(|m| m.distance(p));
        let estimate = distances.fold(f64::INFINITY, f64::min);
        assert!(
            (estimate / lfs(p) - 1.0).abs() < tolerance,
            "at {p}: {estimate} and {}",
            lfs(p)
        );
    }
}

#[test]
fn lfs_agrees_with_brute_force() {
    let circle = Circle::new(2.0).unwrap();
    check(&circle.dense(50).unwrap(), |p| circle.lfs(p), 1e-3);
    let stadium = Stadium::new(3.0, 1.0).unwrap();
    check(&stadium.dense(50).unwrap(), |p| stadium.lfs(p), 1e-2);
    let pair = ParallelSegments::new(3.0, 0.5).unwrap();
    check(&pair.dense(20).unwrap(), |p| pair.lfs(p), 1e-3);
    for (outer, inner) in [(2.0, 1.0), (2.0, 0.1)] {
        let circles = ConcentricCircles::new(outer, inner).unwrap();
        check(&circles.dense(100).unwrap(), |p| circles.lfs(p), 1e-2);
    }
    for (a, b) in [(1.0, 1.0), (2.0, 1.0), (3.0, 1.5)] {
        let ellipse = Ellipse::new(a, b).unwrap();
        check(&ellipse.dense(150).unwrap(), |p| ellipse.lfs(p), 2e-2);
    }
}

#[test]
fn points_lie_on_the_exact_curves() {
    let n = 37;
    let ellipse = Ellipse::new(3.0, 1.0).unwrap().dense(n).unwrap();
    assert_eq!(ellipse.len(), 148);
    for p in ellipse.points() {
        assert!(((*p / DVec2::new(3.0, 1.0)).length() - 1.0).abs() < 1e-15);
    }
    let joints = [0, 37, 74, 111].map(|i| ellipse.points()[i]);
    let expected = [DVec2::X * 3.0, DVec2::Y, DVec2::NEG_X * 3.0, DVec2::NEG_Y];
    for (p, q) in joints.into_iter().zip(expected) {
        assert!(p.distance(q) < 1e-15);
    }
    let stadium = Stadium::new(4.0, 1.5).unwrap().dense(n).unwrap();
    for p in stadium.points() {
        let core = DVec2::new(p.x.clamp(-2.0, 2.0), 0.0);
        assert!((p.distance(core) - 1.5).abs() < 1e-15);
    }
    let pair = ParallelSegments::new(4.0, 3.0).unwrap().dense(n).unwrap();
    assert!(
        pair.points()
            .iter()
            .all(|p| p.y.abs() == 1.5 && p.x.abs() <= 2.0)
    );
    assert_eq!(pair.components().len(), 2);
    assert!(pair.components().iter().all(|c| !c.closed));
}

#[test]
fn curves_run_counter_clockwise_in_steps_of_like_length() {
    let n = 40;
    let quarter_step = FRAC_PI_2 / f64::from(n);
    for (dense, length) in [
        (Circle::new(1.0).unwrap().dense(n).unwrap(), 2.0 * PI),
        (
            Stadium::new(5.0, 1.0).unwrap().dense(n).unwrap(),
            2.0 * PI + 10.0,
        ),
        (
            ParallelSegments::new(5.0, 2.0).unwrap().dense(n).unwrap(),
            10.0,
        ),
        (
            ConcentricCircles::new(1.0, 0.5).unwrap().dense(n).unwrap(),
            3.0 * PI,
        ),
    ] {
        let steps = (0..dense.len()).filter_map(|i| Some((i, dense.next(i)?)));
        let (mut total, mut area) = (0.0, 0.0);
        for (i, j) in steps {
            let (p, q) = (dense.points()[i], dense.points()[j]);
            assert!(p.distance(q) <= quarter_step * 1.000_001);
            assert!(p.distance(q) >= quarter_step * 0.49);
            total += p.distance(q);
            area += p.perp_dot(q) / 2.0;
        }
        assert!((total / length - 1.0).abs() < 1e-3);
        assert!(area > 0.0 || dense.components().iter().any(|c| !c.closed));
    }
}

#[test]
fn impossible_measures_are_refused() {
    for bad in [0.0, -1.0, f64::NAN, f64::INFINITY, 1e60] {
        for error in [
            Circle::new(bad).unwrap_err(),
            Stadium::new(bad, 1.0).unwrap_err(),
            Stadium::new(1.0, bad).unwrap_err(),
            Ellipse::new(bad, 1.0).unwrap_err(),
            Ellipse::new(1.0, bad).unwrap_err(),
            ParallelSegments::new(bad, 1.0).unwrap_err(),
            ParallelSegments::new(1.0, bad).unwrap_err(),
            ConcentricCircles::new(bad, 1.0).unwrap_err(),
            ConcentricCircles::new(1.0, bad).unwrap_err(),
        ] {
            assert!(
                matches!(error, AnalyticError::NotPositive { .. }),
                "{error}"
            );
        }
    }
    let messages = [
        Ellipse::new(1.0, 2.0).unwrap_err().to_string(),
        ConcentricCircles::new(1.0, 1.0).unwrap_err().to_string(),
    ];
    assert_eq!(messages[0], "a is 1 and b 2: the first must not be smaller");
    assert_eq!(
        messages[1],
        "outer is 1 and inner 1: the first must be larger"
    );
}

#[test]
fn too_many_or_no_points_are_refused() {
    let circle = Circle::new(1.0).unwrap();
    assert_eq!(circle.dense(0), Err(DenseError::NoPieces { index: 0 }));
    assert!(matches!(
        circle.dense(u32::MAX),
        Err(DenseError::TooMany { .. })
    ));
    let long = Stadium::new(1e40, 1e-20).unwrap();
    assert_eq!(long.dense(0), Err(DenseError::NoPieces { index: 0 }));
    assert!(matches!(long.dense(1), Err(DenseError::TooMany { .. })));
}
