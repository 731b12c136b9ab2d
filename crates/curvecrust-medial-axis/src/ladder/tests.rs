#![allow(clippy::unwrap_used, reason = "a test may panic")]

use super::*;

/// Rounded squares in rows: discs of many places touch the same other ones.
#[test]
fn no_place_comes_twice() {
    let square = |x: f64, y: f64| {
        format!(
            "M {} {y} a .5 .5 0 0 0 -.5 .5 v 1 a .5 .5 0 0 0 .5 .5 h 1 a .5 .5 0 0 0 .5 -.5 \
             v -1 a .5 .5 0 0 0 -.5 -.5 Z ",
            x + 0.5
        )
    };
    let places = (0..9).map(|i| (f64::from(i % 3), f64::from(i / 3)));
    let d: String = places
        .map(|(i, j)| square(3.0 * i + 4.0, 3.0 * j + 2.0))
        .collect();
    let curve = Curve::from_path_data(&d).unwrap();
    let start = DenseCurve::per_segment(&curve, 16).unwrap();
    for gap_to_radius in [0.02, 0.05, 0.09] {
        let facing = facing_points(&curve, &start, gap_to_radius, 1_000_000).unwrap();
        let dense = facing.unwrap().dense;
        let near = (0..dense.len()).filter(|&i| {
            let next = dense.next(i).unwrap();
            dense.points()[i].distance(dense.points()[next]) < 1e-9
        });
        assert_eq!(near.count(), 0);
    }
}
