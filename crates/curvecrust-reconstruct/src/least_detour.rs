//! Least detour: the curve that goes from point to point with the shortest edges and the smallest
//! detours. Of this project.
//!
//! Every point has two slots for partners. A set of edges costs the sum of
//! - their lengths,
//! - the **detour** at every point v with partners p and q, |vp| + |vq| - |pq|: nothing where the
//!   curve goes straight on, twice the shorter edge where it turns back,
//! - a **price** for every slot that stays open, 2.25 times the length of edge that is to be expected
//!   there; less where an even run of points stops, and at a point that no other would go on to.
//!
//! Sought is the cheapest set of Delaunay edges without triangles. Lengths prefer neighbours, detours
//! prefer to go on (good continuation, as perception does), and prices let a curve end
//! where going on would cost more. No demand is made that there be one curve or that it be closed.
//!
//! 1. **Certify.** Edges that HNN-Crust and the one-step crust find, and that go on almost straight at
//!    both ends, stay.
//! 2. **Complete.** Other edges are added, the shortest first, while both ends have an open slot and
//!    the edge is shorter than the prices of both.
//! 3. **Exchange.** Edges are exchanged along alternating paths of up to twelve joins, as long as
//!    that lowers the cost.
//!
//! # What is known
//! - Edges never cross: they are Delaunay.
//! - The true edges are among the candidates for every rho-sample with rho < 1 and every
//!   epsilon-sample with epsilon < 1. Where the bisector of consecutive samples meets the curve
//!   between them, in x, the disc about x through both is smaller than lfs(x), so the curve inside it
//!   is one arc, which holds no other sample: the disc is empty.
//! - Correct for closed smooth curves with epsilon < 0.297: there HNN-Crust finds exactly the true
//!   edges (SGP 2016, Theorem 3), the beta-skeleton with beta = 1.7 too (Amenta, Bern, Eppstein 1998),
//!   whose edges are all in the one-step crust, and by Lemma 9 of SGP 2016 they turn by less than
//!   step 1 allows: all are certain, and leave no slot.
//!
//! Beyond that nothing is proven, but much is measured: `cargo xtask compare`.
//!
//! Cost: that of the Delaunay triangulation, O(n log n), plus a bounded search for each point that
//! step 1 leaves open or whose surroundings change.

mod candidates;
mod certificates;
mod exchange;
mod explain;
mod joins;
mod prices;

use std::collections::VecDeque;

use curvecrust_geometry::point_set::by_coordinates;
use curvecrust_geometry::{Edge, EdgeSet, PointId, PointSet, in_hilbert_order};
use curvecrust_voronoi::Delaunay;

use crate::algorithm::{AlgorithmInfo, Condition, Guarantee, Reconstructor};
use crate::error::ReconstructError;
use crate::hnn_crust::HnnCrust;
use crate::termini;
use candidates::Candidates;
use certificates::{Certificates, Crust};
use exchange::{Path, Search, Step};
use joins::{Joins, NONE};
use prices::Surroundings;

pub use explain::{ExplainedEdge, Explanation, OpenEnd, Reason, Rejected};

/// The edges of least length and detour.
///
/// ```
/// use curvecrust_geometry::{DVec2, PointSet};
/// use curvecrust_reconstruct::{hnn_crust, least_detour};
///
/// // Two circles that are nearer to each other than their samples are.
/// let circle = |radius: f64| {
///     (0..20).map(move |i| radius * DVec2::from_angle(f64::from(i) * std::f64::consts::TAU / 20.0))
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
            guarantees: &[Guarantee {
                condition: Condition::Epsilon,
                bound: 0.297,
            }],
            cost: "O(n log n)",
            honours_termini: true,
        }
    }

    fn reconstruct(&self, points: &PointSet) -> EdgeSet {
        Work::done(points, &[], |work| work.edges())
    }

    /// A terminus has one slot.
    fn reconstruct_open(
        &self,
        points: &PointSet,
        termini: &[PointId],
    ) -> Result<EdgeSet, ReconstructError> {
        termini::check(points, termini)?;
        Ok(Work::done(points, termini, |work| work.edges()))
    }

    /// Always some.
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
    /// // Point 8 is an outlier and dear to join: even the other row would cost less.
    /// let end = why.open.iter().find(|end| end.point == 7.into()).unwrap();
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
        Ok(Some(Work::done(points, termini, Explanation::new)))
    }
}

/// What the steps work on: the points in Hilbert order.
struct Work<'a> {
    points: &'a PointSet,
    /// What they are called by the caller.
    ids: &'a [PointId],
    candidates: Candidates,
    joins: Joins<'a>,
    /// The edges that step 2 added.
    completed: EdgeSet,
}

impl Work<'_> {
    /// All steps, and what becomes of their result.
    fn done<R>(points: &PointSet, termini: &[PointId], result: impl FnOnce(Work<'_>) -> R) -> R {
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
        let certificates = Certificates::new(points, &hnn, &is_terminus);
        let mut joins = Joins::new(points.points(), is_terminus.clone());
        for [v, w] in certificates.certain(&delaunay) {
            joins.certify(v, w);
        }
        let crust = Crust::new(points, &delaunay, |v| joins.is_settled(v));
        let surroundings = Surroundings {
            points,
            candidates: &candidates,
            hnn: &certificates,
            crust: &crust,
            joins: &joins,
        };
        let prices = surroundings.prices();
        joins.set_prices(prices);
        let mut work = Work {
            points,
            ids,
            candidates,
            joins,
            completed: EdgeSet::default(),
        };
        work.complete();
        work.exchange();
        result(work)
    }

    /// The edges as the caller knows them.
    fn edges(&self) -> EdgeSet {
        let edges = self.joins.edges();
        let edges = edges.edges().iter().filter_map(|&edge| self.named(edge));
        EdgeSet::new(self.points.len(), edges)
    }

    /// The edge between the same points by the names that the caller has for them.
    fn named(&self, edge: Edge) -> Option<Edge> {
        let [a, b] = edge.ends().map(|v| self.ids[v.index()]);
        Edge::new(a, b)
    }

    /// Adds edges between open slots, the shortest first.
    fn complete(&mut self) {
        let points = self.points.points();
        let Self {
            joins, candidates, ..
        } = self;
        let is_open = |v: u32| joins.is_open(v);
        let mut edges: Vec<(f64, [u32; 2])> = Vec::new();
        for v in (0u32..).take(points.len()).filter(|&v| is_open(v)) {
            for &w in candidates.of(v) {
                if v < w && is_open(w) {
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
            let is_possible = joins.is_open(v) && joins.is_open(w) && !joins.are_joined(v, w);
            if is_possible
                && !joins.would_close_triangle(v, w)
                && joins.length(v, w) < joins.price(v) + joins.price(w)
            {
                joins.join(v, w);
            }
        }
        self.completed = self.joins.edges();
    }

    /// Applies exchanges that lower the cost until there is none.
    ///
    /// Ends: the cost falls each time, by more than rounding could feign.
    fn exchange(&mut self) {
        let mut queue: Vec<u32> = (0u32..)
            .take(self.points.len())
            .filter(|&v| !self.joins.is_settled(v))
            .collect();
        queue.sort_unstable_by(|&v, &w| self.candidates.compare(self.points, v, w));
        let mut queue = VecDeque::from(queue);
        let mut is_queued = vec![false; self.points.len()];
        for &v in &queue {
            is_queued[v as usize] = true;
        }
        while let Some(v) = queue.pop_front() {
            is_queued[v as usize] = false;
            let found = Search::below(0.0, &mut self.joins, &self.candidates).from(v);
            let Some(exchange) = found.best() else {
                continue;
            };
            for touched in self.apply(&exchange.path) {
                let around = self.joins.partners(touched);
                for near in around.into_iter().chain([touched]) {
                    if near != NONE && !is_queued[near as usize] && !self.joins.is_settled(near) {
                        is_queued[near as usize] = true;
                        queue.push_back(near);
                    }
                }
            }
        }
    }

    /// The points that the path touches, in its order.
    fn apply(&mut self, path: &Path) -> Vec<u32> {
        for step in path.steps() {
            if let Step::Part(v, w) = *step {
                self.joins.part(v, w);
            }
        }
        for step in path.steps() {
            if let Step::Join(v, w) = *step {
                self.joins.join(v, w);
            }
        }
        let ends = path.steps().iter().flat_map(|step| match *step {
            Step::Part(v, w) | Step::Join(v, w) => [v, w],
        });
        ends.collect()
    }
}
