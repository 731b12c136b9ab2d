//! Orientation and nesting of rings, against planted ones.

#![allow(clippy::unwrap_used, reason = "a test that fails panics")]

use curvecrust_geometry::{DVec2, Edge, EdgeSet, PointId, PointSet, orient2d};
use curvecrust_reconstruct::{NestedChain, Reconstruction};
use proptest::prelude::*;

/// Rings through consecutive points.
fn reconstruction(rings: &[Vec<DVec2>]) -> Reconstruction {
    let points = PointSet::new(rings.concat()).unwrap();
    let ids: Vec<PointId> = points.ids().collect();
    let mut first = 0;
    let mut edges = Vec::new();
    for ring in rings {
        let ring_ids = &ids[first..first + ring.len()];
        let next = ring_ids.iter().cycle().skip(1);
        edges.extend(
            ring_ids
                .iter()
                .zip(next)
                .filter_map(|(&p, &q)| Edge::new(p, q)),
        );
        first += ring.len();
    }
    Reconstruction::new(&points, EdgeSet::new(points.len(), edges)).unwrap()
}

fn circle(centre: DVec2, radius: f64, n: i32, sense: f64) -> Vec<DVec2> {
    let angle = |i: i32| sense * std::f64::consts::TAU * f64::from(i) / f64::from(n);
    (0..n)
        .map(|i| centre + radius * DVec2::from_angle(angle(i)))
        .collect()
}

/// Whether the ring turns left at its first vertex by x, then y.
fn is_counter_clockwise(rings: &[Vec<DVec2>], found: &NestedChain) -> bool {
    let points = rings.concat();
    let ring: Vec<DVec2> = found
        .chain
        .vertices()
        .iter()
        .map(|v| points[v.index()])
        .collect();
    let n = ring.len();
    let extreme = (0..n).min_by(|&i, &j| {
        let key = |i: usize| (ring[i].x, ring[i].y);
        key(i).partial_cmp(&key(j)).unwrap()
    });
    let i = extreme.unwrap();
    orient2d(ring[(i + n - 1) % n], ring[i], ring[(i + 1) % n]) > 0.0
}

proptest! {
    /// Circles around random centres in a row, each with circles inside circles.
    #[test]
    fn planted_depths_are_found(
        families in prop::collection::vec(
            prop::collection::vec((3..90i32, any::<bool>()), 1..6),
            1..6,
        ),
    ) {
        let mut rings = Vec::new();
        let mut depths = Vec::new();
        let mut parents = Vec::new();
        for (x, family) in (0i32..).zip(&families) {
            let centre = DVec2::new(10.0 * f64::from(x), f64::from(x % 2));
            let mut radius = 4.0;
            for (depth, &(n, flipped)) in (0u32..).zip(family) {
                parents.push((depth > 0).then(|| rings.len() - 1));
                rings.push(circle(centre, radius, n, if flipped { -1.0 } else { 1.0 }));
                // The circle inside a triangle has half its radius.
                radius *= 0.45;
                depths.push(Some(depth));
            }
        }
        let found = reconstruction(&rings);
        let nesting: Vec<_> = found.chains().iter().map(|c| c.nesting).collect();
        prop_assert_eq!(nesting, depths);
        let found_parents: Vec<_> = found.chains().iter().map(|c| c.parent).collect();
        prop_assert_eq!(found_parents, parents);
        for ring in found.chains() {
            prop_assert!(is_counter_clockwise(&rings, ring));
        }
    }
}

#[test]
fn slivers_are_oriented_exactly() {
    // A triangle whose area is lost when it is computed in doubles.
    let (a, b) = (DVec2::new(0.5, 0.5), DVec2::new(12.0, 12.0));
    for (third, flipped) in [(24f64.next_up(), false), (24f64.next_down(), true)] {
        let c = DVec2::new(24.0, third);
        let found = reconstruction(&[vec![a, b, c]]);
        let second = found.chains()[0].chain.vertices()[1].index();
        assert_eq!(second, if flipped { 2 } else { 1 });
    }
}

#[test]
fn rings_without_area_and_crossing_rings_are_settled() {
    // Back and forth on a line.
    let line = [0.0, 1.0, 2.0].map(|x| DVec2::new(x, 0.0)).to_vec();
    assert_eq!(reconstruction(&[line]).chains()[0].nesting, Some(0));
    // Two squares that cross: the first vertex of the right one is inside the left one.
    let square = |x: f64| {
        [(0.0, 0.0), (2.0, 0.1), (2.0, 2.1), (0.0, 2.0)]
            .map(|(dx, dy)| DVec2::new(x + dx, x + dy))
            .to_vec()
    };
    let found = reconstruction(&[square(0.0), square(1.0)]);
    let nested = found.chains().iter().map(|c| (c.nesting, c.parent));
    assert!(nested.eq([(Some(0), None), (Some(1), Some(0))]));
}

#[test]
fn many_rings_of_many_points_are_quick() {
    let side = 40;
    let cells = (0..side).flat_map(|x| (0..side).map(move |y| (x, y)));
    let around = cells.map(|(x, y)| {
        circle(
            DVec2::new(3.0 * f64::from(x), 3.0 * f64::from(y)),
            1.0,
            60,
            1.0,
        )
    });
    let frame = circle(DVec2::new(60.0, 60.0), 100.0, 4000, 1.0);
    let rings: Vec<_> = around.chain([frame]).collect();
    let found = reconstruction(&rings);
    let inside = found
        .chains()
        .iter()
        .filter(|c| c.nesting == Some(1))
        .count();
    assert_eq!((found.chains().len(), inside), (1601, 1600));
}
