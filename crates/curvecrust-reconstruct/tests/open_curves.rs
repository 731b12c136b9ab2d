//! Open curves end where they end, with and without marked termini.

#![allow(
    clippy::panic,
    clippy::unwrap_used,
    reason = "a test that fails panics"
)]

use std::f64::consts::TAU;

use curvecrust_geometry::{DVec2, PointId, PointSet};
use curvecrust_reconstruct::{HnnCrust, Reconstruction, Reconstructor};

/// Points in order along an open curve are joined in that order and open at both ends.
fn assert_open(curve: Vec<DVec2>) {
    let points = PointSet::new(curve).unwrap();
    let order: Vec<PointId> = points.ids().collect();
    let found = Reconstruction::by(&HnnCrust::MUTUAL, &points);
    let [only] = found.chains() else {
        panic!("{} chains", found.chains().len())
    };
    assert!(!only.chain.is_closed());
    assert_eq!(only.chain.vertices(), order);
    assert_eq!(only.nesting, None);

    let termini = [order[0], order[order.len() - 1]];
    assert_eq!(found.leaves(), termini);
    let marked = HnnCrust::MUTUAL
        .reconstruct_open(&points, &termini)
        .unwrap();
    assert_eq!(&marked, found.edges());
}

#[test]
fn a_sine_arc() {
    for n in [40, 100, 1000] {
        let x = |i: i32| TAU * f64::from(i) / f64::from(n);
        assert_open((0..=n).map(|i| DVec2::new(x(i), x(i).sin())).collect());
    }
}

#[test]
fn a_spiral() {
    // Three turns of an Archimedean spiral, 1 apart, at even steps of its angle.
    for n in [120, 400, 2000] {
        let turn = |i: i32| 1.0 + 3.0 * f64::from(i) / f64::from(n);
        let at = |i| turn(i) * DVec2::from_angle(TAU * turn(i));
        assert_open((0..=n).map(at).collect());
    }
}

#[test]
fn ends_that_face_each_other_need_termini() {
    // An arc of 37 steps out of 40: each end is the other's half neighbour.
    let arc = (0..=37).map(|i| DVec2::from_angle(TAU * f64::from(i) / 40.0));
    let points = PointSet::new(arc.collect()).unwrap();
    assert_eq!(HnnCrust::MUTUAL.reconstruct(&points).len(), 38);
    let termini = [0, 37].map(PointId::from);
    let open = HnnCrust::MUTUAL
        .reconstruct_open(&points, &termini)
        .unwrap();
    assert_eq!((open.len(), open.leaves()), (37, termini.to_vec()));
}
