//! beta-skeleton: D. G. Kirkpatrick, J. D. Radke, "A framework for computational morphology",
//! Computational Geometry (G. T. Toussaint, ed.), 1985; as a curve reconstruction: N. Amenta,
//! M. Bern, D. Eppstein, "The Crust and the beta-Skeleton: Combinatorial Curve Reconstruction",
//! Graphical Models and Image Processing 60(2), 1998.
//!
//! Points p and q are joined if no other point lies in the two closed discs of radius beta |pq| / 2
//! that touch both; equivalently, if pq is a Delaunay edge that subtends less than asin(1/beta) at
//! both of its apexes. At beta = 1 both discs are the one with diameter pq, and the result is the
//! Gabriel graph (K. R. Gabriel, R. R. Sokal, Systematic Zoology 18, 1969).
//!
//! Correct for closed smooth curves with epsilon < 0.297 at beta = 1.7. Cost: that of the Delaunay
//! triangulation, O(n log n).

use curvecrust_geometry::{EdgeSet, PointSet};

use crate::algorithm::{AlgorithmInfo, Basis, Guarantee, Reconstructor, SamplingBound, Scope};
use crate::delaunay_edges::{filtered, is_skeleton_edge};
use crate::error::ReconstructError;
use crate::parameter::parameter;

/// The parameter of a beta-skeleton: finite and at least 1.
///
/// ```
/// use curvecrust_reconstruct::Beta;
///
/// assert_eq!(Beta::new(1.7)?, Beta::CRUST);
/// assert!(Beta::new(0.99).is_err());
/// # Ok::<(), curvecrust_reconstruct::ReconstructError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
pub struct Beta(f64);

impl Beta {
    /// 1: the Gabriel graph.
    pub const GABRIEL: Self = Self(1.0);
    /// 1.7: the value of Amenta, Bern and Eppstein for curves; apexes below 36.03 degrees.
    pub const CRUST: Self = Self(1.7);

    /// Checks a parameter.
    ///
    /// # Errors
    /// [`Beta`](ReconstructError::Beta) if it is below 1, infinite or not a number.
    pub fn new(beta: f64) -> Result<Self, ReconstructError> {
        if beta >= 1.0 && beta.is_finite() {
            Ok(Self(beta))
        } else {
            Err(ReconstructError::Beta { beta })
        }
    }
}

parameter!(Beta);

/// The beta-skeleton: Delaunay edges that subtend less than asin(1/beta) at both apexes.
///
/// Exact. A point on the boundary of a disc removes the edge, so cocircular points cause no choice.
///
/// ```
/// use curvecrust_geometry::{DVec2, PointSet};
/// use curvecrust_reconstruct::{Beta, beta_skeleton};
///
/// // The long side subtends 90 degrees, the others 45.
/// let corner = [DVec2::ZERO, DVec2::new(2.0, 0.0), DVec2::new(1.0, 1.0)];
/// let points = PointSet::new(corner.to_vec())?;
/// assert_eq!(beta_skeleton(&points, Beta::GABRIEL).len(), 2);
/// assert_eq!(beta_skeleton(&points, Beta::CRUST).len(), 0);
/// # Ok::<(), curvecrust_geometry::PointSetError>(())
/// ```
#[must_use]
pub fn beta_skeleton(points: &PointSet, beta: Beta) -> EdgeSet {
    filtered(points, |dual| is_skeleton_edge(points, dual, beta.0))
}

/// The beta-skeleton behind the common contract.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BetaSkeleton {
    /// Its parameter.
    pub beta: Beta,
}

impl BetaSkeleton {
    /// The Gabriel graph.
    pub const GABRIEL: Self = Self {
        beta: Beta::GABRIEL,
    };
    /// The beta-skeleton at 1.7.
    pub const CRUST: Self = Self { beta: Beta::CRUST };
}

impl Reconstructor for BetaSkeleton {
    fn info(&self) -> AlgorithmInfo {
        let gabriel = AlgorithmInfo {
            name: "gabriel",
            citation: "Gabriel, Sokal: A New Statistical Approach to Geographic Variation \
                       Analysis. Systematic Zoology 1969",
            guarantees: &[],
            cost: "O(n log n)",
            honours_termini: false,
            honours_known: false,
            scope: Scope::CLOSED,
            basis: Basis::Published,
        };
        let skeleton = AlgorithmInfo {
            name: "beta-skeleton",
            citation: "Kirkpatrick, Radke: A Framework for Computational Morphology. 1985",
            ..gabriel
        };
        if self.beta == Beta::GABRIEL {
            gabriel
        } else if self.beta == Beta::CRUST {
            AlgorithmInfo {
                guarantees: const { &[Guarantee::proven(SamplingBound::Epsilon(0.297))] },
                ..skeleton
            }
        } else {
            skeleton
        }
    }

    fn reconstruct(&self, points: &PointSet) -> EdgeSet {
        beta_skeleton(points, self.beta)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use curvecrust_geometry::DVec2;

    #[test]
    fn a_parameter_is_what_was_given() {
        for beta in [1.0, 1.7, 1e300] {
            assert_eq!(Beta::new(beta).map(Beta::get), Ok(beta));
        }
    }

    /// The side of 4 subtends an angle of cotangent 3/4, which belongs to beta = 5/4.
    #[test]
    fn a_point_on_the_boundary_of_a_disc_removes_the_edge() {
        let corner = [(0.0, 0.0), (3.0, 0.0), (3.0, 4.0)];
        let points = PointSet::new(corner.map(DVec2::from).to_vec()).unwrap();
        let joined = |beta| {
            let edges = beta_skeleton(&points, Beta::new(beta).unwrap());
            edges.edges().iter().any(|e| e.a().index() == 1)
        };
        assert!(joined(1.25_f64.next_down()));
        assert!(!joined(1.25));
    }
}
