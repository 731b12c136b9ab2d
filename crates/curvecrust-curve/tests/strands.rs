//! Strokes that touch or cross: what is left of them is apart, and runs through every place.
#![allow(clippy::unwrap_used, reason = "a test may panic")]

use curvecrust_curve::{BezierPath, SplitCurve, strands};
use glam::DVec2;

/// Points along a component of pieces.
fn along(paths: &[BezierPath]) -> Vec<DVec2> {
    let segments = paths.iter().flat_map(BezierPath::segments);
    let points = segments.flat_map(|s| (0..=200).map(|i| s.point(f64::from(i) / 200.0)));
    points.collect()
}

/// Path data, how many strands are left, and how many places there are.
const TOUCHING: &[(&str, usize, usize)] = &[
    // A cross, an end on a line, on a corner, on an end, three lines through a point.
    ("M0 5H10M5 0V10", 3, 1),
    ("M0 5H10M5 5V10", 2, 1),
    ("M0 5L5 5L5 0M5 5L9 9", 2, 1),
    ("M0 5H5M5 5V10", 2, 1),
    ("M0 5H10M1 1L9 9M9 1L1 9", 5, 1),
    // A ring and a line across it, two rings that touch.
    ("M3 0A3 3 0 0 1 -3 0A3 3 0 0 1 3 0ZM-5 1H5", 4, 2),
    (
        "M3 0A3 3 0 0 1 -3 0A3 3 0 0 1 3 0ZM9 0A3 3 0 0 1 3 0A3 3 0 0 1 9 0Z",
        2,
        1,
    ),
    // A loop, and what touches nothing.
    ("M0 0C4 4 -2 4 2 0", 2, 1),
    ("M0 0H9M0 1H9", 2, 0),
];

#[test]
fn strands_are_apart() {
    for &(d, count, places) in TOUCHING {
        let split = SplitCurve::from_path_data(d).unwrap();
        let cut = strands(&split).unwrap();
        let components = cut.curve.components();
        assert_eq!(components.len(), count, "{d}");
        assert_eq!(cut.places.len(), places, "{d}");
        assert!(cut.left_out.is_empty(), "{d}");
        let pieces = cut.curve.pieces().components();
        let points = components.iter().map(|c| along(&pieces[c.range.clone()]));
        let points: Vec<Vec<DVec2>> = points.collect();
        for (i, a) in points.iter().enumerate() {
            for b in &points[..i] {
                let between = a.iter().flat_map(|p| b.iter().map(|q| p.distance(*q)));
                let nearest = between.fold(f64::INFINITY, f64::min);
                assert!(nearest > 0.7 * cut.gap, "{d}: {nearest} of {}", cut.gap);
            }
        }
        for place in &cut.places {
            let ends = pieces.iter().filter(|piece| {
                let segments = piece.segments();
                let ends = [segments[0].start(), segments[segments.len() - 1].end()];
                ends.iter().any(|end| end.distance(*place) < 1e-6 * cut.gap)
            });
            assert!(ends.count() >= 1, "{d}: no piece ends at {place}");
        }
    }
}
