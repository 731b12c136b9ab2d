//! Balls about points off the medial axis (Lemma 10).

use crate::configuration::Configuration;
use crate::interval::Interval;
use crate::vector::Vector;

/// How often the directions from a centre are halved at most.
const DEPTH: u32 = 8;

/// A point c above the curve and off the medial axis, and a number that is at least |c z|.
struct Ball<'a> {
    configuration: &'a Configuration,
    center: Vector,
    radius: Interval,
    /// Lower bounds of lfs at q, and on all of the first interval.
    lfs: Interval,
    reach: Interval,
    /// Discs above the curve and free of it: centre and radius.
    uppers: [(Vector, Interval); 2],
    near_s1: bool,
    near_q: bool,
    /// Whether the nearest point is between q and s1.
    between: bool,
}

/// Whether a ball about `center` refutes the configuration: it holds z, so the point p of the
/// curve that is nearest to the centre is within `radius`, but there is no place for p.
pub(crate) fn refutes(
    configuration: &Configuration,
    reach: Interval,
    center: [f64; 2],
    radius: f64,
) -> bool {
    let one = Interval::point(1.0);
    let (center, radius) = (Vector::point(center), Interval::point(radius));
    let Configuration {
        q, normal, tangent, ..
    } = *configuration;
    let lfs = configuration.lfs(reach);
    let above = configuration.radius(lfs, 1.0);
    let uppers = [
        (Vector::point([0.0, 1.0]), one),
        (q + normal.times(above), above),
    ];
    let from_q = center - q;
    let near_s1 = center.square().is_below(one);
    let near_q = from_q.square().is_below(lfs.square());
    let is_above = uppers
        .iter()
        .any(|(c, r)| (center - *c).square().is_below(r.square()));
    let between = center.x.is_negative()
        && from_q.dot(tangent).is_positive()
        && (near_q || q.dot(tangent).is_negative());
    let ball = Ball {
        configuration,
        center,
        radius,
        lfs,
        reach,
        uppers,
        near_s1,
        near_q,
        between,
    };
    radius.is_positive()
        && (configuration.z - center)
            .square()
            .is_below(radius.square())
        && is_above
        && (near_s1 || near_q)
        && [1.0, -1.0]
            .into_iter()
            .all(|side| ball.covers(side, Interval::new(-1.0, 1.0), DEPTH))
}

impl Ball<'_> {
    fn covers(&self, side: f64, half: Interval, depth: u32) -> bool {
        let [y, x] = half.cosine_and_sine();
        if self.is_excluded(Vector::new(x, side * y)) {
            return true;
        }
        depth > 0
            && half
                .halves()
                .into_iter()
                .all(|half| self.covers(side, half, depth - 1))
    }

    /// How far the centre is from where a ray from it leaves a disc that holds it or that it has
    /// entered.
    fn exit(&self, ray: Vector, (center, radius): (Vector, Interval)) -> Interval {
        let from = self.center - center;
        let along = from.dot(ray);
        ((along.square() + radius.square() - from.square()).sqrt() - along).lower()
    }

    /// How far a ray from the centre is certainly off the medial axis.
    fn off_the_axis(&self, ray: Vector) -> Interval {
        let Configuration { q, .. } = *self.configuration;
        let one = Interval::point(1.0);
        let about_s1 = self.exit(ray, (Vector::point([0.0, 0.0]), one));
        if !self.near_q {
            return about_s1;
        }
        let about_q = self.exit(ray, (q, self.lfs));
        let passes = (self.center + ray.times(about_q)).square().is_below(one);
        if self.near_s1 || passes {
            about_q.max(about_s1)
        } else {
            about_q
        }
    }

    /// Whether the nearest point p is in none of the directions of `ray`.
    fn is_excluded(&self, ray: Vector) -> bool {
        let mut least = Interval::point(0.0);
        for (center, radius) in self.uppers {
            if (self.center - center).square().is_below(radius.square()) {
                least = least.max(self.exit(ray, (center, radius)));
            }
        }
        if self.radius.is_below(least) {
            return true;
        }
        let reached = self.off_the_axis(ray);
        let margin = (reached - self.radius).lower();
        if margin.is_positive() && self.is_taken(self.center + ray.times(reached), margin) {
            return true;
        }
        self.between && self.is_no_point_between(ray, least.hull(self.radius))
    }

    /// Whether a disc below the curve would hold s1 or q, or meet one above.
    fn is_taken(&self, center: Vector, radius: Interval) -> bool {
        let square = radius.square();
        let meets = |(upper, r): &(Vector, Interval)| {
            (center - *upper).square().is_below((*r + radius).square())
        };
        center.square().is_below(square)
            || (center - self.configuration.q).square().is_below(square)
            || self.uppers.iter().any(meets)
    }

    /// Whether no point of the curve between q and s1 is at one of these distances along the ray.
    fn is_no_point_between(&self, ray: Vector, distance: Interval) -> bool {
        let Configuration { q, z, height, .. } = *self.configuration;
        let p = self.center + ray.times(distance);
        let from_q = p - q;
        let tangent = ray.turned();
        let lower = p + ray.times(self.reach);
        p.x.is_positive()
            || p.dot(from_q).is_positive()
            || (z - p).square().is_below(height.square())
            || self.center.dot(tangent).is_positive()
            || (self.center - q).dot(tangent).is_negative()
            || self.reach.is_positive() && self.is_taken(lower, self.reach)
    }
}
