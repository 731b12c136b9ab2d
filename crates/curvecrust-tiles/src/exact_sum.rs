//! Sums that do not depend on the order of their terms.

/// A sum of numbers without rounding error, rounded once when it is asked for.
///
/// Its parts do not overlap and ascend in magnitude (Shewchuk 1997, "Adaptive precision
/// floating-point arithmetic", theorem 10). On lengths there are two or three.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ExactSum {
    parts: Vec<f64>,
}

impl ExactSum {
    /// Adds a finite number.
    ///
    /// ```
    /// use curvecrust_tiles::ExactSum;
    ///
    /// let mut sum = ExactSum::default();
    /// for number in [1e16, 1.0, 1.0, -1e16] {
    ///     sum.add(number);
    /// }
    /// assert_eq!(sum.value(), 2.0);
    /// assert_eq!(1e16 + 1.0 + 1.0 - 1e16, 0.0);
    /// ```
    pub fn add(&mut self, number: f64) {
        let mut carry = number;
        let mut kept = 0;
        for at in 0..self.parts.len() {
            let low;
            [carry, low] = two_sum(carry, self.parts[at]);
            if low != 0.0 {
                self.parts[kept] = low;
                kept += 1;
            }
        }
        self.parts.truncate(kept);
        if carry != 0.0 {
            self.parts.push(carry);
        }
    }

    /// Adds the product of two numbers, without rounding it: as its double and the error of that,
    /// which is one too as long as neither overflows nor underflows.
    ///
    /// ```
    /// use curvecrust_tiles::ExactSum;
    ///
    /// let mut sum = ExactSum::default();
    /// sum.add_product(0.1, 10.0);
    /// sum.add(-1.0);
    /// assert_eq!(sum.value(), f64::EPSILON / 4.0);
    /// assert_eq!(0.1 * 10.0 - 1.0, 0.0);
    /// ```
    pub fn add_product(&mut self, x: f64, y: f64) {
        let product = x * y;
        self.add(x.mul_add(y, -product));
        self.add(product);
    }

    /// Adds all of another sum.
    pub fn add_sum(&mut self, other: &Self) {
        for &part in &other.parts {
            self.add(part);
        }
    }

    /// Adds all of another sum, or takes it away.
    pub(crate) fn add_signed(&mut self, other: &Self, is_taken: bool) {
        for &part in &other.parts {
            self.add(if is_taken { -part } else { part });
        }
    }

    /// The numbers of which it is the sum, for storing it: collecting them gives the sum back.
    ///
    /// ```
    /// use curvecrust_tiles::ExactSum;
    ///
    /// let sum: ExactSum = [1e16, 1.0, 1e-16].into_iter().collect();
    /// assert_eq!(sum.parts(), [1e-16, 1.0, 1e16]);
    /// assert_eq!(sum.parts().iter().copied().collect::<ExactSum>(), sum);
    /// ```
    #[must_use]
    pub fn parts(&self) -> &[f64] {
        &self.parts
    }

    /// The double nearest to the sum; of two that are equally near the even one.
    #[must_use]
    pub fn value(&self) -> f64 {
        let mut parts = self.parts.iter().rev().copied();
        let Some(mut value) = parts.next() else {
            return 0.0;
        };
        while let Some(part) = parts.next() {
            let rest;
            [value, rest] = two_sum(value, part);
            if rest != 0.0 {
                // A tie that was rounded to even is none if more lies on the other side of it.
                let beyond = parts.next().unwrap_or(0.0);
                let doubled = value + 2.0 * rest;
                let is_tie = two_sum(value, 2.0 * rest)[1] == 0.0;
                if is_tie && rest * beyond > 0.0 {
                    value = doubled;
                }
                break;
            }
        }
        value
    }
}

impl FromIterator<f64> for ExactSum {
    fn from_iter<T: IntoIterator<Item = f64>>(numbers: T) -> Self {
        let mut sum = Self::default();
        for number in numbers {
            sum.add(number);
        }
        sum
    }
}

/// `x + y` as a rounded value and its error, exactly (Knuth).
fn two_sum(x: f64, y: f64) -> [f64; 2] {
    let sum = x + y;
    let y_virtual = sum - x;
    let x_virtual = sum - y_virtual;
    [sum, (x - x_virtual) + (y - y_virtual)]
}
