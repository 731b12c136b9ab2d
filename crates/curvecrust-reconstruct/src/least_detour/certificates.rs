//! What HNN-Crust says of the edges: which are certain, and how long those around a point may be.

use curvecrust_geometry::{DVec2, EdgeSet, PointSet};
use curvecrust_voronoi::{Delaunay, DualEdge};

use super::candidates::Candidates;
use super::joins::{NONE, detour, put};
use crate::one_step_crust::is_crust_edge;

/// The least cosine of the turn between certain edges: a turn of 49.5 degrees. Consecutive edges of
/// an epsilon-sample turn by 4 asin(epsilon / (2 - 2 epsilon)) at most (SGP 2016, Lemma 9), which is
/// less than that for epsilon < 0.3.
const STRAIGHT: f64 = 0.65;

/// The largest detour between trusted edges, in lengths of the shorter one. Consecutive edges of
/// equal length of a rho-sample turn by 4 asin(rho / 2) at most (SGP 2016, Lemma 8): for rho < 0.9
/// by 107 degrees, a detour of 0.81.
const TRUSTED: f64 = 0.82;

/// A point that is farther from its nearest neighbour than this many times what the points around are
/// from theirs is taken for an outlier: not all of that distance is to be expected.
const OUTLIER: f64 = 2.5;

/// What it costs to leave a slot open, in longest edges that are to be expected there.
const OPEN: f64 = 2.25;

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
            self.go_on(ends, is_straight) && is_crust_edge(self.points, dual)
        };
        let duals = delaunay.edges().filter(move |dual| is_certain(dual));
        duals.map(|dual| dual.ends.map(u32::from))
    }

    /// For every point what it costs to leave one of its slots open.
    ///
    /// That is [`OPEN`] times the length to be expected: the longest distance to a nearest neighbour
    /// of the two closest candidates and, if it is no outlier, of the point itself; or of an edge at
    /// the point that may be long, since HNN-Crust finds it and the turns at its ends are those of a
    /// rho-sample.
    pub(super) fn prices(&self, candidates: &Candidates) -> Vec<f64> {
        let points = self.points.points();
        let distance = |v: u32, w: u32| points[v as usize].distance(points[w as usize]);
        let to_nearest = |v: u32| candidates.of(v).first().map_or(0.0, |&w| distance(v, w));
        let is_trusted =
            |a: DVec2, b: DVec2| detour(DVec2::ZERO, a, b) <= TRUSTED * a.length().min(b.length());
        let expected = |(v, partners): (u32, &[u32; 2])| {
            let closest = candidates.of(v).iter().take(2);
            let around = closest.map(|&w| to_nearest(w)).fold(0.0, f64::max);
            let own = to_nearest(v).min(OUTLIER * around);
            let trusted = partners.iter().filter(|&&w| self.go_on([v, w], is_trusted));
            let lengths = trusted.map(|&w| distance(v, w));
            lengths.fold(around.max(own), f64::max)
        };
        let all = (0u32..).zip(&self.partners);
        all.map(|at| OPEN * expected(at)).collect()
    }

    /// Whether two points are joined and both go on to another, by edges that are `well` together.
    /// A terminus has nowhere to go on to.
    fn go_on(&self, ends: [u32; 2], well: impl Fn(DVec2, DVec2) -> bool) -> bool {
        let point = |v: u32| self.points.points()[v as usize];
        let goes_on = |v: u32, from: u32| match self.partners[v as usize] {
            [p, q] if p == from || q == from => {
                let onward = if p == from { q } else { p };
                if onward == NONE {
                    self.is_terminus[v as usize]
                } else {
                    well(point(from) - point(v), point(onward) - point(v))
                }
            }
            _ => false,
        };
        let [v, w] = ends;
        v != NONE && w != NONE && goes_on(v, w) && goes_on(w, v)
    }
}
