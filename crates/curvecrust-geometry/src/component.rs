//! Points in order along a curve that is open or closed, by their indices.

use std::ops::Range;

use crate::edge_set::Edge;
use crate::point_id::PointId;

/// Consecutive indices of points in order along a curve; in a closed one the first follows the
/// last, and is not repeated.
///
/// ```
/// use curvecrust_geometry::Component;
///
/// let triangle = Component { range: 4..7, closed: true };
/// assert_eq!((triangle.previous(4), triangle.next(6)), (Some(6), Some(4)));
/// assert_eq!(triangle.pairs().collect::<Vec<_>>(), [(4, 5), (5, 6), (6, 4)]);
/// let path = Component { range: 4..7, closed: false };
/// assert_eq!((path.previous(4), path.next(6)), (None, None));
/// assert_eq!(path.pairs().collect::<Vec<_>>(), [(4, 5), (5, 6)]);
/// ```
#[derive(Clone, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Component {
    /// The indices, in order along the curve.
    pub range: Range<usize>,
    /// Whether the first point follows the last.
    pub closed: bool,
}

impl Component {
    /// The number of points.
    #[must_use]
    pub fn len(&self) -> usize {
        self.range.len()
    }

    /// Whether there is no point.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.range.is_empty()
    }

    /// Whether a point belongs to the component.
    #[must_use]
    pub fn contains(&self, index: usize) -> bool {
        self.range.contains(&index)
    }

    /// The point after one of the component; `None` at an open end. The only point of a closed
    /// component follows itself.
    #[must_use]
    pub fn next(&self, index: usize) -> Option<usize> {
        if index + 1 < self.range.end {
            Some(index + 1)
        } else {
            self.closed.then_some(self.range.start)
        }
    }

    /// The point before one of the component; `None` at an open end.
    #[must_use]
    pub fn previous(&self, index: usize) -> Option<usize> {
        if index > self.range.start {
            Some(index - 1)
        } else {
            self.closed.then(|| self.range.end - 1)
        }
    }

    /// Whether a point of the component is an open end of it.
    #[must_use]
    pub fn is_end(&self, index: usize) -> bool {
        self.previous(index).is_none() || self.next(index).is_none()
    }

    /// How many pairs of consecutive points there are: the point after the last counts if it is
    /// closed.
    #[must_use]
    pub fn pair_count(&self) -> usize {
        self.len().saturating_sub(usize::from(!self.closed))
    }

    /// Each point with the next, in order; the last pair of a closed component leads back to its
    /// first point.
    #[must_use]
    pub fn pairs(&self) -> impl DoubleEndedIterator<Item = (usize, usize)> + Clone + use<> {
        let Range { start, end } = self.range;
        let next = move |index| if index + 1 < end { index + 1 } else { start };
        let firsts = start..start + self.pair_count();
        firsts.map(move |index| (index, next(index)))
    }

    /// The edges between consecutive points, in order. One of a closed component of two points is
    /// there twice; a component of one point has none. Points beyond the last [`PointId`] have
    /// none.
    pub fn edges(&self) -> impl Iterator<Item = Edge> + Clone + use<> {
        self.pairs()
            .filter_map(|(p, q)| Edge::new(PointId::new(p)?, PointId::new(q)?))
    }

    /// The point that is `steps` after one of the component, at most a round ahead if that is
    /// closed.
    ///
    /// Behind the last point of an open component it is the index that a point would have there.
    #[must_use]
    pub fn after(&self, index: usize, steps: usize) -> usize {
        let ahead = index + steps;
        if self.closed && ahead >= self.range.end {
            ahead - self.len()
        } else {
            ahead
        }
    }

    /// How many steps lead from one point on to another, which comes after it or, in a closed
    /// component, anywhere: from a point to itself it is a whole round.
    #[must_use]
    pub fn steps(&self, from: usize, to: usize) -> usize {
        if to > from {
            to - from
        } else {
            to + self.len() - from
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// By going from one to the next.
    #[test]
    fn all_that_it_says_is_said_by_next() {
        for (start, count) in (0..3).flat_map(|start| (0..6).map(move |count| (start, count))) {
            for closed in [false, true] {
                let range = start..start + count;
                let component = Component {
                    range: range.clone(),
                    closed,
                };
                let next = |i: usize| component.next(i);
                let pairs: Vec<_> = range.clone().filter_map(|i| Some((i, next(i)?))).collect();
                assert_eq!(component.pairs().collect::<Vec<_>>(), pairs);
                assert_eq!(component.pair_count(), pairs.len());
                for &(i, j) in &pairs {
                    assert_eq!(component.previous(j), Some(i));
                }
                for from in range.clone() {
                    let mut at = from;
                    for steps in 1..=count {
                        let Some(next) = next(at) else { break };
                        at = next;
                        assert_eq!(component.after(from, steps), at);
                        assert_eq!(component.steps(from, at), steps);
                    }
                }
            }
        }
    }

    #[test]
    fn edges_join_different_points() {
        let ring = |count| Component {
            range: 0..count,
            closed: true,
        };
        let counts = [0, 1, 2, 3].map(|count| ring(count).edges().count());
        assert_eq!(counts, [0, 0, 2, 3]);
    }
}
