//! The checker: whether each leaf of a certificate refutes its box, and the boxes are all there is.
//!
//! It shares the format and the interval type with the prover and uses nothing else of it.

use crate::ball;
use crate::certificate::{Axis, Certificate, Leaf, Node, Reason, Refusal};
use crate::configuration::{Configuration, Unknowns, root};
use crate::interval::Interval;
use crate::midpoint;
use crate::vector::{Disc, Vector};

/// The lemmas are proven for rho below this.
const LARGEST: f64 = 0.9;

/// Checks that a certificate proves Theorem 2 for its curves and its rho, given the lemmas of
/// `docs/theorem-2.md`.
///
/// # Errors
///
/// The first node that is in the way.
pub fn check(certificate: &Certificate) -> Result<(), Refusal> {
    let rho = Interval::around(certificate.rho);
    if !(rho.is_positive() && rho.is_below(Interval::point(LARGEST))) {
        return Err(Refusal::Rho(certificate.rho));
    }
    let mut open = vec![root(rho)];
    for (node, what) in certificate.nodes.iter().enumerate() {
        let unknowns = open.pop().ok_or(Refusal::Left { node })?;
        match what {
            Node::Split(axis) => open.extend(split(&unknowns, *axis)),
            Node::Leaf(leaf) if certificate.curves.refutes(&unknowns, rho, leaf) => {}
            Node::Leaf(_) => return Err(Refusal::Unfounded { node }),
        }
    }
    match open.len() {
        0 => Ok(()),
        boxes => Err(Refusal::Missing { boxes }),
    }
}

/// The two halves of a box along one of the unknowns; the upper one is refuted first.
pub(crate) fn split(unknowns: &Unknowns, axis: Axis) -> [Unknowns; 2] {
    let axis = axis as usize;
    unknowns[axis].halves().map(|half| {
        let mut part = *unknowns;
        part[axis] = half;
        part
    })
}

/// Whether a leaf refutes a box of the four unknowns for all smooth curves.
pub(crate) fn refutes(unknowns: &Unknowns, rho: Interval, leaf: &Leaf) -> bool {
    let case = Configuration::new(unknowns, rho);
    reach(&case, leaf.midpoint).is_some_and(|reach| holds(&leaf.reason, &case, reach))
}

/// A lower bound of lfs between s0 and s1 if a claim about |x s1| is true; none if it is not.
pub(crate) fn reach(case: &Configuration, claim: Option<f64>) -> Option<Interval> {
    let lfs = case.lfs(bound(case, None));
    let holds = claim.is_none_or(|claim| midpoint::is_beyond(claim, case, lfs));
    holds.then(|| bound(case, claim))
}

/// A lower bound of lfs between s0 and s1: by |q s1|, and by |x s1| if the claim about it is true.
pub(crate) fn bound(case: &Configuration, claim: Option<f64>) -> Interval {
    let by_q = 0.5 * (case.distance / case.rho);
    let by_x = claim.map_or(by_q, |claim| Interval::point(claim) / case.rho);
    by_q.lower().max(by_x.lower())
}

/// Whether a reason refutes a configuration. `reach` is a lower bound of lfs between s0 and s1.
pub(crate) fn holds(reason: &Reason, case: &Configuration, reach: Interval) -> bool {
    let (distance, height, slope) = (case.distance, case.height, case.slope);
    let one = Interval::point(1.0);
    let lfs = case.lfs(reach);
    let above = || case.radius(lfs, 1.0);
    let below = || case.radius(lfs, -1.0);
    match reason {
        Reason::Far => (4.0 * case.rho.square()).is_below(case.square_of_z()),
        Reason::Nearest => (distance + 2.0 * (height * slope)).is_negative(),
        Reason::Backwards => case.q.dot(case.tangent).is_positive(),
        Reason::Reach => (case.rho * height).is_below(distance),
        Reason::DiscAtS1 => [1.0, -1.0]
            .iter()
            .any(|y| Disc::unit([0.0, *y]).holds(case.z)),
        Reason::DiscAtQ => height.is_below(2.0 * above()),
        Reason::Sides => {
            let (square, turn) = (distance.square(), one - case.normal.y);
            let offset = distance * slope;
            (square * (one - case.curvature)).is_below(2.0 * (above() * (turn - offset)))
                || (square * (one + case.curvature)).is_below(2.0 * (below() * (turn + offset)))
        }
        Reason::Ends => distance.is_below((-2.0 * (above() * slope)).max(2.0 * (below() * slope))),
        Reason::NoMidpoint => midpoint::is_beyond(f64::INFINITY, case, lfs),
        Reason::Ball { center, radius } => {
            let disc = Disc::new(Vector::point(*center), Interval::point(*radius));
            ball::refutes(case, reach, disc)
        }
    }
}
