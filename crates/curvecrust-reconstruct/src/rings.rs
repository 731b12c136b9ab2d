//! Orientation and nesting of closed polygons, by exact signs.

use curvecrust_geometry::parallel::*;
use curvecrust_geometry::point_set::by_coordinates;
use curvecrust_geometry::{Chain, DVec2, PointId, PointSet, orient2d};
use num_bigint::BigInt;
use num_traits::Signed;
use rstar::primitives::{GeomWithData, Rectangle};
use rstar::{AABB, RTree};

use crate::exact::{common_exponent, cross, integer};

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
    area.is_negative()
}

/// Rings around rings.
pub(crate) struct Surroundings<'a> {
    points: &'a PointSet,
    chains: &'a [Chain],
    runs: Vec<Run>,
    /// The boxes of the runs, each with its index.
    boxes: RTree<GeomWithData<Rectangle<[f64; 2]>, usize>>,
    /// The smallest y.
    lowest: f64,
}

/// The number of sides in a run: few enough to test one by one, enough that runs take little
/// memory.
const RUN: usize = 32;

impl<'a> Surroundings<'a> {
    pub(crate) fn new(points: &'a PointSet, chains: &'a [Chain]) -> Self {
        let rings = chains.iter().enumerate().filter(|(_, c)| c.is_closed());
        let runs = rings.flat_map(|(ring, chain)| {
            let starts = (0..chain.vertices().len()).step_by(RUN);
            starts.map(move |start| Run { ring, start })
        });
        let runs: Vec<Run> = runs.collect();
        let boxed = |(index, run): (usize, &Run)| {
            let bounds = bounds(points, sides(&chains[run.ring], run.start));
            GeomWithData::new(bounds, index)
        };
        Self {
            points,
            chains,
            boxes: RTree::bulk_load(runs.iter().enumerate().map(boxed).collect()),
            runs,
            lowest: points.points().iter().map(|p| p.y).fold(0.0, f64::min),
        }
    }

    /// For each chain how many rings surround it; `None` for open chains.
    pub(crate) fn nesting(&self) -> Vec<Option<u32>> {
        let count = |ring| {
            let around = self.of(ring)?.count();
            // There are fewer rings than points.
            u32::try_from(around).ok()
        };
        (0..self.chains.len()).into_par_iter().map(count).collect()
    }

    /// For each chain the first of the rings around it that one less surround; `None` for open
    /// chains, and where there is no such ring.
    pub(crate) fn parents(&self, nesting: &[Option<u32>]) -> Vec<Option<usize>> {
        let parent = |ring: usize| {
            let outer = nesting[ring]?.checked_sub(1)?;
            self.of(ring)?.find(|&other| nesting[other] == Some(outer))
        };
        (0..self.chains.len()).into_par_iter().map(parent).collect()
    }

    /// The rings that surround a ring, ascending; `None` for an open chain.
    fn of(&self, ring: usize) -> Option<impl Iterator<Item = usize> + use<>> {
        let chain = Some(&self.chains[ring]).filter(|chain| chain.is_closed())?;
        let vertices = chain.vertices().iter().map(|&v| self.points[v]);
        let place = vertices.min_by(|&a, &b| by_coordinates(a, b))?;
        let below = AABB::from_corners([place.x, self.lowest], place.into());
        let boxes = self.boxes.locate_in_envelope_intersecting(below);
        let runs = boxes.map(|of_run| &self.runs[of_run.data]);
        let mut crossed: Vec<usize> = Vec::new();
        for run in runs.filter(|run| run.ring != ring) {
            let sides = sides(&self.chains[run.ring], run.start);
            let crossings = sides.filter(|&side| is_below(side.map(|v| self.points[v]), place));
            crossed.extend(crossings.map(|_| run.ring));
        }
        crossed.sort_unstable();
        // Those that are crossed an odd number of times, once each.
        let mut left = crossed.into_iter().peekable();
        Some(std::iter::from_fn(move || {
            loop {
                let ring = left.next()?;
                if left.next_if_eq(&ring).is_none() {
                    return Some(ring);
                }
            }
        }))
    }
}

/// Consecutive sides of a ring.
struct Run {
    ring: usize,
    /// The position of the first vertex in the ring.
    start: usize,
}

/// The sides of the run that starts at a position of a ring.
fn sides(ring: &Chain, start: usize) -> impl Iterator<Item = [PointId; 2]> + '_ {
    let vertices = ring.vertices();
    let run = &vertices[start..vertices.len().min(start + RUN)];
    let next = vertices[start + 1..].iter().chain(vertices.first());
    run.iter().zip(next).map(|(&a, &b)| [a, b])
}

fn bounds(points: &PointSet, sides: impl Iterator<Item = [PointId; 2]>) -> Rectangle<[f64; 2]> {
    let empty = (DVec2::INFINITY, DVec2::NEG_INFINITY);
    let ends = sides.flatten().map(|v| points[v]);
    let (low, high) = ends.fold(empty, |(low, high), p| (low.min(p), high.max(p)));
    Rectangle::from_corners(low.into(), high.into())
}

/// Whether a side passes below a point; of its ends only the right one belongs to it, so that a
/// vertex counts once.
fn is_below([a, b]: [DVec2; 2], point: DVec2) -> bool {
    let (left, right) = if a.x <= b.x { (a, b) } else { (b, a) };
    left.x < point.x && point.x <= right.x && orient2d(left, right, point) > 0.0
}
