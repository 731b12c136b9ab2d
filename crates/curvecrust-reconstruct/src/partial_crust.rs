//! What some of the points tell about the Delaunay triangulation and the crust of all.
//!
//! Points are known in a part of the plane alone, and nothing is known about the rest. The crust is
//! that of N. Amenta, M. Bern, D. Eppstein, GMIP 1998 ([`crust`](crate::crust())): of the edges
//! that a disc free of points and of Voronoi vertices touches in both ends.
//!
//! - A circle around a triangle of the known points that lies in the known part is empty of all
//!   points. So its centre is a Voronoi vertex of all, and rules out the discs that hold it.
//! - More points make a Voronoi edge shorter. A disc free of Voronoi vertices has a diameter on the
//!   edge that it stands on, so one that has none on the Voronoi edge of the known points never
//!   will. This rules edges out of which nothing but the neighbourhood is known.
//! - A Voronoi vertex v in a disc about c of radius r through p, which holds no point, has an empty
//!   circle of radius |v p| < 2 r at most. That lies in the disc about c of radius 3 r. If this is
//!   known, so are all points and all Voronoi vertices in the small one.
//!
//! So edges are kept for certain, ruled out for certain, or undecided; and what would have to be
//! known to decide them is a disc. Cost: that of the crust.

use curvecrust_geometry::parallel::*;
use curvecrust_geometry::{PointId, PointSet};
use curvecrust_voronoi::{Delaunay, DualEdge};

pub use crate::disc::Disc;

use crate::delaunay_edges::{has_length, is_crust_edge};
use crate::pencil::Pencil;
use crate::voronoi_vertex::VoronoiVertex;
use crate::voronoi_vertices::VoronoiVertices;

/// An edge that more points may rule out or not.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct UndecidedEdge {
    /// Its ends.
    pub ends: [PointId; 2],
    /// If all points in this disc are known, the edge is decided, or another disc is asked for.
    pub disc: Disc,
}

/// The edges between known points that are not ruled out.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct PartialCrust {
    /// Those of the crust of all points, in no order.
    pub kept: Vec<[PointId; 2]>,
    /// Those that may be of it, in no order.
    pub undecided: Vec<UndecidedEdge>,
}

/// The disc within the circumcircle of a Delaunay triangle, counter-clockwise, rounded outwards.
#[must_use]
pub fn circumdisc(points: &PointSet, triangle: [PointId; 3]) -> Disc {
    VoronoiVertex::new(points, triangle).disc()
}

/// Whether every Delaunay triangulation of the points has an edge of one: its Voronoi edge is
/// longer than a point. The others are diagonals of cocircular points, which depend on the choice.
#[must_use]
pub fn is_in_all(points: &PointSet, dual: &DualEdge) -> bool {
    has_length(points, dual)
}

/// What is known about the crust of all points from some of them.
///
/// The edges are those with an end that `is_asked`. `is_known` tells whether all points in a closed
/// disc are among the given ones; if a disc is known, so have to be those inside of it. With
/// everything asked and known, the crust is `kept`.
///
/// ```
/// use curvecrust_geometry::{DVec2, PointSet};
/// use curvecrust_reconstruct::partial_crust::partial_crust;
/// use curvecrust_voronoi::Delaunay;
///
/// let row = (0..9).map(|i| DVec2::new(f64::from(i), 0.01 * f64::from(i * i)));
/// let points = PointSet::new(row.collect())?;
/// let delaunay = Delaunay::new(&points);
/// let all = partial_crust(&points, &delaunay, |_| true, |_| true);
/// assert_eq!((all.kept.len(), all.undecided.len()), (8, 0));
///
/// // Beyond x = 8.5 there may be more: the last edge is not certain.
/// let some = partial_crust(&points, &delaunay, |_| true, |disc| {
///     disc.from.x + disc.to_centre.x + disc.radius < 8.5
/// });
/// assert_eq!((some.kept.len(), some.undecided.len()), (7, 1));
/// # Ok::<(), curvecrust_geometry::PointSetError>(())
/// ```
#[must_use]
pub fn partial_crust(
    points: &PointSet,
    delaunay: &Delaunay,
    is_asked: impl Fn(PointId) -> bool,
    is_known: impl Fn(&Disc) -> bool + Sync,
) -> PartialCrust {
    let candidates: Vec<DualEdge> = delaunay
        .edges()
        .filter(|dual| dual.ends.iter().any(|&end| is_asked(end)))
        .filter(|dual| is_crust_edge(points, dual))
        .collect();
    let length = |dual: &DualEdge| points[dual.ends[0]].distance(points[dual.ends[1]]);
    let longest = candidates.iter().map(length).fold(0.0, f64::max);
    let is_certain = |vertex: &VoronoiVertex| is_known(&vertex.disc());
    let vertices = VoronoiVertices::among(points, delaunay, longest, &is_certain);
    let judged: Vec<(UndecidedEdge, bool)> = candidates
        .par_iter()
        .filter_map(|dual| {
            let free = vertices.free_discs_through(dual.ends)?;
            let disc = around(&Pencil::new(points, dual.ends), free);
            let edge = UndecidedEdge {
                ends: dual.ends,
                disc,
            };
            Some((edge, is_known(&disc)))
        })
        .collect();
    let mut found = PartialCrust::default();
    for (edge, is_kept) in judged {
        if is_kept {
            found.kept.push(edge.ends);
        } else {
            found.undecided.push(edge);
        }
    }
    found
}

/// The disc that holds the empty circles of all Voronoi vertices in some disc of a range.
///
/// With h half the length of the edge, a disc at the cotangent t has its centre h t from the
/// midpoint and the radius r = h sqrt(1 + t^2), which is convex in t. Three times the larger
/// radius, and the way to the centre of the range, hold the disc of radius 3 r about each of the
/// centres.
fn around(pencil: &Pencil<'_>, [low, high]: [f64; 2]) -> Disc {
    let middle = low / 2.0 + high / 2.0;
    let half = pencil.length() / 2.0;
    let radius = half * libm::hypot(1.0, low.abs().max(high.abs()));
    // More than all rounding errors, those of the discs of Voronoi vertices included.
    let radius = (3.0 * radius + (high - low) * half) * (1.0 + 2f64.powi(-7));
    Disc {
        from: pencil.start(),
        to_centre: pencil.to_centre(middle),
        radius,
    }
}
