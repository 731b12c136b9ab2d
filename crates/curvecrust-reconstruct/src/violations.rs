//! Where a reconstruction shows that its sampling condition was violated.

use std::fmt;

use curvecrust_geometry::{EdgeSet, PointId, PointSet};

use crate::error::ReconstructError;
use crate::reconstruction::check_vertices;

/// What the edges of HNN-Crust say about the sampling.
///
/// If the curves are closed, each vertex must have two edges: at leaves, isolated points and
/// junctions the condition was violated, or an open curve ends. Elsewhere [`joints`](Self::joints)
/// tell how near it is to that: a sampling with rho < 0.9 has angles above 73 degrees, one with
/// epsilon < 0.47 above 74 degrees (Lemmas 8 and 9 of Ohrhallinger, Mitchell, Wimmer 2016), or
/// above 126 where the curvature is constant (Table 1). HNN-Crust makes none below 60.
///
/// ```
/// use curvecrust_geometry::{DVec2, PointSet};
/// use curvecrust_reconstruct::{ViolationReport, hnn_crust};
///
/// let corner = [DVec2::new(0.0, 3.0), DVec2::ZERO, DVec2::new(1.0, 0.0)];
/// let points = PointSet::new(corner.to_vec())?;
/// let report = ViolationReport::new(&points, &hnn_crust(&points))?;
/// assert_eq!(report.leaves.len(), 2);
/// let joint = report.joints[0];
/// assert_eq!((joint.degrees, joint.length_ratio), (90.0, 3.0));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct ViolationReport {
    /// Vertices with one edge, ascending.
    pub leaves: Vec<PointId>,
    /// Vertices without an edge, ascending.
    pub isolated: Vec<PointId>,
    /// Vertices with three edges or more, ascending; HNN-Crust with mutual edges has none.
    pub junctions: Vec<PointId>,
    /// The vertices with two edges, ascending.
    pub joints: Vec<Joint>,
}

/// A vertex with two edges.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Joint {
    /// The vertex.
    pub vertex: PointId,
    /// The other ends of its edges, ascending.
    pub neighbours: [PointId; 2],
    /// The angle between the edges in degrees: 180 if the curve goes straight on.
    pub degrees: f64,
    /// The length of the longer edge over that of the shorter: 1 or more.
    pub length_ratio: f64,
}

impl ViolationReport {
    /// Looks at every vertex, in O(n).
    ///
    /// # Errors
    /// [`VertexCount`](ReconstructError::VertexCount) if the edges have another number of
    /// vertices than there are points.
    pub fn new(points: &PointSet, edges: &EdgeSet) -> Result<Self, ReconstructError> {
        check_vertices(points, edges)?;
        let mut ends: Vec<[Option<PointId>; 2]> = vec![[None; 2]; edges.vertex_count()];
        for edge in edges.edges() {
            for (v, other) in [(edge.a(), edge.b()), (edge.b(), edge.a())] {
                if let Some(free) = ends[v.index()].iter_mut().find(|slot| slot.is_none()) {
                    *free = Some(other);
                }
            }
        }
        let joints =
            points
                .ids()
                .zip(edges.degrees())
                .zip(ends)
                .filter_map(|((vertex, degree), ends)| match ends {
                    [Some(a), Some(b)] if degree == 2 => Some(Joint::new(points, vertex, [a, b])),
                    _ => None,
                });
        Ok(Self {
            joints: joints.collect(),
            leaves: edges.leaves(),
            isolated: edges.isolated(),
            junctions: edges.junctions(),
        })
    }

    /// Whether every vertex has two edges, as it must on closed curves.
    #[must_use]
    pub fn is_closed(&self) -> bool {
        self.leaves.is_empty() && self.isolated.is_empty() && self.junctions.is_empty()
    }
}

/// The numbers of leaves, isolated points and junctions, in one line.
///
/// ```
/// use curvecrust_geometry::{DVec2, PointSet};
/// use curvecrust_reconstruct::{ViolationReport, hnn_crust};
///
/// let points = PointSet::new(vec![DVec2::ZERO, DVec2::X])?;
/// let report = ViolationReport::new(&points, &hnn_crust(&points))?;
/// assert_eq!(report.to_string(), "2 leaves, 0 isolated points, 0 junctions");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
impl fmt::Display for ViolationReport {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let counted = |count: usize, one: &str, more: &str| {
            format!("{count} {}", if count == 1 { one } else { more })
        };
        let leaves = counted(self.leaves.len(), "leaf", "leaves");
        let isolated = counted(self.isolated.len(), "isolated point", "isolated points");
        let junctions = counted(self.junctions.len(), "junction", "junctions");
        write!(f, "{leaves}, {isolated}, {junctions}")
    }
}

impl Joint {
    fn new(points: &PointSet, vertex: PointId, neighbours: [PointId; 2]) -> Self {
        let [a, b] = neighbours.map(|n| points[n] - points[vertex]);
        let (short, long) = (a.length().min(b.length()), a.length().max(b.length()));
        Self {
            vertex,
            neighbours,
            degrees: a.perp_dot(b).abs().atan2(a.dot(b)).to_degrees(),
            length_ratio: long / short,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::algorithm::Reconstructor;
    use crate::hnn_crust::{HnnCrust, hnn_crust};
    use crate::nn_crust::nn_crust;
    use curvecrust_geometry::DVec2;

    #[test]
    fn a_dense_ring_has_no_violation() {
        let ring = (0..36).map(|i| DVec2::from_angle(f64::from(10 * i).to_radians()));
        let points = PointSet::new(ring.collect()).unwrap();
        let report = ViolationReport::new(&points, &hnn_crust(&points)).unwrap();
        assert!(report.is_closed());
        assert_eq!(report.joints.len(), 36);
        for joint in report.joints {
            assert!((joint.degrees - 170.0).abs() < 1e-9);
            assert!((1.0..1.0 + 1e-9).contains(&joint.length_ratio));
        }
    }

    #[test]
    fn each_vertex_is_reported_once() {
        // A row with a stem that ends over its middle: a junction for NN-Crust.
        let row = (-2..=2).map(|x| DVec2::new(f64::from(x), 0.0));
        let stem = (0..3).map(|y| DVec2::new(0.0, 1.6 + f64::from(y)));
        let points = PointSet::new(row.chain(stem).collect()).unwrap();
        for edges in [nn_crust(&points), HnnCrust::MUTUAL.reconstruct(&points)] {
            let report = ViolationReport::new(&points, &edges).unwrap();
            let mut vertices = [report.leaves, report.isolated, report.junctions].concat();
            vertices.extend(report.joints.iter().map(|j| j.vertex));
            vertices.sort_unstable();
            assert_eq!(vertices, points.ids().collect::<Vec<_>>());
        }
    }
}
