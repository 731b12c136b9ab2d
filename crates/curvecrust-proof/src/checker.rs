//! The checker: whether each leaf of a certificate refutes its box, and the boxes are all there is.
//!
//! It shares the format and the interval type with the prover and uses nothing else of it.

use crate::ball;
use crate::certificate::{Axis, Certificate, Leaf, Node, Reason};
use crate::configuration::{Configuration, Unknowns, root};
use crate::interval::Interval;
use crate::midpoint;

/// The lemmas are proven for rho below this.
const LARGEST: f64 = 0.9;

/// Why a certificate is no proof.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum Refusal {
    /// The lemmas do not hold for such a rho.
    #[error("rho is {rho}, and the lemmas are proven for less than 0.9")]
    Rho {
        /// What the certificate says.
        rho: f64,
    },
    /// A node after the last box.
    #[error("node {node} is about no box: those before cover everything")]
    Left {
        /// Its index.
        node: usize,
    },
    /// Boxes without a node.
    #[error("{boxes} boxes have no node")]
    Missing {
        /// How many.
        boxes: usize,
    },
    /// A leaf does not refute its box.
    #[error("the reason of node {node} does not refute its box")]
    Unfounded {
        /// Its index.
        node: usize,
    },
}

/// Checks that a certificate proves Theorem 2 for its rho, given the lemmas of `docs/theorem-2.md`.
///
/// # Errors
///
/// The first node that is in the way.
pub fn check(certificate: &Certificate) -> Result<(), Refusal> {
    let rho = Interval::around(certificate.rho);
    if !(rho.is_positive() && rho.is_below(Interval::point(LARGEST))) {
        return Err(Refusal::Rho {
            rho: certificate.rho,
        });
    }
    let mut open = vec![root(rho)];
    for (node, what) in certificate.nodes.iter().enumerate() {
        let Some(unknowns) = open.pop() else {
            return Err(Refusal::Left { node });
        };
        match what {
            Node::Split(axis) => open.extend(split(&unknowns, *axis)),
            Node::Leaf(leaf) if refutes(&unknowns, rho, leaf) => {}
            Node::Leaf(_) => return Err(Refusal::Unfounded { node }),
        }
    }
    if open.is_empty() {
        Ok(())
    } else {
        Err(Refusal::Missing { boxes: open.len() })
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

/// Whether a leaf refutes a box of the four unknowns: |q s1|, the curvature of the circle through q
/// and s1, the tangent of half the angle at q, |q z|. The number rho may be any in an interval.
#[must_use]
pub fn refutes(unknowns: &Unknowns, rho: Interval, leaf: &Leaf) -> bool {
    let configuration = Configuration::new(unknowns, rho);
    let reach = reach(&configuration, leaf.midpoint);
    reach.is_some_and(|reach| holds(&leaf.reason, &configuration, reach))
}

/// A lower bound of lfs between s0 and s1 if a claim about |x s1| is true; none if it is not.
pub(crate) fn reach(configuration: &Configuration, claim: Option<f64>) -> Option<Interval> {
    let lfs = configuration.lfs(bound(configuration, None));
    let holds = claim.is_none_or(|claim| midpoint::is_beyond(claim, configuration, lfs));
    holds.then(|| bound(configuration, claim))
}

/// A lower bound of lfs between s0 and s1: by |q s1|, and by |x s1| if the claim about it is true.
pub(crate) fn bound(configuration: &Configuration, claim: Option<f64>) -> Interval {
    let rho = configuration.rho;
    let by_q = 0.5 * (configuration.distance / rho);
    let by_x = claim.map_or(by_q, |claim| Interval::point(claim) / rho);
    by_q.lower().max(by_x.lower())
}

/// Whether a reason refutes a configuration. `reach` is a lower bound of lfs between s0 and s1.
pub(crate) fn holds(reason: &Reason, configuration: &Configuration, reach: Interval) -> bool {
    let Configuration {
        rho,
        distance,
        curvature,
        height,
        q,
        tangent,
        normal,
        z,
        slope,
    } = *configuration;
    let one = Interval::point(1.0);
    let lfs = configuration.lfs(reach);
    let above = || configuration.radius(lfs, 1.0);
    let below = || configuration.radius(lfs, -1.0);
    match reason {
        Reason::Far => (4.0 * rho.square()).is_below(configuration.square_of_z()),
        Reason::Nearest => (distance + 2.0 * (height * slope)).is_negative(),
        Reason::Backwards => q.dot(tangent).is_positive(),
        Reason::Reach => (rho * height).is_below(distance),
        Reason::DiscAtS1 => z.square().is_below(2.0 * z.y) || z.square().is_below(-(2.0 * z.y)),
        Reason::DiscAtQ => height.is_below(2.0 * above()),
        Reason::Sides => {
            let (square, turn) = (distance.square(), one - normal.y);
            let offset = distance * slope;
            (square * (one - curvature)).is_below(2.0 * (above() * (turn - offset)))
                || (square * (one + curvature)).is_below(2.0 * (below() * (turn + offset)))
        }
        Reason::Ends => {
            distance.is_below(-(2.0 * (above() * slope)))
                || distance.is_below(2.0 * (below() * slope))
        }
        Reason::NoMidpoint => midpoint::is_beyond(f64::INFINITY, configuration, lfs),
        Reason::Ball { center, radius } => ball::refutes(configuration, reach, *center, *radius),
    }
}
