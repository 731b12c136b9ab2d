//! The edges by tiles are those of all points at once, whatever the tiles, halos and runs.

#![allow(clippy::unwrap_used, reason = "a test, its helpers included")]

mod chains;
mod engine;
mod stars;

use curvecrust_geometry::{DVec2, PointSet};
use curvecrust_testing::fixtures;
use curvecrust_testing::hard_points::{HARD_POINTS, grid, line, shuffled, spiral};
use curvecrust_testing::strategies::{any_points, even_runs, point_set};
use curvecrust_tiles::{Method, TilesError};
use engine::{Plan, Split, by_tiles, edges_and_reads, in_memory, pairs, split};
use proptest::prelude::*;

/// Cases of each of the two properties: 10,000 in all in a release build.
const CASES: u32 = if cfg!(debug_assertions) { 400 } else { 5000 };

fn plans() -> impl Strategy<Value = Plan> {
    let split = prop_oneof![
        4 => (1..40usize).prop_map(Split::Cells),
        1 => Just(Split::Cells(1000)),
        2 => (1..30usize).prop_map(Split::Blocks),
        2 => (1..9usize, any::<u64>()).prop_map(|(count, seed)| Split::Random(count, seed)),
        2 => (0.01..3.0).prop_map(Split::Columns),
        1 => Just(Split::Columns(1.0)),
    ];
    let halo = prop_oneof![
        3 => Just(0.0),
        1 => Just(-1.0),
        2 => Just(1.0),
        3 => 0.0..2.0f64,
        1 => Just(1e-9),
        1 => Just(1e9),
    ];
    (split, halo, 1..20usize).prop_map(|(split, halo, run)| Plan { split, halo, run })
}

#[track_caller]
fn assert_exact(points: &PointSet, plan: Plan, name: &str) {
    for (algorithm, method) in Method::ALL {
        let expected = pairs(&in_memory(points, *method));
        let found = by_tiles(points.points(), *method, plan);
        assert_eq!(found, Ok(expected), "{name}, {algorithm}, {plan:?}");
    }
}

/// Some of the points as far away as 10^9 times their distances.
fn with_outliers(points: &PointSet, outliers: &[(f64, f64)]) -> PointSet {
    let far = outliers.iter().map(|&(x, y)| 1e9 * DVec2::new(x, y));
    point_set(points.points().iter().copied().chain(far).collect())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(CASES))]

    #[test]
    fn any_points_in_any_tiles(
        points in any_points(),
        outliers in prop::collection::vec((-1.0..1.0, -1.0..1.0), 0..3),
        plan in plans(),
    ) {
        assert_exact(&with_outliers(&points, &outliers), plan, "any points");
    }

    #[test]
    fn open_rows_in_any_tiles(points in even_runs(), plan in plans()) {
        assert_exact(&point_set(points), plan, "rows");
    }
}

/// Every hard set, in tiles of one point to all.
#[test]
fn hard_points_in_tiles_of_any_size() {
    for hard in HARD_POINTS {
        let points = point_set((hard.points)(300));
        for cells in [1, 2, 7, 30, 300] {
            for halo in [0.0, 1.0] {
                let split = Split::Cells(cells);
                let plan = Plan {
                    split,
                    halo,
                    run: 16,
                };
                assert_exact(&points, plan, hard.name);
            }
        }
        let split = Split::Random(5, 1);
        let plan = Plan {
            split,
            halo: 0.5,
            run: 7,
        };
        assert_exact(&points, plan, hard.name);
    }
}

#[test]
fn every_fixture_of_points() {
    for (name, points) in fixtures::points() {
        let points = point_set(points);
        for (cells, halo) in [(3, 0.0), (20, 0.0), (20, 1e-2), (500, 0.0)] {
            let split = Split::Cells(cells);
            let plan = Plan {
                split,
                halo,
                run: 32,
            };
            assert_exact(&points, plan, &name);
        }
    }
}

#[test]
fn ties_on_borders() {
    let points = point_set(shuffled(grid(400)));
    for width in [1.0, 2.0, 5.0] {
        for halo in [0.0, 1.0, 2.0] {
            let split = Split::Columns(width);
            assert_exact(
                &points,
                Plan {
                    split,
                    halo,
                    run: 5,
                },
                "grid",
            );
        }
    }
}

#[test]
fn one_curve_across_all_tiles() {
    let points = point_set(shuffled(spiral(5000)));
    for cells in [3, 20, 111] {
        let split = Split::Cells(cells);
        assert_exact(
            &points,
            Plan {
                split,
                halo: 0.0,
                run: 64,
            },
            "spiral",
        );
    }
}

/// Of what lies beyond an open end, few runs are read.
#[test]
fn an_open_end_does_not_read_the_world() {
    let counts = |points: Vec<DVec2>, cells| {
        let plan = Plan {
            split: Split::Cells(cells),
            halo: 0.0,
            run: 25,
        };
        let found = edges_and_reads(&split(&points, plan.split), Method::HNN_CRUST, plan);
        found.map(|(_, counts)| counts)
    };
    // 900 arcs of 40 points each: about 1500 runs, of which each question reads two or three.
    let arc = |k: u32| {
        let centre = DVec2::new(f64::from(k % 30), f64::from(k / 30)) * 3.0;
        let angle = move |i: u32| f64::from(i) * 0.1 + f64::from(k);
        (0..40).map(move |i| centre + DVec2::from_angle(angle(i)))
    };
    let arcs = (0..900).flat_map(arc).collect();
    let Ok([questions, reads]) = counts(shuffled(arcs), 900) else {
        panic!("the points are valid");
    };
    assert!(
        questions > 900 && reads < 3 * questions,
        "{reads} for {questions}"
    );
    // Three samples at each of 99 borders read a run; nothing lies beyond the two ends.
    let Ok([questions, reads]) = counts(line(10_000), 100) else {
        panic!("the points are valid");
    };
    assert_eq!([questions, reads], [299, 297]);
}

#[test]
fn few_points() {
    for count in 0..4u32 {
        let points = (0..count).map(|i| DVec2::new(f64::from(i), f64::from(i * i)));
        let points = point_set(points.collect());
        for split in [Split::Cells(3), Split::Blocks(1), Split::Random(3, 5)] {
            for halo in [-1.0, 0.0, 10.0] {
                assert_exact(
                    &points,
                    Plan {
                        split,
                        halo,
                        run: 1,
                    },
                    "few",
                );
            }
        }
    }
}

/// Equal points are found in one tile, in a halo, and where one tile asks another.
#[test]
fn duplicates_name_both_ids() {
    let mut points = shuffled(spiral(50));
    points.push(points[20]);
    let splits = [Split::Cells(6), Split::Blocks(10), Split::Blocks(1)];
    for split in splits {
        for halo in [-1.0, 0.0, 3.0] {
            let found = by_tiles(
                &points,
                Method::HNN_CRUST,
                Plan {
                    split,
                    halo,
                    run: 4,
                },
            );
            let Err(TilesError::Duplicate { first, second, .. }) = found else {
                panic!("{split:?}, {halo}: {found:?}");
            };
            assert_eq!([first, second], [20, 50]);
        }
    }
}

#[test]
fn bad_coordinates_name_the_id() {
    let mut points = spiral(20);
    points[7].y = f64::NAN;
    let plan = Plan {
        split: Split::Blocks(5),
        halo: 1.0,
        run: 4,
    };
    let found = by_tiles(&points, Method::NN_CRUST, plan).unwrap_err();
    assert!(
        matches!(found, TilesError::NotFinite { id: 7, .. }),
        "{found}"
    );
    points[7].y = 1e300;
    let found = by_tiles(&points, Method::NN_CRUST, plan).unwrap_err();
    let magnitude = TilesError::Magnitude {
        id: 7,
        value: 1e300,
    };
    assert_eq!(found, magnitude);
}
