//! What holds of the search of least detour, whatever its cost is: even runs, local optima, margins
//! against all sets of edges, and symmetries.

use curvecrust_geometry::{DVec2, Edge, EdgeSet, PointId, PointSet};
use curvecrust_reconstruct::{LeastDetour, Reconstructor};
use curvecrust_testing::moves::{distances_differ, mapped, permuted, relabelled};
use curvecrust_testing::strategies::{even_runs, point_set, uniform};
use proptest::prelude::*;
use proptest::strategy::ValueTree;
use proptest::test_runner::TestRunner;

use super::least_detour::{Definition, Exhaustive, fault, partners};

/// What rounding may make of a cost.
const ROUNDING: f64 = 1e-9;

/// So many sets of points of a strategy, the same each time.
fn sets(strategy: impl Strategy<Value = Vec<DVec2>>, least: usize, count: usize) -> Vec<PointSet> {
    let mut runner = TestRunner::deterministic();
    let drawn = std::iter::repeat_with(|| strategy.new_tree(&mut runner).unwrap().current());
    drawn
        .map(point_set)
        .filter(|points| points.len() >= least)
        .take(count)
        .collect()
}

/// An edge less and, at one of its ends, another one more.
fn swaps<'a>(
    definition: &'a Definition<'_>,
    edges: &'a EdgeSet,
) -> impl Iterator<Item = EdgeSet> + 'a {
    let certified: Vec<Edge> = definition.certified().collect();
    let removed = edges.edges().iter().copied();
    let removed = removed.filter(move |e| !certified.contains(e));
    removed.flat_map(move |removed| {
        let added = definition.candidates.edges().iter().copied();
        let meets = move |e: &Edge| e.ends().iter().any(|v| removed.ends().contains(v));
        let added = added.filter(move |e| meets(e) && !edges.contains(*e));
        added.map(move |added| {
            let kept = edges.edges().iter().copied().filter(|&e| e != removed);
            EdgeSet::new(edges.vertex_count(), kept.chain([added]))
        })
    })
}

#[test]
fn even_runs_end_in_the_open() {
    let mut ends = 0;
    for points in sets(even_runs(), 6, 60) {
        let definition = Definition::new(&points);
        let edges = LeastDetour.reconstruct(&points);
        let leaves = edges.leaves();
        ends += leaves.iter().filter(|&&v| definition.has_run(v)).count();
    }
    // As many as there are sets, or the tests below would be of something else.
    assert!(ends >= 60, "{ends}");
}

#[test]
fn no_single_swap_lowers_the_cost() {
    for points in sets(even_runs(), 6, 60)
        .iter()
        .chain(&sets(uniform(24), 7, 60))
    {
        let definition = Definition::new(points);
        let edges = LeastDetour.reconstruct(points);
        assert_eq!(fault(points, &edges), None);
        let cost = definition.cost(&edges);
        for others in swaps(&definition, &edges) {
            let is_valid = others.junctions().is_empty() && !Definition::has_triangle(&others);
            let lower = definition.cost(&others) < cost - ROUNDING * (1.0 + cost.abs());
            assert!(!(is_valid && lower), "{:?}: {others:?}", points.points());
        }
    }
}

/// How a bound on the least cost of some sets of edges compares with it, by trying all.
#[derive(Default)]
struct Bounds {
    all: u32,
    exact: u32,
}

impl Bounds {
    /// Notes an upper bound, and fails if it is none.
    fn note(
        &mut self,
        definition: &Definition<'_>,
        bound: f64,
        may_be: impl Fn(&[Vec<PointId>]) -> bool,
    ) {
        let rounding = ROUNDING * (1.0 + bound.abs());
        // Above the bound, so that the search finds what only just does not meet it.
        let above = bound + 2.0 * rounding;
        let least = Exhaustive::least_cost_of(definition, above, may_be);
        assert!(least <= bound + rounding, "{bound} is below {least}");
        self.all += 1;
        self.exact += u32::from(least >= bound - rounding);
    }
}

/// A margin is at least what the cheapest edges without the edge cost more, and mostly just that.
#[test]
fn margins_are_upper_bounds_and_mostly_exact() {
    let mut bounds = Bounds::default();
    for points in sets(uniform(10), 6, 120) {
        let definition = Definition::new(&points);
        let why = LeastDetour.explain(&points, &[]).unwrap().unwrap();
        let cost = definition.cost(&why.edge_set(points.len()));
        for explained in &why.edges {
            let Some(margin) = explained.margin_at_most else {
                continue;
            };
            let [a, b] = explained.edge.ends();
            bounds.note(&definition, cost + margin, |partners| {
                !partners[a.index()].contains(&b)
            });
        }
    }
    let Bounds { all, exact } = bounds;
    assert!(all > 500 && 100 * exact >= 90 * all, "{exact} of {all}");
}

/// An end and its rejected partner can be joined at no more than the cost that is told. That is
/// mostly the least cost at which the end is filled.
#[test]
fn costs_of_rejected_partners_are_upper_bounds_and_mostly_exact() {
    let (mut joined, mut filled) = (Bounds::default(), Bounds::default());
    for points in sets(uniform(10), 6, 120) {
        let definition = Definition::new(&points);
        let why = LeastDetour.explain(&points, &[]).unwrap().unwrap();
        let edges = why.edge_set(points.len());
        let cost = definition.cost(&edges);
        for end in &why.free_ends {
            let Some(rejected) = end.rejected else {
                continue;
            };
            let before = partners(&edges, end.point).len();
            let fills = |partners: &[Vec<PointId>]| partners[end.point.index()].len() > before;
            let bound = cost + rejected.cost_at_most;
            filled.note(&definition, bound, fills);
            joined.note(&definition, bound, |partners| {
                fills(partners) && partners[end.point.index()].contains(&rejected.partner)
            });
        }
    }
    let Bounds { all, exact } = filled;
    assert!(all > 40 && 3 * exact >= 2 * all, "{exact} of {all}");
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(60))]

    /// Even runs are full of ties.
    #[test]
    fn neither_order_nor_mirrors_matter_to_even_runs(
        (points, order) in even_runs().prop_map(point_set).prop_flat_map(|points| {
            let ids: Vec<PointId> = points.ids().collect();
            (Just(points), Just(ids).prop_shuffle())
        }),
    ) {
        let edges = LeastDetour.reconstruct(&points);
        let backwards: Vec<PointId> = order.iter().rev().copied().collect();
        for order in [&order, &backwards] {
            let mixed = permuted(&points, order);
            prop_assert_eq!(&relabelled(&LeastDetour.reconstruct(&mixed), order), &edges);
        }
        if distances_differ(&points) {
            let turned = [
                mapped(&points, |p| -p),
                mapped(&points, |p| DVec2::new(-p.x, p.y)),
                mapped(&points, |p| DVec2::new(p.y, p.x)),
            ];
            for turned in turned.into_iter().flatten() {
                prop_assert_eq!(&LeastDetour.reconstruct(&turned), &edges);
            }
        }
    }
}
