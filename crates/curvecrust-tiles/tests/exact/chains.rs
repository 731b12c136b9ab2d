//! The chains by tiles are those of all points at once.

use curvecrust_geometry::{DVec2, PointId, PointSet};
use curvecrust_testing::hard_points::{HARD_POINTS, polygon, shuffled, spiral};
use curvecrust_testing::strategies::{any_points, even_runs, point_set};
use curvecrust_tiles::{
    Area, CurveId, ExactSum, Method, PieceSummary, TilesError, join_pieces, pieces,
};
use proptest::prelude::*;

use crate::engine::{Plan, Split, chains_by_tiles, in_memory};
use crate::{CASES, plans};

fn assert_same_chains(points: &PointSet, plan: Plan, name: &str) {
    for (algorithm, method) in Method::ALL {
        let expected = in_memory(points, *method).chains();
        let found = chains_by_tiles(points.points(), *method, plan);
        let count = found.as_ref().map(Vec::len);
        assert_eq!(count, Ok(expected.len()), "{name}, {algorithm}, {plan:?}");
        let found = found.into_iter().flatten();
        for (chain, (curve, vertices)) in expected.iter().zip(found) {
            let ids = chain.vertices().iter().map(|&id| u64::from(u32::from(id)));
            let ids: Vec<u64> = ids.collect();
            assert_eq!(vertices, ids, "{name}, {algorithm}, {plan:?}");
            let places = chain.vertices().iter().map(|&id| points[id]);
            assert_eq!(curve.closed, chain.is_closed());
            assert_eq!(curve.count, ids.len() as u64);
            assert_eq!(curve.area, Area::of(places));
            let [first, second] = [ids[0], ids[1]];
            assert_eq!(curve.id, CurveId { first, second });
            let length = |from: PointId, to: PointId| points[from].distance(points[to]);
            let mut sum = ExactSum::default();
            for edge in chain.edges() {
                sum.add(length(edge.a(), edge.b()));
            }
            assert_eq!(curve.length.to_bits(), sum.value().to_bits());
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(CASES / 5))]

    #[test]
    fn any_points_in_any_tiles(points in any_points(), plan in plans()) {
        assert_same_chains(&points, plan, "any points");
    }

    #[test]
    fn open_rows_in_any_tiles(points in even_runs(), plan in plans()) {
        assert_same_chains(&point_set(points), plan, "rows");
    }

    #[test]
    fn sums_do_not_depend_on_their_order(
        mut terms in prop::collection::vec((-1.0..1.0, -60..60i32), 0..40),
    ) {
        let sum = |terms: &[(f64, i32)]| {
            let mut sum = ExactSum::default();
            for &(term, exponent) in terms {
                sum.add(term * f64::from(exponent).exp2());
            }
            sum.value()
        };
        let before = sum(&terms);
        terms.reverse();
        let half = terms.len() / 2;
        terms.rotate_left(half);
        prop_assert_eq!(before.to_bits(), sum(&terms).to_bits());
    }
}

#[test]
fn hard_points() {
    for hard in HARD_POINTS {
        let points = point_set((hard.points)(200));
        for split in [Split::Cells(9), Split::Random(4, 3), Split::Blocks(1)] {
            let plan = Plan {
                split,
                halo: 0.0,
                run: 16,
            };
            assert_same_chains(&points, plan, hard.name);
        }
    }
}

#[test]
fn one_curve_across_all_tiles() {
    for points in [shuffled(spiral(3000)), shuffled(polygon(3000))] {
        for cells in [2, 50, 400] {
            let split = Split::Cells(cells);
            let plan = Plan {
                split,
                halo: 0.0,
                run: 64,
            };
            assert_same_chains(&point_set(points.clone()), plan, "one curve");
        }
    }
}

#[test]
fn a_missing_tile_is_named() {
    let found = pieces(&[2, 3], &[[1, 2], [2, 3]]);
    let summaries: Vec<PieceSummary> = found.iter().map(|p| p.summary(|_| DVec2::ZERO)).collect();
    let missing = TilesError::NoPiece { from: 2, to: 1 };
    assert_eq!(join_pieces(&summaries), Err(missing));
}
