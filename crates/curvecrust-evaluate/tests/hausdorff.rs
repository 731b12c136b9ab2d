//! The bounds against closed forms and brute force.
#![allow(clippy::unwrap_used, reason = "a test may panic")]

use curvecrust_curve::Curve;
use curvecrust_evaluate::{Bounds, Reference, hausdorff};
use curvecrust_geometry::{DVec2, Edge, EdgeSet, PointSet, Segment};
use proptest::prelude::*;

const CIRCLE: &str = "M 1 0 A 1 1 0 0 1 -1 0 A 1 1 0 0 1 1 0 Z";

fn ring(points: &PointSet) -> EdgeSet {
    let ids: Vec<_> = points.ids().collect();
    let edge = |i: usize| Edge::new(ids[i], ids[(i + 1) % ids.len()]);
    EdgeSet::new(ids.len(), (0..ids.len()).filter_map(edge))
}

fn assert_holds(bounds: Bounds, truth: f64, tolerance: f64) {
    let Bounds { lower, upper } = bounds;
    assert!(
        lower <= truth && truth <= upper,
        "{truth} not in {bounds:?}"
    );
    assert!(upper - lower <= 2.0 * tolerance, "{bounds:?}");
}

#[test]
fn inscribed_regular_polygons() {
    let circle = Curve::from_path_data(CIRCLE).unwrap();
    for n in [3, 4, 7, 20] {
        let at = |i: usize| DVec2::from_angle(std::f64::consts::TAU * i as f64 / n as f64);
        let points = PointSet::new((0..n).map(at).collect()).unwrap();
        // Béziers approximate a circle to 3e-4.
        let tolerance = 1e-3;
        let found = hausdorff(&circle, &points, &ring(&points), tolerance);
        let sagitta = 1.0 - (std::f64::consts::PI / n as f64).cos();
        assert_holds(found.distance(), sagitta, tolerance);
        assert_holds(found.curve_to_polygon, sagitta, tolerance);
    }
}

/// The chords of a coarse reference lie inside of the circle by up to the flatness, which the
/// bounds have to make up for, on either side.
#[test]
fn bounds_hold_whatever_the_flatness() {
    let circle = Curve::from_path_data(CIRCLE).unwrap();
    for flatness in [0.05, 0.02, 0.005] {
        let reference = Reference::of_curve(&circle, flatness);
        for radius in [0.5, 0.8, 1.3] {
            let at = |i| radius * DVec2::from_angle(std::f64::consts::TAU * f64::from(i) / 3e3);
            let points = PointSet::new((0..3000).map(at).collect()).unwrap();
            let found = reference.distances(&points, &ring(&points), 1e-3);
            for bounds in [
                found.hausdorff.curve_to_polygon,
                found.hausdorff.polygon_to_curve,
                found.rms.curve_to_polygon,
                found.rms.polygon_to_curve,
            ] {
                // Béziers approximate a circle to 3e-4.
                let widened = Bounds {
                    lower: bounds.lower - 3e-4,
                    upper: bounds.upper + 3e-4,
                };
                assert_holds(widened, (radius - 1.0).abs(), flatness + 1e-3);
            }
        }
    }
}

#[test]
fn the_extent_is_the_larger_side() {
    let corners = [[-1.0, 2.0], [2.0, 2.0], [2.0, 9.0]].map(DVec2::from);
    let sides = corners.windows(2).map(|p| Segment::new(p[0], p[1]));
    assert!((Reference::of_segments(sides).extent() - 7.0).abs() < 1e-15);
    assert!(Reference::of_segments([]).extent() <= 0.0);
}

#[test]
fn a_stray_edge_and_a_missing_one_show_in_their_own_direction() {
    let circle = Curve::from_path_data(CIRCLE).unwrap();
    let at = |i: usize| DVec2::from_angle(std::f64::consts::TAU * i as f64 / 64.0);
    let points = PointSet::new((0..64).map(at).collect()).unwrap();
    let ids: Vec<_> = points.ids().collect();
    let whole = ring(&points);
    let diameter = Edge::new(ids[0], ids[32]).unwrap();
    let strayed = EdgeSet::new(64, whole.edges().iter().copied().chain([diameter]));
    let found = hausdorff(&circle, &points, &strayed, 1e-3);
    assert_holds(found.polygon_to_curve, 1.0, 2e-3);
    assert!(found.curve_to_polygon.upper < 0.01);

    let gap = Edge::new(ids[0], ids[1]).unwrap();
    let missed = EdgeSet::new(64, whole.edges().iter().copied().filter(|&e| e != gap));
    let found = hausdorff(&circle, &points, &missed, 1e-3);
    let half_gap = 2.0 * (std::f64::consts::PI / 128.0).sin();
    assert_holds(found.curve_to_polygon, half_gap, 2e-3);
    assert!(found.polygon_to_curve.upper < 0.01);
}

/// It grows with the extent.
#[test]
fn a_tolerance_is_at_least_1e_7_of_the_extent() {
    for scale in [1.0, 1024.0] {
        let data = format!("M 0 0 C 0 {scale} {scale} {scale} {} 0", 2.0 * scale);
        let curve = Curve::from_path_data(&data).unwrap();
        let points = vec![
            DVec2::ZERO,
            DVec2::new(scale, scale),
            DVec2::new(2.0 * scale, 0.0),
        ];
        let points = PointSet::new(points).unwrap();
        let with = |tolerance: f64| hausdorff(&curve, &points, &ring(&points), tolerance);
        let least = 1e-7 * curve.extent();
        assert_eq!(with(0.0), with(least));
        assert_ne!(with(0.0), with(2.0 * least));
    }
}

#[test]
fn nothing_is_infinitely_far() {
    let circle = Curve::from_path_data(CIRCLE).unwrap();
    let found = hausdorff(&circle, &PointSet::default(), &EdgeSet::default(), 1e-3);
    assert!(found.distance().lower.is_infinite());
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]
    #[test]
    fn bounds_bracket_brute_force(
        ends in prop::collection::vec((-2.0..2.0f64, -2.0..2.0f64), 3..8),
        control in prop::array::uniform8(-2.0..2.0f64),
    ) {
        let points = ends.iter().map(|&(x, y)| DVec2::new(x, y)).collect();
        let points = PointSet::merging_duplicates(points).unwrap().points;
        let edges = ring(&points);
        let c = control;
        let d = format!("M {} {} C {} {} {} {} {} {}", c[0], c[1], c[2], c[3], c[4], c[5], c[6], c[7]);
        // A cusp is no smooth curve: another is drawn in its place.
        let curve = Curve::from_path_data(&d);
        prop_assume!(curve.is_ok());
        let curve = curve.unwrap();
        let tolerance = 1e-3 * curve.extent();
        let found = hausdorff(&curve, &points, &edges, tolerance);

        let bezier = &curve.components()[0].segments()[0];
        let on_curve: Vec<DVec2> = (0..=2000).map(|i| bezier.point(f64::from(i) / 2000.0)).collect();
        let sides: Vec<Segment> = edges
            .edges()
            .iter()
            .map(|e| Segment::new(points[e.a()], points[e.b()]))
            .collect();
        let to_polygon = |p: &DVec2| {
            sides.iter().map(|s| s.distance(*p)).fold(f64::INFINITY, f64::min)
        };
        let to_curve = |p: DVec2| {
            on_curve.iter().map(|q| q.distance(p)).fold(f64::INFINITY, f64::min)
        };
        let farthest = on_curve.iter().map(to_polygon).fold(0.0, f64::max);
        let strayed = sides
            .iter()
            .flat_map(|s| (0..=400).map(|i| s.a.lerp(s.b, f64::from(i) / 400.0)))
            .map(to_curve)
            .fold(0.0, f64::max);
        // Brute force looks at points, at most this far from the true extremes.
        let step = on_curve.windows(2).map(|w| w[0].distance(w[1])).fold(0.0, f64::max);
        let side = sides.iter().map(|s| s.length() / 400.0).fold(0.0, f64::max);
        prop_assert!(farthest <= found.curve_to_polygon.upper + 1e-12);
        prop_assert!(found.curve_to_polygon.lower <= farthest + step);
        prop_assert!(strayed <= found.polygon_to_curve.upper + step);
        prop_assert!(found.polygon_to_curve.lower <= strayed + side + 1e-12);
        let Bounds { lower, upper } = found.distance();
        prop_assert!(upper - lower <= 2.0 * tolerance);
    }
}
