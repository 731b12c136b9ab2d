//! Corners and cusps are refused, joins that are nearly smooth become exactly smooth.
#![allow(
    clippy::unwrap_used,
    reason = "clippy knows helpers of tests as tests in modules only"
)]
#![allow(
    clippy::float_cmp,
    reason = "points that must be kept are kept bit by bit"
)]

use std::f64::consts::PI;

use approx::assert_relative_eq;
use curvecrust_curve::{BezierPath, CubicBezier, Curve, CurveError, CurveParam, SplitCurve};
use glam::DVec2;
use proptest::prelude::*;

fn v(x: f64, y: f64) -> DVec2 {
    DVec2::new(x, y)
}

/// Two segments that meet at the origin: into it along the x axis, out of it at an angle.
fn bent(degrees: f64) -> Vec<CubicBezier> {
    let out = DVec2::from_angle(degrees.to_radians());
    vec![
        CubicBezier::new([v(-3.0, 1.0), v(-2.0, 1.0), v(-1.0, 0.0), DVec2::ZERO]),
        CubicBezier::new([DVec2::ZERO, out * 2.0, v(4.0, 1.0), v(5.0, 1.0)]),
    ]
}

fn near(p: DVec2, q: DVec2, distance: f64) {
    assert!(p.distance(q) <= distance, "{p} and {q}");
}

fn lengths(bezier: &CubicBezier) -> [f64; 2] {
    let [p0, p1, p2, p3] = bezier.control_points();
    [p0.distance(p1), p2.distance(p3)]
}

/// The largest angle between the two tangents at a join.
fn roughness(curve: &Curve) -> f64 {
    let mut worst = 0.0f64;
    for component in curve.components() {
        let segments = component.segments();
        let open = usize::from(!component.is_closed());
        for k in open..segments.len() {
            let before = segments[(k + segments.len() - 1) % segments.len()];
            let (u, w) = (before.tangent(1.0), segments[k].tangent(0.0));
            worst = worst.max(u.perp_dot(w).abs().atan2(u.dot(w)));
        }
    }
    worst
}

#[test]
fn joins_below_one_degree_become_smooth_with_ends_and_lengths_kept() {
    for degrees in [-0.99, -1e-6, 0.0, 1e-9, 0.5, 0.99] {
        let given = bent(degrees);
        let curve = Curve::new(vec![BezierPath::new(given.clone(), false)]).unwrap();
        let smooth = curve.components()[0].segments();
        assert!(roughness(&curve) < 1e-12, "{degrees}");
        for (before, after) in given.iter().zip(smooth) {
            assert_eq!(before.start(), after.start());
            assert_eq!(before.end(), after.end());
            for (a, b) in lengths(before).into_iter().zip(lengths(after)) {
                assert_relative_eq!(a, b, epsilon = 1e-14);
            }
        }
        // Both turned by half of the angle; the handles at the outer ends are as they were.
        let tangent = smooth[0].tangent(1.0);
        assert_relative_eq!(
            tangent.to_angle(),
            degrees.to_radians() / 2.0,
            epsilon = 1e-14
        );
        assert_eq!(smooth[0].control_points()[1], given[0].control_points()[1]);
        assert_eq!(smooth[1].control_points()[2], given[1].control_points()[2]);
    }
}

#[test]
fn joins_from_one_degree_on_are_corners() {
    for degrees in [1.01, -45.0, 90.0, 179.0] {
        let error = Curve::new(vec![BezierPath::new(bent(degrees), false)]).unwrap_err();
        let CurveError::Corners(corners) = error else {
            panic!("{error}");
        };
        let [corner] = corners[..] else {
            panic!("{corners:?}");
        };
        assert_eq!((corner.component, corner.segment), (0, 1));
        assert_eq!(corner.at, DVec2::ZERO);
        assert_relative_eq!(corner.angle_deg, degrees.abs(), epsilon = 1e-9);
    }
}

#[test]
fn every_corner_is_named() {
    let error = Curve::from_path_data("M0 0 H 4 V 3 Z M 10 0 C 10 4 16 4 16 0 M 20 0 H 21 V 1")
        .unwrap_err();
    let CurveError::Corners(corners) = &error else {
        panic!("{error}");
    };
    let places: Vec<_> = corners.iter().map(|c| (c.component, c.segment)).collect();
    assert_eq!(places, [(0, 0), (0, 1), (0, 2), (2, 1)]);
    let text = error.to_string();
    for place in ["at (0, 0)", "at (4, 0)", "at (4, 3)", "at (21, 0)"] {
        assert!(text.contains(place), "{text}");
    }
}

#[test]
fn handles_without_length_take_their_tangent_from_the_next_control_point() {
    let [a, b] = [v(0.0, 0.0), v(4.0, 0.0)];
    let no_start = CubicBezier::new([a, a, v(1.0, 2.0), b]);
    near(no_start.tangent(0.0), v(1.0, 2.0).normalize(), 1e-15);
    near(no_start.tangent(1e-9), v(1.0, 2.0).normalize(), 1e-8);
    let nothing = CubicBezier::new([a, a, b, b]);
    assert_eq!(nothing.tangent(0.0), DVec2::X);
    assert_eq!(nothing.tangent(1.0), DVec2::X);
    assert_eq!(CubicBezier::new([a, b, b, b]).tangent(1.0), DVec2::X);
}

#[test]
fn a_segment_without_a_handle_keeps_its_shape_and_the_other_turns() {
    let out = DVec2::from_angle(0.01);
    let given = vec![
        bent(0.0)[0],
        CubicBezier::new([DVec2::ZERO, DVec2::ZERO, out * 2.0, v(5.0, 1.0)]),
    ];
    let curve = Curve::new(vec![BezierPath::new(given.clone(), false)]).unwrap();
    assert!(roughness(&curve) < 1e-12);
    assert_eq!(curve.components()[0].segments()[1], given[1]);
}

#[test]
fn a_segment_without_one_handle_stays_smooth_at_both_ends() {
    // The control point near the end of the second segment gives its tangent at both ends.
    let out = DVec2::from_angle(0.01);
    let end = v(5.0, 1.0);
    let into = (end - out * 2.0).normalize();
    let given = vec![
        bent(0.0)[0],
        CubicBezier::new([DVec2::ZERO, DVec2::ZERO, out * 2.0, end]),
        CubicBezier::new([
            end,
            end + DVec2::from_angle(0.01).rotate(into),
            v(8.0, 2.0),
            v(9.0, 2.0),
        ]),
    ];
    let curve = Curve::new(vec![BezierPath::new(given.clone(), false)]).unwrap();
    assert!(roughness(&curve) < 1e-12);
    assert_eq!(curve.components()[0].segments()[1], given[1]);
}

#[test]
fn two_segments_without_handles_at_a_bend_are_refused() {
    let given = vec![
        CubicBezier::new([v(-3.0, 0.0), v(-2.0, 0.1), DVec2::ZERO, DVec2::ZERO]),
        CubicBezier::new([DVec2::ZERO, DVec2::ZERO, v(2.0, -0.11), v(3.0, 0.0)]),
    ];
    let error = Curve::new(vec![BezierPath::new(given, false)]).unwrap_err();
    assert!(
        matches!(error, CurveError::NoHandle { segment: 1, .. }),
        "{error}"
    );
}

#[test]
fn straight_segments_are_bent_a_little_at_both_ends() {
    // A polygon of 720 sides: half a degree at each corner.
    let corner = |i: u32| DVec2::from_angle(2.0 * PI * f64::from(i % 720) / 720.0);
    let sides = (0..720).map(|i| CubicBezier::line(corner(i), corner(i + 1)));
    let curve = Curve::new(vec![BezierPath::new(sides.collect(), true)]).unwrap();
    assert!(roughness(&curve) < 1e-10, "{}", roughness(&curve));
    for (i, side) in (0..).zip(curve.components()[0].segments()) {
        assert_eq!(side.start(), corner(i));
        for t in [0.0, 0.2, 0.5, 0.9] {
            assert_relative_eq!(side.point(t).length(), 1.0, epsilon = 1e-5);
        }
    }
}

#[test]
fn straight_segments_written_without_handles_get_those_of_a_line() {
    let bare = Curve::from_path_data("M0 0 C0 0 3 0 3 0 C4 0 5 1 6 1").unwrap();
    let line = bare.components()[0].segments()[0];
    assert_eq!(line, CubicBezier::line(DVec2::ZERO, v(3.0, 0.0)));
}

#[test]
fn cusps_are_found_inside_segments() {
    let refused = |control: [DVec2; 4]| {
        let component = BezierPath::new(vec![CubicBezier::new(control)], false);
        match Curve::new(vec![component]) {
            Err(CurveError::Cusp { t, at, .. }) => Some((t, at)),
            Ok(_) => None,
            Err(error) => panic!("{error}"),
        }
    };
    // The handles cross: B'(1/2) = 0.
    let (t, at) = refused([v(0.0, 0.0), v(1.0, 1.0), v(0.0, 1.0), v(1.0, 0.0)]).unwrap();
    assert_relative_eq!(t, 0.5, epsilon = 1e-6);
    near(at, v(0.5, 0.75), 1e-6);
    // A straight segment that doubles back.
    assert!(refused([v(0.0, 0.0), v(3.0, 0.0), v(-2.0, 0.0), v(1.0, 0.0)]).is_some());
    assert!(refused([v(0.0, 0.0), v(2.0, 0.0), v(2.0, 0.0), v(1.0, 0.0)]).is_some());
    // A tight turn, a loop, and ends without handles are none.
    assert!(refused([v(0.0, 0.0), v(1.0, 1.0), v(0.01, 1.0), v(1.0, 0.0)]).is_none());
    assert!(refused([v(0.0, 0.0), v(2.0, 1.0), v(-1.0, 1.0), v(1.0, 0.0)]).is_none());
    assert!(refused([v(0.0, 0.0), v(0.0, 0.0), v(1.0, 1.0), v(2.0, 0.0)]).is_none());
    assert!(refused([v(0.0, 0.0), v(1.0, 1.0), v(2.0, 0.0), v(2.0, 0.0)]).is_none());
    assert!(refused([v(0.0, 0.0), v(0.0, 0.0), v(2.0, 0.0), v(2.0, 0.0)]).is_none());
}

#[test]
fn a_lone_closed_segment_must_be_smooth_where_it_closes() {
    let drop = "M0 0 C 2 1 2 -1 0 0 Z";
    let error = Curve::from_path_data(drop).unwrap_err();
    assert!(
        matches!(&error, CurveError::Corners(corners) if corners[0].segment == 0),
        "{error}"
    );
    // A cubic alone has its ends in line only if it is a loop that turns by 180 degrees or more;
    // here two make an egg.
    let egg = Curve::from_path_data("M0 0 C 0 2 3 2 3 0 C 3 -1.999 0.001 -2 0 0").unwrap();
    assert!(egg.components()[0].is_closed());
    assert!(roughness(&egg) < 1e-12);
}

#[test]
fn tangents_are_unit_derivatives() {
    let curve = Curve::from_path_data("M0 0 C0 1 1 2 2 2 S4 3 4 4").unwrap();
    for (segment, t) in [(0, 0.0), (0, 0.3), (1, 0.5), (1, 1.0)] {
        let at = CurveParam {
            component: 0,
            segment,
            t,
        };
        let bezier = curve.components()[0].segments()[segment as usize];
        near(curve.tangent(at), bezier.derivative(t).normalize(), 1e-15);
    }
}

proptest! {
    #[test]
    fn whatever_is_accepted_is_smooth(
        knots in prop::collection::vec((0.5f64..2.0, -0.008f64..0.008, 0.1f64..0.5), 3..12),
        scale in prop::sample::select(vec![1e-9, 1.0, 1e9]),
    ) {
        // A star-shaped closed chain whose handles miss their common line by below one degree.
        let n = knots.len();
        let at = |i: usize| {
            let (r, off, arm) = knots[i % n];
            let u = 2.0 * PI * (i % n) as f64 / n as f64;
            let tangent = DVec2::from_angle(u + PI / 2.0) * (arm * scale);
            (DVec2::from_angle(u) * (r * scale), DVec2::from_angle(off).rotate(tangent), tangent)
        };
        let segments = (0..n).map(|i| {
            let ((p, out, _), (q, _, into)) = (at(i), at(i + 1));
            CubicBezier::new([p, p + out, q - into, q])
        });
        let curve = Curve::new(vec![BezierPath::new(segments.collect(), true)]);
        if let Ok(curve) = curve {
            prop_assert!(roughness(&curve) < 1e-12);
        }
    }
}

/// Found in an icon: no handle can take the angle of 0.29 degrees away.
#[test]
fn a_small_angle_without_handles_is_split() {
    let d = "M-3 0C-2 .1 0 0 0 0 0 0 2-.11 3 0";
    assert!(matches!(
        Curve::from_path_data(d),
        Err(CurveError::NoHandle { .. })
    ));
    let split = SplitCurve::from_path_data(d).unwrap();
    assert_eq!(split.corners().len(), 1);
    assert_eq!(split.pieces().components().len(), 2);
}
