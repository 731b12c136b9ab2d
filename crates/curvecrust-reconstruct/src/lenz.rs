//! Lenz-like: after T. Lenz, "How to Sample and Reconstruct Curves with Unusual Features", European
//! Workshop on Computational Geometry (EuroCG), 2006. Its text was not available: this is a sketch
//! of its idea.
//!
//! Two samples that are nearest to each other are a seed. From the shortest seed on, each grows at
//! both of its ends: a probe lies in the direction of the last edge, within 60 degrees of it and as
//! far as 2.4 times its length. The nearest sample in the probe is joined. The curve stops where
//! the probe is empty, and where it meets an edge that is there already.
//!
//! A sample may be passed more than once, so curves may cross, and edges may: this is the only
//! algorithm here whose edges are not among those of the Delaunay triangulation. No sampling
//! condition is known to make it exact. Cost: O(n log n) for a search around each edge, where few
//! samples are in a probe.

use curvecrust_geometry::point_set::by_coordinates;
use curvecrust_geometry::{DVec2, Edge, EdgeSet, PointId, PointSet};
use rstar::RTree;
use rstar::primitives::GeomWithData;

use crate::algorithm::{AlgorithmInfo, Basis, Reconstructor, Scope};
use crate::neighbours::{HalfRule, neighbours};

/// The cosine of 60 degrees, half the angle of a probe.
const HALF_ANGLE: f64 = 0.5;

/// The length of a probe, in lengths of the last edge.
const LENGTH: f64 = 2.4;

/// The edges of the Lenz-like algorithm; several curves may pass a sample.
///
/// ```
/// use curvecrust_geometry::{DVec2, PointSet};
/// use curvecrust_reconstruct::lenz;
///
/// // Two rows that cross in a sample of both.
/// let row = |by: DVec2| (-10..=10).map(move |i| by * f64::from(i));
/// let cross = row(DVec2::X).chain(row(DVec2::Y).filter(|&p| p != DVec2::ZERO));
/// let edges = lenz(&PointSet::new(cross.collect())?);
/// assert_eq!((edges.len(), edges.junctions()), (40, vec![10.into()]));
/// # Ok::<(), curvecrust_geometry::PointSetError>(())
/// ```
#[must_use]
pub fn lenz(points: &PointSet) -> EdgeSet {
    let (points, ids) = &points.in_hilbert_order();
    let mut growth = Growth::new(points);
    for seed in seeds(points) {
        if !growth.holds(seed) {
            growth.grow(seed);
        }
    }
    let pairs = points.ids().zip(&growth.partners);
    let edges = pairs.flat_map(|(p, partners)| {
        let named = move |&q: &PointId| Edge::new(ids[p.index()], ids[q.index()]);
        partners.iter().filter_map(named)
    });
    EdgeSet::new(points.len(), edges)
}

/// Pairs of samples that are nearest to each other, the closest first.
fn seeds(points: &PointSet) -> Vec<[PointId; 2]> {
    let nearest: Vec<Option<PointId>> = neighbours(points, HalfRule::Bisector)
        .iter()
        .map(|found| found.nearest)
        .collect();
    let pairs = points.ids().filter_map(|p| {
        let q = nearest[p.index()]?;
        let [first, second] = in_place(points, [p, q]);
        (nearest[q.index()] == Some(p) && p == first).then_some([first, second])
    });
    let mut seeds: Vec<[PointId; 2]> = pairs.collect();
    let squared = |[p, q]: [PointId; 2]| points[p].distance_squared(points[q]);
    seeds.sort_unstable_by(|&e, &f| {
        let by_place = by_coordinates(points[e[0]], points[f[0]]);
        squared(e).total_cmp(&squared(f)).then(by_place)
    });
    seeds
}

/// The pair, the one first that comes first by coordinates.
fn in_place(points: &PointSet, [p, q]: [PointId; 2]) -> [PointId; 2] {
    if by_coordinates(points[p], points[q]).is_le() {
        [p, q]
    } else {
        [q, p]
    }
}

struct Growth<'a> {
    points: &'a PointSet,
    /// Every place with its index.
    tree: RTree<GeomWithData<[f64; 2], usize>>,
    /// Of every point those that it is joined with.
    partners: Vec<Vec<PointId>>,
}

impl<'a> Growth<'a> {
    fn new(points: &'a PointSet) -> Self {
        let place = |id: PointId| GeomWithData::new(points[id].to_array(), id.index());
        Self {
            points,
            tree: RTree::bulk_load(points.ids().map(place).collect()),
            partners: vec![Vec::new(); points.len()],
        }
    }

    fn holds(&self, [p, q]: [PointId; 2]) -> bool {
        self.partners[p.index()].contains(&q)
    }

    fn add(&mut self, [p, q]: [PointId; 2]) {
        if !self.holds([p, q]) {
            self.partners[p.index()].push(q);
            self.partners[q.index()].push(p);
        }
    }

    /// A curve from its seed on, an edge further at both ends by turns: neither end is the first,
    /// so a turn of the points changes nothing.
    fn grow(&mut self, [p, q]: [PointId; 2]) {
        let mut ends = vec![[p, q], [q, p]];
        while !ends.is_empty() {
            for &end in &ends {
                self.add(end);
            }
            let next = |&last: &[PointId; 2]| Some([last[1], self.probed(last)?]);
            ends = ends
                .iter()
                .filter_map(next)
                .filter(|&end| !self.holds(end))
                .collect();
        }
    }

    /// The nearest sample in the probe of an edge; the first by coordinates of equally near ones.
    fn probed(&self, [from, at]: [PointId; 2]) -> Option<PointId> {
        let place = self.points[at];
        let last = place - self.points[from];
        let most = (LENGTH * LENGTH) * last.length_squared();
        let mut best: Option<(f64, PointId)> = None;
        for near in self.tree.nearest_neighbor_iter(place.into()) {
            let step = DVec2::from(*near.geom()) - place;
            let squared = step.length_squared();
            if squared > best.map_or(most, |(nearest, _)| nearest) {
                break;
            }
            let is_ahead = last.dot(step) >= HALF_ANGLE * last.length() * step.length();
            let to = self.points.points()[near.data];
            let comes_first =
                best.is_none_or(|(_, other)| by_coordinates(to, self.points[other]).is_lt());
            if near.data != at.index() && is_ahead && comes_first {
                best = PointId::new(near.data).map(|id| (squared, id));
            }
        }
        best.map(|(_, id)| id)
    }
}

/// The Lenz-like algorithm behind the common contract.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Lenz;

impl Reconstructor for Lenz {
    fn info(&self) -> AlgorithmInfo {
        AlgorithmInfo {
            basis: Basis::Argued,
            scope: Scope {
                crossings: true,
                ..Scope::CLOSED_AND_OPEN
            },
            ..AlgorithmInfo::new(
                "lenz-like",
                "after Lenz: How to Sample and Reconstruct Curves with Unusual Features. \
                 EuroCG 2006",
                "O(n log n)",
            )
        }
    }

    fn reconstruct(&self, points: &PointSet) -> EdgeSet {
        lenz(points)
    }
}
