//! Why an edge is there, and why an end stayed open.

use curvecrust_geometry::{Edge, EdgeSet, PointId};

use super::Work;
use super::exchange::{Exchange, Search, Step};

/// The edges of [`least_detour`](fn@super::least_detour) and its open ends, each with its reason.
#[derive(Clone, Debug, PartialEq)]
pub struct Explanation {
    /// The edges, ascending.
    pub edges: Vec<ExplainedEdge>,
    /// The points with less than two edges, or none if they are termini, ascending.
    pub open: Vec<OpenEnd>,
}

/// An edge and why it is there.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ExplainedEdge {
    /// The edge.
    pub edge: Edge,
    /// How it came to be there.
    pub reason: Reason,
    /// By how much the cost would rise by the best exchange that removes the edge: near 0 where
    /// another answer is as good. In the unit of the points. `None` for certified edges, which are not
    /// exchanged.
    pub margin: Option<f64>,
}

/// How an edge came to be there.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Reason {
    /// HNN-Crust and the one-step crust agree on it, and it goes on almost straight at both ends.
    Certified,
    /// It was the shortest that was left when it was added, and no exchange removed it.
    Completed,
    /// An exchange that lowered the cost brought it.
    Exchanged,
}

impl Reason {
    /// The reason in one word, lower case.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Certified => "certified",
            Self::Completed => "completed",
            Self::Exchanged => "exchanged",
        }
    }
}

/// A point where a curve ends, or that is alone.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OpenEnd {
    /// The point.
    pub point: PointId,
    /// How many of its slots are open: 1 at an end, 2 if it is alone.
    pub slots: u8,
    /// What it costs to leave them open. In the unit of the points.
    pub price: f64,
    /// The exchange that fills a slot and would cost least; `None` if there is none.
    pub rejected: Option<Rejected>,
}

/// What would fill an open slot, but costs more.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rejected {
    /// The partner.
    pub partner: PointId,
    /// By how much the cost would rise. In the unit of the points.
    pub cost: f64,
}

impl Explanation {
    /// The edges alone, between as many vertices as there are points.
    #[must_use]
    pub fn edge_set(&self, points: usize) -> EdgeSet {
        EdgeSet::new(points, self.edges.iter().map(|explained| explained.edge))
    }

    pub(super) fn new(mut work: Work<'_>) -> Self {
        let edges = work.joins.edges();
        let edges = edges.edges().iter();
        let mut edges: Vec<ExplainedEdge> = edges.filter_map(|&edge| work.explain(edge)).collect();
        edges.sort_unstable_by_key(|explained| explained.edge);
        let open = work.points.ids().filter_map(|point| work.why_open(point));
        let mut open: Vec<OpenEnd> = open.collect();
        open.sort_unstable_by_key(|end| end.point);
        Self { edges, open }
    }
}

impl Work<'_> {
    fn explain(&mut self, edge: Edge) -> Option<ExplainedEdge> {
        let [v, w] = edge.ends().map(u32::from);
        let named = self.named(edge)?;
        if self.joins.is_certified(v, w) {
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
        // A path has a direction: it seeks a new partner for its second point.
        let mut without = |v, w| {
            let search = Search::below(f64::INFINITY, &mut self.joins, &self.candidates);
            search.without(v, w).best().map(|found| found.cost)
        };
        let margins = [without(v, w), without(w, v)];
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

    fn why_open(&mut self, point: PointId) -> Option<OpenEnd> {
        let v = u32::from(point);
        let slots = u8::try_from(self.joins.open_slots(v))
            .ok()
            .filter(|&n| n > 0)?;
        let search = Search::below(f64::INFINITY, &mut self.joins, &self.candidates);
        let found = search.filling(v).best();
        let rejected = found.and_then(|found| self.rejected(v, &found));
        Some(OpenEnd {
            point: self.ids[point.index()],
            slots,
            price: self.joins.cost(v, 0),
            rejected,
        })
    }

    /// Whom the exchange joins the point to, first.
    fn rejected(&self, v: u32, exchange: &Exchange) -> Option<Rejected> {
        let joined = |step: &Step| match *step {
            Step::Join(a, b) if a == v => Some(b),
            Step::Join(a, b) if b == v => Some(a),
            _ => None,
        };
        let partner = exchange.path.steps().iter().find_map(joined)?;
        Some(Rejected {
            partner: self.ids[partner as usize],
            cost: exchange.cost.max(0.0),
        })
    }
}
