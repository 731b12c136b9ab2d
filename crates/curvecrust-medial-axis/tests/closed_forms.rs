//! Voronoi and shrinking-ball lfs against curves whose lfs is known in closed form.
#![allow(clippy::unwrap_used, reason = "a test may panic")]

use curvecrust_curve::DenseCurve;
use curvecrust_curve::analytic::{Circle, ConcentricCircles, Ellipse, ParallelSegments, Stadium};
use curvecrust_geometry::DVec2;
use curvecrust_medial_axis::{Estimator, MeasuredCurve, MedialAxis};

/// A name, dense points for a number of them per quarter circle, and the closed form.
type Oracle = (
    &'static str,
    Box<dyn Fn(u32) -> DenseCurve>,
    Box<dyn Fn(DVec2) -> f64>,
);

fn oracles() -> Vec<Oracle> {
    let circle = Circle::new(1.5).unwrap();
    let stadium = Stadium::new(4.0, 0.7).unwrap();
    let ellipse = Ellipse::new(3.0, 1.0).unwrap();
    let segments = ParallelSegments::new(5.0, 1.0).unwrap();
    let rings = ConcentricCircles::new(2.0, 1.0).unwrap();
    vec![
        (
            "circle",
            Box::new(move |n| circle.dense(n).unwrap()),
            Box::new(move |p| circle.lfs(p)),
        ),
        (
            "stadium",
            Box::new(move |n| stadium.dense(n).unwrap()),
            Box::new(move |p| stadium.lfs(p)),
        ),
        (
            "ellipse",
            Box::new(move |n| ellipse.dense(n).unwrap()),
            Box::new(move |p| ellipse.lfs(p)),
        ),
        (
            "segments",
            Box::new(move |n| segments.dense(n).unwrap()),
            Box::new(move |p| segments.lfs(p)),
        ),
        (
            "rings",
            Box::new(move |n| rings.dense(n).unwrap()),
            Box::new(move |p| rings.lfs(p)),
        ),
    ]
}

/// The largest relative error of the estimate.
fn error(dense: DenseCurve, truth: impl Fn(DVec2) -> f64, estimator: Estimator) -> f64 {
    let measured = MeasuredCurve::new(dense, estimator).unwrap();
    let points = measured.dense().points().iter();
    points
        .zip(measured.lfs().values())
        .map(|(&p, lfs)| (lfs / truth(p) - 1.0).abs())
        .fold(0.0, f64::max)
}

#[test]
fn voronoi_lfs_is_right_and_converges() {
    // What is lost to rounding, at any density.
    let floor = 1e-9;
    for (name, dense, truth) in oracles() {
        let errors = [75, 150, 300, 600].map(|n| error(dense(n), &truth, Estimator::Voronoi));
        println!("{name}: {errors:?}");
        assert!(errors[2] <= 1e-3, "{name}: {errors:?}");
        for pair in errors.windows(2) {
            assert!(pair[1] <= 0.5 * pair[0] + floor, "{name}: {errors:?}");
        }
    }
}

#[test]
fn shrinking_balls_are_right() {
    for (name, dense, truth) in oracles() {
        let error = error(dense(300), &truth, Estimator::ShrinkingBall);
        println!("{name}: {error}");
        assert!(error <= 5e-3, "{name}: {error}");
    }
}

#[test]
fn the_axis_of_a_circle_is_its_centre() {
    let circle = Circle::new(3.0).unwrap();
    let axis = MedialAxis::new(&circle.dense(50).unwrap()).unwrap();
    assert!(!axis.is_empty());
    for edge in axis.edges() {
        for end in [edge.segment.a, edge.segment.b] {
            assert!(end.length() < 1e-9);
        }
    }
}

#[test]
fn scale_and_place_do_not_matter() {
    let reference = Ellipse::new(3.0, 1.0).unwrap().dense(100).unwrap();
    let lfs = MeasuredCurve::new(reference, Estimator::Voronoi).unwrap();
    for scale in [1e-9, 1e9] {
        let moved = Ellipse::new(3.0 * scale, scale).unwrap();
        let moved = moved.dense(100).unwrap();
        let points = moved
            .points()
            .iter()
            .map(|p| *p + DVec2::new(7.0, 5.0) * scale);
        let (params, parts) = (moved.params().to_vec(), moved.components().to_vec());
        let moved = DenseCurve::new(points.collect(), params, parts).unwrap();
        let moved = MeasuredCurve::new(moved, Estimator::Voronoi).unwrap();
        for (a, b) in lfs.lfs().values().iter().zip(moved.lfs().values()) {
            assert!((a * scale / b - 1.0).abs() < 1e-8);
        }
    }
}

#[test]
fn jumps_of_curvature_do_not_make_lfs_too_large() {
    use curvecrust_medial_axis::measure;
    // Curvature jumps at the joins of its Béziers, where branches of the axis end.
    let curve = curvecrust_testing::fixtures::curve("violin");
    let measured = measure(&curve).unwrap();
    let eight = vec![8; measured.dense().len()];
    let fine = measured.dense().refined(&curve, &eight).unwrap();
    let fine = MeasuredCurve::new(fine, Estimator::Voronoi).unwrap();
    // Every eighth of the finer points is one of the others.
    for (i, lfs) in measured.lfs().values().iter().enumerate() {
        assert!(lfs / fine.lfs().at(8 * i) < 1.005, "{i}");
    }
}
