//! Normalised mesh: D. Attali, "r-Regular Shape Reconstruction from Unorganized Points", Symposium
//! on Computational Geometry (SoCG), 1997.
//!
//! A Delaunay edge stays if the circles around its two triangles meet at an angle of less than 90
//! degrees. With half its length h and the ends t1 <= t2 of its Voronoi edge along the bisector,
//! that is h^2 + t1 t2 < 0: the rule of the [one-step crust](mod@crate::one_step_crust), but for
//! equality. An unbounded side counts as t infinite.
//!
//! Correct for the boundary of an r-regular shape, one whose boundary has balls of radius r on both
//! sides everywhere, if neighbouring samples are nearer than sin(pi / 8) r: a uniform condition,
//! not one by the local feature size. Cost: that of the Delaunay triangulation, O(n log n).

use curvecrust_geometry::{EdgeSet, PointSet};

use crate::algorithm::{AlgorithmInfo, Reconstructor, Scope};
use crate::delaunay_edges::{filtered, is_mesh_edge};

/// The normalised mesh, exactly.
///
/// ```
/// use curvecrust_geometry::{DVec2, Edge, PointSet};
/// use curvecrust_reconstruct::{normalised_mesh, one_step_crust};
///
/// // The circles around the triangles above and below the first edge meet at a right angle.
/// let kite = [(-1.0, 0.0), (1.0, 0.0), (1.0, 4.0), (1.0, -1.0)];
/// let points = PointSet::new(kite.map(DVec2::from).to_vec())?;
/// let (crust, mesh) = (one_step_crust(&points).crust, normalised_mesh(&points));
/// assert!(crust.difference(&mesh).eq(Edge::new(0.into(), 1.into())));
/// # Ok::<(), curvecrust_geometry::PointSetError>(())
/// ```
#[must_use]
pub fn normalised_mesh(points: &PointSet) -> EdgeSet {
    filtered(points, |dual| is_mesh_edge(points, dual))
}

/// The normalised mesh behind the common contract.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct NormalisedMesh;

impl Reconstructor for NormalisedMesh {
    fn info(&self) -> AlgorithmInfo {
        AlgorithmInfo {
            scope: Scope::CLOSED,
            ..AlgorithmInfo::new(
                "normalised-mesh",
                "Attali: r-Regular Shape Reconstruction from Unorganized Points. SoCG 1997",
                "O(n log n)",
            )
        }
    }

    fn reconstruct(&self, points: &PointSet) -> EdgeSet {
        normalised_mesh(points)
    }
}
