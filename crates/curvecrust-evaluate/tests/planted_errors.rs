//! The metrics against errors that were put there.
#![allow(clippy::unwrap_used, reason = "a test may panic")]
#![allow(clippy::float_cmp, reason = "shares and counts are exact")]

use curvecrust_curve::Curve;
use curvecrust_evaluate::{
    Bounds, EdgeComparison, Evaluation, Kind, METRICS, Output, Reference, Topology, Truth,
};
use curvecrust_geometry::{DVec2, Edge, EdgeSet, PointId, PointSet, Segment};
use proptest::prelude::*;
use std::f64::consts::{PI, TAU};

fn ring(n: usize, radius: f64) -> Vec<DVec2> {
    let at = |i| DVec2::from_angle(TAU * i as f64 / n as f64) * radius;
    (0..n).map(at).collect()
}

fn edge(p: usize, q: usize) -> Edge {
    Edge::new(PointId::new(p).unwrap(), PointId::new(q).unwrap()).unwrap()
}

/// A large and a small ring about one centre, one after the other.
fn two_rings(n: usize, m: usize) -> (PointSet, EdgeSet, Reference) {
    let points: Vec<DVec2> = ring(n, 2.0).into_iter().chain(ring(m, 0.2)).collect();
    let outer = (0..n).map(|i| edge(i, (i + 1) % n));
    let inner = (0..m).map(|i| edge(n + i, n + (i + 1) % m));
    let edges = EdgeSet::new(n + m, outer.chain(inner));
    let side = |e: &Edge| Segment::new(points[e.a().index()], points[e.b().index()]);
    let curve = Reference::of_segments(edges.edges().iter().map(side));
    (PointSet::new(points).unwrap(), edges, curve)
}

fn evaluate(
    points: &PointSet,
    boundary: &EdgeSet,
    curve: &Reference,
    found: &EdgeSet,
) -> Evaluation {
    let output = Output {
        vertices: points,
        edges: found,
        kind: Kind::Interpolating,
        seconds: Some(0.5),
    };
    Evaluation::new(Truth { curve, boundary }, output, 1e-3)
}

fn value(evaluation: &Evaluation, name: &str) -> Bounds {
    let metric = METRICS.iter().find(|m| m.name == name).unwrap();
    metric.of(evaluation).unwrap()
}

fn number(evaluation: &Evaluation, name: &str) -> f64 {
    let Bounds { lower, upper } = value(evaluation, name);
    assert_eq!(lower, upper, "{name}");
    lower
}

#[test]
fn the_truth_has_the_best_value_of_every_metric() {
    let (points, boundary, curve) = two_rings(12, 8);
    let found = evaluate(&points, &boundary, &curve, &boundary);
    for (name, best) in [
        ("exact", 1.0),
        ("edge_precision", 1.0),
        ("edge_recall", 1.0),
        ("topology", 1.0),
        ("closed_off", 0.0),
        ("open_off", 0.0),
        ("degree_0", 0.0),
        ("degree_2", 20.0),
        ("run_time", 0.5),
    ] {
        assert_eq!(number(&found, name), best, "{name}");
    }
    for name in ["hausdorff", "rms_curve", "rms_output"] {
        let Bounds { lower, upper } = value(&found, name);
        assert!(lower < 1e-12 && upper < 1.5e-3, "{name}: {upper}");
    }
    // The inner ring has the sharper angles.
    assert!((number(&found, "min_angle") - 135.0).abs() < 1e-9);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(100))]
    #[test]
    fn each_removed_added_or_swapped_edge_is_found(
        n in 5usize..20,
        m in 5usize..20,
        removed in 0usize..40,
        added in (0usize..40, 0usize..40),
    ) {
        let (points, boundary, curve) = two_rings(n, m);
        let gone = boundary.edges()[removed % boundary.len()];
        let (p, q) = (added.0 % (n + m), added.1 % (n + m));
        let extra = Edge::new(PointId::new(p).unwrap(), PointId::new(q).unwrap());
        let extra = extra.filter(|e| !boundary.contains(*e));
        let kept = || boundary.edges().iter().copied().filter(|&e| e != gone);

        let without = EdgeSet::new(n + m, kept());
        let c = EdgeComparison::new(&boundary, &without);
        prop_assert_eq!((c.missing, c.wrong.len(), c.correct.len()), (vec![gone], 0, n + m - 1));
        let found = evaluate(&points, &boundary, &curve, &without);
        prop_assert_eq!(number(&found, "exact"), 0.0);
        prop_assert_eq!(number(&found, "edge_precision"), 1.0);
        prop_assert_eq!(number(&found, "edge_recall"), (n + m - 1) as f64 / (n + m) as f64);
        prop_assert_eq!(number(&found, "topology"), 0.0);
        prop_assert_eq!((number(&found, "closed_off"), number(&found, "open_off")), (1.0, 1.0));
        // Half of the missing side, which is farther from all others.
        let half = points[gone.a()].distance(points[gone.b()]) / 2.0 / curve.extent();
        let Bounds { lower, upper } = value(&found, "hausdorff_curve");
        prop_assert!(lower <= half + 1e-12 && half <= upper + 1e-12);
        prop_assert!(value(&found, "hausdorff_output").lower < 1e-12);

        let Some(extra) = extra else { return Ok(()) };
        let with = EdgeSet::new(n + m, boundary.edges().iter().copied().chain([extra]));
        let c = EdgeComparison::new(&boundary, &with);
        prop_assert_eq!((c.missing.len(), c.wrong), (0, vec![extra]));
        let found = evaluate(&points, &boundary, &curve, &with);
        prop_assert_eq!(number(&found, "edge_recall"), 1.0);
        prop_assert_eq!(number(&found, "edge_precision"), (n + m) as f64 / (n + m + 1) as f64);
        prop_assert_eq!(number(&found, "degree_3"), 2.0);
        prop_assert!(number(&found, "topology") == 0.0);

        let swapped = EdgeSet::new(n + m, kept().chain([extra]));
        let c = EdgeComparison::new(&boundary, &swapped);
        prop_assert_eq!((c.missing, c.wrong), (vec![gone], vec![extra]));
        prop_assert_eq!(number(&evaluate(&points, &boundary, &curve, &swapped), "exact"), 0.0);
    }
}

#[test]
fn kinds_of_components() {
    let of = |n, edges: &[(usize, usize)]| {
        Topology::new(&EdgeSet::new(n, edges.iter().map(|&(p, q)| edge(p, q))))
    };
    let path = of(4, &[(0, 1), (1, 2)]);
    assert_eq!((path.open, path.closed, path.branching), (1, 0, 0));
    // A theta: no leaf, and yet no ring.
    let theta = of(4, &[(0, 1), (1, 2), (2, 3), (3, 0), (0, 2)]);
    assert_eq!((theta.open, theta.closed, theta.branching), (0, 0, 1));
    let none = of(3, &[]);
    assert_eq!((none.open, none.closed, none.branching), (0, 0, 0));
    assert_eq!(none.degrees, [3, 0, 0, 0]);
}

/// Inscribed polygons of a circle: the distance along the arc is known in closed form.
#[test]
fn root_mean_squares_of_inscribed_polygons() {
    let circle = Curve::from_path_data("M 1 0 A 1 1 0 0 1 -1 0 A 1 1 0 0 1 1 0 Z").unwrap();
    let curve = Reference::of_curve(&circle, 1e-5);
    for n in [3usize, 4, 7, 20] {
        let points = PointSet::new(ring(n, 1.0)).unwrap();
        let edges = EdgeSet::new(n, (0..n).map(|i| edge(i, (i + 1) % n)));
        let rms = curve.distances(&points, &edges, 1e-3).rms;
        let steps = 100_000;
        let half = PI / n as f64;
        let middle = |i: usize| half * ((2 * i + 1) as f64 / steps as f64 - 1.0);
        let (mut arc, mut chord) = (0.0, 0.0);
        for i in 0..steps {
            arc += (middle(i).cos() - half.cos()).powi(2) / steps as f64;
            let along = half.sin() * ((2 * i + 1) as f64 / steps as f64 - 1.0);
            chord += (1.0 - half.cos().hypot(along)).powi(2) / steps as f64;
        }
        for (found, truth) in [
            (rms.curve_to_polygon, arc.sqrt()),
            (rms.polygon_to_curve, chord.sqrt()),
        ] {
            assert!(
                found.lower <= truth && truth <= found.upper,
                "{found:?} {truth}"
            );
            let middle = f64::midpoint(found.lower, found.upper);
            assert!((middle - truth).abs() < 1e-4, "{n}: {middle} {truth}");
        }
    }
}

#[test]
fn an_approximating_output_has_distances_and_topology() {
    let (points, boundary, curve) = two_rings(12, 8);
    let shifted = points.points().iter().map(|&p| p + DVec2::new(0.01, 0.0));
    let shifted = PointSet::new(shifted.collect()).unwrap();
    let output = Output {
        vertices: &shifted,
        edges: &boundary,
        kind: Kind::Approximating,
        seconds: None,
    };
    let truth = Truth {
        curve: &curve,
        boundary: &boundary,
    };
    let found = Evaluation::new(truth, output, 1e-4);
    let values: Vec<_> = METRICS
        .iter()
        .filter(|m| m.of(&found).is_none())
        .map(|m| m.name)
        .collect();
    assert_eq!(
        values,
        ["exact", "edge_precision", "edge_recall", "run_time"]
    );
    assert_eq!(number(&found, "topology"), 1.0);
    let Bounds { lower, upper } = value(&found, "hausdorff");
    let shift = 0.01 / curve.extent();
    assert!(lower <= shift + 1e-12 && 0.9 * shift < upper);
}
