//! Points of which several may stand for one.

use std::collections::{BTreeMap, VecDeque};

use glam::DVec2;

use crate::point_id::PointId;
use crate::point_set::{PointSet, PointSetError, by_coordinates, id_of, validate};
use crate::spatial_order::{Sorted, sorted};

/// A [`PointSet`] in which some points of the input stand for others, and which they are.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct MergedPoints {
    /// The points that are left, in the order of the input.
    pub points: PointSet,
    /// For every input index the id of the point that represents it.
    pub representative: Vec<PointId>,
    /// For every point that is left its index in the input, ascending.
    pub origin: Vec<usize>,
}

impl MergedPoints {
    /// All points are left.
    fn all(points: PointSet) -> Self {
        Self {
            representative: points.ids().collect(),
            origin: (0..points.len()).collect(),
            points,
        }
    }

    /// The points that represent themselves, each given by its index, are left.
    fn new(points: &[DVec2], represented_by: &[usize]) -> Self {
        let is_left = |&index: &usize| represented_by[index] == index;
        let origin: Vec<usize> = (0..points.len()).filter(is_left).collect();
        let mut id = vec![id_of(0); points.len()];
        for (place, &index) in origin.iter().enumerate() {
            id[index] = id_of(place);
        }
        Self {
            points: PointSet::of_valid(origin.iter().map(|&index| points[index]).collect()),
            representative: represented_by.iter().map(|&index| id[index]).collect(),
            origin,
        }
    }

    /// The number of input points that another one stands for.
    #[must_use]
    pub fn duplicates(&self) -> usize {
        self.representative.len() - self.points.len()
    }
}

impl PointSet {
    /// Takes points among which some may be equal: each group is represented by its first member.
    ///
    /// ```
    /// use curvecrust_geometry::{DVec2, PointSet};
    ///
    /// let merged = PointSet::merging_duplicates(vec![DVec2::X, DVec2::Y, DVec2::X])?;
    /// assert_eq!(merged.points.points(), [DVec2::X, DVec2::Y]);
    /// assert_eq!(merged.representative[2], merged.representative[0]);
    /// # Ok::<(), curvecrust_geometry::PointSetError>(())
    /// ```
    ///
    /// # Errors
    /// The first coordinate that is not finite or out of range, by index.
    pub fn merging_duplicates(mut points: Vec<DVec2>) -> Result<MergedPoints, PointSetError> {
        validate(&mut points)?;
        let Sorted { order, twins } = sorted(&points);
        if twins.is_empty() {
            return Ok(MergedPoints::all(PointSet { points, order }));
        }
        let mut represented_by: Vec<usize> = (0..points.len()).collect();
        for [first, second] in twins {
            represented_by[second] = first;
        }
        Ok(MergedPoints::new(&points, &represented_by))
    }

    /// Takes points of which some stand for all others within a distance of them.
    ///
    /// The points are taken by ascending x, and y where x is equal. Each is represented by the
    /// nearest of those that stand already, if one is within the distance, and else stands itself.
    /// So those that are left are farther apart than the distance, no point moves by more than it,
    /// and what is left does not depend on the order of the input, but for which of several equal
    /// points stands: the first.
    ///
    /// ```
    /// use curvecrust_geometry::{DVec2, PointSet};
    ///
    /// let near = DVec2::new(1.0, 1e-9);
    /// let merged = PointSet::merging_within(vec![near, DVec2::Y, DVec2::X], 1e-6)?;
    /// assert_eq!(merged.points.points(), [DVec2::Y, DVec2::X]);
    /// assert_eq!(merged.origin, [1, 2]);
    /// assert_eq!(merged.representative[0], merged.representative[2]);
    /// # Ok::<(), curvecrust_geometry::PointSetError>(())
    /// ```
    ///
    /// # Errors
    /// A distance that is negative or not finite; the first coordinate that is not finite or out of
    /// range, by index.
    pub fn merging_within(
        mut points: Vec<DVec2>,
        distance: f64,
    ) -> Result<MergedPoints, PointSetError> {
        if !(distance >= 0.0 && distance.is_finite()) {
            return Err(PointSetError::Distance { distance });
        }
        validate(&mut points)?;
        let mut order: Vec<usize> = (0..points.len()).collect();
        order.sort_unstable_by(|&i, &j| by_coordinates(points[i], points[j]).then(i.cmp(&j)));
        let mut represented_by: Vec<usize> = (0..points.len()).collect();
        let mut standing = Strip::default();
        for index in order {
            let place = points[index];
            standing.leave_behind(place.x - distance);
            match standing.nearest(place, distance) {
                Some(near) => represented_by[index] = near,
                None => standing.enter(place, index),
            }
        }
        Ok(MergedPoints::new(&points, &represented_by))
    }
}

/// The standing points that are not far behind in x, by y. They are farther apart than the
/// distance, so that few are near any point.
#[derive(Default)]
struct Strip {
    /// Their indices, by y and x.
    by_y: BTreeMap<[Ordinate; 2], usize>,
    by_x: VecDeque<DVec2>,
}

impl Strip {
    fn enter(&mut self, place: DVec2, index: usize) {
        self.by_y.insert(key(place), index);
        self.by_x.push_back(place);
    }

    fn leave_behind(&mut self, x: f64) {
        while let Some(place) = self.by_x.pop_front() {
            if place.x >= x {
                self.by_x.push_front(place);
                break;
            }
            self.by_y.remove(&key(place));
        }
    }

    /// The nearest within the distance; of several, that of smaller y, then x.
    fn nearest(&self, place: DVec2, distance: f64) -> Option<usize> {
        let lowest = [place.y - distance, f64::NEG_INFINITY].map(Ordinate);
        let highest = [place.y + distance, f64::INFINITY].map(Ordinate);
        let around = self.by_y.range(lowest..=highest);
        let apart = around.map(|(&[y, x], &index)| ((x.0 - place.x).hypot(y.0 - place.y), index));
        let near = apart.filter(|&(apart, _)| apart <= distance);
        near.min_by(|(a, _), (b, _)| a.total_cmp(b))
            .map(|(_, index)| index)
    }
}

fn key(place: DVec2) -> [Ordinate; 2] {
    [place.y, place.x].map(Ordinate)
}

/// A coordinate, ordered.
#[derive(Clone, Copy, Debug)]
struct Ordinate(f64);

impl Ord for Ordinate {
    fn cmp(&self, other: &Self) -> std::cmp::Ordering {
        self.0.total_cmp(&other.0)
    }
}

impl PartialOrd for Ordinate {
    fn partial_cmp(&self, other: &Self) -> Option<std::cmp::Ordering> {
        Some(self.cmp(other))
    }
}

impl PartialEq for Ordinate {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other).is_eq()
    }
}

impl Eq for Ordinate {}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn a_distance_is_zero_or_more() {
        for distance in [-1.0, f64::NAN, f64::INFINITY] {
            let error = PointSet::merging_within(vec![DVec2::X], distance).unwrap_err();
            assert!(matches!(error, PointSetError::Distance { .. }));
        }
        let twice = vec![DVec2::X, DVec2::X];
        let equal = PointSet::merging_duplicates(twice.clone()).unwrap();
        assert_eq!(PointSet::merging_within(twice, 0.0).unwrap(), equal);
    }

    proptest! {
        /// Against all pairs, and in another order.
        #[test]
        fn those_left_are_apart_and_near_those_they_stand_for(
            places in prop::collection::vec((0..12i32, 0..12i32), 0..60),
            distance in 0.0..4.0f64,
        ) {
            let points: Vec<DVec2> = places.iter().map(|&(x, y)| DVec2::new(x.into(), y.into())).collect();
            let merged = PointSet::merging_within(points.clone(), distance).unwrap();
            let left = merged.points.points();
            for (i, p) in left.iter().enumerate() {
                prop_assert!(left[..i].iter().all(|q| p.distance(*q) > distance));
                prop_assert_eq!(*p, points[merged.origin[i]]);
            }
            for (p, id) in points.iter().zip(&merged.representative) {
                prop_assert!(p.distance(merged.points[*id]) <= distance);
            }
            let backwards = points.iter().rev().copied().collect();
            let backwards = PointSet::merging_within(backwards, distance).unwrap();
            let sorted = |set: &PointSet| {
                let mut points = set.points().to_vec();
                points.sort_unstable_by(|&p, &q| by_coordinates(p, q));
                points
            };
            prop_assert_eq!(sorted(&backwards.points), sorted(&merged.points));
        }
    }
}
