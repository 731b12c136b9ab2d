//! Whether Voronoi vertices leave room for a disc that touches two samples.

use std::sync::OnceLock;

use curvecrust_geometry::{DVec2, PointId, PointSet};
use curvecrust_voronoi::Delaunay;
use rayon::prelude::*;
use rstar::RTree;
use rstar::primitives::GeomWithData;

use crate::pencil::{Cut, Effect, Pencil};
use crate::voronoi_vertex::VoronoiVertex;

/// The rounded place of a Voronoi vertex, and its index.
type Tree = RTree<GeomWithData<[f64; 2], usize>>;

/// The Voronoi vertices of a point set, ready for searches.
pub(crate) struct VoronoiVertices<'a> {
    points: &'a PointSet,
    /// A point of the set, from which the trees see all others: far from 0 there are no digits left.
    origin: DVec2,
    vertices: Vec<VoronoiVertex>,
    /// Those nearer to samples than the length of the longest edge to be asked about: where
    /// samples are dense these are few, and no other lies in the smallest disc of an edge.
    near: Tree,
    /// All others, indexed if the smallest disc of some edge is not free.
    far: OnceLock<Tree>,
    reach: f64,
}

impl<'a> VoronoiVertices<'a> {
    /// For questions about edges up to a length.
    pub(crate) fn new(points: &'a PointSet, delaunay: &Delaunay, longest: f64) -> Self {
        let triangles: Vec<[PointId; 3]> = delaunay.triangles().collect();
        let vertices: Vec<VoronoiVertex> = triangles
            .par_iter()
            .map(|&triangle| VoronoiVertex::new(points, triangle))
            .collect();
        // A little more, for rounding.
        let reach = longest * (1.0 + 2f64.powi(-10));
        let origin = points.points().first().copied().unwrap_or_default();
        Self {
            points,
            origin,
            near: tree_of(&vertices, origin, |v| v.radius() <= reach),
            vertices,
            far: OnceLock::new(),
            reach,
        }
    }

    /// Whether some disc with both samples on its boundary has no Voronoi vertex inside, exactly.
    ///
    /// Tries one disc after the other. Vertices inside narrow the range of discs that may still be
    /// free; the next disc is taken from the middle of what is left, so that the range at least
    /// halves, until a disc is free or the ends of the range are too close to tell apart.
    pub(crate) fn spare_a_disc_through(&self, ends: [PointId; 2]) -> bool {
        let pencil = Pencil::new(self.points, ends);
        if self.in_disc(&self.near, &pencil, 0.0).next().is_none() {
            return true;
        }
        let mut range = Range::default();
        while let Some(tried) = range.probe() {
            for vertex in self.inside(&pencil, tried) {
                range.apply(&pencil, vertex);
                if range.surely_excludes(tried) {
                    break;
                }
            }
            if range.surely_contains(tried) {
                return true;
            }
            if range.is_empty(&pencil) {
                return false;
            }
        }
        // What is outside of the discs at both ends of a range is outside of all discs between.
        for end in range.outer_ends() {
            for vertex in self.inside(&pencil, end) {
                range.apply(&pencil, vertex);
            }
        }
        !range.is_empty(&pencil)
    }

    /// All vertices in a disc and perhaps a few around it.
    fn inside(&self, pencil: &Pencil<'_>, cotangent: f64) -> impl Iterator<Item = &VoronoiVertex> {
        let far = self
            .far
            .get_or_init(|| tree_of(&self.vertices, self.origin, |v| v.radius() > self.reach));
        let near = self.in_disc(&self.near, pencil, cotangent);
        near.chain(self.in_disc(far, pencil, cotangent))
    }

    fn in_disc<'t>(
        &'t self,
        tree: &'t Tree,
        pencil: &Pencil<'_>,
        cotangent: f64,
    ) -> impl Iterator<Item = &'t VoronoiVertex> {
        let disc = pencil.disc(cotangent, self.origin);
        // A disc too large for a tree holds them all.
        let all = disc.is_none().then(|| tree.iter());
        let within = disc.map(|(centre, reach_squared)| {
            tree.locate_within_distance(centre.into(), reach_squared)
        });
        let found = within
            .into_iter()
            .flatten()
            .chain(all.into_iter().flatten());
        found.map(|item| &self.vertices[item.data])
    }
}

fn tree_of(
    vertices: &[VoronoiVertex],
    origin: DVec2,
    wanted: impl Fn(&VoronoiVertex) -> bool,
) -> Tree {
    let wanted = vertices.iter().enumerate().filter(|(_, v)| wanted(v));
    let items = wanted.map(|(index, v)| GeomWithData::new(v.position(origin).into(), index));
    RTree::bulk_load(items.collect())
}

/// The discs of a pencil that no vertex has ruled out, by their cotangents: from `low` to `high`,
/// both included.
#[derive(Default)]
struct Range<'a> {
    low: Option<Cut<'a>>,
    high: Option<Cut<'a>>,
    is_blocked: bool,
}

impl<'a> Range<'a> {
    /// Rules out the discs that hold the vertex.
    fn apply(&mut self, pencil: &Pencil<'_>, vertex: &'a VoronoiVertex) {
        match pencil.effect(vertex) {
            Effect::Above(cut) => {
                if self
                    .high
                    .is_none_or(|high| pencil.compare(&cut, &high).is_lt())
                {
                    self.high = Some(cut);
                }
            }
            Effect::Below(cut) => {
                if self
                    .low
                    .is_none_or(|low| pencil.compare(&cut, &low).is_gt())
                {
                    self.low = Some(cut);
                }
            }
            Effect::Everywhere => self.is_blocked = true,
            Effect::Nowhere => {}
        }
    }

    fn is_empty(&self, pencil: &Pencil<'_>) -> bool {
        let crossed = match (&self.low, &self.high) {
            (Some(low), Some(high)) => pencil.compare(low, high).is_gt(),
            _ => false,
        };
        self.is_blocked || crossed
    }

    fn surely_contains(&self, cotangent: f64) -> bool {
        let (low, high) = self.sure_ends();
        !self.is_blocked && low <= cotangent && cotangent <= high
    }

    fn surely_excludes(&self, cotangent: f64) -> bool {
        self.is_blocked
            || self.low.is_some_and(|low| cotangent < low.least)
            || self.high.is_some_and(|high| cotangent > high.most)
    }

    /// A cotangent surely in the range: of the smallest disc if it may be, else one in the middle,
    /// so that the range shrinks fast. `None` if the ends of the range are too close.
    fn probe(&self) -> Option<f64> {
        let (low, high) = self.sure_ends();
        let probe = if low <= 0.0 && 0.0 <= high {
            0.0
        } else if high.is_infinite() {
            2.0 * low + 1.0
        } else if low.is_infinite() {
            2.0 * high - 1.0
        } else {
            low / 2.0 + high / 2.0
        };
        (probe.is_finite() && low <= probe && probe <= high).then_some(probe)
    }

    /// The ends of the range without their rounding errors.
    fn sure_ends(&self) -> (f64, f64) {
        (
            self.low.map_or(f64::NEG_INFINITY, |low| low.most),
            self.high.map_or(f64::INFINITY, |high| high.least),
        )
    }

    /// The ends of the range with their rounding errors.
    fn outer_ends(&self) -> [f64; 2] {
        [
            self.low.map_or(f64::NEG_INFINITY, |low| low.least),
            self.high.map_or(f64::INFINITY, |high| high.most),
        ]
    }
}
