//! Delaunay edges and the crust by tiles are those of all points at once, whatever the tiles, halos
//! and runs.

mod engine;

use curvecrust_geometry::{DVec2, PointSet};
use curvecrust_testing::fixtures;
use curvecrust_testing::hard_points::{HARD_POINTS, grid, shuffled, spiral};
use curvecrust_testing::strategies::{any_points, even_runs, point_set};
use curvecrust_tiles::{
    Area, Elsewhere, Sample, Samples, TilesError, solve_crust_tile, solve_delaunay_tile,
};
use engine::{Kind, at_once, by_tiles};
use proptest::prelude::*;

use crate::engine::{Plan, Split};
use crate::{CASES, plans, with_outliers};

#[track_caller]
fn assert_exact(points: &PointSet, plan: Plan, name: &str) {
    for kind in Kind::ALL {
        let expected = at_once(points, kind);
        let found = by_tiles(points.points(), kind, plan);
        assert_eq!(found, Ok(expected), "{name}, {kind:?}, {plan:?}");
    }
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

fn plan(split: Split, halo: f64, run: usize) -> Plan {
    Plan { split, halo, run }
}

/// Every hard set, in tiles of one point to all.
#[test]
fn hard_points_in_tiles_of_any_size() {
    for hard in HARD_POINTS {
        let points = point_set((hard.points)(60));
        for cells in [1, 2, 7, 60] {
            for halo in [0.0, 1.0] {
                assert_exact(&points, plan(Split::Cells(cells), halo, 16), hard.name);
            }
        }
        assert_exact(&points, plan(Split::Random(5, 1), 0.5, 7), hard.name);
    }
}

#[test]
fn every_fixture_of_points() {
    for (name, points) in fixtures::points() {
        let points = point_set(points);
        for (cells, halo) in [(3, 0.0), (20, 1e-2), (60, 0.0)] {
            assert_exact(&points, plan(Split::Cells(cells), halo, 32), &name);
        }
    }
}

#[test]
fn ties_on_borders() {
    let points = point_set(shuffled(grid(400)));
    for width in [1.0, 2.0, 5.0] {
        for halo in [0.0, 1.0, 2.0] {
            assert_exact(&points, plan(Split::Columns(width), halo, 5), "grid");
        }
    }
}

#[test]
fn one_curve_across_all_tiles() {
    let points = point_set(shuffled(spiral(3000)));
    for cells in [3, 20, 111] {
        assert_exact(&points, plan(Split::Cells(cells), 0.0, 64), "spiral");
    }
}

#[test]
fn few_points() {
    for count in 0..5u32 {
        let points = (0..count).map(|i| DVec2::new(f64::from(i), f64::from(i * i)));
        let points = point_set(points.collect());
        for split in [Split::Cells(3), Split::Blocks(1), Split::Random(3, 5)] {
            for halo in [-1.0, 0.0, 10.0] {
                assert_exact(&points, plan(split, halo, 1), "few");
            }
        }
    }
}

/// Equal points are found in one tile, in a halo, and where one tile asks another.
#[test]
fn duplicates_name_both_ids() {
    let mut points = shuffled(spiral(50));
    points.push(points[20]);
    for split in [Split::Cells(6), Split::Blocks(10), Split::Blocks(1)] {
        for halo in [-1.0, 0.0, 3.0] {
            for kind in Kind::ALL {
                let found = by_tiles(&points, kind, plan(split, halo, 4));
                let Err(TilesError::Duplicate { first, second, .. }) = found else {
                    panic!("{split:?}, {halo}: {found:?}");
                };
                assert_eq!([first, second], [20, 50]);
            }
        }
    }
}

/// With nothing or nonsense loaded all is open, with everything nothing.
#[test]
fn what_is_loaded_decides_what_is_open() {
    let samples = spiral(30).into_iter().zip(0..);
    let owned = Samples::new(samples.map(|(point, id)| Sample { id, point }).collect()).unwrap();
    let nan = Area {
        low: DVec2::NAN,
        high: DVec2::INFINITY,
    };
    for solve in [solve_delaunay_tile, solve_crust_tile] {
        for (loaded, open) in [(Area::NOTHING, 30), (nan, 30), (Area::EVERYTHING, 0)] {
            let stars = solve(&owned, &[], &Elsewhere::outside(loaded)).unwrap();
            assert_eq!(stars.open.len(), open);
        }
    }
}
