//! The prover: halves boxes until a condition refutes each.
//!
//! Nothing here has to be right: the checker decides.

use crate::arcs;
use crate::centers;
use crate::certificate::{Axis, Certificate, Curves, Leaf, Node, Reason};
use crate::checker::{bound, holds, reach, split};
use crate::configuration::{Configuration, Unknowns, root};
use crate::interval::Interval;
use std::sync::atomic::{AtomicBool, Ordering};

/// How much each unknown moves z: the box is halved where the product with its width is largest.
fn weights(curves: Curves) -> [f64; 4] {
    match curves {
        Curves::Smooth => [1.0, 0.6, 2.5, 1.0],
        Curves::Arcs => [2.5, 1.5, 0.0, 1.0],
    }
}

/// How often a box is halved before its parts are no longer shared among threads.
const SHARED: u32 = 12;

/// How many claims about the midpoint are tried.
const CLAIMS: u32 = 5;

/// How many centres of balls are tried again in the next boxes.
const RECENT: usize = 4;

/// Conditions that need no claim.
const SIMPLE: [Reason; 8] = [
    Reason::Far,
    Reason::Nearest,
    Reason::Backwards,
    Reason::Reach,
    Reason::DiscAtS1,
    Reason::DiscAtQ,
    Reason::Sides,
    Reason::Ends,
];

/// Those that a claim makes stronger.
const WITH_A_CLAIM: [Reason; 3] = [Reason::DiscAtQ, Reason::Sides, Reason::Ends];

/// A box that no condition refutes.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error("a box resists: |q s1|, curvature, tangent of half the angle, |q z| in {unknowns:?}")]
pub struct Resisting {
    /// The least and the largest of each unknown.
    pub unknowns: [[f64; 2]; 4],
}

/// A certificate for some curves and every rho below `rho`. Boxes narrower than `least` are given
/// up.
///
/// # Errors
///
/// The first box of the order of nodes that is given up.
pub fn prove(curves: Curves, rho: f64, least: f64) -> Result<Certificate, Resisting> {
    let prover = Prover {
        curves,
        rho: Interval::around(rho),
        least,
    };
    let mut nodes = Vec::new();
    let all = Part {
        unknowns: root(prover.rho),
        claim: None,
    };
    prover.shared(all, SHARED, &mut nodes, None)?;
    Ok(Certificate { curves, rho, nodes })
}

/// A box and a claim about the midpoint that holds in a larger one.
#[derive(Clone, Copy)]
struct Part {
    unknowns: Unknowns,
    claim: Option<f64>,
}

/// Whether boxes before others in the order of nodes have failed: then those do not matter.
struct Before<'a> {
    failed: &'a AtomicBool,
    before: Option<&'a Before<'a>>,
}

impl Before<'_> {
    fn has_failed(&self) -> bool {
        self.failed.load(Ordering::Relaxed) || self.before.is_some_and(Self::has_failed)
    }
}

struct Prover {
    curves: Curves,
    rho: Interval,
    least: f64,
}

impl Prover {
    /// Appends the nodes of a box; its halves may be refuted at the same time.
    fn shared(
        &self,
        part: Part,
        depth: u32,
        nodes: &mut Vec<Node>,
        before: Option<&Before>,
    ) -> Result<(), Resisting> {
        let mut recent = Vec::new();
        if depth == 0 {
            return self.alone(part, &mut recent, nodes, before);
        }
        let Some([lower, upper]) = self.step(part, &mut recent, nodes)? else {
            return Ok(());
        };
        let all = |part, before| {
            let mut nodes = Vec::new();
            self.shared(part, depth - 1, &mut nodes, before)
                .map(|()| nodes)
        };
        let failed = AtomicBool::new(false);
        let upper = || {
            let nodes = all(upper, before);
            failed.store(nodes.is_err(), Ordering::Relaxed);
            nodes
        };
        let earlier = Before {
            failed: &failed,
            before,
        };
        let (upper, lower) = rayon::join(upper, || all(lower, Some(&earlier)));
        nodes.extend(upper?);
        nodes.extend(lower?);
        Ok(())
    }

    fn alone(
        &self,
        part: Part,
        recent: &mut Vec<[f64; 2]>,
        nodes: &mut Vec<Node>,
        before: Option<&Before>,
    ) -> Result<(), Resisting> {
        let mut open = vec![part];
        while let Some(part) = open.pop() {
            if before.is_some_and(Before::has_failed) {
                break;
            }
            open.extend(self.step(part, recent, nodes)?.into_iter().flatten());
        }
        Ok(())
    }

    /// Appends the node of a box: what is left are its halves, if it is not refuted.
    fn step(
        &self,
        mut part: Part,
        recent: &mut Vec<[f64; 2]>,
        nodes: &mut Vec<Node>,
    ) -> Result<Option<[Part; 2]>, Resisting> {
        if let Some(leaf) = self.refutation(&mut part, recent) {
            nodes.push(Node::Leaf(leaf));
            return Ok(None);
        }
        let (axis, width) = widest(self.curves, &part.unknowns);
        if width < self.least {
            let unknowns = part.unknowns.map(|unknown| [unknown.low(), unknown.high()]);
            return Err(Resisting { unknowns });
        }
        nodes.push(Node::Split(axis));
        let claim = part.claim;
        Ok(Some(
            split(&part.unknowns, axis).map(|unknowns| Part { unknowns, claim }),
        ))
    }

    /// A leaf for a box, if there is one; it may improve the claim.
    fn refutation(&self, part: &mut Part, recent: &mut Vec<[f64; 2]>) -> Option<Leaf> {
        match self.curves {
            Curves::Smooth => self.smooth(part, recent),
            Curves::Arcs => self.arcs(part, recent),
        }
    }

    fn arcs(&self, part: &Part, recent: &mut Vec<[f64; 2]>) -> Option<Leaf> {
        let case = arcs::arc(&part.unknowns, self.rho);
        let refutes = |reason: &Reason| arcs::refutes(reason, &case);
        let simple = SIMPLE.into_iter().find(refutes);
        let ball = || with_a_ball(&case, recent, centers::best(&case), refutes);
        let reason = simple.or_else(ball)?;
        Some(Leaf {
            midpoint: None,
            reason,
        })
    }

    fn smooth(&self, part: &mut Part, recent: &mut Vec<[f64; 2]>) -> Option<Leaf> {
        let configuration = Configuration::new(&part.unknowns, self.rho);
        let crude = bound(&configuration, None);
        let simple = |reason: &Reason| holds(reason, &configuration, crude);
        if let Some(reason) = SIMPLE.into_iter().find(simple) {
            return Some(Leaf {
                midpoint: None,
                reason,
            });
        }
        let leaf = with_claim(&configuration, part.claim, recent, None);
        let is_true = |leaf: &Leaf| reach(&configuration, leaf.midpoint).is_some();
        if let Some(leaf) = leaf.filter(is_true) {
            return Some(leaf);
        }
        if holds(&Reason::NoMidpoint, &configuration, crude) {
            let reason = Reason::NoMidpoint;
            return Some(Leaf {
                midpoint: None,
                reason,
            });
        }
        part.claim = best_claim(&configuration, part.claim);
        let reach = bound(&configuration, part.claim);
        let rim = centers::rim(&configuration, reach);
        with_claim(&configuration, part.claim, recent, Some(rim))
    }
}

/// The unknown that moves z most.
fn widest(curves: Curves, unknowns: &Unknowns) -> (Axis, f64) {
    let weights = weights(curves);
    let widths = Axis::ALL.map(|axis| unknowns[axis as usize].width() * weights[axis as usize]);
    let mut best = (Axis::Distance, widths[0]);
    for (axis, width) in Axis::ALL.into_iter().zip(widths) {
        if width > best.1 {
            best = (axis, width);
        }
    }
    best
}

/// A leaf that is right if the claim is: by a disc, a recent ball or one of more centres.
fn with_claim(
    configuration: &Configuration,
    midpoint: Option<f64>,
    recent: &mut Vec<[f64; 2]>,
    more: Option<Vec<[f64; 2]>>,
) -> Option<Leaf> {
    let reach = bound(configuration, midpoint);
    let refutes = |reason: &Reason| holds(reason, configuration, reach);
    if let Some(reason) = WITH_A_CLAIM.into_iter().find(refutes) {
        return Some(Leaf { midpoint, reason });
    }
    let reason = with_a_ball(configuration, recent, more.unwrap_or_default(), refutes)?;
    Some(Leaf { midpoint, reason })
}

/// A ball that refutes a configuration, about a recent centre or one of more.
fn with_a_ball(
    configuration: &Configuration,
    recent: &mut Vec<[f64; 2]>,
    more: Vec<[f64; 2]>,
    refutes: impl Fn(&Reason) -> bool,
) -> Option<Reason> {
    let all = recent.iter().rev().copied().chain(more);
    let (center, reason) = all
        .map(|center| (center, centers::ball(configuration, center)))
        .find(|(_, reason)| refutes(reason))?;
    recent.retain(|other| other.map(f64::to_bits) != center.map(f64::to_bits));
    recent.push(center);
    if recent.len() > RECENT {
        recent.remove(0);
    }
    Some(reason)
}

/// The largest of some claims about the midpoint that hold.
fn best_claim(configuration: &Configuration, known: Option<f64>) -> Option<f64> {
    let is_true = |claim: f64| reach(configuration, Some(claim)).is_some();
    // The search of the checker is no finer in a smaller box; so what is known may be lost.
    let mut best = known.filter(|claim| is_true(*claim));
    let mut low = best.unwrap_or(0.5 * configuration.distance.low());
    let mut high = 0.5 * (configuration.rho * configuration.height).high();
    for _ in 0..CLAIMS {
        let claim = centers::rounded(0.5 * (low + high));
        if is_true(claim) {
            best = Some(claim);
            low = claim;
        } else {
            high = claim;
        }
    }
    best
}
