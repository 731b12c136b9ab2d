//! The certificate: a tree of boxes, each halved or refuted for a reason; and its text.

use std::fmt;
use std::str::FromStr;

/// The curves that a certificate is about.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Curves {
    /// All closed smooth curves.
    Smooth,
    /// Those on which the interval from s0 to s1 is an arc of a circle, or a segment.
    Arcs,
}

impl Curves {
    /// The first line of the text.
    fn head(self) -> &'static str {
        match self {
            Self::Smooth => "curvecrust theorem-2 certificate 1",
            Self::Arcs => "curvecrust theorem-2 arcs certificate 1",
        }
    }
}

/// A tree of boxes of the four unknowns.
#[derive(Clone, Debug, PartialEq)]
pub struct Certificate {
    /// What the theorem is about.
    pub curves: Curves,
    /// Theorem 2 is to hold for every rho below this one.
    pub rho: f64,
    /// The nodes, each before its parts, the upper half after the lower one.
    pub nodes: Vec<Node>,
}

/// A box of the tree.
#[derive(Clone, Debug, PartialEq)]
pub enum Node {
    /// It is halved along the unknown of this index.
    Split(Axis),
    /// It is refuted.
    Leaf(Leaf),
}

/// The unknown along which a box is halved.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Axis {
    /// |q s1|.
    Distance,
    /// The curvature of the circle through q and s1.
    Curvature,
    /// The tangent of half the angle of the curve at q.
    Angle,
    /// |q z|.
    Height,
}

impl Axis {
    /// All, in the order of the unknowns.
    pub const ALL: [Self; 4] = [Self::Distance, Self::Curvature, Self::Angle, Self::Height];
}

/// Why no curve has its unknowns in a box.
#[derive(Clone, Debug, PartialEq)]
pub struct Leaf {
    /// A claim that the reason uses, if any: |x s1| is at least this.
    pub midpoint: Option<f64>,
    /// The condition that fails.
    pub reason: Reason,
}

/// A condition that fails for all of a box. The numbers are those of `docs/theorem-2.md`.
#[derive(Clone, Debug, PartialEq)]
pub enum Reason {
    /// z is farther from s1 than s2 can be (C1).
    Far,
    /// z is nearer to s1 than to q (C2).
    Nearest,
    /// The distance from s1 does not grow along the curve at q (C3).
    Backwards,
    /// q is farther from s1 than s0 can be (C4).
    Reach,
    /// z is in a disc at s1 (C5).
    DiscAtS1,
    /// z is in the disc above q (C6).
    DiscAtQ,
    /// A disc above the curve meets one below (C7).
    Sides,
    /// s1 is in a disc at q (C8).
    Ends,
    /// There is no place for s0 and x (C9).
    NoMidpoint,
    /// The point of the curve nearest to the centre of a ball that holds z has no place (C10).
    Ball {
        /// The centre.
        center: [f64; 2],
        /// The radius.
        radius: f64,
    },
}

/// Why a certificate is no proof.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum Refusal {
    /// The lemmas do not hold for such a rho.
    #[error("rho is {0}, and the lemmas are proven for less than 0.9")]
    Rho(f64),
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

/// The reasons that have no number, and their words.
const WORDS: [(&str, Reason); 9] = [
    ("far", Reason::Far),
    ("nearest", Reason::Nearest),
    ("backwards", Reason::Backwards),
    ("reach", Reason::Reach),
    ("disc-s1", Reason::DiscAtS1),
    ("disc-q", Reason::DiscAtQ),
    ("sides", Reason::Sides),
    ("ends", Reason::Ends),
    ("no-midpoint", Reason::NoMidpoint),
];

/// A text that is no certificate.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("line {line} of the certificate: expected {expected}")]
pub struct FormatError {
    /// The line, from 1.
    pub line: usize,
    /// What should be there.
    pub expected: &'static str,
}

/// One node a line.
impl fmt::Display for Certificate {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "{}\nrho {}", self.curves.head(), self.rho)?;
        for node in &self.nodes {
            writeln!(f, "{node}")?;
        }
        Ok(())
    }
}

impl fmt::Display for Node {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let leaf = match self {
            Self::Split(axis) => return write!(f, "{}", *axis as usize),
            Self::Leaf(leaf) => leaf,
        };
        if let Some(claim) = leaf.midpoint {
            write!(f, "x {claim} ")?;
        }
        if let Reason::Ball {
            center: [x, y],
            radius,
        } = leaf.reason
        {
            return write!(f, "ball {x} {y} {radius}");
        }
        let word = WORDS.iter().find(|(_, reason)| *reason == leaf.reason);
        f.write_str(word.map_or("", |(word, _)| word))
    }
}

impl FromStr for Certificate {
    type Err = FormatError;

    fn from_str(text: &str) -> Result<Self, FormatError> {
        let mut lines = text.lines();
        let error = |line, expected| FormatError { line, expected };
        let head = lines.next();
        let curves = [Curves::Smooth, Curves::Arcs]
            .into_iter()
            .find(|curves| head == Some(curves.head()))
            .ok_or(error(1, "the name of a certificate"))?;
        let rho = lines.next().and_then(|line| line.strip_prefix("rho "));
        let rho = rho.and_then(|rho| rho.parse().ok());
        let rho = rho.ok_or(error(2, "`rho` and a number"))?;
        let nodes = lines
            .enumerate()
            .map(|(i, line)| node(line).ok_or(error(i + 3, "an unknown, 0 to 3, or a reason")));
        let nodes = nodes.collect::<Result<_, _>>()?;
        Ok(Self { curves, rho, nodes })
    }
}

/// Reads one line.
fn node(line: &str) -> Option<Node> {
    let mut words = line.split(' ').peekable();
    if let Ok(index) = line.parse::<usize>() {
        return Axis::ALL.get(index).copied().map(Node::Split);
    }
    let midpoint = match words.next_if_eq(&"x") {
        Some(_) => Some(words.next()?.parse().ok()?),
        None => None,
    };
    let word = words.next()?;
    let reason = if word == "ball" {
        let mut number = || words.next()?.parse().ok();
        let center = [number()?, number()?];
        let radius = number()?;
        Reason::Ball { center, radius }
    } else {
        let (_, reason) = WORDS.iter().find(|(known, _)| *known == word)?;
        reason.clone()
    };
    let end = words.next().is_none();
    end.then_some(Node::Leaf(Leaf { midpoint, reason }))
}
