//! The contract that all algorithms share.

use std::fmt;

use curvecrust_geometry::{EdgeSet, PointId, PointSet};

use crate::error::ReconstructError;
use crate::explanation::Explanation;
use crate::known::Known;

/// An algorithm that joins bare points by the edges of the curves they were sampled from.
///
/// # Guarantees
/// For every point set, degenerate ones included, the edges are the same bytes on every run and any
/// number of threads; permuting the points permutes the edges; scaling by a power of two or an
/// exactly representable shift leaves them as they are.
pub trait Reconstructor: fmt::Debug + Send + Sync {
    /// What is known about the algorithm.
    fn info(&self) -> AlgorithmInfo;

    /// The edges between the points; there are as many vertices as points.
    fn reconstruct(&self, points: &PointSet) -> EdgeSet;

    /// The edges when some points are known to be termini: ends of open curves.
    ///
    /// Without termini this is [`reconstruct`](Self::reconstruct), whatever the algorithm.
    ///
    /// # Errors
    /// [`TerminiNotHonoured`](ReconstructError::TerminiNotHonoured) by algorithms that cannot use
    /// termini; [`TerminusNotAPoint`](ReconstructError::TerminusNotAPoint) otherwise, for the first
    /// that is not in the set.
    fn reconstruct_open(
        &self,
        points: &PointSet,
        termini: &[PointId],
    ) -> Result<EdgeSet, ReconstructError> {
        if termini.is_empty() {
            Ok(self.reconstruct(points))
        } else {
            Err(ReconstructError::TerminiNotHonoured {
                algorithm: self.info().name,
            })
        }
    }

    /// The edges that agree with what is known about the curves.
    ///
    /// With termini alone this is [`reconstruct_open`](Self::reconstruct_open), whatever the
    /// algorithm.
    ///
    /// # Errors
    /// [`KnownNotHonoured`](ReconstructError::KnownNotHonoured) by algorithms that cannot use what
    /// is known; else those of [`reconstruct_open`](Self::reconstruct_open), and an error that says
    /// why no curves through the points agree with it.
    fn reconstruct_known(
        &self,
        points: &PointSet,
        known: &Known,
    ) -> Result<EdgeSet, ReconstructError> {
        reconstruct_termini_alone(self, points, known)
    }

    /// The edges of [`reconstruct_open`](Self::reconstruct_open) and the free ends, each with its
    /// reason; `None` by algorithms whose definition is reason enough.
    ///
    /// # Errors
    /// Those of [`reconstruct_open`](Self::reconstruct_open).
    fn explain(
        &self,
        points: &PointSet,
        termini: &[PointId],
    ) -> Result<Option<Explanation>, ReconstructError> {
        let _ = (points, termini);
        Ok(None)
    }

    /// The edges of [`reconstruct_known`](Self::reconstruct_known), each with its reason; `None` by
    /// algorithms whose definition is reason enough.
    ///
    /// # Errors
    /// Those of [`reconstruct_known`](Self::reconstruct_known).
    fn explain_known(
        &self,
        points: &PointSet,
        known: &Known,
    ) -> Result<Option<Explanation>, ReconstructError> {
        if known.is_of_termini_alone() {
            self.explain(points, &known.termini)
        } else {
            self.reconstruct_known(points, known).map(|_| None)
        }
    }
}

/// The edges of an algorithm that can use termini at most.
pub(crate) fn reconstruct_termini_alone(
    algorithm: &(impl Reconstructor + ?Sized),
    points: &PointSet,
    known: &Known,
) -> Result<EdgeSet, ReconstructError> {
    if known.is_of_termini_alone() {
        algorithm.reconstruct_open(points, &known.termini)
    } else {
        Err(ReconstructError::KnownNotHonoured {
            algorithm: algorithm.info().name,
        })
    }
}

/// What is known about an algorithm.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct AlgorithmInfo {
    /// The name by which programs select it: lower case, with hyphens.
    pub name: &'static str,
    /// Authors, title, venue and year.
    pub citation: &'static str,
    /// Sampling conditions of smooth closed curves, each claimed to be enough for the edges to be
    /// exactly those between consecutive samples, and whether the claim is proven; empty if
    /// there is none.
    pub guarantees: &'static [Guarantee],
    /// Time in the number n of points.
    pub cost: &'static str,
    /// Whether [`Reconstructor::reconstruct_open`] takes termini.
    pub honours_termini: bool,
    /// Whether [`Reconstructor::reconstruct_known`] takes the shape of the curves and
    /// their number.
    pub honours_known: bool,
    /// The curves that it is made for.
    pub scope: Scope,
    /// Where its definition is from.
    pub basis: Basis,
}

/// The curves that an algorithm is made for: on others it may still be right, by chance.
///
/// ```
/// use curvecrust_reconstruct::{HnnCrust, Reconstructor};
///
/// let scope = HnnCrust::MUTUAL.info().scope;
/// assert!(scope.open && !scope.crossings);
/// assert_eq!(scope.to_string(), "closed, open, several, corners");
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Scope {
    /// Closed curves.
    pub closed: bool,
    /// Curves with ends.
    pub open: bool,
    /// More than one curve.
    pub several: bool,
    /// Curves with corners.
    pub corners: bool,
    /// Curves that cross.
    pub crossings: bool,
}

impl Scope {
    /// Several closed curves.
    pub(crate) const CLOSED: Self = Self {
        closed: true,
        open: false,
        several: true,
        corners: false,
        crossings: false,
    };
    /// Several curves, closed or open.
    pub(crate) const CLOSED_AND_OPEN: Self = Self {
        open: true,
        ..Self::CLOSED
    };

    pub(crate) const fn with_corners(self) -> Self {
        Self {
            corners: true,
            ..self
        }
    }

    /// The same kinds of curves, but one alone.
    pub(crate) const fn of_one_curve(self) -> Self {
        Self {
            several: false,
            ..self
        }
    }
}

/// The kinds of curves in words.
impl fmt::Display for Scope {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let kinds = [
            (self.closed, "closed"),
            (self.open, "open"),
            (self.several, "several"),
            (self.corners, "corners"),
            (self.crossings, "crossings"),
        ];
        let named = kinds.iter().filter(|kind| kind.0).map(|kind| kind.1);
        f.pad(&named.collect::<Vec<_>>().join(", "))
    }
}

/// Where the definition of an algorithm is from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Basis {
    /// From the publication.
    Published,
    /// From what others wrote of the publication, which was not available: its idea is kept,
    /// constants and order of steps may differ.
    Argued,
}

impl AlgorithmInfo {
    /// An algorithm without guarantees, for closed curves, that takes points alone.
    #[must_use]
    pub const fn new(name: &'static str, citation: &'static str, cost: &'static str) -> Self {
        Self {
            name,
            citation,
            guarantees: &[],
            cost,
            honours_termini: false,
            honours_known: false,
            scope: Scope::CLOSED,
            basis: Basis::Published,
        }
    }
}

/// The name: [`AlgorithmInfo::name`].
impl fmt::Display for AlgorithmInfo {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.name)
    }
}

/// A sampling condition of smooth closed curves, with its bound, which is exclusive.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum SamplingBound {
    /// Every curve point p has a sample nearer than this times the local feature size at p.
    Epsilon(f64),
    /// Every curve point between consecutive samples is nearer to one of them than this times the
    /// reach of the curve between them.
    Rho(f64),
}

/// For instance `rho < 0.9`, with three decimals at most, as the literature prints them.
impl fmt::Display for SamplingBound {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (name, bound) = match *self {
            Self::Epsilon(bound) => ("epsilon", bound),
            Self::Rho(bound) => ("rho", bound),
        };
        write!(f, "{name} < {}", (bound * 1000.0).round() / 1000.0)
    }
}

/// A sampling condition that is claimed to suffice for an algorithm, and what is known of the
/// claim.
///
/// ```
/// use curvecrust_reconstruct::{HnnCrust, Reconstructor, SamplingBound, Standing};
///
/// let [by_reach, by_lfs] = HnnCrust::MUTUAL.info().guarantees else { panic!("two theorems") };
/// assert_eq!(by_reach.claimed, SamplingBound::Rho(0.9));
/// assert!(matches!(by_reach.standing, Standing::Refuted { .. }));
/// assert_eq!(by_reach.to_string(), "rho < 0.9 (proven for rho < 0.888, false from rho = 0.895)");
/// assert_eq!(by_lfs.to_string(), "epsilon < 0.47");
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Guarantee {
    /// The condition as the source of the algorithm states it.
    pub claimed: SamplingBound,
    /// What is known of it.
    pub standing: Standing,
}

/// What is known of a claimed guarantee.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum Standing {
    /// It is proven.
    Proven,
    /// It is false: from a bound on there are counterexamples.
    Refuted {
        /// The bound below which it is proven; from there to the counterexamples it is conjectured.
        proven_below: f64,
        /// The infimum of the bounds of known counterexamples.
        fails_from: f64,
    },
}

impl Guarantee {
    pub(crate) const fn proven(claimed: SamplingBound) -> Self {
        Self {
            claimed,
            standing: Standing::Proven,
        }
    }
}

/// The claim, and in brackets what is known of it unless it is proven.
impl fmt::Display for Guarantee {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let name = match self.claimed {
            SamplingBound::Epsilon(_) => "epsilon",
            SamplingBound::Rho(_) => "rho",
        };
        // Rounded down: a proof holds for less, and a counterexample is not farther than it is.
        let down = |bound: f64| (bound * 1000.0).floor() / 1000.0;
        write!(f, "{}", self.claimed)?;
        match self.standing {
            Standing::Proven => Ok(()),
            Standing::Refuted {
                proven_below,
                fails_from,
            } => write!(
                f,
                " (proven for {name} < {}, false from {name} = {})",
                down(proven_below),
                down(fails_from)
            ),
        }
    }
}
