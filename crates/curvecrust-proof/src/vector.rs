//! Vectors of the plane whose coordinates are intervals, and discs.

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

    /// The smallest rectangle that holds both.
    pub(crate) fn hull(self, other: Self) -> Self {
        Self::new(self.x.hull(other.x), self.y.hull(other.y))
    }

    /// How far its vectors are from those of another.
    pub(crate) fn distance(self, other: Self) -> Interval {
        let (x, y) = (self.x.distance(other.x), self.y.distance(other.y));
        (x.square() + y.square()).sqrt()
    }

    /// The longer side.
    pub(crate) fn width(self) -> Interval {
        let [x, y] = [self.x, self.y].map(|side| side.upper() - side.lower());
        x.max(y)
    }

    /// One vector in the middle.
    pub(crate) fn middle(self) -> Self {
        Self::point([self.x.middle(), self.y.middle()])
    }

    /// Two rectangles that cover it, cut across the longer side.
    pub(crate) fn halves(self) -> [Self; 2] {
        if self.y.is_wider(self.x) {
            self.y.halves().map(|y| Self { y, ..self })
        } else {
            self.x.halves().map(|x| Self { x, ..self })
        }
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

/// An open disc, or all discs with such a centre and radius.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Disc {
    pub(crate) center: Vector,
    pub(crate) radius: Interval,
}

impl Disc {
    pub(crate) fn new(center: Vector, radius: Interval) -> Self {
        Self { center, radius }
    }

    /// The disc of radius 1 about a point.
    pub(crate) fn unit(center: [f64; 2]) -> Self {
        Self::new(Vector::point(center), Interval::point(1.0))
    }

    /// Whether a point is certainly inside.
    pub(crate) fn holds(self, point: Vector) -> bool {
        let from_center = point - self.center;
        from_center.square().is_below(self.radius.square())
    }

    /// How far a ray from a point runs at least until it leaves the disc for good, if it meets it.
    pub(crate) fn exit(self, point: Vector, ray: Vector) -> Interval {
        let from_center = point - self.center;
        let along = from_center.dot(ray);
        let square = along.square() + self.radius.square() - from_center.square();
        (square.sqrt() - along).lower()
    }
}
