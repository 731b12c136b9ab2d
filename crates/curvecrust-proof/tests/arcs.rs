//! The proof for arcs: its certificate, and the discs that its checker takes as free of an arc.
#![allow(clippy::unwrap_used, reason = "a test, its helpers included")]

use curvecrust_proof::{Axis, Certificate, Curves, Interval, Leaf, Node, Reason, check, prove};
use curvecrust_proof::{Refusal, Resisting};
use proptest::prelude::*;
use std::sync::LazyLock;

static PROVEN: LazyLock<Certificate> = LazyLock::new(|| prove(Curves::Arcs, 0.8945, 1e-6).unwrap());

/// The certificate with each ball changed in turn.
fn with_a_changed_ball(
    change: fn(&mut [f64; 2], &mut f64),
) -> impl Iterator<Item = (usize, Certificate)> {
    (0..PROVEN.nodes.len()).filter_map(move |index| {
        let mut certificate = PROVEN.clone();
        match &mut certificate.nodes[index] {
            Node::Leaf(Leaf {
                reason: Reason::Ball { center, radius },
                ..
            }) => change(center, radius),
            _ => return None,
        }
        Some((index, certificate))
    })
}

#[test]
fn it_is_accepted_and_its_text_too() {
    assert_eq!(check(&PROVEN), Ok(()));
    let read: Certificate = PROVEN.to_string().parse().unwrap();
    assert_eq!(read, *PROVEN);
}

#[test]
fn a_ball_a_thousandth_smaller_or_too_large_is_refused() {
    let smaller = with_a_changed_ball(|_, radius| *radius *= 0.999);
    let larger = with_a_changed_ball(|_, radius| *radius *= 2.0);
    let farther = with_a_changed_ball(|center, _| *center = center.map(|x| 1.2 * x));
    let mut all = 0;
    for (node, certificate) in smaller.chain(larger).chain(farther) {
        assert_eq!(check(&certificate), Err(Refusal::Unfounded { node }));
        all += 1;
    }
    assert!(all > 1000);
}

/// The point x is on the arc: no claim about it is needed, and none is accepted.
#[test]
fn a_claim_is_refused() {
    let mut certificate = PROVEN.clone();
    let leaves = certificate.nodes.iter_mut().filter_map(|node| match node {
        Node::Leaf(leaf) => Some(leaf),
        Node::Split(_) => None,
    });
    leaves.for_each(|leaf| leaf.midpoint = Some(0.0));
    assert!(matches!(
        check(&certificate),
        Err(Refusal::Unfounded { .. })
    ));
}

/// What is proven for arcs is not proven for all curves.
#[test]
fn as_a_certificate_for_all_curves_it_is_refused() {
    let mut certificate = PROVEN.clone();
    certificate.curves = Curves::Smooth;
    assert!(matches!(
        check(&certificate),
        Err(Refusal::Unfounded { .. })
    ));
}

#[test]
fn a_larger_rho_is_refused() {
    let mut certificate = PROVEN.clone();
    certificate.rho = 0.8999;
    assert!(matches!(
        check(&certificate),
        Err(Refusal::Unfounded { .. })
    ));
}

/// The bound is sharp but for a hundred-thousandth.
#[test]
fn it_is_proven_up_to_the_counterexample() {
    let proven: Result<_, Resisting> = prove(Curves::Arcs, 0.895_01, 1e-7);
    assert_eq!(check(&proven.unwrap()), Ok(()));
    assert!(prove(Curves::Arcs, 0.895_019, 1e-7).is_err());
}

/// The point at a distance from s1 on the circle of a curvature that touches the x axis there, and
/// the direction of the circle.
fn on_the_circle(curvature: f64, distance: f64) -> [[f64; 2]; 2] {
    let angle = (0.5 * curvature * distance).asin();
    let at = [-distance * angle.cos(), -distance * angle.sin()];
    [at, [(2.0 * angle).cos(), (2.0 * angle).sin()]]
}

/// The point at a height above a point with a direction.
fn raised([[x, y], [u, v]]: [[f64; 2]; 2], height: f64) -> [f64; 2] {
    [x - height * v, y + height * u]
}

fn distance([a, b]: [f64; 2], [x, y]: [f64; 2]) -> f64 {
    (a - x).hypot(b - y)
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 4000, failure_persistence: None, ..ProptestConfig::default() })]

    /// A disc about a point off the medial axis is taken as free of the curve if and only if it is
    /// free of points of the arc, and on a normal of the arc.
    /// For a wider box it is taken so if it is for each part.
    #[test]
    fn the_distance_to_an_arc_is_that_to_its_points(
        curvature in -1.0..1.0_f64,
        chord in 0.1..0.85_f64,
        toward in 0.3..1.8_f64,
        wide in 0.0..0.01_f64,
        (part, height) in (-0.3..1.3_f64, -0.3..0.999_f64),
    ) {
        let [q, tangent] = on_the_circle(curvature, chord);
        let center = raised(on_the_circle(curvature, part * chord), height);
        let points = (0..=4000).map(|i| on_the_circle(curvature, chord * f64::from(i) / 4000.0)[0]);
        let least = points.map(|p| distance(center, p)).fold(f64::INFINITY, f64::min);
        let unknowns = [chord, curvature, tangent[1] / (1.0 + tangent[0]), toward];
        let refutes = |wide: f64, radius| {
            let reason = Reason::Ball { center, radius };
            let leaf = Leaf { midpoint: None, reason };
            let unknowns = unknowns.map(|x| Interval::new(x - wide, x + wide));
            Curves::Arcs.refutes(&unknowns, Interval::point(0.89), &leaf)
        };
        prop_assert!(!refutes(0.0, 1.0001 * least) && !refutes(wide, 1.0001 * least));
        let lfs = (1.0 - chord).max(chord / 0.89);
        let off_the_axis = distance(center, [0.0, 0.0]) < 1.0 || distance(center, q) < lfs;
        let holds_z = distance(center, raised([q, tangent], toward)) < 0.999 * least;
        let is_free = off_the_axis && height > 0.0 && 0.0 < part && part < 1.0;
        prop_assert!(refutes(0.0, 0.99 * least) || !refutes(wide, 0.99 * least));
        prop_assert_eq!(refutes(0.0, 0.999 * least), is_free && holds_z);
    }
}

/// The angle is no unknown of an arc: to halve it only makes the same box twice.
#[test]
fn a_box_halved_along_the_angle_needs_both_halves() {
    let mut certificate = PROVEN.clone();
    certificate.nodes.insert(0, Node::Split(Axis::Angle));
    let boxes = 1;
    assert_eq!(check(&certificate), Err(Refusal::Missing { boxes }));
}

/// What has to be read to believe it, besides the checker for all curves.
#[test]
fn the_checker_of_arcs_is_short_and_compares_intervals_only() {
    let lines = include_str!("../src/arcs.rs").lines().map(str::trim);
    let code = lines.filter(|line| !line.is_empty() && !line.starts_with("//"));
    assert!(code.clone().count() < 70);
    let compares = |line: &&str| {
        [" < ", " <= ", " > ", " >= ", " == "]
            .iter()
            .any(|sign| line.contains(sign))
    };
    assert_eq!(code.clone().find(compares), None);
}
