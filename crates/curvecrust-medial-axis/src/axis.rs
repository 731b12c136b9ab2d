//! The medial axis, from the Voronoi diagram.
//!
//! N. Amenta, M. Bern, D. Eppstein, *The Crust and the β-Skeleton*, GMIP 1998: the Voronoi diagram
//! of dense points on curves approximates their medial axis. A Voronoi edge between the cells of
//! consecutive points of one curve crosses the curve there; every other one belongs to the axis.
//! For dense points of a smooth curve, the only Voronoi vertices near the curve's own bends are
//! circumcentres of consecutive points, which are its centres of curvature.
//!
//! Cost: that of the Delaunay triangulation, O(n log n).

use curvecrust_curve::DenseCurve;
use curvecrust_geometry::{DVec2, PointSet, PointSetError, Segment, Similarity};
use curvecrust_voronoi::Delaunay;

use crate::crossing;
use crate::error::MedialAxisError;

/// How far from the unit box a piece of the axis is none.
const BEYOND: f64 = 1e6;

/// The approximate medial axis of a dense curve: the closure of the points of the plane with two or
/// more closest dense points, other than those of consecutive ones.
///
/// Empty for a lone straight segment, whose lfs is infinite. A piece farther away than a million
/// times the extent of the curve does not count: there, rounding decides between arcs and lines.
#[derive(Clone, Debug)]
pub struct MedialAxis {
    /// Computed in the unit box, where Voronoi vertices lose the fewest digits.
    to_unit: Similarity,
    edges: Vec<AxisEdge>,
}

/// A piece of the medial axis.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct AxisEdge {
    /// The piece: a Voronoi edge; an unbounded one is cut so far outside that the distance of no
    /// dense point to it changes.
    pub segment: Segment,
    /// Indices of the two dense points it is equidistant from.
    pub sites: [usize; 2],
}

impl MedialAxis {
    /// The medial axis of a dense curve.
    ///
    /// # Errors
    /// [`Crossing`](MedialAxisError::Crossing), [`Touching`](MedialAxisError::Touching) or
    /// [`TooCoarse`](MedialAxisError::TooCoarse), where two consecutive points are not joined by a
    /// Delaunay edge: another part of the curve lies between them (Amenta, Bern, Eppstein, Theorem
    /// 12: the polygon of an epsilon-sample with epsilon < 1 is Delaunay).
    pub fn new(dense: &DenseCurve) -> Result<Self, MedialAxisError> {
        let (axis, spanning) = Self::with_spanning_gaps(dense)?;
        match spanning.first() {
            None => Ok(axis),
            Some(&gap) => Err(crossing::find(dense, &spanning)
                .unwrap_or_else(|| MedialAxisError::too_coarse(crossing::chord(dense, gap)))),
        }
    }

    /// The axis, and the gaps (by their first point) that another part of the curve spans: where
    /// there are any, the axis is not to be trusted.
    pub(crate) fn with_spanning_gaps(
        dense: &DenseCurve,
    ) -> Result<(Self, Vec<usize>), MedialAxisError> {
        let to_unit = Similarity::to_unit_box(dense.points().iter().copied());
        let unit_points = dense.points().iter().map(|&p| to_unit.apply(p)).collect();
        let points = PointSet::new(unit_points).map_err(|error| unusable(dense, &error))?;

        let mut joined: Vec<bool> = (0..dense.len()).map(|i| dense.next(i).is_none()).collect();
        let mut edges = Vec::with_capacity(2 * dense.len());
        let delaunay = Delaunay::new(&points);
        for dual in delaunay.edges() {
            let [i, j] = dual.ends.map(|id| id.index());
            let (forwards, backwards) = (dense.next(i) == Some(j), dense.next(j) == Some(i));
            if forwards {
                joined[i] = true;
            }
            if backwards {
                joined[j] = true;
            }
            if forwards || backwards {
                continue;
            }
            let sites = [points.points()[i], points.points()[j]];
            let segment = bounded(delaunay.voronoi_edge(&dual), sites);
            if segment.distance(DVec2::splat(0.5)) < BEYOND {
                let sites = [i, j];
                edges.push(AxisEdge { segment, sites });
            }
        }
        let spanning = (0..dense.len()).filter(|&i| !joined[i]).collect();
        Ok((Self { to_unit, edges }, spanning))
    }

    /// Whether the axis is empty: the curve is one straight segment.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.edges.is_empty()
    }

    /// The number of edges.
    #[must_use]
    pub fn len(&self) -> usize {
        self.edges.len()
    }

    /// The pieces, in the coordinates of the curve; their order has no meaning.
    pub fn edges(&self) -> impl ExactSizeIterator<Item = AxisEdge> + '_ {
        self.edges.iter().map(|edge| AxisEdge {
            segment: Segment::new(
                self.to_unit.invert(edge.segment.a),
                self.to_unit.invert(edge.segment.b),
            ),
            sites: edge.sites,
        })
    }

    /// Adds points that are known to belong to the axis, each with the dense point it is nearest
    /// to.
    pub(crate) fn extend(&mut self, points: impl IntoIterator<Item = (usize, DVec2)>) {
        let to_unit = self.to_unit;
        let near = points
            .into_iter()
            .map(|(site, point)| (site, to_unit.apply(point)))
            .filter(|(_, point)| point.distance(DVec2::splat(0.5)) < BEYOND);
        self.edges.extend(near.map(|(site, point)| AxisEdge {
            segment: Segment::new(point, point),
            sites: [site, site],
        }));
    }

    /// The transform to the unit box, and the pieces there.
    pub(crate) fn in_unit_box(&self) -> (Similarity, &[AxisEdge]) {
        (self.to_unit, &self.edges)
    }
}

/// The Voronoi edge as a segment, for sites in the unit box: no point of the box has its closest
/// point on an unbounded edge beyond the cut.
fn bounded(voronoi_edge: [Option<DVec2>; 2], [a, b]: [DVec2; 2]) -> Segment {
    let left = (b - a).perp().normalize_or_zero();
    let middle = a.midpoint(b);
    // The closest point of a ray to a point p of the box is no farther from p than its start is.
    let beyond = |start: DVec2, direction: DVec2| start + direction * (2.0 * start.length() + 4.0);
    match voronoi_edge {
        [Some(l), Some(r)] => Segment::new(l, r),
        [Some(l), None] => Segment::new(l, beyond(l, -left)),
        [None, Some(r)] => Segment::new(beyond(r, left), r),
        [None, None] => Segment::new(beyond(middle, left), beyond(middle, -left)),
    }
}

/// Why the dense points are no point set: the door of [`DenseCurve`] leaves equal points only.
fn unusable(dense: &DenseCurve, error: &PointSetError) -> MedialAxisError {
    let index = match *error {
        PointSetError::Duplicate { second, .. } => second,
        PointSetError::NotFinite { index, .. } | PointSetError::Magnitude { index, .. } => index,
        _ => 0,
    };
    MedialAxisError::Touching {
        at: dense.points().get(index).copied().unwrap_or_default(),
        distance: 0.0,
    }
}
