//! Closed cubic B-splines, and pieces of them with bounds of their places and derivatives.

use crate::interval::Interval;
use crate::vector::Vector;

/// A closed curve: a uniform cubic B-spline. Its second derivative is continuous.
///
/// Segment i belongs to four control points from the ith on, the first ones following the last.
#[derive(Clone, Debug, PartialEq)]
pub struct ClosedSpline {
    /// The control points, taken as exact; at least three.
    pub control: Vec<[f64; 2]>,
}

/// A stretch of one segment.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Piece {
    /// The index of the spline.
    pub(crate) component: usize,
    /// The index of the segment.
    pub(crate) segment: usize,
    /// The parameters, from 0 to 1 on a segment.
    pub(crate) parameter: Interval,
    /// Which interval between samples it belongs to.
    pub(crate) between: usize,
    /// A rectangle that holds it.
    pub(crate) place: Vector,
    /// A rectangle that holds its first derivatives.
    velocity: Vector,
    /// A rectangle that holds its second derivatives.
    acceleration: Vector,
    /// The place and the first three derivatives at a parameter in the middle.
    middle: [Vector; 4],
    /// The parameters, from that one on.
    step: Interval,
}

impl Piece {
    /// Half the derivative of the squared distance from the points of a region along the piece.
    ///
    /// Near the centre of an arc it hardly changes, though place and velocity do. So it is taken
    /// from the middle on, by the mean value theorem.
    pub(crate) fn slope(&self, region: Vector) -> Interval {
        let [place, velocity, ..] = self.middle;
        let centre = region.middle();
        let change = self.bend_from(centre) * self.step;
        (place - centre).dot(velocity) + change - (region - centre).dot(self.velocity)
    }

    /// Half the second derivative of the squared distance from the points of a region.
    pub(crate) fn bend(&self, region: Vector) -> Interval {
        let centre = region.middle();
        self.bend_from(centre) - (region - centre).dot(self.acceleration)
    }

    /// That from one point, by the mean value theorem too.
    fn bend_from(&self, centre: Vector) -> Interval {
        let [place, velocity, acceleration, third] = self.middle;
        let change = Interval::point(3.0) * self.velocity.dot(self.acceleration)
            + (self.place - centre).dot(third);
        let at_middle = velocity.square() + (place - centre).dot(acceleration);
        at_middle + change * self.step
    }
}

impl ClosedSpline {
    /// The number of segments.
    #[must_use]
    pub fn len(&self) -> usize {
        self.control.len()
    }

    /// Whether there is no segment.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.control.is_empty()
    }

    /// A rectangle that holds the point at a parameter of a segment.
    #[must_use]
    pub fn point(&self, segment: usize, parameter: f64) -> [Interval; 2] {
        let [place, ..] = self.derivatives(segment, Interval::point(parameter));
        [place.x, place.y]
    }

    /// Rectangles that hold the point at a parameter, and its derivatives.
    fn derivatives(&self, segment: usize, t: Interval) -> [Vector; 4] {
        let corner = |i| Vector::point(self.control[(segment + i) % self.len()]);
        let [a, b, c, d] = [0, 1, 2, 3].map(corner);
        let third = (d - a) + (b - c).times(Interval::point(3.0));
        let bend = (a - b) + (c - b);
        let slope = (c - a).times(Interval::point(0.5));
        let start = (a + b.times(Interval::point(4.0)) + c).times(one_over(6.0));
        let half = 0.5 * t;
        let second = bend + third.times(t);
        let first = slope + (bend + third.times(half)).times(t);
        let place = slope + (bend + third.times(t * one_over(3.0))).times(half);
        [start + place.times(t), first, second, third]
    }

    /// A stretch of a segment.
    pub(crate) fn piece(
        &self,
        [component, segment, between]: [usize; 3],
        parameter: Interval,
    ) -> Piece {
        let middle = Interval::point(parameter.middle());
        let at_middle = self.derivatives(segment, middle);
        let [place, first, second, third] = at_middle;
        // Taylor's formula is exact for a cubic.
        let step = parameter - middle;
        let half = 0.5 * step;
        let acceleration = second + third.times(step);
        let velocity = first + (second + third.times(half)).times(step);
        let chord = first + (second + third.times(step * one_over(3.0))).times(half);
        Piece {
            component,
            segment,
            parameter,
            between,
            place: place + chord.times(step),
            velocity,
            acceleration,
            middle: at_middle,
            step,
        }
    }

    /// The two halves of a piece.
    pub(crate) fn halves(&self, piece: &Piece) -> [Piece; 2] {
        let of = [piece.component, piece.segment, piece.between];
        piece.parameter.halves().map(|half| self.piece(of, half))
    }
}

fn one_over(number: f64) -> Interval {
    Interval::point(1.0) / Interval::point(number)
}
