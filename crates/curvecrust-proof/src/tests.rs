//! The certificate needs each bound: with one that is looser by 1 %, leaves are refused.

use crate::certificate::{Certificate, Curves, Node, Reason};
use crate::checker::{bound, holds, split};
use crate::configuration::{Configuration, root};
use crate::interval::Interval;
use crate::prover::prove;
use std::sync::LazyLock;

static PROVEN: LazyLock<Certificate> =
    LazyLock::new(|| prove(Curves::Smooth, 0.8, 1e-4).expect("0.8 is proven"));

/// A bound that is looser by 1 %.
type Loosened = fn(&mut Configuration, &mut Interval);

/// For each reason, how many leaves use it and how many of them are lost.
fn lost(loosened: Loosened, of: fn(&Reason) -> bool) -> (usize, usize) {
    let certificate = &*PROVEN;
    let rho = Interval::around(certificate.rho);
    let mut open = vec![root(rho)];
    let (mut all, mut lost) = (0, 0);
    for node in &certificate.nodes {
        let unknowns = open.pop().expect("the certificate is whole");
        let leaf = match node {
            Node::Split(axis) => {
                open.extend(split(&unknowns, *axis));
                continue;
            }
            Node::Leaf(leaf) => leaf,
        };
        if of(&leaf.reason) {
            let mut configuration = Configuration::new(&unknowns, rho);
            let mut reach = bound(&configuration, leaf.midpoint);
            assert!(holds(&leaf.reason, &configuration, reach));
            loosened(&mut configuration, &mut reach);
            all += 1;
            lost += usize::from(!holds(&leaf.reason, &configuration, reach));
        }
    }
    (all, lost)
}

fn assert_needed(loosened: Loosened, of: fn(&Reason) -> bool) {
    let (all, lost) = lost(loosened, of);
    assert!(all > 10 && lost > 0, "{lost} of {all}");
}

fn is_ball(reason: &Reason) -> bool {
    matches!(reason, Reason::Ball { .. })
}

#[test]
fn the_bound_of_lfs_is_needed() {
    let loosened: Loosened = |_, reach| *reach = 0.99 * *reach;
    assert_needed(loosened, |reason| *reason == Reason::DiscAtQ);
    assert_needed(loosened, |reason| *reason == Reason::Sides);
    assert_needed(loosened, is_ball);
}

#[test]
fn the_bounds_of_q_and_z_are_needed() {
    assert_needed(
        |configuration, _| configuration.rho = 1.01 * configuration.rho,
        |reason| [Reason::Far, Reason::Reach, Reason::NoMidpoint].contains(reason),
    );
    // q may be farther away than the curve goes, and the nearest point nearer to z than q.
    let nearer: Loosened = |configuration, _| configuration.height = 0.99 * configuration.height;
    assert_needed(nearer, |reason| *reason == Reason::NoMidpoint);
    assert_needed(nearer, is_ball);
    let slower: Loosened = |configuration, _| {
        configuration.slope = configuration.slope + Interval::new(-0.01, 0.01);
    };
    assert_needed(slower, |reason| {
        [Reason::Nearest, Reason::Sides].contains(reason)
    });
}
