//! The checker accepts a certificate, and none that is weaker.
#![allow(clippy::unwrap_used, reason = "a test, its helpers included")]

use curvecrust_proof::{Axis, Certificate, Curves, Leaf, Node, Reason, Refusal, check, prove};
use std::sync::LazyLock;

static PROVEN: LazyLock<Certificate> = LazyLock::new(|| prove(Curves::Smooth, 0.8, 1e-4).unwrap());

/// The indices of the leaves for which a question is answered with yes.
fn leaves(mut asked: impl FnMut(&Leaf) -> bool) -> Vec<usize> {
    let nodes = PROVEN.nodes.iter().enumerate();
    let asked = |(i, node): (usize, &Node)| match node {
        Node::Leaf(leaf) if asked(leaf) => Some(i),
        _ => None,
    };
    nodes.filter_map(asked).collect()
}

/// Some of them, from all parts of the certificate.
fn some(all: &[usize]) -> impl Iterator<Item = usize> {
    all.iter().copied().step_by(all.len() / 20 + 1)
}

/// The certificate with one leaf changed.
fn changed(index: usize, change: impl Fn(&mut Leaf)) -> Certificate {
    let mut certificate = PROVEN.clone();
    if let Node::Leaf(leaf) = &mut certificate.nodes[index] {
        change(leaf);
    }
    certificate
}

fn refuses_at(index: usize, certificate: &Certificate) {
    assert_eq!(check(certificate), Err(Refusal::Unfounded { node: index }));
}

#[test]
fn it_is_accepted_and_its_text_too() {
    assert_eq!(check(&PROVEN), Ok(()));
    let text = PROVEN.to_string();
    let read: Certificate = text.parse().unwrap();
    assert_eq!(read, *PROVEN);
}

#[test]
fn every_condition_is_used() {
    let kinds = [
        Reason::Far,
        Reason::Nearest,
        Reason::Backwards,
        Reason::Reach,
        Reason::DiscAtQ,
        Reason::Sides,
        Reason::NoMidpoint,
    ];
    for kind in kinds {
        assert!(!leaves(|leaf| leaf.reason == kind).is_empty(), "{kind:?}");
    }
    let with_a_claim = leaves(|leaf| leaf.midpoint.is_some());
    let balls = leaves(|leaf| matches!(leaf.reason, Reason::Ball { .. }));
    assert!(with_a_claim.len() > 20 && balls.len() > 20);
}

#[test]
fn a_ball_a_thousandth_smaller_is_refused() {
    let balls = leaves(|leaf| matches!(leaf.reason, Reason::Ball { .. }));
    for index in some(&balls) {
        let smaller = changed(index, |leaf| {
            if let Reason::Ball { radius, .. } = &mut leaf.reason {
                *radius *= 0.999;
            }
        });
        refuses_at(index, &smaller);
    }
}

#[test]
fn a_missing_and_a_needless_box_are_refused() {
    for index in some(&leaves(|_| true)) {
        let mut certificate = PROVEN.clone();
        certificate.nodes.remove(index);
        assert!(check(&certificate).is_err(), "node {index}");
    }
    let mut certificate = PROVEN.clone();
    certificate.nodes.pop();
    assert_eq!(check(&certificate), Err(Refusal::Missing { boxes: 1 }));
    certificate = PROVEN.clone();
    certificate.nodes.push(Node::Split(Axis::Angle));
    let node = PROVEN.nodes.len();
    assert_eq!(check(&certificate), Err(Refusal::Left { node }));
}

/// The prover takes the first reason that holds, so those before it do not.
#[test]
fn a_wrong_reason_is_refused() {
    for index in some(&leaves(|leaf| leaf.reason != Reason::Far)) {
        refuses_at(index, &changed(index, |leaf| leaf.reason = Reason::Far));
    }
}

#[test]
fn a_false_claim_is_refused() {
    // Where there is no place for the midpoint at all, every claim is true.
    let claims = leaves(|leaf| leaf.midpoint.is_some());
    let (mut all, mut refused) = (0, 0);
    for index in some(&claims) {
        let certificate = changed(index, |leaf| {
            leaf.midpoint = leaf.midpoint.map(|claim| 1.1 * claim);
        });
        all += 1;
        refused += usize::from(check(&certificate).is_err());
    }
    assert!(2 * refused > all, "{refused} of {all}");
    let mut certificate = PROVEN.clone();
    for index in claims {
        if let Node::Leaf(leaf) = &mut certificate.nodes[index] {
            leaf.midpoint = leaf.midpoint.map(|claim| 1.01 * claim);
        }
    }
    assert!(check(&certificate).is_err(), "all claims are 1 % larger");
}

/// Definition 3, and so every bound that contains rho, loosened by 1 %.
#[test]
fn a_larger_rho_is_refused() {
    let mut certificate = PROVEN.clone();
    certificate.rho *= 1.01;
    assert!(matches!(
        check(&certificate),
        Err(Refusal::Unfounded { .. })
    ));
    for rho in [0.9, 2.0, 0.0, -0.5, f64::NAN] {
        certificate.rho = rho;
        assert!(matches!(check(&certificate), Err(Refusal::Rho(_))), "{rho}");
    }
}

#[test]
fn what_is_no_certificate_names_its_line() {
    let text = PROVEN.to_string();
    for (wrong, line) in [
        (text.replacen("certificate", "paper", 1), 1),
        (text.replacen("rho 0.8", "rho", 1), 2),
        (format!("{text}4\n"), PROVEN.nodes.len() + 3),
        (format!("{text}far away\n"), PROVEN.nodes.len() + 3),
        (format!("{text}ball 1 2\n"), PROVEN.nodes.len() + 3),
        (format!("{text}x far\n"), PROVEN.nodes.len() + 3),
    ] {
        let error = wrong.parse::<Certificate>().unwrap_err();
        assert_eq!(error.line, line);
    }
}

/// What has to be read to believe the checker, besides the interval type and its vectors.
#[test]
fn the_checker_is_short() {
    let files = [
        include_str!("../src/checker.rs"),
        include_str!("../src/configuration.rs"),
        include_str!("../src/midpoint.rs"),
        include_str!("../src/ball.rs"),
    ];
    let lines = files.iter().flat_map(|text| text.lines().map(str::trim));
    let code = lines.filter(|line| !line.is_empty() && !line.starts_with("//"));
    assert!(code.count() < 300);
}

/// All comparisons of floating-point numbers are those of the interval type.
#[test]
fn the_checker_compares_intervals_only() {
    for text in [
        include_str!("../src/checker.rs"),
        include_str!("../src/configuration.rs"),
        include_str!("../src/midpoint.rs"),
        include_str!("../src/ball.rs"),
        include_str!("../src/vector.rs"),
    ] {
        let code = text.lines().filter(|line| !line.trim().starts_with("//"));
        let compares = |line: &&str| {
            [" < ", " <= ", " >= ", " == ", " != "]
                .iter()
                .any(|sign| line.contains(sign))
                || line.contains(" > ") && !line.contains("depth > 0")
        };
        assert_eq!(code.clone().find(compares), None);
    }
}
