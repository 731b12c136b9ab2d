//! Points that are hard on algorithms: every one of them answers, and rightly where the truth is
//! known.
//!
//! The same points at any size are measured by the program `adversarial` of the benches, which
//! prints how much more they cost than well-spread ones; here are so many of them that what is
//! quadratic is noticed. Against definitions by brute force they are tested in the contract of
//! `curvecrust-reconstruct`.

#![allow(clippy::unwrap_used, reason = "a test that fails panics")]

use curvecrust::DVec2;
use curvecrust::geometry::{Edge, EdgeSet, PointId, PointSet, PointSetError};
use curvecrust::reconstruct::{
    ALGORITHMS, Keep, Reconstruction, Reconstructor, ViolationReport, hnn_crust, one_step_crust,
};
use curvecrust_testing::hard_points::{
    HARD_POINTS, WELL_SPREAD, line, polygon, shuffled, sorted, spiral,
};
use curvecrust_testing::planted::consecutive_edges;
use curvecrust_testing::strategies::point_set as set;

/// The algorithms with a guarantee for curves.
fn guaranteed() -> impl Iterator<Item = &'static dyn Reconstructor> {
    let all = ALGORITHMS.iter().copied();
    all.filter(|algorithm| !algorithm.info().guarantees.is_empty())
}

/// The edges of a set whose points are those of `points` in another order.
fn edges_by_place(edges: &EdgeSet, from: &PointSet) -> Vec<[[u64; 2]; 2]> {
    let bits = |id: PointId| from[id].to_array().map(f64::to_bits);
    let mut places: Vec<_> = edges
        .edges()
        .iter()
        .map(|e| {
            let [a, b] = e.ends().map(bits);
            [a.min(b), a.max(b)]
        })
        .collect();
    places.sort_unstable();
    places
}

#[test]
fn lines_and_polygons_are_returned() {
    for n in [3, 4, 5, 6, 7, 12, 100, 5_000] {
        for scale in [1.0, 0.1, 2f64.powi(-80), 2f64.powi(150)] {
            let scaled = |points: Vec<DVec2>| set(points.iter().map(|p| p * scale).collect());
            for algorithm in guaranteed() {
                let name = algorithm.info().name;
                let on_a_line = scaled(line(n));
                assert_eq!(
                    algorithm.reconstruct(&on_a_line),
                    consecutive_edges(n, false),
                    "{name} {n}"
                );
                // Triangles and squares are no samples of a circle that the theorems know.
                if n > 6 {
                    let ring = scaled(polygon(n));
                    assert_eq!(
                        algorithm.reconstruct(&ring),
                        consecutive_edges(n, true),
                        "{name} {n}"
                    );
                }
            }
        }
    }
}

#[test]
fn a_spiral_is_one_curve() {
    let points = set(spiral(5_000));
    let truth = consecutive_edges(points.len(), false);
    assert_eq!(hnn_crust(&points), truth);
    for algorithm in guaranteed() {
        let found = algorithm.reconstruct(&points);
        let name = algorithm.info().name;
        assert_eq!(truth.difference(&found).count(), 0, "{name}");
        // Its ends may reach for the next arm.
        assert!(found.difference(&truth).count() <= 8, "{name}");
    }
}

#[test]
fn all_hard_points_are_answered_in_every_order() {
    for hard in HARD_POINTS {
        let given = (hard.points)(1_000);
        let reversed = given.iter().rev().copied().collect();
        let orders = [
            shuffled(given.clone()),
            reversed,
            sorted(given.clone(), |p| p.x),
        ];
        let points = set(given);
        assert!(points.len() > 900, "{}", hard.name);
        let others = orders.map(set);
        for algorithm in ALGORITHMS {
            let name = algorithm.info().name;
            let edges = algorithm.reconstruct(&points);
            assert_eq!(edges.vertex_count(), points.len());
            let places = edges_by_place(&edges, &points);
            for other in &others {
                let found = edges_by_place(&algorithm.reconstruct(other), other);
                assert!(found == places, "{name}: {}", hard.name);
            }
            ViolationReport::new(&points, &edges).unwrap();
            let chains = Reconstruction::new(&points, edges.clone()).unwrap();
            let covered: usize = chains.chains().iter().map(|c| c.chain.edge_count()).sum();
            assert_eq!(covered, edges.len(), "{name}: {}", hard.name);
        }
        assert!(
            one_step_crust(&points)
                .skeleton
                .lfs(&points)
                .iter()
                .all(|&lfs| lfs >= 0.0)
        );
    }
}

/// A quadratic algorithm would need minutes for one of these.
#[test]
fn large_sets_are_answered() {
    for hard in HARD_POINTS.iter().chain([&WELL_SPREAD]) {
        let points = set((hard.points)(6_000));
        for algorithm in ALGORITHMS {
            let edges = algorithm.reconstruct(&points);
            assert_eq!(edges.vertex_count(), points.len());
        }
    }
}

#[test]
fn a_million_copies_are_one_point() {
    let copies = vec![DVec2::new(0.1, -0.0); 1_000_000];
    let merged = PointSet::merging_duplicates(copies.clone()).unwrap();
    assert_eq!((merged.points.len(), merged.duplicates()), (1, 999_999));
    let refused = PointSet::new(copies).unwrap_err();
    let PointSetError::Duplicate { first, second, .. } = refused else {
        panic!("{refused}");
    };
    assert_eq!((first, second), (0, 1));
    for algorithm in ALGORITHMS {
        assert!(algorithm.reconstruct(&merged.points).is_empty());
        assert!(algorithm.reconstruct(&PointSet::default()).is_empty());
    }
}

#[test]
fn coordinates_beyond_exact_predicates_are_refused() {
    for value in [1e-300, -1e300, f64::MIN_POSITIVE, f64::MAX, 5e-324] {
        let points = vec![DVec2::ZERO, DVec2::new(1.0, value)];
        let refused = Err(PointSetError::Magnitude { index: 1, value });
        assert_eq!(PointSet::new(points), refused);
    }
    for value in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let refused = PointSet::new(vec![DVec2::new(value, 1.0)]).unwrap_err();
        assert!(matches!(refused, PointSetError::NotFinite { index: 0, .. }));
    }
}

/// Two circles 1e-12 apart: the nearest neighbour is the point of the other circle, whatever else.
#[test]
fn twins_find_each_other() {
    let circles = HARD_POINTS
        .iter()
        .find(|c| c.name == "two circles 1e-12 apart")
        .unwrap();
    let points = set((circles.points)(2_000));
    let edges = curvecrust::reconstruct::HnnCrust { keep: Keep::Union }.reconstruct(&points);
    for i in 0..1_000 {
        let twins = [i, i + 1_000].map(|i| PointId::new(i).unwrap());
        assert!(edges.contains(Edge::new(twins[0], twins[1]).unwrap()));
    }
}
