//! Rings inside rings as polygons with holes.

use curvecrust::DVec2;
use curvecrust::geometry::point_set::by_coordinates;
use curvecrust::geometry::{PointSet, orient2d};
use curvecrust::reconstruct::{NestedChain, Reconstruction};
use rstar::primitives::GeomWithData;
use rstar::primitives::Rectangle;
use rstar::{AABB, RTree};

/// A ring at even nesting, and the rings right inside it; indices of chains.
#[derive(Debug, PartialEq)]
pub(super) struct Polygon {
    pub(super) outside: usize,
    pub(super) holes: Vec<usize>,
}

/// Every ring in exactly one polygon, in the order of their outsides. A hole around which no ring is
/// found, as may be where rings cross, is the outside of a polygon of its own.
pub(super) fn polygons(points: &PointSet, curves: &Reconstruction) -> Vec<Polygon> {
    let chains = curves.chains();
    let corners = |chain: &NestedChain| -> Vec<DVec2> {
        let vertices = chain.chain.vertices().iter();
        vertices.map(|&v| points[v]).collect()
    };
    let outsides = chains.iter().enumerate().filter_map(|(index, chain)| {
        let nesting = chain.nesting.filter(|nesting| nesting % 2 == 0)?;
        let corners = corners(chain);
        let corners = corners
            .into_iter()
            .map(|p| p.to_array())
            .collect::<Vec<_>>();
        let bounds = AABB::from_points(&corners);
        let bounds = Rectangle::from_corners(bounds.lower(), bounds.upper());
        Some(GeomWithData::new(bounds, (index, nesting)))
    });
    let tree = RTree::bulk_load(outsides.collect());
    let mut holes = vec![Vec::new(); chains.len()];
    let mut outside = vec![false; chains.len()];
    for (index, chain) in chains.iter().enumerate() {
        let Some(nesting) = chain.nesting else {
            continue;
        };
        let place = corners(chain)
            .into_iter()
            .min_by(|&a, &b| by_coordinates(a, b));
        let around = place.filter(|_| nesting % 2 == 1).and_then(|place| {
            tree.locate_all_at_point(place.to_array())
                .filter(|ring| ring.data.1 + 1 == nesting)
                .map(|ring| ring.data.0)
                .filter(|&ring| contains(&corners(&chains[ring]), place))
                .min()
        });
        match around {
            Some(ring) => holes[ring].push(index),
            None => outside[index] = true,
        }
    }
    let polygons = holes.into_iter().enumerate().filter(|&(i, _)| outside[i]);
    polygons
        .map(|(outside, holes)| Polygon { outside, holes })
        .collect()
}

/// Whether a point lies in the even-odd interior of a ring.
fn contains(ring: &[DVec2], point: DVec2) -> bool {
    let next = ring.iter().cycle().skip(1);
    let below = |&(&a, &b): &(&DVec2, &DVec2)| {
        let (left, right) = if a.x <= b.x { (a, b) } else { (b, a) };
        left.x < point.x && point.x <= right.x && orient2d(left, right, point) > 0.0
    };
    ring.iter().zip(next).filter(below).count() % 2 == 1
}
