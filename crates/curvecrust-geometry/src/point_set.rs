//! Points that every algorithm may trust: validity is settled once, here.

use std::fmt;
use std::ops::Index;

use glam::DVec2;
use thiserror::Error;

use crate::point_id::PointId;
use crate::spatial_order::{Sorted, sorted};

pub use crate::spatial_order::by_coordinates;

/// Finite, pairwise distinct points of the plane, in the caller's order.
///
/// # Guarantees
/// - Every coordinate is zero or has a magnitude in [`PointSet::MIN_MAGNITUDE`] ..=
///   [`PointSet::MAX_MAGNITUDE`]: the range in which the orientation and in-circle predicates are
///   exact.
/// - No two points are equal; -0.0 is stored as 0.0.
/// - There are fewer than 2^32 - 1 of them, so each has a [`PointId`].
///
/// ```
/// use curvecrust_geometry::{DVec2, PointSet};
///
/// let points = PointSet::new(vec![DVec2::new(0.0, 0.0), DVec2::new(1.0, 0.0)])?;
/// assert_eq!(points.len(), 2);
/// assert!(PointSet::new(vec![DVec2::ZERO, DVec2::new(0.0, f64::NAN)]).is_err());
/// # Ok::<(), curvecrust_geometry::PointSetError>(())
/// ```
#[derive(Clone, Default, PartialEq)]
pub struct PointSet {
    pub(crate) points: Vec<DVec2>,
    /// Along a Hilbert curve: found where equal points are looked for, and of use to most that
    /// take a set.
    pub(crate) order: Vec<PointId>,
}

/// Why points do not form a [`PointSet`].
#[derive(Clone, Debug, Error, PartialEq)]
#[non_exhaustive]
pub enum PointSetError {
    /// A coordinate is NaN or infinite.
    #[error("point {index} is ({x}, {y}): coordinates must be finite")]
    NotFinite {
        /// Index of the point in the input.
        index: usize,
        /// Its x coordinate.
        x: f64,
        /// Its y coordinate.
        y: f64,
    },
    /// A coordinate is too large or too small for the exact predicates.
    #[error(
        "point {index} has the coordinate {value:e}, which exact predicates cannot carry: \
         scale the points so that every coordinate is zero or between {:e} and {:e} in magnitude",
        PointSet::MIN_MAGNITUDE,
        PointSet::MAX_MAGNITUDE
    )]
    Magnitude {
        /// Index of the point in the input.
        index: usize,
        /// The coordinate.
        value: f64,
    },
    /// Two points are equal.
    #[error(
        "points {first} and {second} are both ({x}, {y}): \
         remove one, or merge duplicates with PointSet::merging_duplicates"
    )]
    Duplicate {
        /// Index of the earlier point.
        first: usize,
        /// Index of the later point.
        second: usize,
        /// Their x coordinate.
        x: f64,
        /// Their y coordinate.
        y: f64,
    },
    /// A distance within which points are merged is negative, infinite or NaN.
    #[error("points cannot be merged within {distance}: give a length of 0 or more")]
    Distance {
        /// The distance given.
        distance: f64,
    },
    /// There are more points than ids.
    #[error("{count} points, but a point set holds at most {}", u32::MAX - 1)]
    TooMany {
        /// The number of points given.
        count: usize,
    },
}

impl PointSet {
    /// Points that are known to be valid: some of a set.
    pub(crate) fn of_valid(points: Vec<DVec2>) -> Self {
        let Sorted { order, .. } = sorted(&points);
        Self { points, order }
    }

    /// The smallest non-zero magnitude of a coordinate, 2^-142.
    pub const MIN_MAGNITUDE: f64 = f64::from_bits((1023 - 142) << 52);
    /// The largest magnitude of a coordinate, 2^201.
    pub const MAX_MAGNITUDE: f64 = f64::from_bits((1023 + 201) << 52);

    /// Takes points that are valid as they are.
    ///
    /// # Errors
    /// The first coordinate that is not finite or out of range, by index; else the duplicate whose
    /// later point comes first.
    pub fn new(mut points: Vec<DVec2>) -> Result<Self, PointSetError> {
        validate(&mut points)?;
        let Sorted { order, twins } = sorted(&points);
        if let Some([first, second]) = twins.into_iter().min_by_key(|&[_, second]| second) {
            let DVec2 { x, y } = points[second];
            return Err(PointSetError::Duplicate {
                first,
                second,
                x,
                y,
            });
        }
        Ok(Self { points, order })
    }

    /// Takes anything that iterates over arrays or pairs of f64, or over vectors of glam.
    ///
    /// ```
    /// use curvecrust_geometry::PointSet;
    ///
    /// let points = PointSet::from_points([[0.0, 0.0], [1.0, 0.0]])?;
    /// assert_eq!(points, PointSet::from_points(vec![(0.0, 0.0), (1.0, 0.0)])?);
    /// # Ok::<(), curvecrust_geometry::PointSetError>(())
    /// ```
    ///
    /// # Errors
    /// Those of [`new`](Self::new).
    pub fn from_points<P: Into<DVec2>>(
        points: impl IntoIterator<Item = P>,
    ) -> Result<Self, PointSetError> {
        Self::new(points.into_iter().map(Into::into).collect())
    }

    /// The number of points.
    #[must_use]
    pub fn len(&self) -> usize {
        self.points.len()
    }

    /// Whether there is no point.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.points.is_empty()
    }

    /// The points, in order of their ids.
    #[must_use]
    pub fn points(&self) -> &[DVec2] {
        &self.points
    }

    /// The ids, ascending.
    pub fn ids(&self) -> impl ExactSizeIterator<Item = PointId> + use<> {
        (0..self.points.len()).map(id_of)
    }

    /// The points along a Hilbert curve on a grid of 2^16 x 2^16 cells over their bounding box:
    /// every id once.
    ///
    /// The points of a crowded cell are ordered in the same way on a grid over theirs, those that
    /// share one otherwise by coordinates. So the order depends on the coordinates alone, not on
    /// that of the points nor on the number of threads, and not on a scale by a power of two or an
    /// exact shift.
    ///
    /// Cost: none, since a set keeps the order by which it has found equal points.
    ///
    /// ```
    /// use curvecrust_geometry::PointSet;
    ///
    /// let points = PointSet::from_points([[0.0, 0.0], [1.0, 1.0], [1.0, 0.0], [0.0, 1.0]])?;
    /// // From corner to corner around the square, never across.
    /// let mut sides = points.hilbert_order().windows(2);
    /// assert!(sides.all(|side| points[side[0]].distance(points[side[1]]) == 1.0));
    /// # Ok::<(), curvecrust_geometry::PointSetError>(())
    /// ```
    #[must_use]
    pub fn hilbert_order(&self) -> &[PointId] {
        &self.order
    }

    /// The points along the Hilbert curve as a set of their own, and the id that each has in this
    /// one: what goes from neighbour to neighbour has them close in memory.
    ///
    /// ```
    /// use curvecrust_geometry::PointSet;
    ///
    /// let points = PointSet::from_points([[3.0, 0.0], [1.0, 0.0], [2.0, 0.0]])?;
    /// let (sorted, ids) = points.in_hilbert_order();
    /// assert!(sorted.ids().zip(ids).all(|(new, old)| sorted[new] == points[old]));
    /// # Ok::<(), curvecrust_geometry::PointSetError>(())
    /// ```
    #[must_use]
    pub fn in_hilbert_order(&self) -> (Self, Vec<PointId>) {
        let ids = self.order.clone();
        let points = ids.iter().map(|&id| self[id]).collect();
        let order = self.ids().collect();
        (Self { points, order }, ids)
    }
}

impl fmt::Debug for PointSet {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_tuple("PointSet").field(&self.points).finish()
    }
}

/// # Panics
/// If the id is of another set, and larger than those of this one, as indexing does.
impl Index<PointId> for PointSet {
    type Output = DVec2;

    fn index(&self, id: PointId) -> &DVec2 {
        &self.points[id.index()]
    }
}

impl TryFrom<Vec<DVec2>> for PointSet {
    type Error = PointSetError;

    fn try_from(points: Vec<DVec2>) -> Result<Self, PointSetError> {
        Self::new(points)
    }
}

impl From<PointSet> for Vec<DVec2> {
    fn from(set: PointSet) -> Self {
        set.points
    }
}

impl AsRef<[DVec2]> for PointSet {
    fn as_ref(&self) -> &[DVec2] {
        &self.points
    }
}

impl<'a> IntoIterator for &'a PointSet {
    type Item = &'a DVec2;
    type IntoIter = std::slice::Iter<'a, DVec2>;

    fn into_iter(self) -> Self::IntoIter {
        self.points.iter()
    }
}

impl IntoIterator for PointSet {
    type Item = DVec2;
    type IntoIter = std::vec::IntoIter<DVec2>;

    fn into_iter(self) -> Self::IntoIter {
        self.points.into_iter()
    }
}

#[expect(
    clippy::cast_possible_truncation,
    reason = "validate() bounds the count"
)]
pub(crate) fn id_of(index: usize) -> PointId {
    PointId::from(index as u32)
}

pub(crate) fn validate(points: &mut [DVec2]) -> Result<(), PointSetError> {
    if points.len() >= u32::MAX as usize {
        return Err(PointSetError::TooMany {
            count: points.len(),
        });
    }
    for (index, point) in points.iter_mut().enumerate() {
        let DVec2 { x, y } = *point;
        if !point.is_finite() {
            return Err(PointSetError::NotFinite { index, x, y });
        }
        let carried = |v: f64| {
            v == 0.0 || (PointSet::MIN_MAGNITUDE..=PointSet::MAX_MAGNITUDE).contains(&v.abs())
        };
        if let Some(value) = [x, y].into_iter().find(|&v| !carried(v)) {
            return Err(PointSetError::Magnitude { index, value });
        }
        // -0.0 + 0.0 is 0.0: equal points are then equal bit by bit.
        *point += DVec2::ZERO;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn negative_zero_is_zero() {
        let twins = vec![DVec2::new(0.0, 1.0), DVec2::new(-0.0, 1.0)];
        assert_eq!(
            PointSet::new(twins),
            Err(PointSetError::Duplicate {
                first: 0,
                second: 1,
                x: 0.0,
                y: 1.0
            })
        );
    }

    #[test]
    fn the_range_of_magnitudes_is_closed() {
        for v in [PointSet::MIN_MAGNITUDE, PointSet::MAX_MAGNITUDE, 0.0] {
            assert!(PointSet::new(vec![DVec2::new(-v, v)]).is_ok());
        }
        for v in [PointSet::MIN_MAGNITUDE / 2.0, PointSet::MAX_MAGNITUDE * 2.0] {
            assert_eq!(
                PointSet::new(vec![DVec2::ZERO, DVec2::new(1.0, v)]),
                Err(PointSetError::Magnitude { index: 1, value: v })
            );
        }
    }

    #[test]
    fn merging_keeps_first_appearances_in_order() {
        let [a, b, c] = [DVec2::new(2.0, 0.0), DVec2::new(1.0, 0.0), DVec2::ZERO];
        let merged = PointSet::merging_duplicates(vec![a, b, a, c, b, a]).unwrap();
        assert_eq!(merged.points.points(), [a, b, c]);
        let to: Vec<_> = merged.representative.iter().map(|id| id.index()).collect();
        assert_eq!(to, [0, 1, 0, 2, 1, 0]);
        assert_eq!(merged.duplicates(), 3);
    }

    #[test]
    fn errors_name_index_and_value() {
        let error = PointSet::new(vec![DVec2::X, DVec2::new(f64::INFINITY, 2.0)]).unwrap_err();
        assert_eq!(
            error.to_string(),
            "point 1 is (inf, 2): coordinates must be finite"
        );
    }
}
