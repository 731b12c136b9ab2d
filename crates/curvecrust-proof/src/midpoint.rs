//! Where the sample s0 and the point x of the curve, as far from s0 as from s1, may be (Lemma 9).

use crate::configuration::Configuration;
use crate::interval::Interval;
use crate::vector::Vector;

/// How often the positions are halved at most.
const DEPTH: u32 = 24;

/// The positions: |s0 s1|; the curvature of the circle through s0 and s1 that touches the x axis
/// at s1; the tangent of the angle between the chords from s1 to x and to s0, positive if x is
/// above.
type Positions = [Interval; 3];

/// Whether |x s1| is at least `claim` wherever s0 and x may be; with an infinite claim, whether
/// there is no place for them. `lfs` is a lower bound of lfs(q).
pub(crate) fn is_beyond(claim: f64, case: &Configuration, lfs: Interval) -> bool {
    let unit = Interval::new(-1.0, 1.0);
    let farthest = (case.rho * case.height).high();
    let search = Search {
        case,
        claim: Interval::point(claim),
        above: case.radius(lfs, 1.0),
        below: case.radius(lfs, -1.0),
    };
    let distance = Interval::new(case.distance.low(), farthest);
    search.covers([distance, unit, unit], DEPTH)
}

struct Search<'a> {
    case: &'a Configuration,
    claim: Interval,
    above: Interval,
    below: Interval,
}

impl Search<'_> {
    fn covers(&self, positions: Positions, depth: u32) -> bool {
        let [distance, curvature, bend] = positions;
        // How far s0 or x moves.
        let moves = [distance, 0.5 * curvature, 0.5 * bend];
        let wider = |a: usize, b: usize| if moves[b].is_wider(moves[a]) { b } else { a };
        let axis = [1, 2].into_iter().fold(0, wider);
        let part = |half| {
            let mut part = positions;
            part[axis] = half;
            self.covers(part, depth - 1)
        };
        self.settles(positions) || depth > 0 && positions[axis].halves().into_iter().all(part)
    }

    /// Whether x is far enough, or no curve has s0 and x at these positions.
    fn settles(&self, [distance, curvature, bend]: Positions) -> bool {
        let (case, height) = (self.case, self.case.height);
        let one = Interval::point(1.0);
        let secant = one + bend.square();
        let far = 0.5 * (distance * secant.sqrt());
        if distance.is_below(case.distance)
            || (case.rho * height).is_below(distance)
            || self.claim.is_below(far)
            || (0.5 * (case.rho * height)).is_below(far)
            || (case.rho.square() * secant).is_below(4.0 * bend.square())
        {
            return true;
        }
        let sine = 0.5 * (curvature * distance);
        let cosine = (one - sine.square()).sqrt();
        let towards = Vector::new(-cosine, -sine);
        // z is nearer to s1 than to s0, and x is outside of the two discs at s1.
        let up = Vector::new(-sine, cosine);
        let lift = bend * cosine - sine;
        let chord = 0.5 * (distance * secant);
        if distance.is_below(2.0 * case.z.dot(towards))
            || chord.is_below((2.0 * lift).max(-2.0 * lift))
        {
            return true;
        }
        let s0 = towards.times(distance);
        let x = (towards + up.times(bend)).times(0.5 * distance);
        // Along the curve the distance from s0 grows, inside the disc about the chord.
        let from_s0 = case.q - s0;
        from_s0.dot(case.tangent).is_negative()
            || from_s0.dot(case.q).is_positive()
            || (case.z - x).square().is_below(height.square())
            || self.is_in_a_disc_at_q(s0, far)
            || self.is_in_a_disc_at_q(x, far)
    }

    fn is_in_a_disc_at_q(&self, point: Vector, far: Interval) -> bool {
        let lfs = (far / self.case.rho).lower();
        let from_q = point - self.case.q;
        let (square, rise) = (from_q.square(), from_q.dot(self.case.normal));
        let above = 2.0 * (self.above.max(lfs) * rise);
        square.is_below(above.max(-2.0 * (self.below.max(lfs) * rise)))
    }
}
