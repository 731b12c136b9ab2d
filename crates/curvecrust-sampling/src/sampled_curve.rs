//! Samples in the order of their curve.

use curvecrust_curve::{CurveParam, DenseCurve};
use curvecrust_geometry::{Component, DVec2, EdgeSet, PointSet, PointSetError};

/// Samples of every component of a curve, in curve order, one component after the other.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SampledCurve {
    points: Vec<DVec2>,
    params: Vec<CurveParam>,
    dense_indices: Vec<usize>,
    components: Vec<Component>,
    closing_intervals: Vec<ClosingInterval>,
}

/// The interval of a closed component from its last sample back to its first.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
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

    /// The components, in the order of the curve's, each as the range of its samples.
    #[must_use]
    pub fn components(&self) -> &[Component] {
        &self.components
    }

    /// Whether the condition holds on the last interval of each closed component, whose length
    /// greedy sampling does not choose.
    #[must_use]
    pub fn closing_intervals(&self) -> &[ClosingInterval] {
        &self.closing_intervals
    }

    /// The samples at the ends of open components, ascending: the theorems are for closed curves,
    /// and an algorithm that gets these ends does not look for partners there.
    ///
    /// ```
    /// use curvecrust_curve::Curve;
    /// use curvecrust_sampling::{Condition, sample_curve};
    ///
    /// let arch = Curve::from_path_data("M 0 0 C 0 4 6 4 6 0")?;
    /// let samples = sample_curve(&arch, Condition::rho(0.9)?)?.samples;
    /// assert_eq!(samples.termini(), [0, samples.len() - 1]);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn termini(&self) -> Vec<usize> {
        let components = self.components.iter();
        components
            .flat_map(|c| c.range.clone().filter(|&i| c.is_end(i)))
            .collect()
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
        let edges = self.components.iter().flat_map(Component::edges);
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
        self.components.push(Component { range, closed });
    }

    pub(crate) fn push_closing(&mut self, interval: ClosingInterval) {
        self.closing_intervals.push(interval);
    }
}

impl AsRef<[DVec2]> for SampledCurve {
    fn as_ref(&self) -> &[DVec2] {
        &self.points
    }
}

impl<'a> IntoIterator for &'a SampledCurve {
    type Item = &'a DVec2;
    type IntoIter = std::slice::Iter<'a, DVec2>;

    fn into_iter(self) -> Self::IntoIter {
        self.points.iter()
    }
}
