//! What least detour promises of its edges, from its definition.

use curvecrust_geometry::{DVec2, Edge, EdgeSet, PointId, PointSet};
use curvecrust_reconstruct::{LeastDetour, Reason, Reconstructor};
use curvecrust_testing::strategies::{any_points, even_runs, point_set, uniform};
use proptest::prelude::*;
use proptest::strategy::ValueTree;
use proptest::test_runner::TestRunner;

pub(crate) use self::definition::{Definition, partners};
pub(crate) use self::exhaustive::Exhaustive;

/// The constants of the method, not a copy of them.
#[path = "../../src/least_detour/constants.rs"]
#[allow(
    dead_code,
    reason = "those of the search are no part of the definition"
)]
mod constants;
mod definition;
mod exhaustive;

/// `docs/method.md` lists every constant with its value. It is not there in the published crate.
#[test]
fn the_method_lists_every_constant() {
    let here = std::path::Path::new(env!("CARGO_MANIFEST_DIR"));
    let Ok(method) = std::fs::read_to_string(here.join("../../docs/method.md")) else {
        return;
    };
    let code = include_str!("../../src/least_detour/constants.rs");
    let constants = code.lines().filter_map(|line| {
        let (name, rest) = line.strip_prefix("pub(super) const ")?.split_once(": ")?;
        let (_, value) = rest.split_once(" = ")?;
        Some((name, value.trim_end_matches(';')))
    });
    let constants: Vec<_> = constants.collect();
    assert_eq!(constants.len(), code.matches("const ").count());
    for (name, value) in constants {
        let row = format!("| `{name}` | `{value}` |");
        assert_eq!(
            method.matches(&row).count(),
            1,
            "docs/method.md lacks {row}"
        );
    }
}

/// What is wrong with the edges, if anything.
pub(crate) fn fault(points: &PointSet, edges: &EdgeSet) -> Option<String> {
    let definition = Definition::new(points);
    let candidates = &definition.candidates;
    if let Some(edge) = edges.difference(candidates).next() {
        return Some(format!("{edge:?} is not a candidate"));
    }
    if !edges.junctions().is_empty() || Definition::has_triangle(edges) {
        return Some("a junction or a triangle".to_owned());
    }
    let certified: Vec<Edge> = definition.certified().collect();
    if let Some(edge) = certified.iter().find(|&&e| !edges.contains(e)) {
        return Some(format!("{edge:?} is certified and missing"));
    }
    let cost = definition.cost(edges);
    let is_better = |others: &EdgeSet| definition.cost(others) < cost - 1e-9 * (1.0 + cost.abs());
    let changed = |edge: Edge| {
        let others = edges.edges().iter().copied().filter(|&e| e != edge);
        let added = Some(edge).filter(|&e| !edges.contains(e));
        EdgeSet::new(points.len(), others.chain(added))
    };
    let toggled = candidates.edges().iter().filter(|e| !certified.contains(e));
    for &edge in toggled {
        let others = changed(edge);
        let is_valid = others.junctions().is_empty() && !Definition::has_triangle(&others);
        if is_valid && is_better(&others) {
            return Some(format!("without or with {edge:?} the cost is less"));
        }
    }
    None
}

/// Nearly all small sets of scattered points, with hardly a certified edge, get the cheapest
/// 2-matching.
#[test]
fn exchanges_find_the_cheapest_edges_of_nearly_all_small_sets() {
    let mut runner = TestRunner::deterministic();
    let (mut sets, mut cheapest, mut excess) = (0_u32, 0_u32, 0.0);
    while sets < 500 {
        let points = point_set(uniform(13).new_tree(&mut runner).unwrap().current());
        if points.len() < 7 {
            continue;
        }
        let definition = Definition::new(&points);
        let cost = definition.cost(&LeastDetour.reconstruct(&points));
        let least = Exhaustive::least_cost(&definition, cost);
        sets += 1;
        cheapest += u32::from(cost <= least + 1e-9);
        excess += cost - least;
    }
    assert!(cheapest >= 490, "{cheapest} of {sets}");
    // The others cost little more: on the average, all are as likely as the best within 1 %.
    assert!(excess / f64::from(sets) < 0.01, "{excess}");
}

/// A cluster as wide as a few roundings, where penalties are 10^12 times as large as lengths: their
/// rounding errors once looked like a gain, and exchanges went on for ever.
#[test]
fn penalties_much_larger_than_lengths_feign_no_gain() {
    let steps = [
        (0, 0),
        (1, 6),
        (3, 4),
        (5, 6),
        (6, 4),
        (5, 4),
        (4, 0),
        (5, 0),
        (2, 6),
        (1, 0),
        (6, 1),
        (2, 1),
        (6, 0),
        (2, 4),
        (0, 6),
    ];
    let cluster = steps.map(|(x, y)| {
        let step = |n: i32| 1.0 + f64::from(n) * f64::EPSILON;
        DVec2::new(step(x), step(y))
    });
    let around = [(0.0, 1.0), (1.0, 2.0), (0.0, 2.0)].map(DVec2::from);
    let points = PointSet::new([&cluster[..], &around[..]].concat()).unwrap();
    for v in points.ids() {
        let edges = LeastDetour.reconstruct_open(&points, &[v]).unwrap();
        assert!(edges.degrees()[v.index()] <= 1);
    }
}

/// Two points are joined, and more in a row one after another, whatever the turn of the last edge.
/// But up to five points that turn by more than a run may are the corners of a polygon.
#[test]
fn a_few_points_in_a_row_are_joined() {
    for n in 2..9 {
        for degrees in [0.0, 30.0, 44.0, 60.0, 90.0] {
            if degrees > 45.0 && (4..6).contains(&n) {
                continue;
            }
            let turn = DVec2::from_angle(f64::to_radians(degrees));
            let mut row: Vec<DVec2> = (1..n).map(|i| f64::from(i) * DVec2::X).collect();
            row.push(f64::from(n - 1) * DVec2::X + turn);
            let points = PointSet::new(row).unwrap();
            let edges =
                (1..points.len()).filter_map(|i| Edge::new(PointId::new(i - 1)?, PointId::new(i)?));
            let edges = EdgeSet::new(points.len(), edges);
            assert_eq!(LeastDetour.reconstruct(&points), edges, "{n}, {degrees}");
        }
    }
}

/// Half circles with ends beside each other: lengths and detours alone would bridge the gap, but
/// the penalty at the end of an even run is small.
#[test]
fn even_runs_end_and_uneven_ones_continue() {
    let arc = |x: f64, even: bool| {
        (0..=10).map(move |i| {
            // Uneven: every other sample is moved by half a step.
            let shift = if even || i % 2 == 0 || i == 10 {
                0.0
            } else {
                0.5
            };
            let angle = (f64::from(i) + shift) * std::f64::consts::PI / 10.0;
            DVec2::new(x, 0.0) + DVec2::from_angle(angle)
        })
    };
    let leaves = |even: bool| {
        // Steps of 0.31, and 0.6 from one arc to the other.
        let points = arc(0.0, even).chain(arc(2.6, even)).collect();
        let points = PointSet::new(points).unwrap();
        LeastDetour.reconstruct(&points).leaves().len()
    };
    assert_eq!(leaves(true), 4);
    assert!(leaves(false) < 4);
}

/// What once failed: letters C, dots, a blunt thin tip, rectangles by their corners, strokes in
/// line and beside each other, a short last step. The points are in the order of the curves.
#[test]
fn shapes_that_people_draw() {
    let at = |x: f64, y: f64| DVec2::new(x, y);
    let polygon = |n: u32, centre: DVec2| {
        (0..n).map(move |i| {
            let angle = (f64::from(i) + 0.5) * std::f64::consts::TAU / f64::from(n);
            centre + DVec2::from_angle(angle) / (2.0 * (std::f64::consts::PI / f64::from(n)).sin())
        })
    };
    let arc = |steps: u32, per_turn: u32| {
        (0..=steps).map(move |i| {
            10.0 * DVec2::from_angle(f64::from(i) * std::f64::consts::TAU / f64::from(per_turn))
        })
    };
    let row = |n: u32, from: DVec2| (0..n).map(move |i| from + f64::from(i) * DVec2::X);
    let tip = |side: f64| {
        let along = [
            0.02, 0.05, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 0.95,
        ];
        along.map(|x: f64| at(x, side * 0.2 * (x.sqrt() - x) + side * 0.0005))
    };
    let lower = tip(-1.0).into_iter().chain([at(1.0, -0.0005)]);
    let upper = tip(1.0).into_iter().chain([at(1.0, 0.0005)]);
    let last = 10.0 * DVec2::from_angle(67.5_f64.to_radians());
    let step_back = arc(9, 48).chain([last + 0.13 * DVec2::from_angle(202.5_f64.to_radians())]);
    type Curves = Vec<(Vec<DVec2>, bool)>;
    let shapes: [(&str, Curves); 8] = [
        ("arc", vec![(arc(40, 48).collect(), false)]),
        (
            "two squares",
            vec![
                (polygon(4, at(0.0, 0.0)).collect(), true),
                (polygon(4, at(3.0, 0.0)).collect(), true),
            ],
        ),
        (
            "three pentagons",
            [0.0, 4.0, 8.0]
                .map(|x| (polygon(5, at(x, 0.0)).collect(), true))
                .to_vec(),
        ),
        (
            "wing",
            vec![(
                lower.rev().chain([DVec2::ZERO]).chain(upper).collect(),
                true,
            )],
        ),
        (
            "rectangle",
            vec![(
                vec![at(0.0, 0.0), at(3.0, 0.0), at(3.0, 1.0), at(0.0, 1.0)],
                true,
            )],
        ),
        (
            "in line",
            vec![
                (row(9, at(0.0, 0.0)).collect(), false),
                (row(9, at(13.0, 0.0)).collect(), false),
            ],
        ),
        (
            "parallel",
            [0.0, 1.6]
                .map(|y| (row(12, at(0.3 * y, y)).collect(), false))
                .to_vec(),
        ),
        ("step back", vec![(step_back.collect(), false)]),
    ];
    for (name, curves) in shapes {
        let (mut points, mut edges) = (Vec::new(), Vec::new());
        for (curve, is_closed) in curves {
            let first = points.len();
            points.extend(curve);
            let last = points.len() - 1;
            let closing = is_closed.then_some((last, first));
            let pairs = (first..last).map(|i| (i, i + 1)).chain(closing);
            edges.extend(pairs.filter_map(|(v, w)| Edge::new(PointId::new(v)?, PointId::new(w)?)));
        }
        let edges = EdgeSet::new(points.len(), edges);
        let found = LeastDetour.reconstruct(&PointSet::new(points).unwrap());
        assert_eq!(found, edges, "{name}");
    }
}

/// An outlier beside a straight row is left alone, at every distance of a spacing or more; the tip
/// of a corner that is as far from both legs is not.
#[test]
fn an_outlier_is_left_alone() {
    let row = |y: f64| (0..12).map(move |i| DVec2::new(f64::from(i), y * f64::from(i)));
    for height in [1.0, 1.5, 2.0, 3.0] {
        let points = row(0.0).chain([DVec2::new(5.4, height)]).collect();
        let points = PointSet::new(points).unwrap();
        let edges = LeastDetour.reconstruct(&points);
        assert_eq!((edges.len(), edges.isolated().len()), (11, 1), "{height}");
    }
    let tip = row(0.15).chain(row(-0.15).skip(1)).collect();
    let edges = LeastDetour.reconstruct(&PointSet::new(tip).unwrap());
    assert!(edges.isolated().is_empty());
}

/// Each edge and each free end is explained as the definition has it.
fn explained_as_defined(points: &PointSet) -> Result<(), TestCaseError> {
    let definition = Definition::new(points);
    let edges = LeastDetour.reconstruct(points);
    let why = LeastDetour.explain(points, &[]).unwrap().unwrap();
    let explained: Vec<Edge> = why.edges.iter().map(|e| e.edge).collect();
    prop_assert_eq!(&explained[..], edges.edges());
    let certified: Vec<Edge> = definition.certified().collect();
    for explained in &why.edges {
        let is_certified = certified.contains(&explained.edge);
        prop_assert_eq!(explained.reason == Reason::Certified, is_certified);
        prop_assert!(!is_certified || explained.margin_at_most.is_none());
        let margin = explained.margin_at_most;
        prop_assert!(margin.is_none_or(|margin| margin >= 0.0));
    }
    let free: Vec<_> = why
        .free_ends
        .iter()
        .map(|end| (end.point, usize::from(end.count)))
        .collect();
    let expected = points.ids().map(|v| (v, 2 - partners(&edges, v).len()));
    prop_assert_eq!(free, expected.filter(|s| s.1 > 0).collect::<Vec<_>>());
    for end in &why.free_ends {
        let penalty = definition.penalties[end.point.index()][usize::from(end.count) - 1];
        prop_assert!((end.penalty - penalty).abs() <= 1e-9 * penalty);
        let Some(rejected) = end.rejected else {
            continue;
        };
        let joined = Edge::new(end.point, rejected.partner).unwrap();
        prop_assert!(definition.candidates.contains(joined) && !edges.contains(joined));
        prop_assert!(rejected.cost_at_most >= 0.0);
    }
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]

    #[test]
    fn what_is_explained_is_what_is_returned(points in any_points()) {
        explained_as_defined(&points)?;
    }

    #[test]
    fn ends_of_even_runs_are_explained_as_defined(points in even_runs().prop_map(point_set)) {
        explained_as_defined(&points)?;
    }
}
