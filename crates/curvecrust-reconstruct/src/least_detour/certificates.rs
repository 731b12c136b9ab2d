//! What HNN-Crust and the one-step crust say of the edges: which are certain.

use curvecrust_geometry::{DVec2, EdgeSet, PointSet};
use curvecrust_voronoi::{Delaunay, DualEdge};

use super::joins::{NONE, put};
use crate::one_step_crust::is_crust_edge;

/// The least cosine of the turn between certain edges: a turn of 49.5 degrees. Consecutive edges of
/// an epsilon-sample turn by 4 asin(epsilon / (2 - 2 epsilon)) at most (SGP 2016, Lemma 9), which is
/// less than that for epsilon < 0.3.
const STRAIGHT: f64 = 0.65;

/// The edges that HNN-Crust finds: at most two at each point.
pub(super) struct Certificates<'a> {
    points: &'a PointSet,
    partners: Vec<[u32; 2]>,
    is_terminus: &'a [bool],
}

impl<'a> Certificates<'a> {
    pub(super) fn new(points: &'a PointSet, hnn: &EdgeSet, is_terminus: &'a [bool]) -> Self {
        let mut partners = vec![[NONE; 2]; points.len()];
        for edge in hnn.edges() {
            let [v, w] = edge.ends().map(u32::from);
            put(&mut partners, v, w);
        }
        Self {
            points,
            partners,
            is_terminus,
        }
    }

    /// The edges that are certain: HNN-Crust and the one-step crust find them, and they go on
    /// almost straight at both ends.
    pub(super) fn certain<'b>(
        &'b self,
        delaunay: &'b Delaunay,
    ) -> impl Iterator<Item = [u32; 2]> + 'b {
        let is_certain = |dual: &DualEdge| {
            let ends = dual.ends.map(u32::from);
            let is_straight = |a: DVec2, b: DVec2| -a.dot(b) >= STRAIGHT * a.length() * b.length();
            self.partners_of(ends[0]).any(|w| w == ends[1])
                && self.goes_on(ends, |v| self.partners_of(v), is_straight)
                && is_crust_edge(self.points, dual)
        };
        let duals = delaunay.edges().filter(move |dual| is_certain(dual));
        duals.map(|dual| dual.ends.map(u32::from))
    }

    /// Whether an edge of a graph goes on at both ends, to another neighbour, by edges that are
    /// `well` together. A terminus has nowhere to go on to.
    pub(super) fn goes_on<N: Iterator<Item = u32>>(
        &self,
        ends: [u32; 2],
        neighbours: impl Fn(u32) -> N,
        well: impl Fn(DVec2, DVec2) -> bool,
    ) -> bool {
        let point = |v: u32| self.points.points()[v as usize];
        let from = |v: u32, to: u32| {
            let mut onward = neighbours(v).filter(|&w| w != to);
            self.is_terminus[v as usize]
                || onward.any(|w| well(point(to) - point(v), point(w) - point(v)))
        };
        let [v, w] = ends;
        from(v, w) && from(w, v)
    }

    /// Those that HNN-Crust joins to the point.
    pub(super) fn partners_of(&self, v: u32) -> impl Iterator<Item = u32> + '_ {
        let partners = self.partners[v as usize].into_iter();
        partners.filter(|&w| w != NONE)
    }
}

/// The edges of the one-step crust at points that are not settled.
pub(super) struct Crust {
    /// Once from every such point, ascending.
    edges: Vec<[u32; 2]>,
}

impl Crust {
    pub(super) fn new(
        points: &PointSet,
        delaunay: &Delaunay,
        is_settled: impl Fn(u32) -> bool,
    ) -> Self {
        let is_left = |v: &u32| !is_settled(*v);
        let wanted = delaunay.edges().filter(|dual| {
            dual.ends.map(u32::from).iter().any(is_left) && is_crust_edge(points, dual)
        });
        let both_ways = wanted.flat_map(|dual| {
            let [v, w] = dual.ends.map(u32::from);
            [[v, w], [w, v]]
        });
        let mut edges: Vec<_> = both_ways.filter(|[from, _]| is_left(from)).collect();
        edges.sort_unstable();
        Self { edges }
    }

    /// Whom it joins to the point; nobody if the point is settled.
    pub(super) fn of(&self, v: u32) -> impl Iterator<Item = u32> + '_ {
        let first = self.edges.partition_point(|&[from, _]| from < v);
        let at_v = self.edges[first..]
            .iter()
            .take_while(move |[from, _]| *from == v);
        at_v.map(|&[_, to]| to)
    }
}
