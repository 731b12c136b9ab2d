//! Vectors of the plane whose coordinates are intervals.

use crate::interval::Interval;
use std::ops::{Add, Sub};

/// A rectangle of vectors.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Vector {
    pub(crate) x: Interval,
    pub(crate) y: Interval,
}

impl Vector {
    pub(crate) fn new(x: Interval, y: Interval) -> Self {
        Self { x, y }
    }

    /// One vector.
    pub(crate) fn point([x, y]: [f64; 2]) -> Self {
        Self::new(Interval::point(x), Interval::point(y))
    }

    pub(crate) fn dot(self, other: Self) -> Interval {
        self.x * other.x + self.y * other.y
    }

    pub(crate) fn square(self) -> Interval {
        self.x.square() + self.y.square()
    }

    pub(crate) fn times(self, factor: Interval) -> Self {
        Self::new(factor * self.x, factor * self.y)
    }

    /// Turned by a quarter, from the x axis to the y axis.
    pub(crate) fn turned(self) -> Self {
        Self::new(-self.y, self.x)
    }
}

impl Add for Vector {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self::new(self.x + other.x, self.y + other.y)
    }
}

impl Sub for Vector {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Self::new(self.x - other.x, self.y - other.y)
    }
}
