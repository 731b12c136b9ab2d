//! Orientation and nesting of closed polygons, by exact signs.

use curvecrust_geometry::point_set::by_coordinates;
use curvecrust_geometry::{Chain, DVec2, PointId, PointSet, orient2d};
use num_bigint::BigInt;
use rayon::prelude::*;
use rstar::{AABB, RTree, RTreeObject};

use crate::exact::{common_exponent, cross, integer, is_negative};

/// Whether the signed area of the ring is negative, exactly.
pub(crate) fn is_clockwise(points: &PointSet, ring: &[PointId]) -> bool {
    let Some(&first) = ring.first() else {
        return false;
    };
    // From a vertex, so that the terms are no larger than the ring.
    let relative = ring.iter().map(|&v| points[v] - points[first]);
    let sides = || relative.clone().zip(relative.clone().cycle().skip(1));
    let (area, size) = sides().fold((0.0, 0.0), |(area, size), (a, b)| {
        (
            area + a.perp_dot(b),
            size + (a.x * b.y).abs() + (a.y * b.x).abs(),
        )
    });
    // Each term errs by a few ulps of its size, the sum by as many ulps as there are terms.
    #[expect(
        clippy::cast_precision_loss,
        reason = "only a bound on rounding errors"
    )]
    let error = (ring.len() + 8) as f64 * f64::EPSILON * size;
    if area.abs() > error {
        return area < 0.0;
    }
    let places: Vec<DVec2> = ring.iter().map(|&v| points[v]).collect();
    let exponent = common_exponent(&places);
    let places: Vec<_> = places.iter().map(|&p| integer(p, exponent)).collect();
    let next = places.iter().cycle().skip(1);
    let area: BigInt = places.iter().zip(next).map(|(a, b)| cross(a, b)).sum();
    is_negative(&area)
}

/// For each chain how many rings surround it; `None` for open chains.
pub(crate) fn nesting(points: &PointSet, chains: &[Chain]) -> Vec<Option<u32>> {
    let rings = chains.iter().enumerate().filter(|(_, c)| c.is_closed());
    let sides = rings.flat_map(|(ring, chain)| {
        chain.edges().map(move |edge| {
            let [a, b] = edge.ends().map(|v| points[v]);
            let (left, right) = if a.x <= b.x { (a, b) } else { (b, a) };
            Side { ring, left, right }
        })
    });
    let tree = RTree::bulk_load(sides.collect());
    let lowest = points.points().iter().map(|p| p.y).fold(0.0, f64::min);
    let depth = |(ring, chain): (usize, &Chain)| {
        let vertices = chain.vertices().iter().map(|&v| points[v]);
        let place = vertices.min_by(|&a, &b| by_coordinates(a, b))?;
        chain.is_closed().then(|| {
            let below = AABB::from_corners([place.x, lowest], place.into());
            let mut crossed: Vec<usize> = tree
                .locate_in_envelope_intersecting(below)
                .filter(|side| side.ring != ring && side.is_below(place))
                .map(|side| side.ring)
                .collect();
            crossed.sort_unstable();
            let surrounding = crossed.chunk_by(|a, b| a == b).filter(|c| c.len() % 2 == 1);
            surrounding.fold(0, |count, _| count + 1)
        })
    };
    chains.par_iter().enumerate().map(depth).collect()
}

/// A side of a ring, from left to right.
struct Side {
    ring: usize,
    left: DVec2,
    right: DVec2,
}

impl Side {
    /// Whether the side passes below a point; of its ends only the right one belongs to it, so that
    /// a vertex counts once.
    fn is_below(&self, point: DVec2) -> bool {
        self.left.x < point.x
            && point.x <= self.right.x
            && orient2d(self.left, self.right, point) > 0.0
    }
}

impl RTreeObject for Side {
    type Envelope = AABB<[f64; 2]>;

    fn envelope(&self) -> Self::Envelope {
        AABB::from_corners(self.left.into(), self.right.into())
    }
}
