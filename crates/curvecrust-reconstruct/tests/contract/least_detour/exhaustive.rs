//! The cheapest 2-matching of few points, by trying all.

use curvecrust_geometry::{Edge, PointId};

use super::definition::Definition;

/// The least cost of all triangle-free 2-matchings with the certified edges, by trying all.
pub(crate) struct Exhaustive<'a> {
    definition: &'a Definition<'a>,
    partners: Vec<Vec<PointId>>,
    least: f64,
}

impl<'a> Exhaustive<'a> {
    /// Given the cost of one of them.
    pub(crate) fn least_cost(definition: &'a Definition<'a>, known: f64) -> f64 {
        Self::least_cost_of(definition, known, |_| true)
    }

    /// That of those which `may_be`, where it is below a `known` one: else the known one.
    pub(crate) fn least_cost_of(
        definition: &'a Definition<'a>,
        known: f64,
        may_be: impl Fn(&[Vec<PointId>]) -> bool,
    ) -> f64 {
        let mut search = Self {
            definition,
            partners: vec![Vec::new(); definition.points.len()],
            least: known,
        };
        let certified: Vec<Edge> = definition.certified().collect();
        for &edge in &certified {
            search.add(edge);
        }
        let candidates = definition.candidates.edges().iter().copied();
        let rest: Vec<Edge> = candidates.filter(|e| !certified.contains(e)).collect();
        search.with_or_without(&rest, &may_be);
        search.least
    }

    fn add(&mut self, edge: Edge) {
        self.partners[edge.a().index()].push(edge.b());
        self.partners[edge.b().index()].push(edge.a());
    }

    /// The least that all points cost, each by itself, if some of the other edges are added.
    fn bound(&self, rest: &[Edge]) -> f64 {
        let at = |(v, partners): (PointId, &Vec<PointId>)| {
            let cost = |partners: &[PointId]| self.definition.cost_at(v, partners);
            let others = rest.iter().filter(|e| e.ends().contains(&v));
            let others = others.map(|e| if e.a() == v { e.b() } else { e.a() });
            let others: Vec<PointId> = others.collect();
            let more = |partners: Vec<PointId>| {
                let added = others.iter().filter(|&q| !partners.contains(q));
                let added = added.map(|&q| [&partners[..], &[q]].concat());
                let allowed = added.filter(|partners| partners.len() <= 2);
                allowed.collect::<Vec<_>>()
            };
            let one_more = more(partners.clone());
            let two_more = one_more.iter().cloned().flat_map(more);
            let all = two_more.chain(one_more.iter().cloned());
            all.map(|partners| cost(&partners))
                .fold(cost(partners), f64::min)
        };
        let points = self.definition.points.ids();
        points.zip(&self.partners).map(at).sum()
    }

    fn with_or_without(&mut self, rest: &[Edge], may_be: &impl Fn(&[Vec<PointId>]) -> bool) {
        let bound = self.bound(rest);
        if bound >= self.least {
            return;
        }
        let Some((&edge, rest)) = rest.split_first() else {
            if may_be(&self.partners) {
                self.least = bound;
            }
            return;
        };
        let [a, b] = edge.ends().map(|v| &self.partners[v.index()]);
        if a.len() < 2 && b.len() < 2 && !a.iter().any(|v| b.contains(v)) {
            self.add(edge);
            self.with_or_without(rest, may_be);
            for v in edge.ends() {
                self.partners[v.index()].pop();
            }
        }
        self.with_or_without(rest, may_be);
    }
}
