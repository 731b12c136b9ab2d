//! Interval arithmetic with outward rounding.
//!
//! IEEE 754 rounds +, -, *, / and the square root correctly, so the neighbouring double on each
//! side encloses the exact value. No other function is used. The crate `inari` needs GMP or a
//! processor feature; six operations do not.

use std::ops::{Add, Div, Mul, Neg, Sub};

/// A closed interval of real numbers.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Interval {
    lo: f64,
    hi: f64,
}

const fn down(x: f64) -> f64 {
    x.next_down()
}
const fn up(x: f64) -> f64 {
    x.next_up()
}

impl Interval {
    /// The interval of one number.
    pub(super) const fn point(x: f64) -> Self {
        Self { lo: x, hi: x }
    }
    /// The interval between two numbers.
    pub(super) fn new(lo: f64, hi: f64) -> Self {
        Self { lo, hi }
    }
    /// Its lower end.
    pub(super) fn lo(self) -> f64 {
        self.lo
    }
    /// Its upper end.
    pub(super) fn hi(self) -> f64 {
        self.hi
    }
    /// Its lower end as an interval.
    pub(super) fn lower(self) -> Self {
        Self::point(self.lo)
    }
    /// A number in its middle.
    pub(super) fn mid(self) -> f64 {
        0.5 * (self.lo + self.hi)
    }
    /// How wide it is, rounded.
    pub(super) fn width(self) -> f64 {
        self.hi - self.lo
    }
    /// Its two halves.
    pub(super) fn halves(self) -> [Self; 2] {
        let m = self.mid();
        [Self { lo: self.lo, hi: m }, Self { lo: m, hi: self.hi }]
    }
    /// Whether each number of this interval is below each of the other.
    pub(super) fn is_below(self, o: Self) -> bool {
        self.hi < o.lo
    }
    /// Whether -1 or 1 is inside, not at an end.
    pub(super) fn straddles_one(self) -> bool {
        (self.lo < 1.0 && self.hi > 1.0) || (self.lo < -1.0 && self.hi > -1.0)
    }
    /// The squares.
    pub(super) fn square(self) -> Self {
        let (a, b) = (self.lo.abs(), self.hi.abs());
        let hi = a.max(b);
        let lo = if self.lo <= 0.0 && self.hi >= 0.0 {
            0.0
        } else {
            a.min(b)
        };
        Self {
            lo: down(lo * lo).max(0.0),
            hi: up(hi * hi),
        }
    }
    /// The square root of the non-negative part.
    pub(super) fn sqrt(self) -> Self {
        Self {
            lo: down(self.lo.max(0.0).sqrt()).max(0.0),
            hi: up(self.hi.max(0.0).sqrt()),
        }
    }
    /// The larger of two numbers.
    pub(super) fn max(self, o: Self) -> Self {
        Self {
            lo: self.lo.max(o.lo),
            hi: self.hi.max(o.hi),
        }
    }
    /// The smallest interval around both.
    pub(super) fn hull(self, o: Self) -> Self {
        Self {
            lo: self.lo.min(o.lo),
            hi: self.hi.max(o.hi),
        }
    }
}
impl Neg for Interval {
    type Output = Self;
    fn neg(self) -> Self {
        Self {
            lo: -self.hi,
            hi: -self.lo,
        }
    }
}
impl Add for Interval {
    type Output = Self;
    fn add(self, o: Self) -> Self {
        Self {
            lo: down(self.lo + o.lo),
            hi: up(self.hi + o.hi),
        }
    }
}
impl Sub for Interval {
    type Output = Self;
    fn sub(self, o: Self) -> Self {
        Self {
            lo: down(self.lo - o.hi),
            hi: up(self.hi - o.lo),
        }
    }
}
impl Mul for Interval {
    type Output = Self;
    fn mul(self, o: Self) -> Self {
        let p = [
            self.lo * o.lo,
            self.lo * o.hi,
            self.hi * o.lo,
            self.hi * o.hi,
        ];
        let lo = p[0].min(p[1]).min(p[2].min(p[3]));
        let hi = p[0].max(p[1]).max(p[2].max(p[3]));
        Self {
            lo: down(lo),
            hi: up(hi),
        }
    }
}
impl Mul<Interval> for f64 {
    type Output = Interval;
    fn mul(self, o: Interval) -> Interval {
        Interval::point(self) * o
    }
}
impl Div for Interval {
    type Output = Self;
    fn div(self, o: Self) -> Self {
        if o.lo <= 0.0 && o.hi >= 0.0 {
            return Self {
                lo: f64::NEG_INFINITY,
                hi: f64::INFINITY,
            };
        }
        let p = [
            self.lo / o.lo,
            self.lo / o.hi,
            self.hi / o.lo,
            self.hi / o.hi,
        ];
        let lo = p[0].min(p[1]).min(p[2].min(p[3]));
        let hi = p[0].max(p[1]).max(p[2].max(p[3]));
        Self {
            lo: down(lo),
            hi: up(hi),
        }
    }
}
