//! NN-Crust: T. K. Dey, P. Kumar, "A Simple Provable Algorithm for Curve Reconstruction", ACM-SIAM
//! Symposium on Discrete Algorithms (SODA), 1999.
//!
//! Every sample s is joined to its nearest neighbour n0, and to the closest sample q on the other
//! side: with an angle n0-s-q of 90 degrees or more. The output is the union of all these edges.
//! Where HNN-Crust drops what is not returned, NN-Crust keeps it, so the last sample of an open
//! curve reaches out to anything that lies beyond it.
//!
//! Correct for closed smooth curves with epsilon < 1/3. Local, like HNN-Crust: O(n log n) and
//! nearly linear on curves.

use curvecrust_geometry::{EdgeSet, PointSet};

use crate::algorithm::{AlgorithmInfo, Basis, Guarantee, Reconstructor, SamplingBound, Scope};
use crate::neighbours::{Choices, HalfRule, Keep};

/// The edges of NN-Crust.
///
/// ```
/// use curvecrust_geometry::{DVec2, PointSet};
/// use curvecrust_reconstruct::{hnn_crust, nn_crust};
///
/// // A stem that ends over the middle of a row: its last sample reaches for the row.
/// let row = (-2..=2).map(|x| DVec2::new(f64::from(x), 0.0));
/// let stem = (0..3).map(|y| DVec2::new(0.0, 1.6 + f64::from(y)));
/// let points = PointSet::new(row.chain(stem).collect())?;
/// assert_eq!(nn_crust(&points).len(), 7);
/// assert_eq!(nn_crust(&points).junctions().len(), 1);
/// assert_eq!(hnn_crust(&points).len(), 6);
/// # Ok::<(), curvecrust_geometry::PointSetError>(())
/// ```
#[must_use]
pub fn nn_crust(points: &PointSet) -> EdgeSet {
    Choices::new(points, HalfRule::RightAngle).edges(Keep::Union)
}

/// NN-Crust behind the common contract.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct NnCrust;

impl Reconstructor for NnCrust {
    fn info(&self) -> AlgorithmInfo {
        AlgorithmInfo {
            name: "nn-crust",
            citation: "Dey, Kumar: A Simple Provable Algorithm for Curve Reconstruction. SODA 1999",
            guarantees: const { &[Guarantee::proven(SamplingBound::Epsilon(1.0 / 3.0))] },
            cost: "O(n log n)",
            honours_termini: false,
            honours_known: false,
            scope: Scope::CLOSED,
            basis: Basis::Published,
        }
    }

    fn reconstruct(&self, points: &PointSet) -> EdgeSet {
        nn_crust(points)
    }
}
