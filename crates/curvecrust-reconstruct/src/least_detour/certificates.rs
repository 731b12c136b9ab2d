//! The edges that HNN-Crust and the one-step crust agree on.

use curvecrust_geometry::{DVec2, EdgeSet, PointSet};
use curvecrust_voronoi::{Delaunay, DualEdge};

use super::constants::CERTIFIED_COSINE;
use super::matching::{NONE, add_partners};
use crate::delaunay_edges::is_crust_edge;

/// The edges that HNN-Crust finds: at most two at each point.
pub(super) struct HnnGraph<'a> {
    points: &'a PointSet,
    partners: Vec<[u32; 2]>,
    is_terminus: &'a [bool],
}

impl<'a> HnnGraph<'a> {
    pub(super) fn new(points: &'a PointSet, hnn: &EdgeSet, is_terminus: &'a [bool]) -> Self {
        let mut partners = vec![[NONE; 2]; points.len()];
        for edge in hnn.edges() {
            let [v, w] = edge.ends().map(u32::from);
            add_partners(&mut partners, v, w);
        }
        Self {
            points,
            partners,
            is_terminus,
        }
    }

    /// The certified edges: HNN-Crust and the one-step crust find them, and they continue almost
    /// straight at both ends.
    pub(super) fn certified<'b>(
        &'b self,
        delaunay: &'b Delaunay,
    ) -> impl Iterator<Item = [u32; 2]> + 'b {
        let is_certified = |dual: &DualEdge| {
            let ends = dual.ends.map(u32::from);
            let is_straight =
                |a: DVec2, b: DVec2| -a.dot(b) >= CERTIFIED_COSINE * a.length() * b.length();
            self.neighbours(ends[0]).any(|w| w == ends[1])
                && self.continues_at_both_ends(ends, |v| self.neighbours(v), is_straight)
                && is_crust_edge(self.points, dual)
        };
        let duals = delaunay.edges().filter(move |dual| is_certified(dual));
        duals.map(|dual| dual.ends.map(u32::from))
    }

    /// Whether an edge of a graph continues at both ends: another edge of the graph starts there,
    /// and `is_continuation` accepts the vectors of the two. An edge need not continue at a
    /// terminus.
    pub(super) fn continues_at_both_ends<N: Iterator<Item = u32>>(
        &self,
        ends: [u32; 2],
        neighbours: impl Fn(u32) -> N,
        is_continuation: impl Fn(DVec2, DVec2) -> bool,
    ) -> bool {
        let point = |v: u32| self.points.points()[v as usize];
        let continues = |v: u32, to: u32| {
            let mut others = neighbours(v).filter(|&w| w != to);
            self.is_terminus[v as usize]
                || others.any(|w| is_continuation(point(to) - point(v), point(w) - point(v)))
        };
        let [v, w] = ends;
        continues(v, w) && continues(w, v)
    }

    pub(super) fn neighbours(&self, v: u32) -> impl Iterator<Item = u32> + '_ {
        let partners = self.partners[v as usize].into_iter();
        partners.filter(|&w| w != NONE)
    }
}

/// The edges of the one-step crust at points that certified edges do not saturate.
pub(super) struct CrustGraph {
    /// Each edge once from every such end, ascending.
    edges: Vec<[u32; 2]>,
}

impl CrustGraph {
    pub(super) fn new(
        points: &PointSet,
        delaunay: &Delaunay,
        is_saturated: impl Fn(u32) -> bool,
    ) -> Self {
        let is_left = |v: &u32| !is_saturated(*v);
        let crust = delaunay.edges().filter(|dual| {
            dual.ends.map(u32::from).iter().any(is_left) && is_crust_edge(points, dual)
        });
        let both_ways = crust.flat_map(|dual| {
            let [v, w] = dual.ends.map(u32::from);
            [[v, w], [w, v]]
        });
        let mut edges: Vec<_> = both_ways.filter(|[from, _]| is_left(from)).collect();
        edges.sort_unstable();
        Self { edges }
    }

    /// The other ends of the edges at a point; none if the point is saturated.
    pub(super) fn neighbours(&self, v: u32) -> impl Iterator<Item = u32> + '_ {
        let first = self.edges.partition_point(|&[from, _]| from < v);
        let at_v = self.edges[first..]
            .iter()
            .take_while(move |[from, _]| *from == v);
        at_v.map(|&[_, to]| to)
    }
}
