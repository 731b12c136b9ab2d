//! Curves that have no lfs, each refused with its place.
#![allow(clippy::unwrap_used, reason = "a test may panic")]

use curvecrust_curve::Curve;
use curvecrust_medial_axis::{
    Discretisation, MeasureOptions, MeasuredCurve, MedialAxisError, measure_with,
};

const ADAPTIVE: Discretisation = Discretisation::Adaptive { gap_to_lfs: 0.05 };

fn by(curve: &Curve, discretisation: Discretisation) -> Result<MeasuredCurve, MedialAxisError> {
    let options = MeasureOptions {
        discretisation,
        ..MeasureOptions::default()
    };
    measure_with(curve, &options)
}

fn refusal(d: &str, discretisation: Discretisation) -> MedialAxisError {
    let curve = Curve::from_path_data(d).unwrap();
    by(&curve, discretisation).unwrap_err()
}

#[test]
fn crossing_curves() {
    // A line through a circle of radius 2.
    let d = "M 2 0 A 2 2 0 0 1 -2 0 A 2 2 0 0 1 2 0 Z M 0.1 -5 L 0.3 5";
    for discretisation in [ADAPTIVE, Discretisation::PerSegment(300)] {
        let error = refusal(d, discretisation);
        let MedialAxisError::Crossing { at, components } = error else {
            panic!("{error}");
        };
        assert!((at.length() - 2.0).abs() < 1e-2, "{at}");
        assert!(at.x > 0.13 && at.x < 0.25, "{at}");
        assert!(components == [0, 1] || components == [1, 0]);
    }
}

#[test]
fn a_curve_that_crosses_itself() {
    // A loop whose ends run on past each other.
    let d = "M -1 -0.3 C 5 3 -5 3 1.1 -0.4";
    let error = refusal(d, ADAPTIVE);
    let MedialAxisError::Crossing { at, components } = error else {
        panic!("{error}");
    };
    assert!(at.x.abs() < 0.2 && at.y < 1.0, "{at}");
    assert_eq!(components, [0, 0]);
}

#[test]
fn a_crossing_at_a_dense_point_is_a_touch() {
    // A figure of eight that crosses at the origin, where two segments begin.
    let d = "M 0 0 C 1 1 3 1 3 0 C 3 -1 1 -1 0 0 C -1 1 -3 1 -3 0 C -3 -1 -1 -1 0 0 Z";
    let error = refusal(d, ADAPTIVE);
    assert!(
        matches!(error, MedialAxisError::Touching { at, .. } if at.length() < 1e-2),
        "{error}"
    );
}

#[test]
fn curves_that_touch() {
    // Two circles of radius 1 that touch at the origin.
    let d = "M 0 0 A 1 1 0 0 1 -2 0 A 1 1 0 0 1 0 0 Z M 2 0 A 1 1 0 0 1 0 0 A 1 1 0 0 1 2 0 Z";
    let error = refusal(d, ADAPTIVE);
    assert!(
        matches!(error, MedialAxisError::Touching { at, .. } if at.length() < 1e-2),
        "{error}"
    );
}

#[test]
fn curves_drawn_twice() {
    let line = "M 0 0 L 7 3";
    let part_of_it = "M 0.7 0.3 L 6.3 2.7";
    let error = refusal(&format!("{line} {part_of_it}"), ADAPTIVE);
    assert!(
        matches!(
            error,
            MedialAxisError::Touching { .. } | MedialAxisError::Crossing { .. }
        ),
        "{error}"
    );
    let same = refusal(&format!("{line} {line}"), ADAPTIVE);
    assert!(matches!(same, MedialAxisError::Touching { .. }), "{same}");
}

#[test]
fn curves_too_near_for_their_points() {
    // Two lines 0.01 apart, each with ten points on a length of 10, half a gap apart.
    let error = refusal(
        "M 0 0 H 10 M 0.5 0.01 H 10.5",
        Discretisation::PerSegment(9),
    );
    assert!(
        matches!(error, MedialAxisError::TooCoarse { .. }),
        "{error}"
    );
}

#[test]
fn ratios_out_of_range() {
    for bad in [0.0, -1.0, 1.5, f64::NAN] {
        let discretisation = Discretisation::Adaptive { gap_to_lfs: bad };
        let error = refusal("M 0 0 H 10", discretisation);
        assert!(
            error
                .to_string()
                .starts_with(&format!("gap_to_lfs is {bad}")),
            "{error}"
        );
    }
}

#[test]
fn more_points_than_the_limit() {
    let error = refusal("M 0 0 H 10", Discretisation::PerSegment(u32::MAX));
    assert!(matches!(error, MedialAxisError::Dense(_)), "{error}");
}

#[test]
fn a_lone_segment_has_no_axis() {
    let curve = Curve::from_path_data("M 0 0 L 7 3").unwrap();
    for discretisation in [ADAPTIVE, Discretisation::PerSegment(300)] {
        let measured = by(&curve, discretisation).unwrap();
        assert!(measured.lfs().values().iter().all(|lfs| lfs.is_infinite()));
    }
}

#[test]
fn a_tip_that_asks_for_points_without_end() {
    // The first segment bends so sharply at its start that no points are dense there.
    let d = "M 0 -5937499999.999 C 0.0008869949227792841 -5937499999.999461 3e9 -59375e5 \
             3e9 -59375e5 C 3e9 -59375e5 6e9 -59375e5 6e9 -59375e5";
    for gap_to_lfs in [0.5, 0.05] {
        let error = refusal(d, Discretisation::Adaptive { gap_to_lfs });
        let MedialAxisError::Touching { at, .. } = error else {
            panic!("{error}");
        };
        assert!(at.x < 600.0, "{at}");
    }
}
