//! The certificate is accepted, and nothing weaker is.

use super::{Node, accepts, prove};

#[test]
fn all_curves_are_proven_and_a_weaker_certificate_is_refused() {
    let rho = 0.8;
    let certificate = prove(rho).expect("0.8 is proven");
    assert!(accepts(rho, &certificate));
    assert!(!accepts(rho, &certificate[1..]));
    assert!(
        !accepts(0.9, &certificate),
        "what holds at 0.8 is no proof at 0.9"
    );
    let smaller: Vec<Node> = certificate
        .iter()
        .map(|node| match node {
            Node::Ball { center, radius } => Node::Ball {
                center: *center,
                radius: radius * 0.999,
            },
            node => node.clone(),
        })
        .collect();
    assert!(!accepts(rho, &smaller), "a ball a thousandth smaller");
}

#[test]
fn where_the_theorem_is_false_a_box_resists() {
    assert!(prove(0.9).is_err());
}
