//! Arcs: the interval from s0 to s1 is an arc of a circle or a segment (Lemma 12).
//!
//! All that the checker knows of smooth curves holds for them. Three things are added: the angle
//! of the curve at q follows from its place, x is farther from s1 than q, and the point of the arc
//! that is nearest to the centre of a ball is known (Lemma 13).

use crate::certificate::{Curves, Leaf, Reason};
use crate::checker::{self, holds};
use crate::configuration::{Configuration, Unknowns};
use crate::interval::Interval;
use crate::vector::{Disc, Vector};

impl Curves {
    /// Whether a leaf refutes a box of the four unknowns: |q s1|, the curvature of the circle
    /// through q and s1, the tangent of half the angle at q, |q z|; on arcs the third is not used.
    /// The number rho may be any in an interval.
    #[must_use]
    pub fn refutes(self, unknowns: &Unknowns, rho: Interval, leaf: &Leaf) -> bool {
        match self {
            Self::Smooth => checker::refutes(unknowns, rho, leaf),
            Self::Arcs => {
                let case = arc(unknowns, rho);
                leaf.midpoint.is_none() && refutes(&leaf.reason, &case)
            }
        }
    }
}

/// What the unknowns determine if q is on an arc that touches the x axis at s1: the curve turns at
/// q by twice the angle of the chord.
pub(crate) fn arc([distance, curvature, _, height]: &Unknowns, rho: Interval) -> Configuration {
    let sine = 0.5 * (*distance * *curvature);
    let cosine = (Interval::point(1.0) - sine.square()).sqrt();
    let unknowns = [*distance, *curvature, sine / cosine, *height];
    Configuration {
        slope: sine,
        ..Configuration::new(&unknowns, rho)
    }
}

/// A lower bound of lfs on the arc: it is more than |x s1| / rho, and |x s1| more than |q s1|.
pub(crate) fn reach(case: &Configuration) -> Interval {
    (case.distance / case.rho).lower()
}

/// Whether a reason refutes a configuration.
pub(crate) fn refutes(reason: &Reason, case: &Configuration) -> bool {
    let reach = reach(case);
    match reason {
        Reason::Ball { center, radius } => {
            let disc = Disc::new(Vector::point(*center), Interval::point(*radius));
            is_free(case, reach, disc) && disc.holds(case.z)
        }
        _ => holds(reason, case, reach),
    }
}

/// Whether a disc is free of the curve: the point p of the arc that is nearest to its centre is
/// between q and s1 and not inside, and the way from p to the centre is off the medial axis.
fn is_free(case: &Configuration, reach: Interval, disc: Disc) -> bool {
    let from_q = disc.center - case.q;
    let off_the_axis = [Disc::unit([0.0, 0.0]), Disc::new(case.q, case.lfs(reach))];
    disc.center.x.is_negative()
        && from_q.dot(case.tangent).is_positive()
        && off_the_axis.iter().any(|other| other.holds(disc.center))
        && disc.radius.is_positive()
        && disc.radius.is_below(height(case.curvature, disc.center))
}

/// A lower bound of how far a point is above the circle that touches the x axis at s1, with one of
/// the curvatures: the more the circle bends down, the farther it is from a point above.
pub(crate) fn height(curvature: Interval, point: Vector) -> Interval {
    let (one, curvature) = (Interval::point(1.0), curvature.lower());
    let power = 2.0 * point.y + curvature * point.square();
    (power / (one + (one + curvature * power).sqrt())).lower()
}
