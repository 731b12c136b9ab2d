//! Numbers that are known to lie between two others.

/// A number that is known to lie between two others.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bounds {
    /// It is at least this.
    pub lower: f64,
    /// It is at most this.
    pub upper: f64,
}

impl Bounds {
    /// Those of a number that is known.
    #[must_use]
    pub fn exactly(value: f64) -> Self {
        Self {
            lower: value,
            upper: value,
        }
    }

    /// Those of the number divided by a positive one.
    pub(crate) fn over(self, divisor: f64) -> Self {
        Self {
            lower: self.lower / divisor,
            upper: self.upper / divisor,
        }
    }
}
