//! A Voronoi vertex with a bound on its rounding error.

use curvecrust_geometry::point_set::by_coordinates;
use curvecrust_geometry::{DVec2, PointId, PointSet};
use num_traits::ToPrimitive;

use crate::disc::Disc;
use crate::exact::{cross, integers, sub};

/// Half a unit in the last place of 1: the relative error of one operation.
const U: f64 = f64::EPSILON / 2.0;

/// The circumcentre of a Delaunay triangle, as an offset from one of its corners: as a coordinate
/// it would lose the digits that matter near samples, and others when all points are shifted.
#[derive(Debug)]
pub(crate) struct VoronoiVertex {
    /// The corners, counter-clockwise from the one at the widest angle.
    pub(crate) corners: [PointId; 3],
    /// The first corner.
    corner: DVec2,
    /// The vertex is at `corner + offset`, up to the error.
    offset: DVec2,
    /// At least the distance between offset and true offset; at most 2^-20 of its length.
    error: f64,
}

/// A vector with a bound on its distance to the true vector.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Approximate {
    pub(crate) vector: DVec2,
    pub(crate) error: f64,
}

impl VoronoiVertex {
    /// Of a counter-clockwise Delaunay triangle.
    pub(crate) fn new(points: &PointSet, triangle: [PointId; 3]) -> Self {
        let corners = widest_first(points, triangle);
        let [a, b, c] = corners.map(|id| points[id]);
        let (ab, ac) = (b - a, c - a);
        let area = twice_area([a, b, c]);
        let across = ac * ab.length_squared() - ab * ac.length_squared();
        let offset = -across.perp() / (2.0 * area.value);
        // Both terms of `across` err by 6 U of their size, their difference by 1 U. As the widest
        // angle has 60 degrees or more, the sizes sum to no more than twice the result.
        let length = 1.5 * offset.abs().max_element();
        let error = (32.0 * U + 2.0 * area.relative_error) * length;
        Self {
            corners,
            corner: a,
            offset,
            error,
        }
    }

    /// From `p` to the vertex.
    pub(crate) fn seen_from(&self, p: DVec2) -> Approximate {
        let to_corner = self.corner - p;
        let vector = to_corner + self.offset;
        let size = to_corner.abs().max_element() + self.offset.abs().max_element();
        Approximate {
            vector,
            error: self.error + 4.0 * U * size,
        }
    }

    /// The corner at the widest angle.
    pub(crate) fn corner(&self) -> DVec2 {
        self.corner
    }

    /// The circumradius of its triangle, or less by a factor of at most the square root of 2.
    pub(crate) fn size(&self) -> f64 {
        self.offset.abs().max_element()
    }

    /// The circumradius of its triangle, rounded.
    pub(crate) fn radius(&self) -> f64 {
        libm::hypot(self.offset.x, self.offset.y)
    }

    /// The disc within the circumcircle, rounded outwards.
    pub(crate) fn disc(&self) -> Disc {
        // The true centre is off by the error, and so is the true radius.
        Disc {
            from: self.corner,
            to_centre: self.offset,
            radius: self.radius() * (1.0 + 8.0 * U) + 2.0 * self.error,
        }
    }

    /// Where it is as seen from an origin, rounded.
    pub(crate) fn position(&self, origin: DVec2) -> DVec2 {
        (self.corner - origin) + self.offset
    }
}

/// The corners from the one opposite the longest side, in the same sense of rotation.
fn widest_first(points: &PointSet, triangle: [PointId; 3]) -> [PointId; 3] {
    let at = |i: usize| points[triangle[i % 3]];
    let opposite = |i: usize| at(i + 1).distance_squared(at(i + 2));
    let first = [1, 2].into_iter().fold(0, |best, i| {
        let longer = opposite(i).total_cmp(&opposite(best));
        let before = by_coordinates(at(best), at(i));
        if longer.then(before).is_gt() { i } else { best }
    });
    [0, 1, 2].map(|i| triangle[(first + i) % 3])
}

struct Area {
    value: f64,
    relative_error: f64,
}

/// Twice the area of a counter-clockwise triangle, by integers if it is a sliver.
fn twice_area([a, b, c]: [DVec2; 3]) -> Area {
    let (ab, ac) = (b - a, c - a);
    let value = ab.perp_dot(ac);
    // Each product errs by 3 U, their difference by one more.
    let error = 8.0 * U * ((ab.x * ac.y).abs() + (ab.y * ac.x).abs());
    if value > error * 2f64.powi(28) {
        return Area {
            value,
            relative_error: 2.0 * error / value,
        };
    }
    let ([a, b, c], exponent) = integers([a, b, c]);
    let area = cross(&sub(&b, &a), &sub(&c, &a)).to_f64();
    let unit = 2f64.powi(exponent);
    Area {
        value: area.map_or(f64::INFINITY, |area| area * unit * unit),
        relative_error: 2.0 * U,
    }
}
