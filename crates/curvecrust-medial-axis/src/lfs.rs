//! Local feature size and reach.

use std::ops::RangeInclusive;

use curvecrust_curve::DenseCurve;
use curvecrust_geometry::parallel::*;
use curvecrust_geometry::{DVec2, Interrupt, SegmentTree};

use crate::axis::MedialAxis;

/// Queries in a row, each of which helps the next.
const CHUNK: usize = 512;

/// The local feature size at every dense point: its distance to the medial axis.
///
/// Infinite where the axis is empty. lfs is 1-Lipschitz along the curve (SGP 2016, Section 4).
#[derive(Clone, Debug, PartialEq)]
pub struct LocalFeatureSize {
    /// A segment tree of minima: the values are its leaves, at `len..2 * len`; node `i` is the
    /// minimum of nodes `2 i` and `2 i + 1`.
    minima: Vec<f64>,
    len: usize,
}

impl LocalFeatureSize {
    /// The distance of every dense point to the medial axis.
    #[must_use]
    pub fn new(dense: &DenseCurve, axis: &MedialAxis) -> Self {
        let (to_unit, edges) = axis.in_unit_box();
        // Pieces of the axis run far out of the box of the curve, some 10^20 times as far.
        let points = dense.points().iter().map(|&p| to_unit.apply(p));
        let (centre, radius) = disc_around(points);
        let tree = SegmentTree::near(centre, radius, edges.iter().map(|edge| edge.segment));
        // In curve order, each query starts from the answer to the one before. Chunks of a fixed
        // size, so that the number of threads changes nothing.
        let mut values = vec![f64::INFINITY; dense.len()];
        let interrupt = Interrupt::current();
        values
            .par_chunks_mut(CHUNK)
            .zip(dense.points().par_chunks(CHUNK))
            .for_each(|(values, points)| {
                interrupt.check();
                let mut last = None;
                for (value, &p) in values.iter_mut().zip(points) {
                    let p = to_unit.apply(p);
                    let nearest = match last {
                        Some(segment) => tree.nearest_after(p, segment),
                        None => tree.nearest(p),
                    };
                    if let Some((segment, distance)) = nearest {
                        *value = to_unit.invert_length(distance);
                        last = Some(segment);
                    }
                }
            });
        Self::from_values(values)
    }

    /// Takes the lfs of every dense point, in their order, from another source.
    #[must_use]
    pub fn from_values(values: Vec<f64>) -> Self {
        let len = values.len();
        let mut minima = vec![f64::INFINITY; len];
        minima.extend(values);
        for i in (1..len).rev() {
            minima[i] = minima[2 * i].min(minima[2 * i + 1]);
        }
        Self { minima, len }
    }

    /// The number of dense points.
    #[must_use]
    pub fn len(&self) -> usize {
        self.len
    }

    /// Whether there is no dense point.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.len == 0
    }

    /// The lfs of every dense point, in their order.
    #[must_use]
    pub fn values(&self) -> &[f64] {
        &self.minima[self.len..]
    }

    /// The lfs at dense point `i`.
    ///
    /// # Panics
    /// If there is no such point.
    #[must_use]
    pub fn at(&self, i: usize) -> f64 {
        self.values()[i]
    }

    /// The smallest lfs of all.
    #[must_use]
    pub fn minimum(&self) -> f64 {
        self.values().iter().copied().fold(f64::INFINITY, f64::min)
    }

    /// The reach of an interval of dense points: the minimum of lfs over it (SGP 2016, Definition
    /// 2), in O(log n).
    ///
    /// An interval that runs over the seam of a closed curve is the union of two. Infinite for an
    /// empty one; points beyond the last do not count.
    ///
    /// ```
    /// use curvecrust_medial_axis::LocalFeatureSize;
    ///
    /// let lfs = LocalFeatureSize::from_values(vec![3.0, 1.0, 4.0, 1.5]);
    /// assert_eq!(lfs.reach(2..=3), 1.5);
    /// assert_eq!(lfs.reach(0..=3), 1.0);
    /// ```
    #[must_use]
    pub fn reach(&self, interval: RangeInclusive<usize>) -> f64 {
        let mut from = self.len + (*interval.start()).min(self.len);
        let mut to = self.len + interval.end().saturating_add(1).min(self.len);
        let mut least = f64::INFINITY;
        while from < to {
            if from % 2 == 1 {
                least = least.min(self.minima[from]);
                from += 1;
            }
            if to % 2 == 1 {
                to -= 1;
                least = least.min(self.minima[to]);
            }
            from /= 2;
            to /= 2;
        }
        least
    }
}

/// The centre and the radius of the circle about the box of some points.
fn disc_around(points: impl Iterator<Item = DVec2>) -> (DVec2, f64) {
    let empty = (DVec2::INFINITY, DVec2::NEG_INFINITY);
    let (low, high) = points.fold(empty, |(low, high), p| (low.min(p), high.max(p)));
    (low.midpoint(high), low.distance(high) / 2.0)
}

#[cfg(test)]
mod tests {
    #![allow(
        clippy::float_cmp,
        reason = "a minimum is one of the values, unrounded"
    )]

    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn reach_is_the_minimum(values in prop::collection::vec(0.0..1.0f64, 0..40)) {
            let lfs = LocalFeatureSize::from_values(values.clone());
            prop_assert_eq!(lfs.values(), &values);
            for from in 0..values.len() {
                for to in from..values.len() {
                    let least = values[from..=to].iter().copied().fold(f64::INFINITY, f64::min);
                    prop_assert_eq!(lfs.reach(from..=to), least);
                }
            }
        }
    }
}
