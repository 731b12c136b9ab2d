//! The shortest tour: J. Giesen, "Curve Reconstruction, the Traveling Salesman Problem and Menger's
//! Theorem on Length", Symposium on Computational Geometry (SoCG), 1999; E. Althaus, K. Mehlhorn,
//! "Traveling Salesman-Based Curve Reconstruction in Polynomial Time", SIAM Journal on Computing
//! 31(1), 2001.
//!
//! One closed curve through all points, the shortest one. A closed curve that is sampled densely
//! enough is the shortest tour of its samples, also where it has corners. Sought by Lin-Kernighan
//! exchanges (1973) from a greedy start, and after random perturbations: the tour found is short,
//! and [`is_shortest_tour`] may prove that none is shorter.
//!
//! A user who knows that the curves are open, how many there are, or where they end, gets the
//! shortest set of such paths through all points.
//!
//! Cost: O(n log n) for the start, and a search whose time grows with n but has no such bound.

use curvecrust_geometry::{EdgeSet, PointSet};

use crate::algorithm::{AlgorithmInfo, Reconstructor, Scope, reconstruct_termini_alone};
use crate::constrained::{closed_through_all, one, through_all};
use crate::error::ReconstructError;
use crate::held_karp;
use crate::known::{Known, Shape, are_on_a_line};
use crate::spanning_tree::spanning_tree;
use crate::tour::Goal;

/// The shortest closed tour through all points that the search finds, a simple polygon; a path if
/// all points lie on one line.
///
/// The search starts from an order that turns and mirrors of the points change. So where other
/// tours are hardly longer, it may find another one for turned points.
///
/// ```
/// use curvecrust_geometry::{DVec2, PointSet};
/// use curvecrust_reconstruct::{is_shortest_tour, shortest_tour};
///
/// // A star: its tips are sharper than HNN-Crust can do.
/// let star = (0..10).map(|i| {
///     let radius = if i % 2 == 0 { 3.0 } else { 1.0 };
///     radius * DVec2::from_angle(f64::from(i) * std::f64::consts::TAU / 10.0)
/// });
/// let points = PointSet::new(star.collect())?;
/// let tour = shortest_tour(&points);
/// assert_eq!(tour.degrees(), [2; 10]);
/// assert!(is_shortest_tour(&points, &tour));
/// # Ok::<(), curvecrust_geometry::PointSetError>(())
/// ```
#[must_use]
pub fn shortest_tour(points: &PointSet) -> EdgeSet {
    if are_on_a_line(points, points.ids()) {
        spanning_tree(points)
    } else {
        closed_through_all(points, Goal::Length)
    }
}

/// Whether the edges are a closed tour through all points of which it is proven that no other is
/// shorter, but for rounding.
///
/// The proof is a Held-Karp bound (M. Held, R. M. Karp, "The Traveling-Salesman Problem and Minimum
/// Spanning Trees: Part II", Mathematical Programming 1, 1971): with a price on every point, no
/// tour is cheaper than a spanning tree with one edge more, the least of all such. Where that is
/// less than the tour, branch and bound closes the gap if it is small. `false` says that the search
/// for a proof was given up, or that a tour is shorter. Cost: O(n^2 log n) up to ten times for all
/// pairs, and O(n log n) for each of up to 23,000 rounds. Edges of another number of points are no
/// tour through these.
#[must_use]
pub fn is_shortest_tour(points: &PointSet, edges: &EdgeSet) -> bool {
    let is_tour = edges.vertex_count() == points.len()
        && points.len() > 2
        && edges.degrees().iter().all(|&degree| degree == 2)
        && edges.chains().len() == 1;
    is_tour && held_karp::proves(points, edges)
}

/// The shortest tour behind the common contract.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ShortestTour;

impl Reconstructor for ShortestTour {
    fn info(&self) -> AlgorithmInfo {
        AlgorithmInfo {
            honours_known: true,
            scope: Scope::CLOSED.with_corners().of_one_curve(),
            ..AlgorithmInfo::new(
                "shortest-tour",
                "Giesen: Curve Reconstruction, the Traveling Salesman Problem and Menger's \
                 Theorem on Length. SoCG 1999",
                "O(n log n) and a search",
            )
        }
    }

    fn reconstruct(&self, points: &PointSet) -> EdgeSet {
        shortest_tour(points)
    }

    /// One closed curve, or open ones.
    fn reconstruct_known(
        &self,
        points: &PointSet,
        known: &Known,
    ) -> Result<EdgeSet, ReconstructError> {
        let curves = known.curves.map(|curves| curves.get() as usize);
        let is_closed = known.shape == Some(Shape::Closed);
        if known.is_of_termini_alone() || is_closed && curves.is_some_and(|curves| curves > 1) {
            return reconstruct_termini_alone(self, points, known);
        }
        known.check(points)?;
        Ok(match curves.unwrap_or(1) {
            _ if points.is_empty() => EdgeSet::default(),
            1 => one(points, known, Goal::Length),
            curves => through_all(points, known, curves, Goal::Length),
        })
    }
}
