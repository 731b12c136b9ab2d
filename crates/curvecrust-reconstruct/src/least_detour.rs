//! Least detour: a minimum-cost triangle-free 2-matching of Delaunay edges, with penalties for free
//! ends, improved by Lin-Kernighan moves. Of this project; `docs/method.md` says more.
//!
//! A 2-matching is a set of edges with at most two at each point (Edmonds 1965), and a
//! triangle-free one has no cycle of three edges (D. Hartvigsen, "Extensions of Matching Theory",
//! thesis, Carnegie Mellon University, 1984). A point with fewer than two edges has free ends. The
//! cost of a 2-matching is minus the logarithm of how likely it is, in a model that knows ratios of
//! lengths and turns, but no lengths. It is the sum of
//! - for every **edge** the logarithm of its length, less that of the spacings at its ends,
//! - for every point with two edges its **bend**, which grows with the turn and with the ratio of
//!   the lengths of the two: as their squares where they are small, as their logarithms where they
//!   are large,
//! - the **penalty** of every free end; less at the end of an even run of points, and at an isolated
//!   point to which no curve nearby continues.
//!
//! Sought is the cheapest one. Edges express proximity, bends good continuation, and penalties let a
//! curve end where going on would cost more. The result may be any number of curves, open or closed.
//! Since a bend depends on two edges, this is no linear matching problem, and it is not solved
//! exactly:
//!
//! 1. **Certify.** Where HNN-Crust leaves no free end among points near each other, its edges stay.
//!    Elsewhere edges stay that HNN-Crust and the one-step crust find and that continue almost
//!    straight at both ends. Edges that are much longer than the runs at both of their ends are
//!    gaps, and do not stay.
//! 2. **Complete.** Other edges are added, the shortest first, while both of their points have a
//!    free end and the edge costs less than the penalties of both.
//! 3. **Exchange.** Edges are exchanged along alternating paths of up to twelve added edges (Lin,
//!    Kernighan 1973), as long as that lowers the cost.
//!
//! # What is known
//! - Edges never cross: they are Delaunay.
//! - The true edges are among the candidates for every rho-sample with rho < 1 and every
//!   epsilon-sample with epsilon < 1. Where the bisector of consecutive samples meets the curve
//!   between them, in x, the disc about x through both is smaller than lfs(x), so the curve inside
//!   it is one arc, which holds no other sample: the disc is empty.
//! - Correct wherever HNN-Crust is correct and gives every point two edges, as it does by its
//!   theorems on closed smooth curves, unless an edge is a gap. No sampling condition excludes gaps:
//!   an arc of 320 degrees, closed by a chord, is an epsilon-sample of a circle with epsilon < 0.2.
//!
//! Beyond that nothing is proven, but much is measured: `cargo xtask compare`.
//!
//! Cost: that of the Delaunay triangulation, O(n log n), plus a bounded search for each point that
//! certified edges do not saturate or whose surroundings change.

mod candidates;
mod clusters;
mod completions;
mod constants;
mod exchange;
mod explain;
mod hnn_graph;
mod matching;
mod measure;
mod penalties;

use std::collections::VecDeque;

use curvecrust_geometry::point_set::by_coordinates;
use curvecrust_geometry::{Edge, EdgeSet, PointId, PointSet, in_hilbert_order};
use curvecrust_voronoi::Delaunay;

use crate::algorithm::{AlgorithmInfo, Reconstructor};
use crate::error::ReconstructError;
use crate::explanation::Explanation;
use crate::hnn_crust::HnnCrust;
use crate::known::{self, Known};
use crate::termini;
use candidates::Candidates;
use completions::Completions;
use exchange::{Path, Search, Step};
use hnn_graph::HnnGraph;
use matching::{Matching, NONE};
use measure::Measure;
use penalties::PenaltyModel;

/// The edges of the cheapest triangle-free 2-matching that the search finds.
///
/// ```
/// use curvecrust_geometry::{DVec2, PointSet};
/// use curvecrust_reconstruct::{hnn_crust, least_detour};
///
/// // Two circles that are nearer to each other than their samples are.
/// let circle = |r: f64| {
///     (0..20).map(move |i| r * DVec2::from_angle(f64::from(i) * std::f64::consts::TAU / 20.0))
/// };
/// let points = PointSet::new(circle(3.2).chain(circle(4.0)).collect())?;
/// let rings = least_detour(&points).chains();
/// assert!(rings.len() == 2 && rings.iter().all(|ring| ring.is_closed()));
/// assert!(hnn_crust(&points).chains().len() > 2);
/// # Ok::<(), curvecrust_geometry::PointSetError>(())
/// ```
#[must_use]
pub fn least_detour(points: &PointSet) -> EdgeSet {
    LeastDetour.reconstruct(points)
}

/// Least detour behind the common contract.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct LeastDetour;

impl Reconstructor for LeastDetour {
    fn info(&self) -> AlgorithmInfo {
        AlgorithmInfo {
            name: "least-detour",
            citation: "The curvecrust authors: docs/method.md of this project. 2026",
            guarantees: &[],
            cost: "O(n log n)",
            honours_termini: true,
        }
    }

    fn reconstruct(&self, points: &PointSet) -> EdgeSet {
        Solver::solve(points, &[], |solved| solved.edges())
    }

    /// A terminus has at most one edge.
    fn reconstruct_open(
        &self,
        points: &PointSet,
        termini: &[PointId],
    ) -> Result<EdgeSet, ReconstructError> {
        termini::check(points, termini)?;
        Ok(Solver::solve(points, termini, |solved| solved.edges()))
    }

    /// See [`known`](mod@crate::known) for how.
    fn reconstruct_known(
        &self,
        points: &PointSet,
        known: &Known,
    ) -> Result<EdgeSet, ReconstructError> {
        known::reconstruct(self, points, known)
    }

    /// Edges that it would not have without what is known are there since that is known:
    /// [`Reason::Required`](crate::explanation::Reason::Required). Always `Some`.
    fn explain_known(
        &self,
        points: &PointSet,
        known: &Known,
    ) -> Result<Option<Explanation>, ReconstructError> {
        known::explain(self, points, known)
    }

    /// Always `Some`.
    ///
    /// ```
    /// use curvecrust_geometry::{DVec2, PointSet};
    /// use curvecrust_reconstruct::{LeastDetour, Reason, Reconstructor};
    ///
    /// // A row of five points, and one of three that stops long before the next point.
    /// let lower = (0..5).map(|x| DVec2::new(f64::from(x), 0.0));
    /// let upper = [0.0, 1.0, 2.0, 14.0].map(|x| DVec2::new(x, 9.0));
    /// let points = PointSet::new(lower.chain(upper).collect())?;
    /// let why = LeastDetour.explain(&points, &[])?.unwrap();
    /// assert_eq!(why.edges.len(), 6);
    /// assert_eq!(why.edges[0].reason, Reason::Completed);
    /// assert_eq!(why.edges[1].reason, Reason::Certified);
    /// // Point 8 is an outlier and costs much to join: even the other row would cost less.
    /// let end = why.free_ends.iter().find(|end| end.point == 7.into()).unwrap();
    /// let rejected = end.rejected.unwrap();
    /// assert_eq!(rejected.partner, 4.into());
    /// assert!(rejected.cost > 0.0);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    fn explain(
        &self,
        points: &PointSet,
        termini: &[PointId],
    ) -> Result<Option<Explanation>, ReconstructError> {
        termini::check(points, termini)?;
        Ok(Some(Solver::solve(points, termini, |solved| {
            solved.explanation()
        })))
    }
}

/// What the steps work on: the points in Hilbert order.
struct Solver<'a> {
    points: &'a PointSet,
    /// Their ids in the caller's order.
    ids: &'a [PointId],
    candidates: Candidates,
    completions: Completions,
    matching: Matching<'a>,
    /// The edges that step 2 added.
    completed: EdgeSet,
}

impl<'a> Solver<'a> {
    /// Takes all steps, and returns what `result` makes of them.
    fn solve<R>(points: &PointSet, termini: &[PointId], result: impl FnOnce(Solver<'_>) -> R) -> R {
        let mut is_named = vec![false; points.len()];
        for id in termini {
            is_named[id.index()] = true;
        }
        let (points, ids) = &in_hilbert_order(points);
        let is_terminus: Vec<bool> = ids.iter().map(|id| is_named[id.index()]).collect();
        let termini: Vec<PointId> = points.ids().filter(|v| is_terminus[v.index()]).collect();
        let delaunay = Delaunay::new(points);
        let candidates = Candidates::new(points, &delaunay);
        let hnn = HnnCrust::MUTUAL.with_termini(points, &termini);
        let hnn = HnnGraph::new(points, &candidates, &hnn, &is_terminus);
        let log_spacings = hnn.log_spacings(&candidates);
        let mut matching =
            Matching::new(points.points(), log_spacings.clone(), is_terminus.clone());
        for [v, w] in hnn.certified(&delaunay) {
            matching.certify(v, w);
        }
        let model = PenaltyModel {
            measure: Measure::new(points.points()),
            candidates: &candidates,
            hnn: &hnn,
            log_spacings: &log_spacings,
            matching: &matching,
        };
        let penalties = model.penalties();
        matching.set_penalties(penalties);
        let completions = Completions::new(points.len(), &candidates, &matching);
        let mut solver = Solver {
            points,
            ids,
            candidates,
            completions,
            matching,
            completed: EdgeSet::default(),
        };
        solver.complete();
        solver.exchange();
        result(solver)
    }

    /// The edges in the caller's ids.
    fn edges(&self) -> EdgeSet {
        let edges = self.matching.edges();
        let edges = edges
            .edges()
            .iter()
            .filter_map(|&edge| self.in_callers_ids(edge));
        EdgeSet::new(self.points.len(), edges)
    }

    /// The edge in the caller's ids.
    fn in_callers_ids(&self, edge: Edge) -> Option<Edge> {
        let [a, b] = edge.ends().map(|v| self.ids[v.index()]);
        Edge::new(a, b)
    }

    /// Adds edges between free ends, the shortest first.
    fn complete(&mut self) {
        let points = self.points.points();
        let Self {
            matching,
            candidates,
            ..
        } = self;
        let is_free = |v: u32| matching.has_free_end(v);
        let mut edges: Vec<(f64, [u32; 2])> = Vec::new();
        for v in (0u32..).take(points.len()).filter(|&v| is_free(v)) {
            for &w in candidates.of(v) {
                if v < w && is_free(w) {
                    edges.push((
                        points[v as usize].distance_squared(points[w as usize]),
                        [v, w],
                    ));
                }
            }
        }
        let in_order = |[v, w]: [u32; 2]| {
            let [v, w] = [v, w].map(|id| points[id as usize]);
            if by_coordinates(v, w).is_le() {
                [v, w]
            } else {
                [w, v]
            }
        };
        edges.sort_unstable_by(|(a, e), (b, f)| {
            let ([p, q], [r, s]) = (in_order(*e), in_order(*f));
            a.total_cmp(b)
                .then_with(|| by_coordinates(p, r))
                .then_with(|| by_coordinates(q, s))
        });
        for (_, [v, w]) in edges {
            let are_free = matching.has_free_end(v) && matching.has_free_end(w);
            if are_free
                && !matching.contains(v, w)
                && !matching.would_close_triangle(v, w)
                && matching.edge_cost(v, w) < matching.penalty(v) + matching.penalty(w)
            {
                matching.add(v, w);
            }
        }
        self.completed = self.matching.edges();
    }

    /// Applies exchanges that lower the cost until there is none.
    ///
    /// This ends, since each exchange lowers the cost by more than rounding could feign.
    fn exchange(&mut self) {
        let mut queue: Vec<u32> = (0u32..)
            .take(self.points.len())
            .filter(|&v| !self.matching.is_saturated(v))
            .collect();
        queue.sort_unstable_by(|&v, &w| self.candidates.compare(self.points, v, w));
        let mut queue = VecDeque::from(queue);
        let mut is_queued = vec![false; self.points.len()];
        for &v in &queue {
            is_queued[v as usize] = true;
        }
        while let Some(v) = queue.pop_front() {
            is_queued[v as usize] = false;
            let found = self.search_below(0.0).from(v);
            let Some(exchange) = found.best() else {
                continue;
            };
            for touched in self.apply(&exchange.path) {
                let around = self.matching.partners(touched);
                for near in around.into_iter().chain([touched]) {
                    if near != NONE
                        && !is_queued[near as usize]
                        && !self.matching.is_saturated(near)
                    {
                        is_queued[near as usize] = true;
                        queue.push_back(near);
                    }
                }
            }
        }
    }

    /// A search for exchanges that cost less than `limit`.
    fn search_below(&mut self, limit: f64) -> Search<'_, 'a> {
        Search::below(
            limit,
            &mut self.matching,
            &self.candidates,
            &self.completions,
        )
    }

    /// Takes the steps of a path, and returns the points that it touches, in its order.
    fn apply(&mut self, path: &Path) -> Vec<u32> {
        for step in path.steps() {
            if let Step::Remove(v, w) = *step {
                self.matching.remove(v, w);
            }
        }
        for step in path.steps() {
            if let Step::Add(v, w) = *step {
                self.matching.add(v, w);
            }
        }
        let ends = path.steps().iter().flat_map(|step| match *step {
            Step::Remove(v, w) | Step::Add(v, w) => [v, w],
        });
        ends.collect()
    }
}
