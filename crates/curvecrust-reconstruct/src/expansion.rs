//! Sums and products of doubles without rounding error, for signs that a filter cannot settle.
//!
//! J. R. Shewchuk, "Adaptive Precision Floating-Point Arithmetic and Fast Robust Geometric
//! Predicates", Discrete & Computational Geometry 18, 1997.

/// An exact number: the sum of its terms, which do not overlap and ascend in magnitude.
///
/// Exact as long as no product over- or underflows. Polynomials of degree 4 in the coordinates of a
/// point set do not: coordinates are multiples of 2^-194 below 2^202.
#[derive(Clone, Debug, Default)]
pub(crate) struct Expansion {
    terms: Vec<f64>,
}

impl Expansion {
    /// `x - y`.
    pub(crate) fn difference(x: f64, y: f64) -> Self {
        let mut sum = Self::default();
        sum.add(-y);
        sum.add(x);
        sum
    }

    /// `x * y`.
    pub(crate) fn product(x: f64, y: f64) -> Self {
        let mut sum = Self::default();
        sum.add_product(x, y);
        sum
    }

    pub(crate) fn plus(mut self, other: &Self) -> Self {
        for &term in &other.terms {
            self.add(term);
        }
        self
    }

    pub(crate) fn minus(mut self, other: &Self) -> Self {
        for &term in &other.terms {
            self.add(-term);
        }
        self
    }

    pub(crate) fn times(&self, other: &Self) -> Self {
        let mut sum = Self::default();
        for &x in &self.terms {
            for &y in &other.terms {
                sum.add_product(x, y);
            }
        }
        sum
    }

    /// A number with the sign of the sum; zero iff the sum is.
    pub(crate) fn sign(&self) -> f64 {
        self.terms.last().copied().unwrap_or(0.0)
    }

    fn add_product(&mut self, x: f64, y: f64) {
        let product = x * y;
        self.add(x.mul_add(y, -product));
        self.add(product);
    }

    /// Shewchuk's theorem 10, leaving out terms that vanish.
    fn add(&mut self, value: f64) {
        let mut carry = value;
        self.terms.retain_mut(|term| {
            let [sum, error] = two_sum(carry, *term);
            carry = sum;
            *term = error;
            error != 0.0
        });
        if carry != 0.0 {
            self.terms.push(carry);
        }
    }
}

/// `x + y` as a rounded value and its error, exactly (Knuth).
fn two_sum(x: f64, y: f64) -> [f64; 2] {
    let sum = x + y;
    let y_virtual = sum - x;
    let x_virtual = sum - y_virtual;
    [sum, (x - x_virtual) + (y - y_virtual)]
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        /// (a - b) (c - d) - e f, with cancellation between its products, against integers.
        #[test]
        fn signs_are_those_of_integers(
            [a, b, c, d] in prop::array::uniform4(-(1i64 << 52)..1i64 << 52),
            off in -2i64..3,
        ) {
            #[expect(clippy::cast_precision_loss, reason = "at most 2^53")]
            let diff = |x: i64, y: i64| Expansion::difference(x as f64, y as f64);
            let left = diff(a, b).times(&diff(c, d));
            let right = diff(b, a).times(&diff(d, c)).plus(&diff(off, 0));
            let sign = left.clone().minus(&right).sign();
            prop_assert_eq!(sign.partial_cmp(&0.0), Some(0.cmp(&off)));
            let exact = i128::from(a - b) * i128::from(c - d);
            prop_assert_eq!(left.sign().partial_cmp(&0.0), Some(exact.cmp(&0)));
        }
    }
}
