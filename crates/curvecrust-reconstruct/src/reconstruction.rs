//! A reconstruction in the form that a user needs: curves in order, rings inside rings, and loose
//! ends.

use curvecrust_geometry::edge_set::vertices_with_degree;
use curvecrust_geometry::{Chain, EdgeSet, PointId, PointSet};

use crate::algorithm::Reconstructor;
use crate::error::ReconstructError;
use crate::known::Known;
use crate::rings::{Surroundings, is_clockwise};

/// Edges between points, and the curves that they form.
///
/// ```
/// use curvecrust_geometry::{DVec2, PointSet};
/// use curvecrust_reconstruct::{HnnCrust, Reconstruction};
///
/// let circle = |n: i32, radius: f64| {
///     (0..n).map(move |i| {
///         radius * DVec2::from_angle(f64::from(-i) * std::f64::consts::TAU / f64::from(n))
///     })
/// };
/// let ring = PointSet::new(circle(20, 3.0).chain(circle(12, 1.0)).collect())?;
/// let found = Reconstruction::by(&HnnCrust::MUTUAL, &ring);
/// let [outer, hole] = found.chains() else { panic!("two rings") };
/// assert!((&found).into_iter().all(|curve| curve.chain.is_closed()));
/// assert_eq!((outer.nesting, hole.nesting), (Some(0), Some(1)));
/// assert_eq!(hole.parent, Some(0));
/// // Counter-clockwise, although the points were given clockwise.
/// assert_eq!(outer.chain.vertices()[1].index(), 19);
/// assert!(found.edges().leaves().is_empty());
/// # Ok::<(), curvecrust_geometry::PointSetError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Reconstruction {
    edges: EdgeSet,
    degrees: Vec<u32>,
    chains: Vec<NestedChain>,
}

/// A maximal chain of a reconstruction, cut at junctions.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct NestedChain {
    /// Its vertices in order. A ring runs counter-clockwise: its signed area is positive, also
    /// where it crosses itself. It starts at its smallest vertex. An open chain, and a ring
    /// without area, keeps the direction that [`Chain`] defines.
    pub chain: Chain,
    /// How many other rings surround a ring: 0 on the outside, 1 for a hole, 2 for an island in a
    /// hole. `None` for an open chain.
    ///
    /// A ring surrounds another if its even-odd interior holds the vertex of the other that comes
    /// first by x, then y. For rings that do not cross, any vertex would do.
    pub nesting: Option<u32>,
    /// The ring right around a ring, as a position in [`Reconstruction::chains`]: the first of
    /// those that surround it whose nesting is one less. `None` on the outside, for an open chain,
    /// and where rings cross so that there is no such ring.
    pub parent: Option<usize>,
}

impl Reconstruction {
    /// Reconstructs the points by an algorithm.
    #[must_use]
    pub fn by(algorithm: &dyn Reconstructor, points: &PointSet) -> Self {
        Self::of_valid(points, algorithm.reconstruct(points))
    }

    /// Reconstructs the points by an algorithm that uses what is known about the curves.
    ///
    /// # Errors
    /// Those of [`Reconstructor::reconstruct_known`].
    pub fn by_known(
        algorithm: &dyn Reconstructor,
        points: &PointSet,
        known: &Known,
    ) -> Result<Self, ReconstructError> {
        let edges = algorithm.reconstruct_known(points, known)?;
        Ok(Self::of_valid(points, edges))
    }

    /// Orders the edges between points into curves, in O(n log n) unless rings are deeply nested.
    ///
    /// # Errors
    /// [`VertexCount`](ReconstructError::VertexCount) if the edges have another number of
    /// vertices than there are points.
    pub fn new(points: &PointSet, edges: EdgeSet) -> Result<Self, ReconstructError> {
        check_vertices(points, &edges)?;
        Ok(Self::of_valid(points, edges))
    }

    fn of_valid(points: &PointSet, edges: EdgeSet) -> Self {
        let orient = |chain: Chain| {
            let flip = chain.is_closed() && is_clockwise(points, chain.vertices());
            if flip { chain.reversed() } else { chain }
        };
        let oriented: Vec<Chain> = edges.chains().into_iter().map(orient).collect();
        let around = Surroundings::new(points, &oriented);
        let nesting = around.nesting();
        let parents = around.parents(&nesting);
        drop(around);
        let chains = oriented
            .into_iter()
            .zip(nesting.into_iter().zip(parents))
            .map(|(chain, (nesting, parent))| NestedChain {
                chain,
                nesting,
                parent,
            })
            .collect();
        Self {
            degrees: edges.degrees(),
            edges,
            chains,
        }
    }

    /// The edges, sorted and unique, with their leaves, isolated vertices and junctions.
    #[must_use]
    pub fn edges(&self) -> &EdgeSet {
        &self.edges
    }

    /// The number of edges at each vertex.
    #[must_use]
    pub fn degrees(&self) -> &[u32] {
        &self.degrees
    }

    /// The vertices of degree 1, ascending.
    #[must_use]
    pub fn leaves(&self) -> Vec<PointId> {
        vertices_with_degree(&self.degrees, |degree| degree == 1)
    }

    /// The vertices without an edge, ascending.
    #[must_use]
    pub fn isolated(&self) -> Vec<PointId> {
        vertices_with_degree(&self.degrees, |degree| degree == 0)
    }

    /// The vertices of degree 3 or more, ascending.
    #[must_use]
    pub fn junctions(&self) -> Vec<PointId> {
        vertices_with_degree(&self.degrees, |degree| degree > 2)
    }

    /// The maximal open chains and the rings, each edge in exactly one of them, in the order of
    /// [`EdgeSet::chains`]: by smallest end or vertex.
    #[must_use]
    pub fn chains(&self) -> &[NestedChain] {
        &self.chains
    }
}

/// The chains: [`Reconstruction::chains`].
impl<'a> IntoIterator for &'a Reconstruction {
    type Item = &'a NestedChain;
    type IntoIter = std::slice::Iter<'a, NestedChain>;

    fn into_iter(self) -> Self::IntoIter {
        self.chains.iter()
    }
}

/// The edges: [`Reconstruction::edges`].
impl AsRef<EdgeSet> for Reconstruction {
    fn as_ref(&self) -> &EdgeSet {
        &self.edges
    }
}

impl From<Reconstruction> for EdgeSet {
    fn from(found: Reconstruction) -> Self {
        found.edges
    }
}

pub(crate) fn check_vertices(points: &PointSet, edges: &EdgeSet) -> Result<(), ReconstructError> {
    let (vertices, count) = (edges.vertex_count(), points.len());
    if vertices != count {
        return Err(ReconstructError::VertexCount { vertices, count });
    }
    Ok(())
}
