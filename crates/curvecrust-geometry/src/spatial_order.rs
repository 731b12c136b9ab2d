//! An order of the points in which neighbours in the plane are close to each other.

use glam::DVec2;
use rayon::prelude::*;

use crate::hilbert;
use crate::point_set::{PointId, PointSet, by_coordinates};

/// Points that may share a cell of the grid; more of them get a grid of their own.
const CROWD: usize = 24;

/// Below this many points a task is not divided among threads.
const TASK: usize = 1 << 14;

/// The points along a Hilbert curve on a grid of 2^16 x 2^16 cells over their bounding box: every id
/// once.
///
/// The points of a crowded cell are ordered in the same way on a grid over theirs, those that share
/// one otherwise by coordinates. So the order depends on the coordinates alone, not on that of the
/// points nor on the number of threads, and not on a scale by a power of two or an exact shift.
///
/// Cost: O(n log n), that of sorting numbers of 64 bits. Every grid separates the two extreme points
/// of its cell and is 2^16 times as fine as the last; the range of coordinates bounds the depth to 25.
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
    let mut packed: Vec<u64> = points.ids().map(|id| u64::from(u32::from(id))).collect();
    sort(points.points(), &mut packed);
    packed
        .into_iter()
        .map(|p| PointId::from(index(p)))
        .collect()
}

/// The points along the Hilbert curve as a set of their own, and the id that each has in `points`: what
/// goes from neighbour to neighbour has them close in memory.
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
    (PointSet::reordered(reordered), ids)
}

#[expect(clippy::cast_possible_truncation, reason = "the low half is the index")]
fn index(packed: u64) -> u32 {
    packed as u32
}

/// Sorts indices (the low halves) by the keys of their points, which fill the high halves.
fn sort(points: &[DVec2], packed: &mut [u64]) {
    let grid = Grid::over(points, packed);
    let fill = |p: &mut u64| {
        let index = index(*p);
        *p = u64::from(grid.key(points[index as usize])) << 32 | u64::from(index);
    };
    if packed.len() < TASK {
        packed.iter_mut().for_each(fill);
    } else {
        packed.par_iter_mut().with_min_len(TASK).for_each(fill);
    }
    sort_unstable(packed, rayon::current_num_threads());
    for crowd in packed.chunk_by_mut(|a, b| a >> 32 == b >> 32) {
        if crowd.len() > CROWD {
            sort(points, crowd);
        } else if crowd.len() > 1 {
            let at = |p: &u64| points[index(*p) as usize];
            crowd.sort_unstable_by(|p, q| by_coordinates(at(p), at(q)));
        }
    }
}

/// Sorts distinct numbers, on up to `threads` threads.
fn sort_unstable(numbers: &mut [u64], threads: usize) {
    if threads < 2 || numbers.len() < TASK {
        numbers.sort_unstable();
        return;
    }
    let half = threads / 2;
    let middle = numbers.len() / threads * half;
    let (low, _, high) = numbers.select_nth_unstable(middle);
    rayon::join(
        || sort_unstable(low, half),
        || sort_unstable(high, threads - half),
    );
}

/// A grid over the bounding box of some points.
struct Grid {
    low: DVec2,
    scale: f64,
}

impl Grid {
    fn over(points: &[DVec2], packed: &[u64]) -> Self {
        let (low, high) = packed
            .iter()
            .map(|&p| points[index(p) as usize])
            .fold((DVec2::INFINITY, DVec2::NEG_INFINITY), |(low, high), p| {
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
    fn key(&self, p: DVec2) -> u32 {
        let cell = (p - self.low) * self.scale;
        hilbert::key(cell.x as u32, cell.y as u32)
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
        let mut state = 1u64;
        let mut numbers: Vec<u64> = (0..100_000)
            .map(|i| {
                state = state
                    .wrapping_mul(6_364_136_223_846_793_005)
                    .wrapping_add(1);
                state >> 40 << 20 | i
            })
            .collect();
        let mut one = numbers.clone();
        sort_unstable(&mut one, 1);
        sort_unstable(&mut numbers, 5);
        assert_eq!(one, numbers);
    }
}
