//! Interval arithmetic with outward rounding.
//!
//! IEEE 754 rounds sums, products, quotients and square roots to the nearest number, so its two
//! neighbours enclose the exact value. Nothing else is used here. The crate `inari` rounds better,
//! but it needs the library GMP or certain processors.
//!
//! All comparisons of floating-point numbers of the proof are in this file.

use std::ops::{Add, Div, Mul, Neg, Sub};

/// A closed interval of real numbers: its ends are no NaN and in order, infinite if nothing is
/// known.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Interval {
    low: f64,
    high: f64,
}

impl Interval {
    /// All real numbers.
    pub const WHOLE: Self = Self {
        low: f64::NEG_INFINITY,
        high: f64::INFINITY,
    };

    /// The interval between two numbers; all real numbers if they are none or not in order.
    #[must_use]
    pub fn new(low: f64, high: f64) -> Self {
        if low <= high {
            Self { low, high }
        } else {
            Self::WHOLE
        }
    }

    /// The interval of one number.
    #[must_use]
    pub fn point(number: f64) -> Self {
        Self::new(number, number)
    }

    /// An interval that holds the decimal number from which `number` was read.
    #[must_use]
    pub fn around(number: f64) -> Self {
        Self::outward(number, number)
    }

    /// Ends that were rounded to nearest, moved out by one number each.
    fn outward(low: f64, high: f64) -> Self {
        Self::new(low.next_down(), high.next_up())
    }

    /// The lower end.
    #[must_use]
    pub fn low(self) -> f64 {
        self.low
    }

    /// The upper end.
    #[must_use]
    pub fn high(self) -> f64 {
        self.high
    }

    /// The lower end, as an interval.
    #[must_use]
    pub fn lower(self) -> Self {
        Self::point(self.low)
    }

    /// The upper end, as an interval.
    #[must_use]
    pub fn upper(self) -> Self {
        Self::point(self.high)
    }

    /// Whether it is more than one number.
    #[must_use]
    pub fn has_length(self) -> bool {
        self.low < self.high
    }

    /// Some number in the middle.
    #[must_use]
    pub fn middle(self) -> f64 {
        0.5 * self.low + 0.5 * self.high
    }

    /// The width, rounded.
    #[must_use]
    pub fn width(self) -> f64 {
        self.high - self.low
    }

    /// Two intervals that cover it.
    #[must_use]
    pub fn halves(self) -> [Self; 2] {
        let middle = self.middle();
        if self.low <= middle && middle <= self.high {
            [Self::new(self.low, middle), Self::new(middle, self.high)]
        } else {
            [self, self]
        }
    }

    /// Whether each number of it is below each of another.
    #[must_use]
    pub fn is_below(self, other: Self) -> bool {
        self.high < other.low
    }

    /// Whether all its numbers are positive.
    #[must_use]
    pub fn is_positive(self) -> bool {
        0.0 < self.low
    }

    /// Whether all its numbers are negative.
    #[must_use]
    pub fn is_negative(self) -> bool {
        self.high < 0.0
    }

    /// Whether it is wider than another.
    #[must_use]
    pub fn is_wider(self, other: Self) -> bool {
        self.width() > other.width()
    }

    /// Whether it holds every number of another.
    #[must_use]
    pub fn holds(self, other: Self) -> bool {
        self.low <= other.low && other.high <= self.high
    }

    /// The squares of its numbers.
    #[must_use]
    pub fn square(self) -> Self {
        let (a, b) = (self.low.abs(), self.high.abs());
        let least = if self.low <= 0.0 && 0.0 <= self.high {
            0.0
        } else {
            a.min(b)
        };
        let most = a.max(b);
        let squares = Self::outward(least * least, most * most);
        Self::new(squares.low.max(0.0), squares.high)
    }

    /// The square roots of those of its numbers that have one; 0 and above.
    #[must_use]
    pub fn sqrt(self) -> Self {
        let roots = Self::outward(self.low.max(0.0).sqrt(), self.high.max(0.0).sqrt());
        Self::new(roots.low.max(0.0), roots.high)
    }

    /// The larger of a number of each.
    #[must_use]
    pub fn max(self, other: Self) -> Self {
        Self::new(self.low.max(other.low), self.high.max(other.high))
    }

    /// The smaller of a number of each.
    #[must_use]
    pub fn min(self, other: Self) -> Self {
        Self::new(self.low.min(other.low), self.high.min(other.high))
    }

    /// How far its numbers are from those of another, from the least to the largest distance.
    #[must_use]
    pub fn distance(self, other: Self) -> Self {
        let Self { low, high } = self - other;
        if low <= 0.0 && 0.0 <= high {
            return Self::new(0.0, high.max(-low));
        }
        Self::new(low.abs().min(high.abs()), low.abs().max(high.abs()))
    }

    /// The smallest interval that holds both.
    #[must_use]
    pub fn hull(self, other: Self) -> Self {
        Self::new(self.low.min(other.low), self.high.max(other.high))
    }

    /// The cosine and the sine of the angles whose half has its tangent in it.
    #[must_use]
    pub fn cosine_and_sine(self) -> [Self; 2] {
        let (one, two) = (Self::point(1.0), Self::point(2.0));
        let cosine = two / (one + self.square()) - one;
        let sine = |half: Self| two * half / (one + half.square());
        // The sine is monotone but for the angles -90 and 90 degrees.
        let mut sines = sine(Self::point(self.low)).hull(sine(Self::point(self.high)));
        for extreme in [-1.0, 1.0] {
            if self.low <= extreme && extreme <= self.high {
                sines = sines.hull(Self::point(extreme));
            }
        }
        [cosine, sines]
    }

    /// The least and the largest of four results that were rounded to nearest.
    fn of_four([a, b, c, d]: [f64; 4]) -> Self {
        if a.is_nan() || b.is_nan() || c.is_nan() || d.is_nan() {
            return Self::WHOLE;
        }
        Self::outward(a.min(b).min(c.min(d)), a.max(b).max(c.max(d)))
    }
}

impl Neg for Interval {
    type Output = Self;
    fn neg(self) -> Self {
        Self::new(-self.high, -self.low)
    }
}

impl Add for Interval {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self::outward(self.low + other.low, self.high + other.high)
    }
}

impl Sub for Interval {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Self::outward(self.low - other.high, self.high - other.low)
    }
}

impl Mul for Interval {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        let ([a, b], [c, d]) = ([self.low, self.high], [other.low, other.high]);
        Self::of_four([a * c, a * d, b * c, b * d])
    }
}

impl Mul<Interval> for f64 {
    type Output = Interval;
    fn mul(self, other: Interval) -> Interval {
        Interval::point(self) * other
    }
}

/// All real numbers, if the divisor holds 0.
impl Div for Interval {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        if other.low <= 0.0 && 0.0 <= other.high {
            return Self::WHOLE;
        }
        let ([a, b], [c, d]) = ([self.low, self.high], [other.low, other.high]);
        Self::of_four([a / c, a / d, b / c, b / d])
    }
}
