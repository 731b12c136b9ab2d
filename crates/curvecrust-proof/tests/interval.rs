//! Interval operations enclose the exact results, which integers of any size give.
#![allow(clippy::unwrap_used, reason = "a test, its helpers included")]

use curvecrust_proof::Interval;
use num_bigint::BigInt;
use proptest::prelude::*;

/// A number times a power of two.
#[derive(Clone)]
struct Exact(BigInt, i64);

impl Exact {
    fn new(number: f64) -> Self {
        let bits = number.to_bits();
        let exponent = i64::try_from(bits >> 52 & 0x7ff).unwrap();
        let fraction = bits & ((1 << 52) - 1);
        let (digits, exponent) = match exponent {
            0 => (fraction, -1074),
            _ => (fraction | 1 << 52, exponent - 1075),
        };
        let digits = BigInt::from(digits);
        Self(if number < 0.0 { -digits } else { digits }, exponent)
    }

    fn times(&self, other: &Self) -> Self {
        Self(&self.0 * &other.0, self.1 + other.1)
    }

    fn plus(&self, other: &Self) -> Self {
        let least = self.1.min(other.1);
        let scaled = |e: &Self| e.0.clone() << u64::try_from(e.1 - least).unwrap();
        Self(scaled(self) + scaled(other), least)
    }

    fn minus(&self, other: &Self) -> Self {
        self.plus(&Self(-other.0.clone(), other.1))
    }

    fn is_at_most(&self, other: &Self) -> bool {
        self.minus(other).0 <= BigInt::ZERO
    }
}

/// Whether an interval, of finite ends or not, holds an exact number.
fn holds(interval: Interval, number: &Exact) -> bool {
    let above = |low: f64| low == f64::NEG_INFINITY || Exact::new(low).is_at_most(number);
    let below = |high: f64| high == f64::INFINITY || number.is_at_most(&Exact::new(high));
    above(interval.low()) && below(interval.high())
}

/// Numbers of all magnitudes, simple ones among them, and an interval around each.
fn sample() -> impl Strategy<Value = (f64, Interval)> {
    let any = any::<f64>().prop_filter("finite", |x| x.is_finite());
    let simple = (-8_i32..=8).prop_map(|x| f64::from(x) / 4.0);
    let number = prop_oneof![any, -4.0..4.0, simple];
    (number, 0.0..1.0_f64, 0.0..1.0_f64).prop_map(|(x, below, above)| {
        let around = Interval::new(x - below * x.abs(), x + above * x.abs());
        (x, around)
    })
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 4000, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn sums_differences_and_products((a, i) in sample(), (b, j) in sample()) {
        let (x, y) = (Exact::new(a), Exact::new(b));
        prop_assert!(holds(i + j, &x.plus(&y)));
        prop_assert!(holds(i - j, &x.minus(&y)));
        prop_assert!(holds(i * j, &x.times(&y)));
        prop_assert!(holds(i.square(), &x.times(&x)));
        prop_assert!(holds(-i, &Exact::new(-a)));
        prop_assert!(holds(i.hull(j), &x) && holds(i.hull(j), &y));
        let larger = if x.is_at_most(&y) { y } else { x };
        prop_assert!(holds(i.max(j), &larger));
    }

    /// The quotient of a and b is inside if a is between the products of the ends with b.
    #[test]
    fn quotients((a, i) in sample(), (b, j) in sample()) {
        let (a, i, b, j) = if b < 0.0 { (-a, -i, -b, -j) } else { (a, i, b, j) };
        let quotient = i / j;
        let (dividend, divisor) = (Exact::new(a), Exact::new(b));
        let (low, high) = (quotient.low(), quotient.high());
        prop_assert!(low == f64::NEG_INFINITY || Exact::new(low).times(&divisor).is_at_most(&dividend));
        prop_assert!(high == f64::INFINITY || dividend.is_at_most(&Exact::new(high).times(&divisor)));
    }

    #[test]
    fn roots((a, i) in sample()) {
        let (a, i) = if a < 0.0 { (-a, -i) } else { (a, i) };
        let root = i.sqrt();
        let number = Exact::new(a);
        let square = |end: f64| Exact::new(end).times(&Exact::new(end));
        prop_assert!(root.low() >= 0.0 && square(root.low()).is_at_most(&number));
        prop_assert!(root.high() == f64::INFINITY || number.is_at_most(&square(root.high())));
    }

    /// (1 - m²)² + (2 m)² = (1 + m²)²; the enclosure is tested without dividing.
    #[test]
    fn cosines_and_sines(m in -3.0..3.0_f64, below in 0.0..1.0_f64, above in 0.0..1.0_f64) {
        let [cosine, sine] = Interval::new(m - below, m + above).cosine_and_sine();
        let (one, m) = (Exact::new(1.0), Exact::new(m));
        let whole = one.plus(&m.times(&m));
        let between = |i: Interval, number: &Exact| {
            Exact::new(i.low()).times(&whole).is_at_most(number)
                && number.is_at_most(&Exact::new(i.high()).times(&whole))
        };
        prop_assert!(between(cosine, &one.minus(&m.times(&m))));
        prop_assert!(between(sine, &m.plus(&m)));
    }

    #[test]
    fn halves_cover((a, i) in sample()) {
        let [low, high] = i.halves();
        prop_assert!(holds(low, &Exact::new(a)) || holds(high, &Exact::new(a)));
        prop_assert!(i.holds(low) && i.holds(high) && i == low.hull(high));
    }
}

#[test]
fn what_is_no_number_is_every_number() {
    let [zero, one] = [0.0, 1.0].map(Interval::point);
    assert_eq!(Interval::WHOLE, one / zero);
    assert_eq!(Interval::WHOLE, Interval::point(f64::NAN));
    assert_eq!(Interval::WHOLE, Interval::new(2.0, 1.0));
    assert_eq!(Interval::WHOLE, zero * Interval::WHOLE);
    assert_eq!(Interval::WHOLE, Interval::WHOLE - Interval::WHOLE);
    assert!(!one.is_below(one) && !one.is_below(Interval::WHOLE) && zero.is_below(one));
}

/// 0.86 is no double; the interval holds it all the same.
#[test]
fn a_decimal_number_is_inside() {
    let around = Interval::around(0.86);
    let hundred = Exact::new(100.0);
    let decimal = Exact::new(86.0);
    assert!(
        Exact::new(around.low())
            .times(&hundred)
            .is_at_most(&decimal)
    );
    assert!(decimal.is_at_most(&Exact::new(around.high()).times(&hundred)));
}
