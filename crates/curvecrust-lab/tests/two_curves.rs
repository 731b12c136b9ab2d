//! Two curves of one set of samples: no algorithm can be right on both.
#![allow(clippy::unwrap_used, reason = "a test, its helpers included")]

use curvecrust::DVec2;
use curvecrust::geometry::{Edge, EdgeSet, PointId, PointSet, Random};
use curvecrust::reconstruct::{LeastDetour, Reconstructor};
use curvecrust_lab::counterexamples::{ProvenSamples, two_curves, two_sparser_curves};

/// The edges of the second curve in terms of the samples of the first.
fn renamed(edges: &EdgeSet, from: &PointSet, to: &PointSet) -> EdgeSet {
    let same = |id: PointId| {
        let apart = |other: &usize| to.points()[*other].distance(from[id]);
        let nearest = (0..to.len())
            .min_by(|a, b| apart(a).total_cmp(&apart(b)))
            .unwrap();
        assert!(
            apart(&nearest) < 1e-12,
            "a sample of one curve is one of the other"
        );
        PointId::new(nearest).unwrap()
    };
    let edges = edges.edges().iter();
    let renamed = edges.map(|edge| Edge::new(same(edge.a()), same(edge.b())).unwrap());
    EdgeSet::new(to.len(), renamed)
}

#[test]
fn both_are_sampled_alike() {
    // Below the 0.7171 that was known in floating point.
    let [_, sparser] = [two_curves(), two_sparser_curves()].map(|curves| {
        let curves = curves.unwrap();
        for one in &curves {
            one.prove().unwrap();
        }
        let (_, [truth, other]) = pair(&curves);
        assert_eq!(truth.len(), other.len());
        assert_eq!(truth.difference(&other).count(), 4);
        assert_eq!(other.difference(&truth).count(), 4);
        curves
    });
    assert!(sparser.iter().all(|one| one.bound.value() < 0.7171));
}

/// The margins of the edges that not both curves have.
fn margins(points: &PointSet, edges: [&EdgeSet; 2]) -> Vec<f64> {
    let explained = LeastDetour.explain(points, &[]).unwrap().unwrap();
    let in_doubt = explained.edges.iter().filter(|found| {
        let [one, other] = edges.map(|edges| edges.contains(found.edge));
        one != other
    });
    in_doubt
        .map(|found| found.margin_at_most.unwrap())
        .collect()
}

/// The samples of a pair, and the edges of both curves.
fn pair(curves: &[ProvenSamples; 2]) -> (PointSet, [EdgeSet; 2]) {
    let [points, others] = curves.each_ref().map(|curve| curve.points().unwrap());
    let [truth, other] = curves.each_ref().map(|curve| curve.truth());
    let other = renamed(&other, &others, &points);
    (points, [truth, other])
}

#[test]
fn least_detour_says_that_both_pairs_are_ambiguous() {
    for curves in [two_curves(), two_sparser_curves()] {
        let (points, edges) = pair(&curves.unwrap());
        let even = margins(&points, edges.each_ref());
        assert_eq!(even.len(), 4);
        assert!(even.iter().all(|margin| margin.abs() < 1e-12), "{even:?}");
    }
}

#[test]
fn a_nudge_decides() {
    let (points, edges) = pair(&two_curves().unwrap());
    let mut random = Random::new(1);
    let mut nudged =
        |p: &DVec2| *p + 1e-3 * DVec2::new(random.between(-1.0, 1.0), random.between(-1.0, 1.0));
    let nudged = PointSet::new(points.points().iter().map(&mut nudged).collect()).unwrap();
    let decided = margins(&nudged, edges.each_ref());
    assert_eq!(decided.len(), 4);
    assert!(decided.iter().all(|margin| *margin > 1e-4), "{decided:?}");
}
