//! The lfs of pieces that meet in corners, where it is known.
#![allow(clippy::unwrap_used, reason = "a test, its helpers included")]

use curvecrust_curve::SplitCurve;
use curvecrust_geometry::DVec2;
use curvecrust_medial_axis::{
    MeasurePiecesOptions, MeasuredCurve, MedialAxisError, measure_pieces_with,
};

fn by(split: &SplitCurve, gap_to_lfs: f64) -> Result<MeasuredCurve, MedialAxisError> {
    let options = MeasurePiecesOptions {
        gap_to_lfs,
        ..MeasurePiecesOptions::default()
    };
    measure_pieces_with(split, &options)
}

fn measured(d: &str) -> MeasuredCurve {
    by(&SplitCurve::from_path_data(d).unwrap(), 0.05).unwrap()
}

/// The lfs of a piece where its dense points are nearest to a place.
fn near(measured: &MeasuredCurve, piece: usize, at: DVec2) -> f64 {
    let range = measured.dense().components()[piece].range.clone();
    let distance = |&i: &usize| measured.dense().points()[i].distance(at);
    let nearest = range.min_by(|i, j| distance(i).total_cmp(&distance(j)));
    measured.lfs().at(nearest.unwrap())
}

fn assert_near(value: f64, expected: f64) {
    assert!(
        (value - expected).abs() < 0.01 * expected,
        "{value} for {expected}"
    );
}

#[test]
fn sides_of_a_bar_see_the_opposite_ones() {
    let bar = measured("M 0 0 H 10 V 1 H 0 Z");
    for (piece, expected) in [(0, 0.5), (1, 5.0), (2, 0.5), (3, 5.0)] {
        let range = bar.dense().components()[piece].range.clone();
        for i in range {
            assert_near(bar.lfs().at(i), expected);
        }
    }
}

#[test]
fn arms_see_each_other_away_from_their_corner() {
    // The top of a half disc is 1 from its diameter, and sqrt(2) from its corners. What is nearest
    // to a corner is the far half of the diameter, which is cut again.
    let half_disc = measured("M 0 0 A 1 1 0 0 1 2 0 Z");
    assert_near(near(&half_disc, 0, DVec2::new(1.0, -1.0)), 0.5);
    assert_near(near(&half_disc, 0, DVec2::ZERO), 0.5);
    // Two straight arms never do, but another curve counts for both.
    let vee = measured("M 0 4 L 0 0 L 4 0 M 2 -1 H 3");
    assert_near(near(&vee, 0, DVec2::ZERO), 5f64.sqrt() / 2.0);
    assert_near(near(&vee, 1, DVec2::new(2.5, 0.0)), 0.5);
    assert_near(near(&vee, 2, DVec2::new(2.5, -1.0)), 0.5);
}

#[test]
fn gaps_are_as_short_as_asked_for() {
    let frame = measured("M 0 0 H 6 V 6 H 0 Z M 1 1 H 5 V 5 H 1 Z");
    for i in 0..frame.dense().len() {
        if let Some(next) = frame.dense().next(i) {
            let gap = frame.dense().points()[i].distance(frame.dense().points()[next]);
            assert!(gap <= 0.05 * frame.lfs().at(i).min(frame.lfs().at(next)));
        }
    }
    assert_near(frame.lfs().minimum(), 0.5);
}

#[test]
fn pieces_that_touch_are_refused() {
    let crossing = SplitCurve::from_path_data("M 0 0 H 4 V 4 H 0 Z M 2 2 H 6 V 6 H 2 Z").unwrap();
    let error = by(&crossing, 0.05).unwrap_err();
    assert!(matches!(error, MedialAxisError::Touching { .. }), "{error}");
    let bar = SplitCurve::from_path_data("M 0 0 H 10 V 1 H 0 Z").unwrap();
    let error = by(&bar, 0.0).unwrap_err();
    assert!(matches!(error, MedialAxisError::GapToLfs(_)), "{error}");
}

#[test]
fn what_is_apart_has_the_lfs_that_it_has_alone() {
    let (ellipse, disc) = (
        "M 4 0 A 4 2 0 0 1 -4 0 A 4 2 0 0 1 4 0 Z",
        "M 5 0 A 2 2 0 0 1 1 0 Z",
    );
    let both = SplitCurve::from_path_data(&format!("{ellipse} {disc}")).unwrap();
    assert!(by(&both, 0.02).is_err());
    let found = by(&both.apart(), 0.02).unwrap();
    let mut values = found.lfs().values();
    for alone in [ellipse, disc] {
        let alone = SplitCurve::from_path_data(alone).unwrap();
        let alone = by(&alone, 0.02).unwrap();
        let (here, rest) = values.split_at(alone.dense().len());
        assert!(here == alone.lfs().values());
        values = rest;
    }
    assert!(values.is_empty());
}
