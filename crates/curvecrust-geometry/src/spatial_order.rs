//! Orders of points: by coordinates, and one in which neighbours in the plane are close.

use crate::parallel::*;
use glam::DVec2;
use std::cmp::Ordering;

use crate::hilbert;
use crate::point_id::PointId;
use crate::radix::sort_by_upper_half;

/// Points that may share a cell of the grid; more of them get a grid of their own.
const CROWD: usize = 24;

/// Below this many points a task is not divided among threads.
const TASK: usize = 1 << 14;

/// Orders points by x, then y: the order by which ties are broken.
#[must_use]
pub fn by_coordinates(a: DVec2, b: DVec2) -> Ordering {
    a.x.total_cmp(&b.x).then(a.y.total_cmp(&b.y))
}

/// An order of points, and which of them are equal.
pub(crate) struct Sorted {
    /// Every id once.
    pub(crate) order: Vec<PointId>,
    /// For every point that equals an earlier one: the first of its group, and its own index.
    pub(crate) twins: Vec<[usize; 2]>,
}

/// Orders points along the Hilbert curve, as [`PointSet::hilbert_order`] has them. Equal ones come
/// one after another, by index.
///
/// Cost: O(n), that of a radix sort of numbers of 64 bits by their upper halves. Every grid
/// separates the two extreme points of its cell and is 2^16 times as fine as the last; the range of
/// coordinates bounds the depth to 25.
pub(crate) fn sorted(points: &[DVec2]) -> Sorted {
    let grid = Grid::over(points.iter().copied());
    #[expect(clippy::cast_possible_truncation, reason = "validate() bounds it")]
    let count = points.len() as u32;
    let mut keyed: Vec<u64> = (0..count)
        .into_par_iter()
        .with_min_len(TASK)
        .map(|index| grid.keyed(points, index))
        .collect();
    let mut twins = Vec::new();
    sort(points, &mut keyed, &mut twins);
    let order = keyed.into_iter().map(|k| PointId::from(index(k))).collect();
    Sorted { order, twins }
}

/// The index of a point, beside its key in the upper half.
#[expect(clippy::cast_possible_truncation, reason = "the lower half")]
fn index(keyed: u64) -> u32 {
    keyed as u32
}

/// Sorts points, each a key in the upper half and an index in the lower one; of equal keys the
/// indices ascend.
fn sort(points: &[DVec2], keyed: &mut [u64], twins: &mut Vec<[usize; 2]>) {
    sort_by_upper_half(keyed);
    for crowd in keyed.chunk_by_mut(|j, k| j >> 32 == k >> 32) {
        let at = |k: &u64| points[index(*k) as usize];
        if crowd.len() > CROWD && crowd.iter().any(|k| at(k) != at(&crowd[0])) {
            let grid = Grid::over(crowd.iter().map(at));
            for k in &mut *crowd {
                *k = grid.keyed(points, index(*k));
            }
            sort(points, crowd, twins);
        } else if crowd.len() > 1 {
            crowd.sort_unstable_by(|j, k| by_coordinates(at(j), at(k)).then(j.cmp(k)));
            for equal in crowd.chunk_by(|j, k| at(j) == at(k)) {
                let [first, others @ ..] = equal else {
                    continue;
                };
                let pair = |k: &u64| [*first, *k].map(|k| index(k) as usize);
                twins.extend(others.iter().map(pair));
            }
        }
    }
}

/// A grid over the bounding box of some points.
struct Grid {
    low: DVec2,
    scale: f64,
}

impl Grid {
    fn over(points: impl Iterator<Item = DVec2>) -> Self {
        let (low, high) = points.fold((DVec2::INFINITY, DVec2::NEG_INFINITY), |(low, high), p| {
            (low.min(p), high.max(p))
        });
        let extent = (high - low).max_element();
        let scale = if extent > 0.0 {
            (hilbert::SIDE - 0.5) / extent
        } else {
            0.0
        };
        Self { low, scale }
    }

    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "between 0 and SIDE"
    )]
    #[inline(always)]
    fn keyed(&self, points: &[DVec2], index: u32) -> u64 {
        let cell = (points[index as usize] - self.low) * self.scale;
        let key = hilbert::key(cell.x as u32, cell.y as u32);
        u64::from(key) << 32 | u64::from(index)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::point_set::PointSet;
    use proptest::prelude::*;
    use std::collections::HashSet;

    #[test]
    fn clusters_within_clusters_are_resolved() {
        // Thirty clusters, each a millionth of the last, of a hundred points in a row.
        let points: Vec<DVec2> = (0..30)
            .flat_map(|depth| (1..=100).map(move |i| (depth, i)))
            .map(|(depth, i)| DVec2::new(f64::from(i) * 1e-6f64.powi(depth), 0.0))
            .collect();
        let points = PointSet::new(points[..700].to_vec()).unwrap();
        let order = points.hilbert_order();
        let mut sorted = order.to_vec();
        sorted.sort_unstable();
        assert!(sorted.into_iter().eq(points.ids()));
        let xs = order.iter().map(|&id| points[id].x);
        let jumps = xs.clone().zip(xs.skip(1)).filter(|(a, b)| a > b).count();
        assert!(jumps < 100, "{jumps}");
    }

    #[test]
    fn the_order_of_the_points_does_not_matter() {
        // Several to a cell, some cells crowded.
        let mut points: Vec<DVec2> = (0..3000u32)
            .map(|i| DVec2::new(f64::from(i % 7) * 1e-9, f64::from(i / 7) * 1e-7))
            .chain([DVec2::ONE])
            .collect();
        let ordered = |points: &[DVec2]| {
            let points = PointSet::new(points.to_vec()).unwrap();
            let order = points.hilbert_order().iter();
            order.map(|&id| points[id]).collect::<Vec<_>>()
        };
        let before = ordered(&points);
        points.reverse();
        points.rotate_left(1234);
        assert_eq!(before, ordered(&points));
    }

    proptest! {
        /// Of few places, some in crowded cells, most points have twins.
        #[test]
        fn twins_are_found(
            places in prop::collection::vec((0..4u8, 0..4u8, 0..3i32), 1..300),
        ) {
            let at = |&(x, y, depth): &(u8, u8, i32)| {
                DVec2::new(f64::from(x), f64::from(y)) * 1e-6f64.powi(depth)
            };
            let points: Vec<DVec2> = places.iter().map(at).collect();
            let Sorted { order, mut twins } = sorted(&points);
            let first_of = |i: usize| points.iter().position(|&p| p == points[i]).unwrap_or(i);
            let firsts = (0..points.len()).map(|i| [first_of(i), i]);
            twins.sort_unstable_by_key(|&[_, second]| second);
            prop_assert_eq!(twins, firsts.filter(|[i, j]| i != j).collect::<Vec<_>>());
            // Every index once, and those of equal points in a row.
            let mut runs: Vec<usize> = order.iter().map(|id| first_of(id.index())).collect();
            runs.dedup();
            let ids: HashSet<PointId> = order.iter().copied().collect();
            prop_assert_eq!(ids.len(), points.len());
            prop_assert_eq!(runs.len(), runs.iter().collect::<HashSet<_>>().len());
        }
    }

    #[test]
    fn threads_do_not_matter() {
        let mut random = crate::Random::new(1);
        // Half of the points in one cell of the first grid.
        let points = (0..300_000).map(|i| {
            let scale = if i % 2 == 0 { 1.0 } else { 1e-6 };
            DVec2::new(random.unit(), random.unit()) * scale
        });
        let points = PointSet::merging_duplicates(points.collect())
            .unwrap()
            .points;
        let on = |threads| {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads);
            pool.build()
                .unwrap()
                .install(|| sorted(points.points()).order)
        };
        assert_eq!(on(1), on(5));
    }
}
