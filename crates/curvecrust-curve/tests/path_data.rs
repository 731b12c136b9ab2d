//! Path strings against known points, closed forms and dense sampling.
#![allow(
    clippy::unwrap_used,
    reason = "clippy knows helpers of tests as tests in modules only"
)]
#![allow(
    clippy::float_cmp,
    reason = "points that must be kept are kept bit by bit"
)]

use std::f64::consts::{PI, TAU};

use approx::{assert_abs_diff_eq, assert_relative_eq};
use curvecrust_curve::{BezierPath, CubicBezier, Curve, CurveError, CurveParam};
use glam::DVec2;
use proptest::prelude::*;

fn v(x: f64, y: f64) -> DVec2 {
    DVec2::new(x, y)
}

fn curve(d: &str) -> Curve {
    Curve::from_path_data(d).unwrap()
}

fn ends(curve: &Curve) -> Vec<DVec2> {
    let segments = curve.components().iter().flat_map(BezierPath::segments);
    segments.map(CubicBezier::end).collect()
}

#[test]
fn every_command_absolute_and_relative_ends_where_it_should() {
    // One direction throughout, so that everything is smooth.
    let absolute = curve("M1 2 L2 2 H3 C4 2 5 2 6 2 S7 2 8 2 Q9 2 10 2 T12 2 A0 1 0 0 0 13 2");
    let relative = curve("m1 2 l1 0 h1 c1 0 2 0 3 0 s1 0 2 0 q1 0 2 0 t2 0 a0 1 0 0 0 1 0");
    let expected = [2.0, 3.0, 6.0, 8.0, 10.0, 12.0, 13.0].map(|x| v(x, 2.0));
    assert_eq!(ends(&absolute), expected);
    assert_eq!(ends(&relative), expected);
    assert_eq!(ends(&curve("M 2,1 V 2 v 1")), [v(2.0, 2.0), v(2.0, 3.0)]);
}

#[test]
fn reflected_handles() {
    let cubic = curve("M0 0 C0 1 1 2 2 2 S4 3 4 4");
    assert_eq!(
        cubic.components()[0].segments()[1].control_points(),
        [v(2.0, 2.0), v(3.0, 2.0), v(4.0, 3.0), v(4.0, 4.0)]
    );
    // y = x (2 - x) / 2, then its mirror image.
    let quadratic = curve("M0 0 Q1 1 2 0 T4 0");
    let param = |segment, t| CurveParam {
        component: 0,
        segment,
        t,
    };
    assert_relative_eq!(quadratic.point(param(0, 0.25)).y, 0.375, epsilon = 1e-15);
    assert_relative_eq!(quadratic.point(param(1, 0.25)).y, -0.375, epsilon = 1e-15);
    // After another command, S has a first handle without length.
    let plain = curve("M0 0 H1 S2 0 3 0");
    let [p0, p1, ..] = plain.components()[0].segments()[1].control_points();
    assert_eq!(p0, p1);
}

#[test]
fn coordinates_keep_every_digit() {
    let curve = curve("M 1.2345678901234567 0 L 2.3456789012345678 0.1");
    let segment = curve.components()[0].segments()[0];
    assert_eq!(segment.start(), v(1.234_567_890_123_456_7, 0.0));
    assert_eq!(segment.end(), v(2.345_678_901_234_568, 0.1));
}

#[test]
fn subpaths_are_components_and_lone_moves_are_not() {
    let curve = curve("M9 9 M0 0 h1 m1 0 h1 M5 5 A1 1 0 0 1 7 5 A1 1 0 0 1 5 5 Z Z M3 3");
    let closed: Vec<_> = curve
        .components()
        .iter()
        .map(BezierPath::is_closed)
        .collect();
    assert_eq!(closed, [false, false, true]);
    assert_eq!(curve.components()[1].segments()[0].start(), v(2.0, 0.0));
    // After Z the next command starts at the start of the closed subpath.
    let after = Curve::from_path_data("M5 5 A1 1 0 0 1 7 5 A1 1 0 0 1 5 5 Z h1").unwrap();
    assert_eq!(after.components()[1].segments()[0].start(), v(5.0, 5.0));
}

/// A half circle of radius 1, and a second one that comes back up to a gap.
fn circle_with_gap(gap: f64, z: &str) -> Result<Curve, CurveError> {
    let d = format!("M 0 0 A 1 1 0 0 1 2 0 A 1 1 0 0 1 0 {gap} {z}");
    Curve::from_path_data(&d)
}

#[test]
fn ends_that_meet_within_a_millionth_close() {
    for (gap, closed) in [(0.0, true), (1.9e-6, true), (2.1e-6, false)] {
        let curve = circle_with_gap(gap, "").unwrap();
        let component = &curve.components()[0];
        assert_eq!(component.is_closed(), closed, "gap {gap}");
        let end = component.segments().last().unwrap().end();
        assert_eq!(end, if closed { DVec2::ZERO } else { v(0.0, gap) });
    }
    // With Z, a small gap is snapped too, and a larger one gets a straight segment.
    assert_eq!(
        circle_with_gap(1.9e-6, "Z").unwrap().components()[0]
            .segments()
            .len(),
        52
    );
    let hook = curve("M0 0 H4 A1 1 0 0 1 4 2 H0");
    assert!(!hook.components()[0].is_closed());
    let half = curve("M0 0 H4 A1 1 0 0 1 4 2 H0 A1 1 0 0 1 0 0");
    assert!(half.components()[0].is_closed());
    let straight = curve("M2 0 H4 A1 1 0 0 1 4 2 H0 A1 1 0 0 1 0 0 Z");
    let last = *straight.components()[0].segments().last().unwrap();
    assert_eq!((last.start(), last.end()), (v(0.0, 0.0), v(2.0, 0.0)));
}

#[test]
fn segments_of_zero_length_are_left_out() {
    let curve = curve("M0 0 h0 h1 l0 0 c0 0 0 0 0 0 h1 a1 1 0 0 0 0 0");
    assert_eq!(ends(&curve), [v(1.0, 0.0), v(2.0, 0.0)]);
}

#[test]
fn arcs_are_circles_and_ellipses() {
    // Centre (3, 1), half axes 4 and 2, turned by 30 degrees.
    let (centre, radii, axis) = (
        v(3.0, 1.0),
        v(4.0, 2.0),
        DVec2::from_angle(30f64.to_radians()),
    );
    let on = |u: f64| centre + axis.rotate(DVec2::from_angle(u) * radii);
    for (from, to, large, sweep) in [
        (0.2, 1.9, 0, 1),
        (0.2, 4.5, 1, 1),
        (1.9, 0.2, 0, 0),
        (4.5, 0.2, 1, 0),
    ] {
        let (p, q) = (on(from), on(to));
        let curve = curve(&format!(
            "M{},{} A4,2 30 {large} {sweep} {},{}",
            p.x, p.y, q.x, q.y
        ));
        let segments = curve.components()[0].segments();
        assert_eq!(
            (segments[0].start(), segments.last().unwrap().end()),
            (p, q)
        );
        for t in (0..=20).map(|i| f64::from(i) / 20.0) {
            for segment in segments {
                let unit = v(axis.x, -axis.y).rotate(segment.point(t) - centre) / radii;
                assert_abs_diff_eq!(unit.length(), 1.0, epsilon = 1e-7);
            }
        }
        let middle = (segments.len() as f64 / 2.0).floor();
        let share = middle / segments.len() as f64;
        let at = segments[segments.len() / 2].start();
        assert_relative_eq!(
            at.distance(on(from + (to - from) * share)),
            0.0,
            epsilon = 1e-9
        );
    }
}

#[test]
fn radii_that_are_too_small_are_scaled_up() {
    let curve = curve("M0 0 A 1e-3 1e-3 0 0 1 2 0");
    let (low, high) = curve.bounding_box();
    assert!(low.distance(v(0.0, -1.0)) < 1e-7);
    assert!(high.distance(v(2.0, 0.0)) < 1e-7);
}

#[test]
fn arcs_whose_ends_nearly_meet_are_short_or_a_whole_turn() {
    for (radius, chord) in [(1e3, 1e-5), (1.0, 1e-9), (1e4, 1e-6), (2.0, 1e-12)] {
        let arc = |flags: &str| curve(&format!("M0 0A{radius} {radius} 0 {flags} {chord} 0"));
        for sweep in [0, 1] {
            let (short, long) = (arc(&format!("0 {sweep}")), arc(&format!("1 {sweep}")));
            assert_relative_eq!(short.extent(), chord, max_relative = 1e-9);
            assert_relative_eq!(long.extent(), 2.0 * radius, max_relative = 1e-6);
        }
    }
    assert_eq!(ends(&curve("M0 0A1e200 1e200 0 0 1 1 0")), [v(1.0, 0.0)]);
    let beyond = Curve::from_path_data("M0 0A1e200 1 0 0 1 0 1");
    assert!(
        matches!(beyond, Err(CurveError::NotFinite { .. })),
        "{beyond:?}"
    );
}

#[test]
fn arcs_of_every_scale() {
    for scale in [1e-20, 1e-9, 1e9, 1e30] {
        let d = format!("M0 0 A{scale} {scale} 0 0 1 0 {} Z", 2.0 * scale);
        // A half disc has corners, and says so whatever its size.
        let error = Curve::from_path_data(&d).unwrap_err();
        let CurveError::Corners(corners) = error else {
            panic!("{error}");
        };
        assert_relative_eq!(corners[0].angle_deg, 90.0, epsilon = 1e-6);
    }
}

proptest! {
    #[test]
    fn any_arc_lies_on_its_ellipse(
        from in 0.0..TAU, turn in 0.001..6.2f64, ratio in 0.001f64..1.0, rotation in -400.0..400.0f64,
        forwards: bool,
    ) {
        let (radii, axis) = (v(1.0, ratio), DVec2::from_angle(rotation.to_radians()));
        let turn = if forwards { turn } else { -turn };
        let on = |u: f64| axis.rotate(DVec2::from_angle(u) * radii);
        let (p, q) = (on(from), on(from + turn));
        let (large, sweep) = (u8::from(turn.abs() > PI), u8::from(forwards));
        let d = format!("M{},{}A1 {ratio} {rotation} {large} {sweep} {},{}", p.x, p.y, q.x, q.y);
        let curve = curve(&d);
        let segments = curve.components()[0].segments();
        for i in 0..=20 {
            for segment in segments {
                let unit = v(axis.x, -axis.y).rotate(segment.point(f64::from(i) / 20.0)) / radii;
                prop_assert!((unit.length() - 1.0).abs() < 1e-7, "{d}");
            }
        }
        let length: f64 = segments.iter().map(|s| {
            let at = |t| v(axis.x, -axis.y).rotate(s.point(t)) / radii;
            at(0.0).angle_to(at(1.0)).abs()
        }).sum();
        prop_assert!((length - turn.abs()).abs() < 1e-6, "{d}: {length}");
    }

    #[test]
    fn the_bounding_box_is_tight(c in prop::array::uniform8(-10f64..10.0)) {
        let bezier = CubicBezier::new([v(c[0], c[1]), v(c[2], c[3]), v(c[4], c[5]), v(c[6], c[7])]);
        let (low, high) = bezier.bounding_box();
        let points = (0..=4000).map(|i| bezier.point(f64::from(i) / 4000.0));
        let (mut inner_low, mut inner_high) = (DVec2::INFINITY, DVec2::NEG_INFINITY);
        for p in points {
            inner_low = inner_low.min(p);
            inner_high = inner_high.max(p);
        }
        // Between samples at h = 1/4000 a coordinate rises by at most |B''| h²/8 < 1e-5.
        prop_assert!((inner_low - low).min_element() >= -1e-12);
        prop_assert!((inner_low - low).max_element() <= 1e-5);
        prop_assert!((high - inner_high).min_element() >= -1e-12);
        prop_assert!((high - inner_high).max_element() <= 1e-5);
    }

    #[test]
    fn derivatives_are_limits_of_differences(
        c in prop::array::uniform8(-10f64..10.0),
        t in 0.1f64..0.9,
    ) {
        let bezier = CubicBezier::new([v(c[0], c[1]), v(c[2], c[3]), v(c[4], c[5]), v(c[6], c[7])]);
        let h = 1e-4;
        let first = (bezier.point(t + h) - bezier.point(t - h)) / (2.0 * h);
        let second = (bezier.derivative(t + h) - bezier.derivative(t - h)) / (2.0 * h);
        prop_assert!(first.distance(bezier.derivative(t)) < 1e-4);
        prop_assert!(second.distance(bezier.second_derivative(t)) < 1e-4);
    }

    #[test]
    fn path_strings_never_panic(d in "[MmLlHhVvCcSsQqTtAaZz0-9eE.,+\\- ]{0,60}") {
        let _ = Curve::from_path_data(&d);
    }

    #[test]
    fn paths_by_the_grammar_never_panic(
        commands in prop::collection::vec(
            (prop::sample::select(b"MmLlHhVvCcSsQqTtAaZz".to_vec()), prop::array::uniform8(
                prop_oneof![-3i32..3, Just(i32::MAX)]
            )),
            0..12,
        ),
        exponent in prop::sample::select(vec![-400, -300, -150, -9, 0, 9, 150, 290, 299]),
    ) {
        let mut d = "M0,0".to_owned();
        for (command, numbers) in commands {
            let count = match command.to_ascii_lowercase() {
                b'z' => 0,
                b'h' | b'v' => 1,
                b'c' => 6,
                b's' | b'q' => 4,
                b'a' => 7,
                _ => 2,
            };
            d.push(char::from(command));
            for (i, n) in numbers.iter().take(count).enumerate() {
                let is_flag = count == 7 && (i == 3 || i == 4);
                d += &if is_flag { format!("{} ", n & 1) } else { format!("{n}e{exponent} ") };
            }
        }
        let _ = Curve::from_path_data(&d);
    }

    #[test]
    fn any_text_never_panics(text in any::<String>()) {
        let _ = Curve::from_path_data(&text);
        let _ = Curve::from_path_data(&format!("M0 0{text}"));
        let _ = Curve::from_svg(&text);
    }
}
