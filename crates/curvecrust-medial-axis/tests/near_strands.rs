//! Long strands that are near each other: few points give their axis, and the same lfs.
#![allow(clippy::unwrap_used, reason = "a test may panic")]

use curvecrust_curve::{BezierPath, CubicBezier, Curve};
use curvecrust_geometry::DVec2;
use curvecrust_medial_axis::{
    Discretisation, Estimator, MeasureOptions, MeasuredCurve, MedialAxisError, measure,
    measure_axis, measure_with,
};

/// A path through points, with the derivatives there.
fn path(of: impl Fn(f64) -> DVec2, from: f64, to: f64, pieces: u32, closed: bool) -> BezierPath {
    let width = (to - from) / f64::from(pieces);
    let tiny = 1e-5 * width;
    let slope = |t: f64| (of(t + tiny) - of(t - tiny)) / (2.0 * tiny);
    let at = |i: u32| {
        let i = if closed { i % pieces } else { i };
        from + f64::from(i) * width
    };
    let segment = |i: u32| {
        let (a, b) = (at(i), at(i + 1));
        let (start, end) = (of(a), of(b));
        let third = width / 3.0;
        CubicBezier::new([start, start + slope(a) * third, end - slope(b) * third, end])
    };
    BezierPath::new((0..pieces).map(segment).collect(), closed)
}

fn closed(of: impl Fn(f64) -> DVec2, pieces: u32) -> BezierPath {
    path(of, 0.0, std::f64::consts::TAU, pieces, true)
}

/// Curves whose strands are `gap` apart.
fn curves(gap: f64) -> Vec<(&'static str, Curve)> {
    let on = |radius: f64| move |t: f64| DVec2::from_angle(t) * radius;
    let ellipse = |a: f64, b: f64| move |t: f64| DVec2::new(a * t.cos(), b * t.sin());
    let wave = |y: f64| move |x: f64| DVec2::new(x, y + 0.3 * (2.0 * x).sin());
    let line = |y: f64, slope: f64| move |x: f64| DVec2::new(x, y + slope * x);
    let spiral = move |t: f64| DVec2::from_angle(t) * (0.5 + gap * t / std::f64::consts::TAU);
    let turns = 6.0 * std::f64::consts::TAU;
    let flower =
        |size: f64| move |t: f64| DVec2::from_angle(t) * size * (1.0 + 0.2 * (5.0 * t).cos());
    let rings = (0..4).map(|i| closed(on(1.0 + gap * f64::from(i)), 96 + i));
    let sets = vec![
        ("rings", rings.collect()),
        (
            "ellipses that diverge",
            vec![
                closed(ellipse(2.0, 1.0), 80),
                closed(ellipse(2.0 + gap, 1.0 + 9.0 * gap), 103),
            ],
        ),
        (
            "waves",
            vec![
                path(wave(0.0), 0.0, 5.0, 64, false),
                path(wave(gap), -0.3, 4.0, 47, false),
            ],
        ),
        (
            "a slit that opens",
            vec![
                path(line(0.0, 0.0), 0.0, 4.0, 2, false),
                path(line(gap, 0.05), 0.0, 4.0, 3, false),
            ],
        ),
        (
            "a strand that ends between two",
            vec![
                path(line(-gap, 0.0), 0.0, 4.0, 3, false),
                path(line(0.1 * gap, 0.0), -1.0, 2.2, 2, false),
                path(line(gap, 0.0), 0.0, 4.0, 2, false),
            ],
        ),
        ("spiral", vec![path(spiral, 0.0, turns, 240, false)]),
        (
            "flowers",
            vec![closed(flower(1.0), 160), closed(flower(1.0 + gap), 173)],
        ),
    ];
    let curve = |(name, paths)| (name, Curve::new(paths).unwrap());
    sets.into_iter().map(curve).collect()
}

/// Compared with the Voronoi diagram of points that are dense everywhere.
#[test]
fn lfs_is_that_of_points_that_are_dense_everywhere() {
    let discretisation = Discretisation::Adaptive { gap_to_lfs: 0.06 };
    let options = MeasureOptions {
        discretisation,
        ..MeasureOptions::default()
    };
    for (name, curve) in curves(0.0015) {
        let measured = measure_with(&curve, &options).unwrap();
        let dense = MeasuredCurve::new(measured.dense().clone(), Estimator::Voronoi).unwrap();
        let (axis, _) = measure_axis(&curve, &options).unwrap();
        let ratios = measured.lfs().values().iter().zip(dense.lfs().values());
        let ratios: Vec<f64> = ratios.map(|(a, b)| a / b).collect();
        let least = ratios.iter().copied().fold(f64::INFINITY, f64::min);
        let greatest = ratios.iter().copied().fold(0.0, f64::max);
        println!(
            "{name}: {} and {} points, {least} to {greatest}",
            ratios.len(),
            axis.len()
        );
        assert!(
            least > 0.997 && greatest < 1.003,
            "{name}: {least} to {greatest}"
        );
    }
}

#[test]
fn strands_that_cross_at_a_tiny_angle_are_found() {
    let ellipse = |a: f64, b: f64| move |t: f64| DVec2::new(a * t.cos(), b * t.sin());
    for off in [1e-3, 1e-4, 1e-5] {
        let paths = vec![
            closed(ellipse(2.0, 1.0), 20),
            closed(ellipse(2.0 + off, 1.0 - off), 26),
        ];
        let error = measure(&Curve::new(paths).unwrap()).unwrap_err();
        println!("{error}");
        assert!(matches!(error, MedialAxisError::Crossing { .. }), "{error}");
    }
}

/// With gaps a hundred times smaller, the axis takes about ten times as many points.
#[test]
fn an_axis_between_near_strands_takes_few_points() {
    for ((name, wide), (_, narrow)) in curves(1e-3).into_iter().zip(curves(1e-5)) {
        let pieces = [wide, narrow].map(|curve| {
            let (axis, _) = measure_axis(&curve, &MeasureOptions::default()).unwrap();
            axis.len()
        });
        println!("{name}: {pieces:?}");
        assert!(pieces[1] < 20 * pieces[0], "{name}: {pieces:?}");
    }
}

/// The diagonals inside of two rounded squares: strands that face each other on one side are far
/// from something on the other.
#[test]
fn what_is_far_from_near_strands_is_as_precise_as_ever() {
    let square = |size: f64, radius: f64| {
        let s = size - radius;
        let r = format!("A {radius} {radius} 0 0 1");
        format!(
            "M {s} {size} H -{s} {r} -{size} {s} V -{s} {r} -{s} -{size} H {s} {r} {size} -{s} \
             V {s} {r} {s} {size} Z"
        )
    };
    let d = square(1.0, 0.3) + &square(0.999, 0.299);
    let curve = Curve::from_path_data(&d).unwrap();
    let (axis, _) = measure_axis(&curve, &MeasureOptions::default()).unwrap();
    let mut inside = 0;
    for p in axis.edges().map(|edge| edge.segment.a) {
        if p.abs().max_element() < 0.9 {
            inside += 1;
            assert!((p.x.abs() - p.y.abs()).abs() < 1e-4, "{p}");
            assert!(p.x.abs() < 0.7 + 1e-4, "{p}");
        }
    }
    assert!(inside > 100, "{inside}");
    assert!(axis.len() < 10_000, "{}", axis.len());
}
