//! HNN-Crust: S. Ohrhallinger, S. A. Mitchell, M. Wimmer, "Curve Reconstruction with Many Fewer
//! Samples", Computer Graphics Forum 35(5) (SGP 2016), sections 5 and 8.1.
//!
//! Every sample s chooses its nearest neighbour n0, and its half neighbour: the closest sample on
//! its own side of the bisector of s and n0, that is the closest q with |qs| < |q n0|. An edge is
//! kept if both of its ends chose it (section 8.1: reconstructed bijectively), so consecutive edges
//! meet at 60 degrees or more, and an open curve ends by itself where the choice of its last sample
//! is not returned.
//!
//! The paper claims it correct for closed smooth curves with rho < 0.9 (Theorem 2) or epsilon <
//! 0.47 (Theorem 3). Theorem 2 is false as printed: from rho = 0.8950 on there are curves with
//! samples at which an edge is lost. The covering of its Figure 8 leaves the ratio 0.7323
//! uncovered. It is proven for rho < 0.888, and with that all of Theorem 3: the project's
//! docs/theorem-2.md has the proof, one case of which a computer decides, and docs/theory.md the
//! counterexample. Between the two bounds nothing is known. A leaf on a curve that should be closed
//! shows that the condition is violated, or that it is one of these cases.
//!
//! Local: the cost is that of finding neighbours, O(n log n) and nearly linear on curves.

use curvecrust_geometry::{EdgeSet, PointId, PointSet};

use crate::algorithm::{
    AlgorithmInfo, Basis, Guarantee, Reconstructor, SamplingBound, Scope, Standing,
};
use crate::error::ReconstructError;
use crate::neighbours::{Choices, HalfRule, Keep};
use crate::termini;

/// The edges on which both of their ends agree: [`HnnCrust::MUTUAL`].
///
/// ```
/// use curvecrust_geometry::{DVec2, PointSet};
/// use curvecrust_reconstruct::hnn_crust;
///
/// let circle: Vec<DVec2> = (0..8)
///     .map(|i| DVec2::from_angle(f64::from(i) * std::f64::consts::TAU / 8.0))
///     .collect();
/// let edges = hnn_crust(&PointSet::new(circle)?);
/// assert_eq!(edges.len(), 8);
/// assert!(edges.chains()[0].is_closed());
/// # Ok::<(), curvecrust_geometry::PointSetError>(())
/// ```
#[must_use]
pub fn hnn_crust(points: &PointSet) -> EdgeSet {
    HnnCrust::MUTUAL.reconstruct(points)
}

/// HNN-Crust with the choice of which chosen edges to keep.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct HnnCrust {
    /// Which of the chosen edges are kept.
    pub keep: Keep,
}

impl HnnCrust {
    /// The paper's algorithm and the default: edges reconstructed bijectively.
    pub const MUTUAL: Self = Self { keep: Keep::Mutual };
    /// The union of all choices; the same edges wherever the guarantee holds.
    pub const UNION: Self = Self { keep: Keep::Union };

    /// The edges when some of the points are termini.
    pub(crate) fn with_termini(self, points: &PointSet, termini: &[PointId]) -> EdgeSet {
        let choices = Choices::new(points, HalfRule::Bisector);
        choices.without_half(termini).edges(self.keep)
    }
}

impl Reconstructor for HnnCrust {
    fn info(&self) -> AlgorithmInfo {
        AlgorithmInfo {
            name: match self.keep {
                Keep::Mutual => "hnn-crust",
                Keep::Union => "hnn-crust-union",
            },
            citation: "Ohrhallinger, Mitchell, Wimmer: Curve Reconstruction with Many Fewer \
                       Samples. SGP 2016",
            guarantees: &[
                Guarantee {
                    claimed: SamplingBound::Rho(0.9),
                    standing: Standing::Refuted {
                        proven_below: 0.888,
                        fails_from: 0.895_018,
                    },
                },
                Guarantee {
                    claimed: SamplingBound::Epsilon(0.47),
                    standing: Standing::Proven,
                },
            ],
            cost: "O(n log n)",
            honours_termini: true,
            honours_known: false,
            scope: Scope::CLOSED_AND_OPEN.with_corners(),
            basis: Basis::Published,
        }
    }

    fn reconstruct(&self, points: &PointSet) -> EdgeSet {
        self.with_termini(points, &[])
    }

    /// A terminus chooses its nearest neighbour only.
    ///
    /// ```
    /// use curvecrust_geometry::{DVec2, PointId, PointSet};
    /// use curvecrust_reconstruct::{HnnCrust, Reconstructor};
    ///
    /// // The corners of a rectangle, walked from 0 to 3: nothing says that the last side is open.
    /// let corners = [(0.0, 0.0), (0.0, 2.0), (3.0, 2.0), (3.0, 0.0)];
    /// let points = PointSet::new(corners.map(|(x, y)| DVec2::new(x, y)).to_vec())?;
    /// assert_eq!(HnnCrust::MUTUAL.reconstruct(&points).len(), 4);
    ///
    /// let termini = [0, 3].map(PointId::from);
    /// assert_eq!(HnnCrust::MUTUAL.reconstruct_open(&points, &termini)?.len(), 3);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    fn reconstruct_open(
        &self,
        points: &PointSet,
        termini: &[PointId],
    ) -> Result<EdgeSet, ReconstructError> {
        termini::check(points, termini)?;
        Ok(self.with_termini(points, termini))
    }
}
