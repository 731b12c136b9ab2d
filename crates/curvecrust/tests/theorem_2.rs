//! The counterexample to Theorem 2 of SGP 2016, see `docs/theorem-2.md`.
#![allow(clippy::unwrap_used, reason = "a test, its helpers included")]

use curvecrust::DVec2;
use curvecrust::curve::Curve;
use curvecrust::evaluate::EdgeComparison;
use curvecrust::geometry::{Edge, EdgeSet, PointId, PointSet};
use curvecrust::medial_axis::{Discretisation, MeasureOptions, measure_with};
use curvecrust::reconstruct::{LeastDetour, Reconstructor, hnn_crust};
use curvecrust::sampling::{Condition, PlacedSamples, check};

const DRAWING: &str = include_str!("../../../fixtures/counterexamples/theorem-2.svg");
const SAMPLES: &str = include_str!("../../../fixtures/counterexamples/theorem-2.csv");

/// How many samples are on the first component; the last ones are on the tiny circle.
const ON_THE_CURVE: usize = 50;
/// The angle of the arc before s1.
const ARC: f64 = 1.337;

fn samples() -> PointSet {
    let point = |line: &str| {
        let (x, y) = line.split_once(',').unwrap();
        DVec2::new(x.parse().unwrap(), y.parse().unwrap())
    };
    PointSet::new(SAMPLES.lines().skip(1).map(point).collect()).unwrap()
}

/// The polygons of the samples in the order of the file, which is that of the two components.
fn truth(count: usize) -> EdgeSet {
    let id = |i| PointId::new(i).unwrap();
    let ring = |from: usize, to: usize| {
        let next = move |i: usize| if i + 1 < to { i + 1 } else { from };
        (from..to).filter_map(move |i| Edge::new(id(i), id(next(i))))
    };
    EdgeSet::new(
        count,
        ring(0, ON_THE_CURVE).chain(ring(ON_THE_CURVE, count)),
    )
}

#[test]
fn the_samples_are_those_of_the_closed_form() {
    let points = samples();
    // The drawing has its unit, lfs(s1), 100 long, and y down.
    let s0 = DVec2::new(-ARC.sin(), 1.0 - ARC.cos()) * 100.0;
    assert!(points[0.into()].distance(s0) < 1e-6);
    assert_eq!(points[1.into()], DVec2::ZERO);
    assert_eq!(points[2.into()], DVec2::new(179.4, 0.0));
}

/// The three comparisons by which s1 takes a sample of the circle before s2.
#[test]
fn a_sample_of_the_circle_is_the_half_neighbour() {
    let points = samples();
    let [s0, s1, s2] = [0, 1, 2].map(|i| points[PointId::from(i)]);
    let circle = points.points()[ON_THE_CURVE..].iter();
    let before = circle.filter(|z| z.distance(s1) < z.distance(s0).min(s1.distance(s2)));
    assert!(before.count() > 0);
    assert!(s0.distance(s1) < s1.distance(s2));
}

#[test]
fn rho_is_certified_to_be_below_what_theorem_2_asks_for() {
    let curve = Curve::from_svg(DRAWING).unwrap();
    let options = MeasureOptions {
        discretisation: Discretisation::Adaptive { gap_to_lfs: 0.001 },
        ..Default::default()
    };
    let measured = measure_with(&curve, &options).unwrap();
    let placed = PlacedSamples::project(&measured, samples().points(), 1e-4).unwrap();
    let verdict = check(&measured, &placed.samples, Condition::rho(0.898).unwrap());
    assert!(verdict.holds(), "{verdict:?}");
    let worst = verdict.worst.unwrap();
    assert!(0.895 < worst.bound && worst.at_most < 0.898, "{worst:?}");
}

#[test]
fn hnn_crust_loses_the_edge_from_s1_to_s2_and_no_other() {
    let points = samples();
    let truth = truth(points.len());
    let found = EdgeComparison::new(&truth, &hnn_crust(&points));
    assert_eq!(found.missing, [Edge::new(1.into(), 2.into()).unwrap()]);
    assert!(found.wrong.is_empty());
    // The edge is not out of reach for every algorithm.
    assert_eq!(LeastDetour.reconstruct(&points), truth);
}
