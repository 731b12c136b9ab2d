//! The chains by tiles are those of all points at once.

use curvecrust_geometry::{DVec2, PointId, PointSet};
use curvecrust_reconstruct::{HnnCrust, Reconstruction};
use curvecrust_testing::hard_points::{HARD_POINTS, polygon, shuffled, spiral};
use curvecrust_testing::strategies::{any_points, even_runs, point_set};
use curvecrust_tiles::{
    Area, Crossings, CurveId, ExactSum, Method, PieceSummary, TilesError, join_pieces, pieces,
    surrounding,
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

/// Which rings run clockwise, and which lie around which.
fn assert_same_nesting(points: &PointSet, plan: Plan, name: &str) {
    for (algorithm, method) in Method::ALL {
        let name = format!("{name}, {algorithm}, {plan:?}");
        let edges = in_memory(points, *method);
        let chains = edges.chains();
        let expected = Reconstruction::new(points, edges).unwrap();
        let found = chains_by_tiles(points.points(), *method, plan).unwrap();
        for (chain, ((curve, _), nested)) in chains.iter().zip(found.iter().zip(expected.chains()))
        {
            let is_turned = nested.chain != *chain;
            assert_eq!(curve.signed_area < 0.0, is_turned, "{name}");
        }
        let curves = found.iter().enumerate();
        let rings: Vec<usize> = curves
            .filter(|(_, (c, _))| c.closed)
            .map(|(i, _)| i)
            .collect();
        let places: Vec<DVec2> = rings.iter().map(|&ring| found[ring].0.leftmost).collect();
        let sides = |crossings: &mut Crossings| -> Result<(), TilesError> {
            for &ring in rings.iter().rev() {
                let (curve, ids) = &found[ring];
                let place = |at: usize| points.points()[usize::try_from(ids[at]).unwrap()];
                for at in 0..ids.len() {
                    let side = [place(at), place((at + 1) % ids.len())];
                    crossings.pass(ring, curve.area, side);
                }
            }
            Ok(())
        };
        for most in [0, 2, 1000] {
            let mut nesting: Vec<_> = found.iter().map(|(c, _)| c.closed.then_some(0)).collect();
            let count = |place: usize, around: &[usize]| {
                nesting[rings[place]] = u32::try_from(around.len()).ok();
            };
            surrounding(&places, most, sides, count).unwrap();
            let mut parents = vec![None; found.len()];
            let choose = |place: usize, around: &[usize]| {
                let outer = nesting[rings[place]].and_then(|n| n.checked_sub(1));
                let mut around = around.iter().copied();
                parents[rings[place]] = around.find(|&ring| nesting[ring] == outer);
            };
            surrounding(&places, most, sides, choose).unwrap();
            for (at, nested) in expected.chains().iter().enumerate() {
                let of_tiles = (nesting[at], parents[at]);
                assert_eq!(of_tiles, (nested.nesting, nested.parent), "{name}");
            }
        }
    }
}

/// Rings in rings, near each other, in no order.
fn rings_in_rings(count: usize) -> Vec<DVec2> {
    let ring = |i: usize| {
        let radius = 1.0 + 0.4 * i as f64;
        let number = 20 + 12 * i;
        let shift = DVec2::new(0.07 * i as f64, 0.0);
        polygon(number).into_iter().map(move |p| radius * p + shift)
    };
    shuffled((0..count).flat_map(ring).collect())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(CASES / 5))]

    #[test]
    fn any_points_in_any_tiles(points in any_points(), plan in plans()) {
        assert_same_chains(&points, plan, "any points");
        assert_same_nesting(&points, plan, "any points");
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
            assert_same_nesting(&points, plan, hard.name);
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
fn rings_in_rings_across_tiles() {
    let points = point_set(rings_in_rings(12));
    let found = Reconstruction::by(&HnnCrust::MUTUAL, &points);
    let deepest = found
        .chains()
        .iter()
        .filter_map(|chain| chain.nesting)
        .max();
    assert_eq!(deepest, Some(11));
    for cells in [1, 7, 100] {
        let split = Split::Cells(cells);
        let plan = Plan {
            split,
            halo: 0.0,
            run: 16,
        };
        assert_same_chains(&points, plan, "rings in rings");
        assert_same_nesting(&points, plan, "rings in rings");
    }
}

#[test]
fn a_missing_tile_is_named() {
    let found = pieces(&[2, 3], &[[1, 2], [2, 3]]);
    let summaries: Vec<PieceSummary> = found.iter().map(|p| p.summary(|_| DVec2::ZERO)).collect();
    let missing = TilesError::NoPiece { from: 2, to: 1 };
    assert_eq!(join_pieces(&summaries), Err(missing));
}
