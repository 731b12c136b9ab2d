//! Why an edge is there, and why an end stays free.

use curvecrust_geometry::{Edge, PointId};

use super::Solver;
use super::exchange::{Exchange, Step};
use crate::explanation::{ExplainedEdge, Explanation, FreeEnd, Reason, Rejected};

impl Solver<'_> {
    pub(super) fn explanation(mut self) -> Explanation {
        let edges = self.matching.edges();
        let edges = edges.edges().iter();
        let mut edges: Vec<ExplainedEdge> = edges.filter_map(|&edge| self.explain(edge)).collect();
        edges.sort_unstable_by_key(|explained| explained.edge);
        let free_ends = self
            .points
            .ids()
            .filter_map(|point| self.explain_free_end(point));
        let mut free_ends: Vec<FreeEnd> = free_ends.collect();
        free_ends.sort_unstable_by_key(|end| end.point);
        Explanation { edges, free_ends }
    }

    fn explain(&mut self, edge: Edge) -> Option<ExplainedEdge> {
        let [v, w] = edge.ends().map(u32::from);
        let named = self.in_callers_ids(edge)?;
        if self.matching.is_certified(v, w) {
            return Some(ExplainedEdge {
                edge: named,
                reason: Reason::Certified,
                margin: None,
            });
        }
        let reason = if self.completed.contains(edge) {
            Reason::Completed
        } else {
            Reason::Exchanged
        };
        // A path has a direction: it seeks a new partner for t2.
        let mut removing = |t1, t2| {
            let search = self.search_below(f64::INFINITY);
            search.removing(t1, t2).best().map(|found| found.cost)
        };
        let margins = [removing(v, w), removing(w, v)];
        Some(ExplainedEdge {
            edge: named,
            reason,
            // The search for improvements leaves some paths aside that this one follows.
            margin: margins
                .into_iter()
                .flatten()
                .reduce(f64::min)
                .map(|margin| margin.max(0.0)),
        })
    }

    fn explain_free_end(&mut self, point: PointId) -> Option<FreeEnd> {
        let v = u32::from(point);
        let count = u8::try_from(self.matching.free_ends(v))
            .ok()
            .filter(|&n| n > 0)?;
        let search = self.search_below(f64::INFINITY);
        let found = search.adding_at(v).best();
        let rejected = found.and_then(|found| self.rejected(v, &found));
        Some(FreeEnd {
            point: self.ids[point.index()],
            count,
            penalty: self.matching.cost(v, 0),
            rejected,
        })
    }

    /// The first partner that the exchange gives to the point.
    fn rejected(&self, v: u32, exchange: &Exchange) -> Option<Rejected> {
        let partner_of_v = |step: &Step| match *step {
            Step::Add(a, b) if a == v => Some(b),
            Step::Add(a, b) if b == v => Some(a),
            _ => None,
        };
        let partner = exchange.path.steps().iter().find_map(partner_of_v)?;
        Some(Rejected {
            partner: self.ids[partner as usize],
            cost: exchange.cost.max(0.0),
        })
    }
}
