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
//! - the **penalty** of every free end; less at the end of an even run of points, and at an
//!   isolated point to which no curve nearby continues.
//!
//! Sought is the cheapest one. Edges express proximity, bends good continuation, and penalties let
//! a curve end where going on would cost more. The result may be any number of curves, open or
//! closed. Since a bend depends on two edges, this is no linear matching problem, and it is not
//! solved exactly:
//!
//! 1. **Certify.** Where HNN-Crust leaves no free end among points near each other, and chooses no
//!    edge of which there is another one as long, its edges stay. Elsewhere edges stay that
//!    HNN-Crust and the one-step crust find and that continue almost straight at both ends. Edges
//!    that are much longer than the runs at both of their ends are gaps, and do not stay.
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
//!   theorems on closed smooth curves, unless an edge is a gap or two candidates are equally near.
//!   No sampling condition excludes gaps: an arc of 320 degrees, closed by a chord, is an
//!   epsilon-sample of a circle with epsilon < 0.2.
//!
//! Beyond that nothing is proven, but much is measured: `cargo xtask compare`.
//!
//! Cost: that of the Delaunay triangulation, O(n log n), plus a bounded search for each point that
//! certified edges do not saturate or whose surroundings change.

mod candidates;
mod certificates;
mod constants;
mod exchange;
mod explain;
mod hnn_graph;
mod matching;
mod measure;
mod path;
mod penalties;
mod plan;
mod search_graph;
mod ways;

use std::collections::VecDeque;

use curvecrust_geometry::point_set::by_coordinates;
use curvecrust_geometry::{DVec2, Edge, EdgeSet, Interrupt, PointId, PointSet};
use curvecrust_voronoi::Delaunay;

use crate::algorithm::{AlgorithmInfo, Basis, Reconstructor, Scope};
use crate::constrained;
use crate::error::ReconstructError;
use crate::explanation::Explanation;
use crate::hnn_crust::HnnCrust;
use crate::known::Known;
use crate::termini;
use candidates::Candidates;
use certificates::Certificates;
use exchange::{Exchange, Search};
use hnn_graph::HnnGraph;
use matching::Matching;
use measure::Measure;
use path::Step;
use penalties::PenaltyModel;
use plan::Plan;
use search_graph::{NO_ARC, SearchGraph};

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
            honours_known: true,
            scope: Scope::CLOSED_AND_OPEN.with_corners(),
            basis: Basis::Published,
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

    /// One curve is a short tour or path; `docs/method.md` says how the others are found.
    fn reconstruct_known(
        &self,
        points: &PointSet,
        known: &Known,
    ) -> Result<EdgeSet, ReconstructError> {
        constrained::reconstruct(self, points, known)
    }

    /// Edges that only knowledge about the curves requires have the reason
    /// [`Reason::Required`](crate::explanation::Reason::Required). Margins, penalties and costs are
    /// those of the curves without it. Always `Some`.
    fn explain_known(
        &self,
        points: &PointSet,
        known: &Known,
    ) -> Result<Option<Explanation>, ReconstructError> {
        constrained::explain(self, points, known)
    }

    /// Always `Some`.
    ///
    /// ```
    /// use curvecrust_geometry::{DVec2, PointSet};
    /// use curvecrust_reconstruct::{LeastDetour, Reason, Reconstructor};
    ///
    /// // A row of five points, and one of four that stops long before the next point.
    /// let lower = (0..5).map(|x| DVec2::new(f64::from(x), 0.0));
    /// let upper = [0.0, 1.0, 2.0, 3.0, 16.0].map(|x| DVec2::new(x, 9.0));
    /// let points = PointSet::new(lower.chain(upper).collect())?;
    /// let why = LeastDetour.explain(&points, &[])?.unwrap();
    /// assert_eq!(why.edges.len(), 7);
    /// assert_eq!(why.edges[2].reason, Reason::Certified);
    /// assert_eq!(why.edges[3].reason, Reason::Completed);
    /// // Point 9 is an outlier and costs much to join.
    /// let alone = why.free_ends.iter().find(|end| end.point == 9.into()).unwrap();
    /// let rejected = alone.rejected.unwrap();
    /// assert_eq!(rejected.partner, 8.into());
    /// assert!(rejected.cost_at_most > 0.0);
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
    candidates: &'a Candidates,
    certificates: &'a Certificates<'a>,
    graph: &'a SearchGraph<'a>,
    matching: Matching<'a>,
    is_queued: Vec<bool>,
    /// The edges that step 2 added.
    completed: EdgeSet,
}

impl Solver<'_> {
    /// Takes all steps, and returns what `result` makes of them.
    fn solve<R>(points: &PointSet, termini: &[PointId], result: impl FnOnce(Solver<'_>) -> R) -> R {
        let mut is_named = vec![false; points.len()];
        for id in termini {
            is_named[id.index()] = true;
        }
        let (points, ids) = &points.in_hilbert_order();
        let is_terminus: Vec<bool> = ids.iter().map(|id| is_named[id.index()]).collect();
        let termini: Vec<PointId> = points.ids().filter(|v| is_terminus[v.index()]).collect();
        let delaunay = Delaunay::new(points);
        let candidates = Candidates::new(points, &delaunay);
        let hnn = HnnCrust::MUTUAL.with_termini(points, &termini);
        let hnn = HnnGraph::new(points, &candidates, &hnn, &is_terminus);
        let certificates = Certificates::new(&is_terminus, hnn.certified(&delaunay));
        drop(delaunay);
        let measure = Measure::new(points.points());
        let log_spacings = hnn.log_spacings(&candidates, &certificates);
        let model = PenaltyModel {
            measure,
            candidates: &candidates,
            hnn: &hnn,
            log_spacings: &log_spacings,
            certificates: &certificates,
        };
        let penalties = model.penalties();
        let graph = SearchGraph::new(
            measure,
            &candidates,
            &certificates,
            &log_spacings,
            &penalties,
        );
        let mut solver = Solver {
            points,
            ids,
            candidates: &candidates,
            certificates: &certificates,
            graph: &graph,
            matching: Matching::new(&graph),
            is_queued: vec![false; graph.nodes().count()],
            completed: EdgeSet::default(),
        };
        solver.complete();
        solver.exchange();
        result(solver)
    }

    /// The edges in the caller's ids.
    fn edges(&self) -> EdgeSet {
        let edges = self.matching_edges();
        let edges = edges
            .edges()
            .iter()
            .filter_map(|&edge| self.in_callers_ids(edge));
        EdgeSet::new(self.points.len(), edges)
    }

    /// The certified edges and those of the matching.
    fn matching_edges(&self) -> EdgeSet {
        let graph = self.graph;
        let others = self
            .matching
            .edges()
            .map(|arc| graph.ends(arc).map(|node| graph.point(node)));
        let all = self.certificates.edges().chain(others);
        let edges = all.filter_map(|[v, w]| Edge::new(v.into(), w.into()));
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
        let (matching, graph) = (&mut self.matching, self.graph);
        let place = |node: u32| points[graph.point(node) as usize];
        let mut edges: Vec<(f64, [DVec2; 2], usize)> = Vec::new();
        for v in graph.nodes() {
            for arc in graph.of(v).filter(|&arc| v < graph.target(arc)) {
                let mut ends = [v, graph.target(arc)].map(place);
                ends.sort_unstable_by(|&p, &q| by_coordinates(p, q));
                edges.push((ends[0].distance_squared(ends[1]), ends, arc));
            }
        }
        edges.sort_unstable_by(|(a, [p, q], _), (b, [r, s], _)| {
            a.total_cmp(b)
                .then_with(|| by_coordinates(*p, *r))
                .then_with(|| by_coordinates(*q, *s))
        });
        for (_, _, arc) in edges {
            let ends = graph.ends(arc);
            let [at_v, at_w] = ends.map(|v| matching.arcs(v));
            let penalties = ends.map(|v| graph.penalty(v, 1));
            if ends.iter().all(|&v| matching.has_free_end(v))
                && !matching.share_partner(at_v, at_w)
                && graph.cost(arc) < penalties[0] + penalties[1]
            {
                matching.add(arc);
            }
        }
        self.completed = self.matching_edges();
    }

    /// Applies exchanges that lower the cost until there is none: first those that narrow searches
    /// find, since these are many and cheap.
    ///
    /// This ends, since each exchange lowers the cost by more than rounding could feign.
    fn exchange(&mut self) {
        let graph = self.graph;
        let mut order: Vec<u32> = graph.nodes().filter(|&v| !graph.is_saturated(v)).collect();
        order.sort_unstable_by(|&v, &w| {
            let [v, w] = [v, w].map(|node| graph.point(node));
            self.candidates.compare(self.points, v, w)
        });
        for plan in [Plan::NARROW, Plan::BROAD] {
            self.descend(order.iter().copied(), plan, |_| {});
        }
    }

    /// Applies exchanges that begin at some nodes, or where others change something, until none
    /// lowers the cost, and reports each.
    fn descend(
        &mut self,
        nodes: impl Iterator<Item = u32>,
        plan: Plan,
        mut applied: impl FnMut(Exchange),
    ) {
        let graph = self.graph;
        let interrupt = Interrupt::current();
        let mut queue = VecDeque::new();
        for v in nodes {
            self.enqueue(v, &mut queue);
        }
        while let Some(v) = queue.pop_front() {
            interrupt.check();
            self.is_queued[v as usize] = false;
            let search = Search::below(0.0, &mut self.matching, plan);
            let Some(exchange) = search.from(v).best() else {
                continue;
            };
            self.apply(exchange.path.steps().iter().copied());
            for touched in exchange.path.nodes(graph) {
                let around = self.matching.arcs(touched).into_iter();
                let around = around.filter(|&arc| arc != NO_ARC);
                for near in around.map(|arc| graph.target(arc)).chain([touched]) {
                    self.enqueue(near, &mut queue);
                }
            }
            applied(exchange);
        }
    }

    /// Puts a node into the queue, if edges of it may change and it is not there.
    fn enqueue(&mut self, v: u32, queue: &mut VecDeque<u32>) {
        if !self.graph.is_saturated(v) && !std::mem::replace(&mut self.is_queued[v as usize], true)
        {
            queue.push_back(v);
        }
    }

    /// Takes steps, first those that remove.
    fn apply(&mut self, steps: impl Iterator<Item = Step> + Clone) {
        for step in steps.clone() {
            if let Step::Remove(arc) = step {
                self.matching.remove(arc);
            }
        }
        for step in steps {
            if let Step::Add(arc) = step {
                self.matching.add(arc);
            }
        }
    }
}
