//! Why an edge is there, and why an end stays free.

use curvecrust_geometry::{Edge, PointId};

use super::Solver;
use super::constants::EXPLAINED_CANDIDATES;
use super::exchange::{Exchange, Search};
use super::plan::{Bounds, Plan};
use crate::explanation::{ExplainedEdge, Explanation, FreeEnd, Reason, Rejected};

impl<'a> Solver<'a> {
    pub(super) fn explanation(mut self) -> Explanation {
        let certified = self.certificates.edges();
        let certified = certified.filter_map(|[v, w]| {
            let edge = self.in_callers_ids(Edge::new(v.into(), w.into())?)?;
            let reason = Reason::Certified;
            Some(ExplainedEdge {
                edge,
                reason,
                margin_at_most: None,
            })
        });
        let mut edges: Vec<ExplainedEdge> = certified.collect();
        let arcs: Vec<usize> = self.matching.edges().collect();
        edges.extend(arcs.into_iter().filter_map(|arc| self.explain(arc)));
        edges.sort_unstable_by_key(|explained| explained.edge);
        let nodes = self.graph.nodes();
        let free_ends = nodes.filter_map(|node| self.explain_free_end(node));
        let mut free_ends: Vec<FreeEnd> = free_ends.collect();
        free_ends.sort_unstable_by_key(|end| end.point);
        Explanation { edges, free_ends }
    }

    /// Explains the edge of an arc.
    fn explain(&mut self, arc: usize) -> Option<ExplainedEdge> {
        let [v, w] = self.graph.ends(arc);
        let [a, b] = [v, w].map(|node| self.graph.point(node).into());
        let edge = Edge::new(a, b)?;
        let reason = if self.completed.contains(edge) {
            Reason::Completed
        } else {
            Reason::Exchanged
        };
        Some(ExplainedEdge {
            edge: self.in_callers_ids(edge)?,
            reason,
            margin_at_most: self.margin(v, arc),
        })
    }

    /// What the best edges without the edge of an arc that are found cost more.
    fn margin(&mut self, v: u32, arc: usize) -> Option<f64> {
        let (graph, plan) = (self.graph, Plan::within(Bounds::Avoid(arc)));
        // A path has a direction: it seeks a new partner for t2.
        let either = [(v, arc), (graph.target(arc), graph.twin(arc))];
        let found = either.map(|(t1, arc)| self.search(plan).removing(t1, arc).best());
        let costs = found.into_iter().flatten();
        let costs = costs.map(|exchange| self.cost_after(exchange, plan));
        costs.reduce(f64::min)
    }

    fn explain_free_end(&mut self, v: u32) -> Option<FreeEnd> {
        if self.graph.is_saturated(v) {
            return None;
        }
        let count = u8::try_from(self.matching.free_ends(v))
            .ok()
            .filter(|&n| n > 0)?;
        Some(FreeEnd {
            point: self.callers_id(v),
            count,
            penalty: self.matching.cost(v, 0),
            rejected: self.rejected(v),
        })
    }

    /// The partner that costs least of those that a node with a free end might also have.
    fn rejected(&mut self, v: u32) -> Option<Rejected> {
        let (graph, plan) = (self.graph, Plan::within(Bounds::Keep(v)));
        let own = self.matching.arcs(v);
        let others = graph.of(v).filter(|arc| !own.contains(arc));
        let mut best: Option<Rejected> = None;
        for arc in others.take(EXPLAINED_CANDIDATES) {
            let Some(exchange) = self.search(plan).adding(v, arc).best() else {
                continue;
            };
            let cost_at_most = self.cost_after(exchange, plan);
            if best.is_none_or(|best| cost_at_most < best.cost_at_most) {
                let partner = self.callers_id(graph.target(arc));
                best = Some(Rejected {
                    partner,
                    cost_at_most,
                });
            }
        }
        best
    }

    /// A search for exchanges, whatever they cost.
    fn search(&mut self, plan: Plan) -> Search<'_, 'a> {
        Search::below(f64::INFINITY, &mut self.matching, plan)
    }

    /// What an exchange adds to the cost, together with those that it then makes worth while. The
    /// matching is left as it was.
    ///
    /// Not below 0: the search for improvements leaves some paths aside that this one follows.
    fn cost_after(&mut self, first: Exchange, plan: Plan) -> f64 {
        self.apply(first.path.steps().iter().copied());
        let touched = first.path.nodes(self.graph);
        let mut exchanges = vec![first];
        // A narrow search finds nearly all that a broad one does, in a fifth of the time.
        let then = Plan {
            bounds: plan.bounds,
            ..Plan::NARROW
        };
        self.descend(touched, then, |next| exchanges.push(next));
        let cost: f64 = exchanges.iter().map(|exchange| exchange.cost).sum();
        for exchange in exchanges.iter().rev() {
            self.apply(exchange.path.undone());
        }
        cost.max(0.0)
    }

    fn callers_id(&self, v: u32) -> PointId {
        self.ids[self.graph.point(v) as usize]
    }
}
