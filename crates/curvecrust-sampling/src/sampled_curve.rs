//! Samples in the order of their curve.

use std::ops::Range;

use curvecrust_curve::{CurveParam, DenseCurve};
use curvecrust_geometry::{DVec2, Edge, EdgeSet, PointId, PointSet, PointSetError};

/// Samples of every component of a curve, in curve order, one component after the other.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SampledCurve {
    points: Vec<DVec2>,
    params: Vec<CurveParam>,
    dense_indices: Vec<usize>,
    components: Vec<SampledComponent>,
    closing_intervals: Vec<ClosingInterval>,
}

/// Which of the samples belong to one component.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SampledComponent {
    /// Indices of its samples.
    pub range: Range<usize>,
    /// Whether the last sample is followed by the first.
    pub closed: bool,
}

/// The interval of a closed component from its last sample back to its first.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ClosingInterval {
    /// Index of the component.
    pub component: usize,
    /// Whether the condition holds on it.
    pub holds: bool,
}

impl SampledCurve {
    /// The samples.
    #[must_use]
    pub fn points(&self) -> &[DVec2] {
        &self.points
    }

    /// Where each sample lies on the curve.
    #[must_use]
    pub fn params(&self) -> &[CurveParam] {
        &self.params
    }

    /// Which dense point each sample is.
    #[must_use]
    pub fn dense_indices(&self) -> &[usize] {
        &self.dense_indices
    }

    /// The components, in the order of the curve's.
    #[must_use]
    pub fn components(&self) -> &[SampledComponent] {
        &self.components
    }

    /// What the test of each closed component's last interval, which greedy sampling takes as it
    /// comes, has found.
    #[must_use]
    pub fn closing_intervals(&self) -> &[ClosingInterval] {
        &self.closing_intervals
    }

    /// The number of samples.
    #[must_use]
    pub fn len(&self) -> usize {
        self.points.len()
    }

    /// Whether there is no sample.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.points.is_empty()
    }

    /// The samples as bare points: ids are their indices here.
    ///
    /// # Errors
    /// If two samples are equal or a coordinate is out of range.
    pub fn point_set(&self) -> Result<PointSet, PointSetError> {
        PointSet::new(self.points.clone())
    }

    /// The manifold boundary (SGP 2016, Section 4): the edges that join consecutive samples of each
    /// component, the ground truth of a reconstruction.
    ///
    /// A closed component of two samples has one edge, one of a single sample none.
    #[must_use]
    pub fn manifold_boundary(&self) -> EdgeSet {
        let edges = self.components.iter().flat_map(|component| {
            let range = component.range.clone();
            let next = move |i: usize| {
                if i + 1 < range.end {
                    i + 1
                } else {
                    range.start
                }
            };
            let joined = component.range.len() - usize::from(!component.closed);
            component
                .range
                .clone()
                .take(joined)
                .filter_map(move |i| Edge::new(PointId::new(i)?, PointId::new(next(i))?))
        });
        EdgeSet::new(self.points.len(), edges)
    }

    pub(crate) fn push_component(
        &mut self,
        dense: &DenseCurve,
        samples: impl Iterator<Item = usize>,
        closed: bool,
    ) {
        let start = self.points.len();
        for i in samples {
            self.points.push(dense.points()[i]);
            self.params.push(dense.params()[i]);
            self.dense_indices.push(i);
        }
        let range = start..self.points.len();
        self.components.push(SampledComponent { range, closed });
    }

    pub(crate) fn push_closing(&mut self, interval: ClosingInterval) {
        self.closing_intervals.push(interval);
    }
}
