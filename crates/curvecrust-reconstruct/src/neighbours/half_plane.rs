//! The half-planes of half neighbours: one sign, decided without rounding error.

use glam::DVec2;

use super::HalfRule;

/// Bound on the error of a.b minus the threshold, relative to |a_x b_x| + |a_y b_y| + threshold.
///
/// With u = 2^-53, every product errs by at most 5 u in all: two differences, the product itself,
/// a sum and the last difference. 8 u leaves room for rounding the bound.
pub(super) const ERROR: f64 = 8.0 * (f64::EPSILON / 2.0);

/// The half-plane in which the half neighbour of a point s is sought.
///
/// With a = q - s and b = n0 - s, a point q lies in it iff a.b < b.b / 2 (bisector rule, open) or
/// a.b <= 0 (right-angle rule, closed).
///
/// ```
/// use curvecrust_geometry::DVec2;
/// use curvecrust_reconstruct::neighbours::{HalfPlane, HalfRule};
///
/// let at = |x| DVec2::new(x, 1.0);
/// let plane = HalfPlane::new(HalfRule::Bisector, at(0.0), at(1.0));
/// assert!(plane.contains(at(0.25)) && !plane.contains(at(0.5)));
/// let plane = HalfPlane::new(HalfRule::RightAngle, at(0.0), at(1.0));
/// assert!(plane.contains(at(0.0)) && !plane.contains(at(0.25)));
/// ```
#[derive(Clone, Copy, Debug)]
pub struct HalfPlane {
    rule: HalfRule,
    s: DVec2,
    n0: DVec2,
    /// b, rounded.
    pub(super) normal: DVec2,
    /// What a.b must not reach, rounded.
    pub(super) threshold: f64,
}

impl HalfPlane {
    /// The half-plane of a point `s` with the nearest neighbour `n0`.
    #[inline(always)]
    #[must_use]
    pub fn new(rule: HalfRule, s: DVec2, n0: DVec2) -> Self {
        let normal = n0 - s;
        Self {
            rule,
            s,
            n0,
            normal,
            threshold: threshold(rule, normal.length_squared()),
        }
    }

    /// The direction into the half-plane, away from the nearest neighbour: its signs are exact.
    #[must_use]
    pub fn inwards(&self) -> DVec2 {
        -self.normal
    }

    /// How far `q` lies beyond the boundary, rounded, and a bound on the error.
    #[inline(always)]
    fn excess(&self, q: DVec2) -> [f64; 2] {
        let products = (q - self.s) * self.normal;
        let excess = products.element_sum() - self.threshold;
        let error = ERROR * (products.abs().element_sum() + self.threshold);
        [excess, error]
    }

    /// Whether `q` lies in the half-plane, and not so close to its boundary that it takes more than
    /// floating point to see it.
    #[inline(always)]
    pub(super) fn certainly_contains(&self, q: DVec2) -> bool {
        let [excess, error] = self.excess(q);
        excess < -error
    }

    /// Whether `q` lies in the half-plane: exact for the coordinates of a point set.
    #[inline(always)]
    #[must_use]
    pub fn contains(&self, q: DVec2) -> bool {
        let [excess, error] = self.excess(q);
        if excess.abs() > error {
            excess < 0.0
        } else {
            self.contains_exactly(q)
        }
    }

    #[cold]
    fn contains_exactly(&self, q: DVec2) -> bool {
        match self.rule {
            HalfRule::Bisector => self.exact(q) < 0.0,
            HalfRule::RightAngle => self.exact(q) <= 0.0,
        }
    }

    /// A number with the sign of 2 a.b - b.b, or of a.b.
    ///
    /// Differences are split into a rounded value and its error, so that the polynomial becomes a
    /// sum of products of two doubles. Coordinates are multiples of 2^-194 below 2^202: no product
    /// under- or overflows.
    fn exact(&self, q: DVec2) -> f64 {
        let mut sum = Expansion::default();
        for axis in 0..2 {
            let a = two_diff(q[axis], self.s[axis]);
            let b = two_diff(self.n0[axis], self.s[axis]);
            for b_part in b {
                for a_part in a {
                    sum.add_product(2.0 * a_part, b_part);
                }
                if self.rule == HalfRule::Bisector {
                    for other in b {
                        sum.add_product(-b_part, other);
                    }
                }
            }
        }
        sum.sign()
    }
}

/// What a.b must not reach, from |b|^2.
#[inline(always)]
pub(super) fn threshold(rule: HalfRule, normal_squared: f64) -> f64 {
    match rule {
        HalfRule::Bisector => 0.5 * normal_squared,
        HalfRule::RightAngle => 0.0,
    }
}

/// `x - y` as a rounded value and its error, exactly (Knuth).
fn two_diff(x: f64, y: f64) -> [f64; 2] {
    two_sum(x, -y)
}

/// `x + y` as a rounded value and its error, exactly (Knuth).
fn two_sum(x: f64, y: f64) -> [f64; 2] {
    let sum = x + y;
    let y_virtual = sum - x;
    let x_virtual = sum - y_virtual;
    [sum, (x - x_virtual) + (y - y_virtual)]
}

/// A sum of up to 16 products of doubles without rounding error.
///
/// Its terms are not zero, do not overlap and ascend in magnitude (Shewchuk 1997, "Adaptive
/// precision floating-point arithmetic", theorem 10), so the last one has the sign of all.
#[derive(Default)]
struct Expansion {
    terms: [f64; 32],
    len: usize,
}

impl Expansion {
    fn add_product(&mut self, x: f64, y: f64) {
        let product = x * y;
        self.add(x.mul_add(y, -product));
        self.add(product);
    }

    /// Zeros are not kept: on a grid of integers few terms remain.
    fn add(&mut self, value: f64) {
        let mut carry = value;
        let mut kept = 0;
        for i in 0..self.len {
            let low;
            [carry, low] = two_sum(carry, self.terms[i]);
            self.terms[kept] = low;
            kept += usize::from(low != 0.0);
        }
        if carry != 0.0
            && let Some(free) = self.terms.get_mut(kept)
        {
            *free = carry;
            kept += 1;
        }
        self.len = kept;
    }

    fn sign(&self) -> f64 {
        self.terms[..self.len].last().copied().unwrap_or(0.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// Coordinates are `i * 2^-e`: an exact sign by integers.
    fn contains_by_integers(rule: HalfRule, [s, n0, q]: [[i64; 2]; 3]) -> bool {
        let sub = |p: [i64; 2], r: [i64; 2]| [i128::from(p[0] - r[0]), i128::from(p[1] - r[1])];
        let dot = |p: [i128; 2], r: [i128; 2]| p[0] * r[0] + p[1] * r[1];
        let (a, b) = (sub(q, s), sub(n0, s));
        match rule {
            HalfRule::Bisector => 2 * dot(a, b) < dot(b, b),
            HalfRule::RightAngle => dot(a, b) <= 0,
        }
    }

    #[expect(clippy::cast_precision_loss, reason = "below 2^53")]
    fn point(p: [i64; 2], exponent: i32) -> DVec2 {
        DVec2::new(p[0] as f64, p[1] as f64) * 2f64.powi(exponent)
    }

    fn near_a_line() -> impl Strategy<Value = [[i64; 2]; 3]> {
        let wide = -(1i64 << 52)..1i64 << 52;
        let small = -40i64..40;
        // s and n0 anywhere or on a small grid; q a few units from the bisector or the normal in s.
        (
            prop::array::uniform4(prop_oneof![wide, small.clone()]),
            [small.clone(), small.clone()],
            -2i64..3,
            any::<bool>(),
        )
            .prop_map(|([sx, sy, dx, dy], [ex, ey], t, on_bisector)| {
                let (dx, dy) = (dx / 16, dy / 16);
                let (sx, sy) = (sx / 4, sy / 4);
                let half = i64::from(on_bisector);
                let q = [
                    sx + half * (dx / 2) - t * dy + ex / 20,
                    sy + half * (dy / 2) + t * dx + ey / 20,
                ];
                [[sx, sy], [sx + dx, sy + dy], q]
            })
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(20_000))]
        #[test]
        fn signs_are_those_of_integers(
            at in near_a_line(),
            exponent in prop_oneof![Just(-140), Just(0), Just(140)],
        ) {
            let [s, n0, q] = at.map(|p| point(p, exponent));
            for rule in [HalfRule::Bisector, HalfRule::RightAngle] {
                let plane = HalfPlane::new(rule, s, n0);
                prop_assert_eq!(plane.contains(q), contains_by_integers(rule, at));
                // Without the filter too.
                prop_assert_eq!(plane.contains_exactly(q), contains_by_integers(rule, at));
            }
        }
    }
}
