//! Conservative Crust: T. K. Dey, K. Mehlhorn, E. A. Ramos, "Curve Reconstruction: Connecting Dots
//! with Good Reason", Symposium on Computational Geometry (SoCG), 1999. Its goal is published; the
//! order of its steps is argued here, since the text was not available.
//!
//! It is for any points: it gives edges together with a smooth curve, perhaps an open one, that
//! justifies them. The Gabriel edges are the first candidates. An edge e goes if the disc about its
//! midpoint of radius rho |e| / 2 holds a Voronoi vertex, or a leaf that is no end of e: all such
//! edges together, and again with the leaves that are new, until none goes. A larger rho gives
//! fewer edges.
//!
//! With rho = 1, the default, the disc is the one that the edge is a diameter of. It holds no
//! sample then, so only Voronoi vertices remove edges.
//!
//! Right for closed curves that are sampled densely; open ones get no edge between their ends.
//! Cost: that of the Delaunay triangulation, O(n log n), and a search around each edge; for rho
//! above 1, in every round.

use curvecrust_geometry::{DVec2, Edge, EdgeSet, PointId, PointSet};
use curvecrust_voronoi::Delaunay;
use num_bigint::BigInt;
use rstar::RTree;
use rstar::primitives::GeomWithData;

use crate::algorithm::{AlgorithmInfo, Basis, Reconstructor, Scope};
use crate::delaunay_edges::is_gabriel_edge;
use crate::error::ReconstructError;
use crate::exact::{Vector, dot, integers, sub};
use crate::parameter::parameter;
use crate::pencil::circumcentre;
use crate::voronoi_vertex::VoronoiVertex;
use crate::voronoi_vertices::VoronoiVertices;

/// Half a unit in the last place of 1: the relative error of one operation.
const U: f64 = f64::EPSILON / 2.0;

/// The parameter of Conservative Crust: finite and at least 1.
///
/// ```
/// use curvecrust_reconstruct::ConservativeRho;
///
/// assert_eq!(ConservativeRho::new(1.0)?, ConservativeRho::LEAST);
/// assert!(ConservativeRho::new(0.9).is_err());
/// # Ok::<(), curvecrust_reconstruct::ReconstructError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
pub struct ConservativeRho(f64);

impl ConservativeRho {
    /// 1: the disc that an edge is a diameter of.
    pub const LEAST: Self = Self(1.0);

    /// Checks a parameter.
    ///
    /// # Errors
    /// [`ConservativeRho`](ReconstructError::ConservativeRho) if it is below 1, infinite or not a
    /// number.
    pub fn new(rho: f64) -> Result<Self, ReconstructError> {
        if rho >= 1.0 && rho.is_finite() {
            Ok(Self(rho))
        } else {
            Err(ReconstructError::ConservativeRho { rho })
        }
    }
}

parameter!(ConservativeRho);

/// The edges of Conservative Crust, exactly; what lies on the boundary of a disc is outside.
///
/// ```
/// use curvecrust_geometry::{DVec2, PointSet};
/// use curvecrust_reconstruct::{ConservativeRho, conservative_crust};
///
/// // Three quarters of a circle: no edge joins the ends.
/// let arc = (0..=30).map(|i| DVec2::from_angle(f64::from(i) * 1.5 * std::f64::consts::PI / 30.0));
/// let points = PointSet::new(arc.collect())?;
/// assert_eq!(conservative_crust(&points, ConservativeRho::LEAST).len(), 30);
/// # Ok::<(), curvecrust_geometry::PointSetError>(())
/// ```
#[must_use]
pub fn conservative_crust(points: &PointSet, rho: ConservativeRho) -> EdgeSet {
    let (points, ids) = &points.in_hilbert_order();
    let delaunay = Delaunay::new(points);
    let gabriel: Vec<Disc> = delaunay
        .edges()
        .filter(|dual| is_gabriel_edge(points, dual))
        .map(|dual| Disc::new(points, dual.ends, rho.0))
        .collect();
    let longest = gabriel.iter().map(|disc| disc.across.length());
    let longest = longest.fold(0.0, f64::max);
    // What lies in a disc is no farther from a sample than its radius and half the edge.
    let reach = longest * (rho.0 + 1.0) * std::f64::consts::FRAC_1_SQRT_2;
    let vertices = VoronoiVertices::new(points, &delaunay, reach);
    let is_free = |disc: &Disc| {
        !vertices.any_near(&|origin| disc.seen_from(origin), |vertex| {
            disc.holds_vertex(points, vertex)
        })
    };
    let mut kept: Vec<Disc> = gabriel.into_iter().filter(is_free).collect();
    if rho > ConservativeRho::LEAST {
        while remove_beside_leaves(points, &mut kept) {}
    }
    let edge = |disc: &Disc| {
        let [p, q] = disc.ends.map(|v| ids[v.index()]);
        Edge::new(p, q)
    };
    EdgeSet::new(points.len(), kept.iter().filter_map(edge))
}

/// Removes the edges whose disc holds a leaf that is not their end; whether there were any.
fn remove_beside_leaves(points: &PointSet, kept: &mut Vec<Disc>) -> bool {
    let edges = kept
        .iter()
        .filter_map(|disc| Edge::new(disc.ends[0], disc.ends[1]));
    let leaves = EdgeSet::new(points.len(), edges).leaves();
    let place = |leaf: &PointId| GeomWithData::new(points[*leaf].to_array(), leaf.index());
    let leaves = RTree::bulk_load(leaves.iter().map(place).collect());
    let is_free = |disc: &Disc| {
        let is_held = |leaf: &GeomWithData<[f64; 2], usize>| {
            PointId::new(leaf.data).is_some_and(|leaf| disc.holds_leaf(points, leaf))
        };
        let Some((centre, squared)) = disc.seen_from(DVec2::ZERO) else {
            return !leaves.iter().any(is_held);
        };
        let mut near = leaves.locate_within_distance(centre.into(), squared);
        !near.any(is_held)
    };
    let before = kept.len();
    kept.retain(is_free);
    kept.len() < before
}

/// The disc about the midpoint of an edge.
struct Disc {
    ends: [PointId; 2],
    p: DVec2,
    /// From the first end to the second.
    across: DVec2,
    rho: f64,
}

impl Disc {
    fn new(points: &PointSet, ends: [PointId; 2], rho: f64) -> Self {
        let [p, q] = ends.map(|id| points[id]);
        Self {
            ends,
            p,
            across: q - p,
            rho,
        }
    }

    fn radius(&self) -> f64 {
        self.rho * self.across.length() / 2.0
    }

    /// Its centre as seen from an origin, and its squared radius, a little too large.
    fn seen_from(&self, origin: DVec2) -> Option<(DVec2, f64)> {
        let centre = (self.p - origin) + self.across / 2.0;
        // A vertex errs by 2^-20 of its distance to a sample.
        let radius = self.radius() * (1.0 + 2f64.powi(-17)) + 64.0 * U * centre.length();
        let squared = radius * radius;
        squared.is_finite().then_some((centre, squared))
    }

    /// Whether a place at a distance to the midpoint is inside, if its error leaves no doubt.
    fn holds_at(&self, distance: f64, error: f64) -> Option<bool> {
        let doubt = error + 16.0 * U * (distance + self.radius());
        let margin = self.radius() - distance;
        // Not so if anything is infinite or NaN, too.
        (margin.abs() > doubt).then_some(margin > 0.0)
    }

    fn holds_vertex(&self, points: &PointSet, vertex: &VoronoiVertex) -> bool {
        let seen = vertex.seen_from(self.p);
        let distance = (seen.vector - self.across / 2.0).length();
        let error = seen.error + 4.0 * U * self.across.length();
        self.holds_at(distance, error).unwrap_or_else(|| {
            let ([p, q], [a, b, c]) = (self.ends, vertex.corners);
            let ([p, q, a, b, c], _) = integers([p, q, a, b, c].map(|id| points[id]));
            let (place, weight) = circumcentre([&p, &a, &b, &c]);
            self.holds_exactly([place, sub(&q, &p)], &weight)
        })
    }

    fn holds_leaf(&self, points: &PointSet, leaf: PointId) -> bool {
        if self.ends.contains(&leaf) {
            return false;
        }
        let distance = (points[leaf] - self.p - self.across / 2.0).length();
        let error = 8.0 * U * (points[leaf] - self.p).length();
        self.holds_at(distance, error).unwrap_or_else(|| {
            let [p, q] = self.ends;
            let ([p, q, leaf], _) = integers([p, q, leaf].map(|id| points[id]));
            self.holds_exactly([sub(&leaf, &p), sub(&q, &p)], &BigInt::from(1))
        })
    }

    /// Whether `place / weight` is inside, seen from the first end; as `across` is.
    fn holds_exactly(&self, [place, across]: [Vector; 2], weight: &BigInt) -> bool {
        // rho = numerator / denominator
        let ([[numerator, denominator]], _) = integers([DVec2::new(self.rho, 1.0)]);
        let across = across.map(|x| x * weight);
        let twice_to_middle = [0, 1].map(|i| &place[i] + &place[i] - &across[i]);
        let distance = dot(&twice_to_middle, &twice_to_middle) * &denominator * &denominator;
        distance < dot(&across, &across) * &numerator * &numerator
    }
}

/// Conservative Crust behind the common contract.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ConservativeCrust {
    /// Its parameter.
    pub rho: ConservativeRho,
}

impl ConservativeCrust {
    /// The one that keeps the most edges.
    pub const LEAST: Self = Self {
        rho: ConservativeRho::LEAST,
    };
}

impl Reconstructor for ConservativeCrust {
    fn info(&self) -> AlgorithmInfo {
        AlgorithmInfo {
            basis: Basis::Argued,
            scope: Scope::CLOSED_AND_OPEN,
            ..AlgorithmInfo::new(
                "conservative-crust",
                "Dey, Mehlhorn, Ramos: Curve Reconstruction: Connecting Dots with Good Reason. \
                 SoCG 1999",
                "O(n log n)",
            )
        }
    }

    fn reconstruct(&self, points: &PointSet) -> EdgeSet {
        conservative_crust(points, self.rho)
    }
}
