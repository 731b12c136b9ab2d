//! Samples with ids that hold for all tiles.

use curvecrust_geometry::{DVec2, PointSet, PointSetError};

use crate::area::Area;
use crate::error::TilesError;

/// A point and its number among all points of all tiles.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sample {
    /// Its number, by which the edges of the result name it.
    pub id: u64,
    /// Where it is.
    pub point: DVec2,
}

/// Valid samples at different places, along a Hilbert curve: neighbours in the list are close in
/// the plane.
#[derive(Clone, Debug, Default)]
pub struct Samples {
    ids: Vec<u64>,
    points: PointSet,
}

impl Samples {
    /// Checks samples and sorts them.
    ///
    /// ```
    /// use curvecrust_geometry::DVec2;
    /// use curvecrust_tiles::{Sample, Samples, TilesError};
    ///
    /// let sample = |id, x| Sample { id, point: DVec2::new(x, 0.0) };
    /// let samples = Samples::new(vec![sample(70, 2.0), sample(40, 0.0), sample(30, 1.0)])?;
    /// let ids: Vec<u64> = samples.iter().map(|sample| sample.id).collect();
    /// assert_eq!(ids, [40, 30, 70]);
    ///
    /// let twins = Samples::new(vec![sample(70, 2.0), sample(40, 2.0)]);
    /// assert!(matches!(twins, Err(TilesError::Duplicate { first: 40, second: 70, .. })));
    /// # Ok::<(), TilesError>(())
    /// ```
    ///
    /// # Errors
    /// A coordinate that is not finite or out of the range of a [`PointSet`], two samples at one
    /// place, or more samples than a point set can hold.
    pub fn new(samples: Vec<Sample>) -> Result<Self, TilesError> {
        let given: Vec<u64> = samples.iter().map(|s| s.id).collect();
        let points = samples.into_iter().map(|s| s.point).collect();
        let points = PointSet::new(points).map_err(|error| named(&error, &given))?;
        let (points, order) = points.in_hilbert_order();
        let ids = order.into_iter().map(|id| given[id.index()]).collect();
        Ok(Self { ids, points })
    }

    /// The number of samples.
    #[must_use]
    pub fn len(&self) -> usize {
        self.ids.len()
    }

    /// Whether there is none.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.ids.is_empty()
    }

    /// The numbers of the samples, in their order.
    #[must_use]
    pub fn ids(&self) -> &[u64] {
        &self.ids
    }

    /// The places of the samples, in their order.
    #[must_use]
    pub fn points(&self) -> &PointSet {
        &self.points
    }

    /// The sample at a position; `None` behind the last one.
    #[must_use]
    pub fn get(&self, position: usize) -> Option<Sample> {
        let (&id, &point) = (self.ids.get(position)?, self.points.points().get(position)?);
        Some(Sample { id, point })
    }

    /// The samples in their order.
    pub fn iter(&self) -> impl ExactSizeIterator<Item = Sample> + '_ {
        let both = self.ids.iter().zip(self.points.points());
        both.map(|(&id, &point)| Sample { id, point })
    }

    /// The areas of runs of `length` samples each; the last run has the rest. An
    /// [`Atlas`](crate::Atlas) is made of them. Runs of 0 samples count as runs of 1.
    #[must_use]
    pub fn run_areas(&self, length: usize) -> Vec<Area> {
        let runs = self.points.points().chunks(length.max(1));
        runs.map(|run| Area::of(run.iter().copied())).collect()
    }
}

/// An error about points in terms of their ids.
pub(crate) fn named(error: &PointSetError, ids: &[u64]) -> TilesError {
    let id = |index: usize| ids.get(index).copied().unwrap_or_default();
    match *error {
        PointSetError::NotFinite { index, x, y } => TilesError::NotFinite {
            id: id(index),
            x,
            y,
        },
        PointSetError::Magnitude { index, value } => TilesError::Magnitude {
            id: id(index),
            value,
        },
        PointSetError::Duplicate {
            first,
            second,
            x,
            y,
        } => TilesError::duplicate(id(first), id(second), DVec2::new(x, y)),
        _ => TilesError::TooMany { count: ids.len() },
    }
}
