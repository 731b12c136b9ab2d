//! Numbers as text.

use std::fmt;

/// Writes the shortest decimal that reads back as the same number, with an exponent where it would
/// be long.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Number(pub(crate) f64);

impl fmt::Display for Number {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self(value) = *self;
        let magnitude = value.abs();
        if magnitude > 0.0 && !(1e-5..1e16).contains(&magnitude) && value.is_finite() {
            write!(f, "{value:e}")
        } else {
            // + 0.0: no sign of zero.
            write!(f, "{}", value + 0.0)
        }
    }
}

/// A number with its noun.
pub(crate) fn counted(count: usize, noun: &str) -> String {
    match (count, noun) {
        (1, _) => format!("1 {noun}"),
        (_, "leaf") => format!("{count} leaves"),
        _ => format!("{count} {noun}s"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn short() {
        let shown = |value: f64| Number(value).to_string();
        assert_eq!(shown(0.1 + 0.2), "0.30000000000000004");
        assert_eq!(shown(-0.0), "0");
        assert_eq!(shown(3.0), "3");
        assert_eq!(shown(1e300), "1e300");
        assert_eq!(shown(-2.5e-42), "-2.5e-42");
        assert_eq!(shown(f64::INFINITY), "inf");
    }

    proptest! {
        #[test]
        fn reads_back(value in prop::num::f64::NORMAL | prop::num::f64::SUBNORMAL) {
            let read: f64 = Number(value).to_string().parse().unwrap();
            prop_assert_eq!(read.to_bits(), value.to_bits());
        }
    }
}
