//! What a caller knows about the curves: that they are closed or open, and how many there are.
//!
//! Points alone leave open where a curve ends and whether two parts of it are one. A caller who
//! knows need not leave that to an estimate: with [`Known`] the search goes through the sets of
//! edges that agree with it, and through no others.

use std::num::NonZeroU32;

use curvecrust_geometry::{PointId, PointSet, orient2d};

use crate::error::ReconstructError;
use crate::termini;

/// What a caller knows about the curves; by default nothing.
///
/// ```
/// use curvecrust_geometry::{DVec2, PointSet};
/// use curvecrust_reconstruct::{Known, LeastDetour, Reconstruction};
///
/// // Two rows of points are two lines; as one closed curve they are a ring.
/// let row = |y| (0..8).map(move |x| DVec2::new(f64::from(x), y));
/// let points = PointSet::new(row(0.0).chain(row(3.0)).collect())?;
/// assert_eq!(Reconstruction::by(&LeastDetour, &points).chains().len(), 2);
/// let ring = Reconstruction::by_known(&LeastDetour, &points, &Known::ONE_CLOSED_CURVE)?;
/// assert_eq!(ring.chains().len(), 1);
/// assert_eq!(ring.chains()[0].nesting, Some(0));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Known {
    /// Whether all curves are closed or all are open; `None` if that is not known.
    pub shape: Option<Shape>,
    /// How many curves there are, which then go through all points; `None` if that is not known.
    pub curves: Option<NonZeroU32>,
    /// Points that are ends of open curves, in any order; some of them or all.
    pub termini: Vec<PointId>,
}

/// Whether curves have ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shape {
    /// No curve ends: each point has two partners.
    Closed,
    /// Every curve has two ends.
    Open,
}

impl Known {
    /// One closed curve goes through all points.
    pub const ONE_CLOSED_CURVE: Self = Self {
        shape: Some(Shape::Closed),
        curves: Some(NonZeroU32::MIN),
        termini: Vec::new(),
    };

    /// One open curve goes through all points: sorts points along a line.
    ///
    /// ```
    /// use curvecrust_geometry::{DVec2, PointSet};
    /// use curvecrust_reconstruct::{Known, LeastDetour, Reconstruction};
    ///
    /// let shuffled = [4.0, 0.0, 7.0, 2.0, 30.0].map(|x| DVec2::new(x, x * x / 50.0));
    /// let points = PointSet::new(shuffled.to_vec())?;
    /// let line = Reconstruction::by_known(&LeastDetour, &points, &Known::ONE_OPEN_CURVE)?;
    /// let vertices = line.chains()[0].chain.vertices();
    /// let order: Vec<usize> = vertices.iter().map(|v| v.index()).collect();
    /// assert_eq!(order, [1, 3, 0, 2, 4]);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub const ONE_OPEN_CURVE: Self = Self {
        shape: Some(Shape::Open),
        curves: Some(NonZeroU32::MIN),
        termini: Vec::new(),
    };

    /// Whether no more than some termini is known.
    #[must_use]
    pub fn is_of_termini_alone(&self) -> bool {
        self.shape.is_none() && self.curves.is_none()
    }

    /// The shape, which termini may tell: one curve with an end is open.
    pub(crate) fn shape(&self) -> Option<Shape> {
        let is_open = self.curves == Some(NonZeroU32::MIN) && !self.termini.is_empty();
        self.shape.or(is_open.then_some(Shape::Open))
    }

    /// What no set of points, or not this one, can agree with.
    pub(crate) fn check(&self, points: &PointSet) -> Result<(), ReconstructError> {
        termini::check(points, &self.termini)?;
        let count = points.len();
        let closed = self.shape == Some(Shape::Closed);
        let termini = distinct(&self.termini).len();
        if closed && termini > 0 {
            return Err(ReconstructError::TerminiOfClosedCurves { termini });
        }
        let each = if closed { 3 } else { 2 };
        let curves = self
            .curves
            .map_or(usize::from(closed && count > 0), |n| n.get() as usize);
        let needed = curves.saturating_mul(each);
        if count < needed {
            return Err(ReconstructError::TooFewPoints {
                count,
                curves,
                needed,
            });
        }
        if self.curves.is_some() && termini > 2 * curves {
            return Err(ReconstructError::TooManyTermini { termini, curves });
        }
        if closed && count > 0 && are_on_a_line(points, points.ids()) {
            return Err(ReconstructError::ClosedOnALine { count });
        }
        Ok(())
    }
}

/// The points, each once, ascending.
pub(crate) fn distinct(termini: &[PointId]) -> Vec<PointId> {
    let mut termini = termini.to_vec();
    termini.sort_unstable();
    termini.dedup();
    termini
}

/// Whether all points lie on one line, exactly; as fewer than three do.
pub(crate) fn are_on_a_line(points: &PointSet, mut ids: impl Iterator<Item = PointId>) -> bool {
    let [Some(a), Some(b)] = [ids.next(), ids.next()] else {
        return true;
    };
    ids.all(|c| orient2d(points[a], points[b], points[c]) == 0.0)
}
