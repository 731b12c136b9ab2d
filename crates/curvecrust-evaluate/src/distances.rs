//! All distances between a reconstruction and the curve.

use curvecrust_geometry::{EdgeSet, PointSet};

use crate::hausdorff::{self, Hausdorff};
use crate::reference::{Polygon, Reference};
use crate::rms::{self, RootMeanSquare};

/// How far a reconstruction and the curve are apart.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Distances {
    /// At most.
    pub hausdorff: Hausdorff,
    /// On average.
    pub rms: RootMeanSquare,
}

impl Reference {
    /// The distances between the curve and the edges of a reconstruction, whose vertices need not
    /// lie on the curve, with bounds about `tolerance` apart: a length in the unit of the curve,
    /// taken as at least 1e-7 of its extent.
    ///
    /// Infinite when there is no edge, or nothing to compare with.
    #[must_use]
    pub fn distances(&self, points: &PointSet, edges: &EdgeSet, tolerance: f64) -> Distances {
        let tolerance = tolerance.max(1e-7 * self.extent());
        let polygon = Polygon::new(points, edges);
        Distances {
            hausdorff: hausdorff::between(self, &polygon, tolerance),
            rms: rms::between(self, &polygon, tolerance),
        }
    }
}
