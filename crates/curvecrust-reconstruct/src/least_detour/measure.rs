//! Lengths, turns and what they cost.

use curvecrust_geometry::DVec2;

use super::constants::{RATIO_SCALE, RATIO_WEIGHT, TURN_SCALE, TURN_WEIGHT};

/// Measures edges and turns between points.
#[derive(Clone, Copy, Debug)]
pub(super) struct Measure<'a> {
    points: &'a [DVec2],
    /// A power of two that makes the extent of the points about 1, so that scaling by a power of
    /// two changes no digit of a logarithm.
    unit: f64,
}

impl<'a> Measure<'a> {
    pub(super) fn new(points: &'a [DVec2]) -> Self {
        let infinite = DVec2::INFINITY;
        let bounds = points
            .iter()
            .fold((infinite, -infinite), |(low, high), &p| {
                (low.min(p), high.max(p))
            });
        let extent = (bounds.1 - bounds.0).max_element();
        Self {
            points,
            unit: reciprocal_power_of_two(extent),
        }
    }

    pub(super) fn vector(&self, v: u32, w: u32) -> DVec2 {
        let [v, w] = [v, w].map(|id| self.points[id as usize]);
        (w - v) * self.unit
    }

    pub(super) fn length(&self, v: u32, w: u32) -> f64 {
        length(self.vector(v, w))
    }

    pub(super) fn log_length(&self, v: u32, w: u32) -> f64 {
        libm::log(self.length(v, w))
    }

    /// The way from a point to another.
    pub(super) fn arm(&self, v: u32, w: u32) -> Arm {
        let vector = self.vector(v, w);
        let length = length(vector);
        Arm {
            direction: vector / length,
            log_length: libm::log(length),
        }
    }

    /// Whether the path p, v, q turns by no more than the angle with this cosine.
    pub(super) fn turns_less(&self, cosine: f64, p: u32, v: u32, q: u32) -> bool {
        let (a, b) = (self.vector(p, v), self.vector(v, q));
        a.dot(b) >= cosine * a.length() * b.length()
    }
}

/// A direction and the logarithm of a length.
#[derive(Clone, Copy, Debug)]
pub(super) struct Arm {
    direction: DVec2,
    log_length: f64,
}

impl Arm {
    /// What it costs that a curve comes by one arm of a point and goes by another: minus the
    /// logarithm of how likely the turn and the change of length are, with that of straight on and
    /// no change as 0.
    ///
    /// The same bits either way.
    pub(super) fn bend(&self, other: &Self) -> f64 {
        let cosine = -self.direction.dot(other.direction).clamp(-1.0, 1.0);
        let ratio = self.log_length - other.log_length;
        // The square of the turn t, but for a factor that falls from 1 to 0.81 at half a circle:
        // 16 sin^2(t / 4).
        let turn = 8.0 * (1.0 - (0.5 + 0.5 * cosine).sqrt());
        TURN_WEIGHT * libm::log1p(turn / TURN_SCALE)
            + RATIO_WEIGHT * libm::log1p(ratio * ratio / RATIO_SCALE)
    }
}

/// Above 0 where rounding would make it 0.
fn length(vector: DVec2) -> f64 {
    let length = vector.length();
    if length > 1e-150 {
        length
    } else {
        vector.x.hypot(vector.y).max(f64::MIN_POSITIVE)
    }
}

/// A power of two between half the reciprocal of a number and it; 1 for numbers without one.
fn reciprocal_power_of_two(x: f64) -> f64 {
    /// The bits of the mantissa, and the largest exponent of a number and its reciprocal.
    const MANTISSA: u32 = 52;
    const REFLECTED: u64 = 2046;
    let exponent = (x.to_bits() >> MANTISSA) & 0x7ff;
    if x.is_finite() && (2..REFLECTED).contains(&exponent) {
        f64::from_bits((REFLECTED - exponent) << MANTISSA)
    } else {
        1.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_unit_is_a_power_of_two() {
        for (x, unit) in [(1.0, 1.0), (3.0, 0.5), (0.3, 4.0), (0.25, 4.0), (0.0, 1.0)] {
            assert!((reciprocal_power_of_two(x) - unit).abs() < 1e-300, "{x}");
        }
        assert!((reciprocal_power_of_two(f64::INFINITY) - 1.0).abs() < 1e-300);
    }

    #[test]
    fn bends_cost_what_turn_and_ratio_cost() {
        let at = |degrees: f64, length: f64| DVec2::from_angle(degrees.to_radians()) * length;
        for (degrees, ratio) in [(0.0, 1.0), (30.0, 1.0), (90.0, 2.0), (180.0, 5.0)] {
            let points = [at(180.0, 1.0), DVec2::ZERO, at(degrees, ratio)];
            let measure = Measure::new(&points);
            let quarter = (degrees / 4.0).to_radians().sin();
            let turn = TURN_WEIGHT * (1.0 + 16.0 * quarter * quarter / TURN_SCALE).ln();
            let change = RATIO_WEIGHT * (1.0 + ratio.ln().powi(2) / RATIO_SCALE).ln();
            let [p, q] = [measure.arm(1, 0), measure.arm(1, 2)];
            let bend = p.bend(&q);
            assert!((bend - turn - change).abs() < 1e-12, "{degrees} {ratio}");
            assert_eq!(bend.to_bits(), q.bend(&p).to_bits());
        }
    }

    #[test]
    fn points_as_near_as_can_be_have_finite_costs() {
        let points = [
            DVec2::ZERO,
            DVec2::new(5e-324, 0.0),
            DVec2::new(0.0, 1e-200),
            DVec2::ONE,
        ];
        let measure = Measure::new(&points);
        for [v, p, q] in [[0, 1, 2], [0, 2, 3], [1, 0, 3], [2, 0, 1]] {
            let [p, q] = [measure.arm(v, p), measure.arm(v, q)];
            assert!(p.bend(&q).is_finite() && p.log_length.is_finite());
        }
    }
}
