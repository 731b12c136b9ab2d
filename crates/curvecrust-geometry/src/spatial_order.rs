//! An order of the points in which neighbours in the plane are close to each other.

use crate::parallel::*;
use glam::DVec2;

use crate::hilbert;
use crate::point_id::PointId;
use crate::point_set::{PointSet, by_coordinates};
use crate::radix::sort_by_upper_half;

/// Points that may share a cell of the grid; more of them get a grid of their own.
const CROWD: usize = 24;

/// Below this many points a task is not divided among threads.
const TASK: usize = 1 << 14;

/// The points along a Hilbert curve on a grid of 2^16 x 2^16 cells over their bounding box: every
/// id once.
///
/// The points of a crowded cell are ordered in the same way on a grid over theirs, those that share
/// one otherwise by coordinates. So the order depends on the coordinates alone, not on that of the
/// points nor on the number of threads, and not on a scale by a power of two or an exact shift.
///
/// Cost: O(n), that of a radix sort of numbers of 64 bits by their upper halves. Every grid
/// separates the two extreme points of its cell and is 2^16 times as fine as the last; the range of
/// coordinates bounds the depth to 25.
///
/// ```
/// use curvecrust_geometry::{DVec2, PointSet, hilbert_order};
///
/// let corners = [(0.0, 0.0), (1.0, 1.0), (1.0, 0.0), (0.0, 1.0)].map(|(x, y)| DVec2::new(x, y));
/// let points = PointSet::new(corners.to_vec())?;
/// let order = hilbert_order(&points);
/// // From corner to corner around the square, never across.
/// assert!(order.windows(2).all(|pair| points[pair[0]].distance(points[pair[1]]) == 1.0));
/// # Ok::<(), curvecrust_geometry::PointSetError>(())
/// ```
#[must_use]
pub fn hilbert_order(points: &PointSet) -> Vec<PointId> {
    let points = points.points();
    let grid = Grid::over(points.iter().copied());
    #[expect(clippy::cast_possible_truncation, reason = "a point set bounds it")]
    let count = points.len() as u32;
    let mut keyed: Vec<u64> = (0..count)
        .into_par_iter()
        .with_min_len(TASK)
        .map(|index| grid.keyed(points, index))
        .collect();
    sort(points, &mut keyed);
    keyed.into_iter().map(|k| PointId::from(index(k))).collect()
}

/// The points along the Hilbert curve as a set of their own, and the id that each has in `points`:
/// what goes from neighbour to neighbour has them close in memory.
///
/// ```
/// use curvecrust_geometry::{DVec2, PointSet, in_hilbert_order};
///
/// let points = PointSet::new([3.0, 1.0, 2.0].map(|x| DVec2::new(x, 0.0)).to_vec())?;
/// let (sorted, ids) = in_hilbert_order(&points);
/// assert!(sorted.ids().zip(ids).all(|(new, old)| sorted[new] == points[old]));
/// # Ok::<(), curvecrust_geometry::PointSetError>(())
/// ```
#[must_use]
pub fn in_hilbert_order(points: &PointSet) -> (PointSet, Vec<PointId>) {
    let ids = hilbert_order(points);
    let reordered = ids.iter().map(|&id| points[id]).collect();
    (PointSet::of_valid(reordered), ids)
}

/// The index of a point, beside its key in the upper half.
#[expect(clippy::cast_possible_truncation, reason = "the lower half")]
fn index(keyed: u64) -> u32 {
    keyed as u32
}

/// Sorts points, each a key in the upper half and an index in the lower one.
fn sort(points: &[DVec2], keyed: &mut [u64]) {
    sort_by_upper_half(keyed);
    for crowd in keyed.chunk_by_mut(|j, k| j >> 32 == k >> 32) {
        let at = |k: &u64| points[index(*k) as usize];
        if crowd.len() > CROWD {
            let grid = Grid::over(crowd.iter().map(at));
            for k in &mut *crowd {
                *k = grid.keyed(points, index(*k));
            }
            sort(points, crowd);
        } else if crowd.len() > 1 {
            crowd.sort_unstable_by(|j, k| by_coordinates(at(j), at(k)));
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

    #[test]
    fn clusters_within_clusters_are_resolved() {
        // Thirty clusters, each a millionth of the last, of a hundred points in a row.
        let points: Vec<DVec2> = (0..30)
            .flat_map(|depth| (1..=100).map(move |i| (depth, i)))
            .map(|(depth, i)| DVec2::new(f64::from(i) * 1e-6f64.powi(depth), 0.0))
            .collect();
        let points = PointSet::new(points[..700].to_vec()).unwrap();
        let order = hilbert_order(&points);
        let mut sorted = order.clone();
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
            let order = hilbert_order(&points);
            order.into_iter().map(|id| points[id]).collect::<Vec<_>>()
        };
        let before = ordered(&points);
        points.reverse();
        points.rotate_left(1234);
        assert_eq!(before, ordered(&points));
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
            pool.build().unwrap().install(|| hilbert_order(&points))
        };
        assert_eq!(on(1), on(5));
    }
}
