//! Balls about points off the medial axis (Lemma 10, C10).

use crate::configuration::Configuration;
use crate::interval::Interval;
use crate::vector::{Disc, Vector};

/// How often the directions from a centre are halved at most.
const DEPTH: u32 = 8;

/// A ball about a point c above the curve and off the medial axis; its radius is at least |c z|.
struct Ball<'a> {
    case: &'a Configuration,
    center: Vector,
    radius: Interval,
    /// A lower bound of lfs on the first interval.
    reach: Interval,
    /// Discs that are free of the medial axis: about s1 and about q.
    off_the_axis: [Disc; 2],
    /// Discs above the curve that are free of it: at s1 and at q.
    above: [Disc; 2],
    /// Whether the nearest point is between q and s1.
    between: bool,
}

/// Whether a ball refutes the configuration: it holds z, so the point p of the curve that is
/// nearest to its centre is within its radius, but there is no place for p.
pub(crate) fn refutes(case: &Configuration, reach: Interval, disc: Disc) -> bool {
    let Disc { center, radius } = disc;
    let lfs = case.lfs(reach);
    let height = case.radius(lfs, 1.0);
    let about_q = Disc::new(case.q, lfs);
    let at_q = Disc::new(case.q + case.normal.times(height), height);
    let ahead = (center - case.q).dot(case.tangent).is_positive();
    let towards_s1 = about_q.holds(center) || case.q.dot(case.tangent).is_negative();
    let ball = Ball {
        case,
        center,
        radius,
        reach,
        off_the_axis: [Disc::unit([0.0, 0.0]), about_q],
        above: [Disc::unit([0.0, 1.0]), at_q],
        between: center.x.is_negative() && ahead && towards_s1,
    };
    radius.is_positive()
        && disc.holds(case.z)
        && ball.off_the_axis.iter().any(|disc| disc.holds(center))
        && ball.above.iter().any(|disc| disc.holds(center))
        && ball.covers(1.0, Interval::new(-1.0, 1.0), DEPTH)
        && ball.covers(-1.0, Interval::new(-1.0, 1.0), DEPTH)
}

impl Ball<'_> {
    /// Whether p is in none of some directions: the half circle up (`side` 1) or down, or a part.
    fn covers(&self, side: f64, half: Interval, depth: u32) -> bool {
        let [up, right] = half.cosine_and_sine();
        let part = |half| self.covers(side, half, depth - 1);
        self.is_excluded(Vector::new(right, side * up))
            || depth > 0 && half.halves().into_iter().all(part)
    }

    /// How far a ray runs in those discs that hold the centre.
    fn farthest(&self, ray: Vector, discs: [Disc; 2]) -> Interval {
        let around = discs.into_iter().filter(|disc| disc.holds(self.center));
        let exits = around.map(|disc| disc.exit(self.center, ray));
        exits.fold(Interval::point(0.0), Interval::max)
    }

    /// Whether p is in none of the directions of `ray`.
    fn is_excluded(&self, ray: Vector) -> bool {
        let least = self.farthest(ray, self.above);
        let mut reached = self.farthest(ray, self.off_the_axis);
        for disc in self.off_the_axis {
            if disc.holds(self.center + ray.times(reached)) {
                reached = reached.max(disc.exit(self.center, ray));
            }
        }
        let margin = (reached - self.radius).lower();
        let opposite = Disc::new(self.center + ray.times(reached), margin);
        self.radius.is_below(least)
            || self.is_taken(opposite)
            || self.between && self.is_no_point_between(ray, least.hull(self.radius))
    }

    /// Whether a disc below the curve would hold s1 or q, or meet one above.
    fn is_taken(&self, disc: Disc) -> bool {
        let meets =
            |other: &Disc| Disc::new(other.center, other.radius + disc.radius).holds(disc.center);
        disc.radius.is_positive()
            && (disc.holds(Vector::point([0.0, 0.0]))
                || disc.holds(self.case.q)
                || self.above.iter().any(meets))
    }

    /// Whether no point of the curve between q and s1 is at one of these distances along the ray.
    fn is_no_point_between(&self, ray: Vector, distance: Interval) -> bool {
        let p = self.center + ray.times(distance);
        let tangent = ray.turned();
        p.x.is_positive()
            || p.dot(p - self.case.q).is_positive()
            || Disc::new(self.case.z, self.case.height).holds(p)
            || self.center.dot(tangent).is_positive()
            || (self.center - self.case.q).dot(tangent).is_negative()
            || self.is_taken(Disc::new(p + ray.times(self.reach), self.reach))
    }
}
