//! Mean and deviation of lengths.

/// The sums of some lengths and of their squares.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Spacing {
    count: f64,
    sum: f64,
    squares: f64,
}

impl Spacing {
    /// Of one length more.
    pub(crate) fn with(self, length: f64) -> Self {
        self.and(Self {
            count: 1.0,
            sum: length,
            squares: length * length,
        })
    }

    /// Of all lengths of both.
    pub(crate) fn and(self, other: Self) -> Self {
        Self {
            count: self.count + other.count,
            sum: self.sum + other.sum,
            squares: self.squares + other.squares,
        }
    }

    pub(crate) fn is_empty(self) -> bool {
        self.count <= 0.0
    }

    /// There must be a length.
    pub(crate) fn mean(self) -> f64 {
        self.sum / self.count
    }

    /// The standard deviation: 0 where it is no more than rounding.
    pub(crate) fn deviation(self) -> f64 {
        let mean = self.mean();
        let variance = self.squares / self.count - mean * mean;
        if variance > 1e-13 * mean * mean {
            variance.sqrt()
        } else {
            0.0
        }
    }
}
