//! The triangulation against its definition.
#![allow(clippy::unwrap_used, reason = "a test may panic")]

use curvecrust_geometry::{DVec2, PointSet, in_circle, orient2d};
use curvecrust_voronoi::{Delaunay, brio_order};
use proptest::prelude::*;

fn set(coordinates: &[(f64, f64)]) -> PointSet {
    let points = coordinates.iter().map(|&(x, y)| DVec2::new(x, y)).collect();
    PointSet::merging_duplicates(points).unwrap().points
}

/// Coordinates that like to be collinear, cocircular or a few ulps apart.
fn nearly_degenerate() -> impl Strategy<Value = Vec<(f64, f64)>> {
    let coordinate = prop_oneof![
        (-4i32..4).prop_map(f64::from),
        (-2i64..3).prop_map(|ulps| 1.0 + f64::EPSILON * ulps as f64),
        -2.0..2.0f64,
    ];
    prop::collection::vec((coordinate.clone(), coordinate), 0..40)
}

/// The triangles by coordinates, so that they compare across orders of the points.
fn shapes(points: &PointSet) -> Vec<[(u64, u64); 3]> {
    let delaunay = Delaunay::new(points);
    let mut shapes: Vec<_> = delaunay
        .triangles()
        .map(|t| {
            let mut corners = t.map(|id| (points[id].x.to_bits(), points[id].y.to_bits()));
            corners.sort_unstable();
            corners
        })
        .collect();
    shapes.sort_unstable();
    shapes
}

proptest! {
    #[test]
    fn circumcircles_are_empty(coordinates in nearly_degenerate()) {
        let points = set(&coordinates);
        for triangle in Delaunay::new(&points).triangles() {
            let [a, b, c] = triangle.map(|id| points[id]);
            prop_assert!(orient2d(a, b, c) > 0.0);
            for &p in points.points() {
                prop_assert!(in_circle(a, b, c, p) <= 0.0);
            }
        }
    }

    #[test]
    fn edges_and_triangles_agree(coordinates in nearly_degenerate()) {
        let points = set(&coordinates);
        let delaunay = Delaunay::new(&points);
        let mut from_edges = 0;
        for edge in delaunay.edges() {
            let [a, b] = edge.ends.map(|id| points[id]);
            let [left, right] = edge.apexes.map(|id| id.map(|id| points[id]));
            prop_assert!(left.is_none_or(|p| orient2d(a, b, p) > 0.0));
            prop_assert!(right.is_none_or(|p| orient2d(a, b, p) < 0.0));
            for (apex, centre) in edge.apexes.iter().zip(delaunay.voronoi_edge(&edge)) {
                prop_assert_eq!(apex.is_some(), centre.is_some());
                from_edges += usize::from(apex.is_some());
            }
        }
        prop_assert_eq!(from_edges, 3 * delaunay.triangles().count());
        // Euler: V - E + F = 1 for a triangulated disc, a path on a line, or nothing at all.
        let (v, e, f) = (points.len(), delaunay.edges().count(), delaunay.triangles().count());
        prop_assert_eq!(v + f, e + usize::from(v > 0));
    }

    #[test]
    fn the_order_of_the_points_does_not_matter(
        coordinates in nearly_degenerate().prop_shuffle(),
    ) {
        let points = set(&coordinates);
        let mut sorted: Vec<_> = points.points().iter().map(|p| (p.x, p.y)).collect();
        sorted.sort_by(|a, b| a.partial_cmp(b).unwrap());
        prop_assert_eq!(shapes(&points), shapes(&set(&sorted)));
    }

    #[test]
    fn every_point_is_inserted_once(n in 0usize..3000) {
        let on_a_spiral = |i: usize| {
            let t = i as f64 * 0.1;
            DVec2::new(t * t.cos(), t * t.sin())
        };
        let points = PointSet::new((1..=n).map(on_a_spiral).collect()).unwrap();
        let mut order = brio_order(&points);
        order.sort_unstable();
        prop_assert!(order.into_iter().eq(points.ids()));
    }
}

#[test]
fn voronoi_vertices_of_the_largest_and_smallest_coordinates_are_finite() {
    let (small, large) = (PointSet::MIN_MAGNITUDE, PointSet::MAX_MAGNITUDE);
    let points = set(&[
        (0.0, 0.0),
        (large, small),
        (-large, small),
        (small, 0.0),
        (0.0, large),
    ]);
    let delaunay = Delaunay::new(&points);
    assert!(delaunay.triangles().count() > 0);
    assert!(delaunay.voronoi_vertices().iter().all(|v| v.is_finite()));
}

/// Spade would look at every point of the line for every other: a second, where this takes a
/// millisecond.
#[test]
fn points_on_a_line_are_joined_in_their_order() {
    let count = 20_000u32;
    let on_a_line = (0..count).map(|i| DVec2::new(f64::from(i * 7_919 % count), 0.0));
    let mut points: Vec<DVec2> = on_a_line.map(|p| DVec2::new(p.x, p.x / 4.0)).collect();
    let along = |points: &[DVec2]| {
        let set = PointSet::new(points.to_vec()).unwrap();
        let delaunay = Delaunay::new(&set);
        let steps = delaunay.edges().map(|e| {
            assert_eq!(
                (e.apexes, delaunay.voronoi_edge(&e)),
                ([None; 2], [None; 2])
            );
            let [a, b] = e.ends.map(|id| set[id].x);
            b - a
        });
        (
            delaunay.triangles().count(),
            steps.filter(|s| (s - 1.0).abs() < 0.5).count(),
        )
    };
    assert_eq!(along(&points), (0, points.len() - 1));

    // One point beside it, and every other makes a triangle with it.
    points.push(DVec2::new(0.0, 9.0));
    let set = PointSet::new(points).unwrap();
    assert_eq!(Delaunay::new(&set).triangles().count(), count as usize - 1);
}
