//! The prover: adaptive subdivision; for each box it tries the conditions, then balls.

use super::checker::{foot, needed_radius, refutes};
use super::interval::Interval;
use super::statement::{Node, Unknowns, root};
use std::f64::consts::{FRAC_PI_2, PI};

/// How much an unknown moves z: the largest product with the width is split.
const WEIGHTS: [f64; 4] = [1.0, 0.6, 2.5, 1.0];
/// Boxes below this weighted width are given up.
const LEAST: f64 = 2e-4;

/// A certificate for `rho`.
///
/// # Errors
///
/// The box that resists, if there is one.
pub fn prove(rho: f64) -> Result<Vec<Node>, String> {
    let rho = Interval::point(rho);
    let mut certificate = vec![];
    let mut open = vec![root(rho)];
    while let Some(unknowns) = open.pop() {
        if let Some(leaf) = refutation(&unknowns, rho) {
            certificate.push(leaf);
            continue;
        }
        let (axis, width) = widest(&unknowns);
        if width < LEAST {
            return Err(format!("a box resists: {unknowns:?}"));
        }
        certificate.push(Node::Split(axis));
        for half in unknowns[axis].halves() {
            let mut part = unknowns;
            part[axis] = half;
            open.push(part);
        }
    }
    Ok(certificate)
}

fn widest(unknowns: &Unknowns) -> (usize, f64) {
    let widths = [0, 1, 2, 3].map(|axis| (axis, unknowns[axis].width() * WEIGHTS[axis]));
    widths.into_iter().fold(
        (2, 0.0),
        |best, next| if next.1 > best.1 { next } else { best },
    )
}

fn refutation(unknowns: &Unknowns, rho: Interval) -> Option<Node> {
    if refutes(unknowns, rho, &Node::Refuted) {
        return Some(Node::Refuted);
    }
    if unknowns[2].straddles_one() {
        return None;
    }
    let about_s1 = (0..24).map(|i| FRAC_PI_2 + 1.6 * (f64::from(i) + 0.5) / 24.0);
    let [x, y] = foot(unknowns, rho);
    let about_q = (0..12).map(|i| PI * (f64::from(i) + 0.5) / 12.0);
    about_s1
        .map(|a| [(1.0 - 1e-9) * a.cos(), (1.0 - 1e-9) * a.sin()])
        .chain(about_q.map(|a| [x + 0.6 * a.cos(), y + 0.6 * a.sin()]))
        .map(|center| Node::Ball {
            center,
            radius: needed_radius(unknowns, rho, center),
        })
        .find(|ball| refutes(unknowns, rho, ball))
}
