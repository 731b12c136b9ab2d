//! What least detour promises of its edges, from its definition.

use curvecrust_geometry::point_set::by_coordinates;
use curvecrust_geometry::{DVec2, Edge, EdgeSet, PointId, PointSet};

use super::oracles;

/// The cost of edges as the module's doc defines it, with brute force for what it depends on.
struct Definition<'a> {
    points: &'a PointSet,
    /// Delaunay edges whose dual is longer than a point.
    candidates: EdgeSet,
    hnn: EdgeSet,
    prices: Vec<f64>,
}

fn partners(edges: &EdgeSet, v: PointId) -> Vec<PointId> {
    let at = edges.edges().iter().filter(|e| e.ends().contains(&v));
    at.map(|e| if e.a() == v { e.b() } else { e.a() }).collect()
}

fn detour(v: DVec2, p: DVec2, q: DVec2) -> f64 {
    v.distance(p) + v.distance(q) - p.distance(q)
}

impl<'a> Definition<'a> {
    fn new(points: &'a PointSet) -> Self {
        let pairs = points.ids().flat_map(|p| points.ids().map(move |q| (p, q)));
        let candidates =
            pairs.filter(|&(p, q)| p < q && oracles::voronoi_edge(points, p, q).is_some());
        let candidates = candidates.filter_map(|(p, q)| Edge::new(p, q));
        let mut definition = Self {
            points,
            candidates: EdgeSet::new(points.len(), candidates),
            hnn: oracles::hnn_crust(points),
            prices: Vec::new(),
        };
        definition.prices = points.ids().map(|v| definition.price(v)).collect();
        definition
    }

    fn closest(&self, v: PointId) -> Vec<PointId> {
        let mut closest = partners(&self.candidates, v);
        closest.sort_by(|&p, &q| {
            let distance = |p: PointId| self.points[v].distance_squared(self.points[p]);
            distance(p)
                .total_cmp(&distance(q))
                .then(by_coordinates(self.points[p], self.points[q]))
        });
        closest
    }

    fn price(&self, v: PointId) -> f64 {
        let to_nearest = |v: PointId| {
            let nearest = self.closest(v).first().copied();
            nearest.map_or(0.0, |p| self.points[v].distance(self.points[p]))
        };
        let around = self.closest(v).into_iter().take(2).map(to_nearest);
        let around = around.fold(0.0, f64::max);
        let own = to_nearest(v).min(2.5 * around);
        let is_trusted = |v: DVec2, p: DVec2, q: DVec2| {
            detour(v, p, q) <= 0.82 * v.distance(p).min(v.distance(q))
        };
        let at_v = partners(&self.hnn, v).into_iter();
        let trusted = at_v.filter(|&w| self.go_on(Edge::new(v, w).unwrap(), is_trusted));
        let lengths = trusted.map(|w| self.points[v].distance(self.points[w]));
        2.25 * lengths.fold(around.max(own), f64::max)
    }

    /// Whether both ends of an edge of HNN-Crust have another, which is `well` with it.
    fn go_on(&self, edge: Edge, well: impl Fn(DVec2, DVec2, DVec2) -> bool) -> bool {
        edge.ends()
            .into_iter()
            .all(|v| match partners(&self.hnn, v)[..] {
                [p, q] => well(self.points[v], self.points[p], self.points[q]),
                _ => false,
            })
    }

    fn certain(&self) -> impl Iterator<Item = Edge> + '_ {
        let crust = oracles::one_step_crust(self.points);
        let is_straight = |v: DVec2, p: DVec2, q: DVec2| {
            let (a, b) = (p - v, q - v);
            -a.dot(b) >= 0.65 * a.length() * b.length()
        };
        let edges = self.hnn.edges().iter().copied();
        edges.filter(move |&e| crust.contains(e) && self.go_on(e, is_straight))
    }

    fn cost(&self, edges: &EdgeSet) -> f64 {
        let lengths = edges.edges().iter().map(|e| {
            let [p, q] = e.ends().map(|id| self.points[id]);
            p.distance(q)
        });
        let at = |v: PointId| match partners(edges, v)[..] {
            [p, q] => detour(self.points[v], self.points[p], self.points[q]),
            [_] => self.prices[v.index()],
            _ => 2.0 * self.prices[v.index()],
        };
        lengths.sum::<f64>() + self.points.ids().map(at).sum::<f64>()
    }

    fn has_triangle(edges: &EdgeSet) -> bool {
        let rings = edges.chains();
        rings
            .iter()
            .any(|c| c.is_closed() && c.vertices().len() == 3)
    }
}

/// What is wrong with the edges, if anything.
pub(crate) fn fault(points: &PointSet, edges: &EdgeSet) -> Option<String> {
    let definition = Definition::new(points);
    let candidates = &definition.candidates;
    if let Some(edge) = edges.difference(candidates).next() {
        return Some(format!("{edge:?} is not a candidate"));
    }
    if !edges.junctions().is_empty() || Definition::has_triangle(edges) {
        return Some("a junction or a triangle".to_owned());
    }
    let certain: Vec<Edge> = definition.certain().collect();
    if let Some(edge) = certain.iter().find(|&&e| !edges.contains(e)) {
        return Some(format!("{edge:?} is certain and missing"));
    }
    let cost = definition.cost(edges);
    let is_better = |others: &EdgeSet| definition.cost(others) < cost * (1.0 - 1e-9);
    let changed = |edge: Edge| {
        let others = edges.edges().iter().copied().filter(|&e| e != edge);
        let added = Some(edge).filter(|&e| !edges.contains(e));
        EdgeSet::new(points.len(), others.chain(added))
    };
    let toggled = candidates.edges().iter().filter(|e| !certain.contains(e));
    for &edge in toggled {
        let others = changed(edge);
        let is_valid = others.junctions().is_empty() && !Definition::has_triangle(&others);
        if is_valid && is_better(&others) {
            return Some(format!("without or with {edge:?} the cost is less"));
        }
    }
    None
}
