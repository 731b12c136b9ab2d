//! Connect2D from its definition: all costs and all fans are computed anew for every step.

use std::collections::BTreeSet;

use curvecrust_geometry::{Edge, EdgeSet, PointId, PointSet};
use curvecrust_voronoi::Delaunay;

use super::family::{Pair, by_length, degree, delaunay_pairs, edge_set, spanning_tree};
use super::oracles::beta_skeleton;

type Triangle = [PointId; 3];

struct Region<'a> {
    points: &'a PointSet,
    triangles: Vec<Triangle>,
    inside: BTreeSet<usize>,
}

fn sides([a, b, c]: Triangle) -> [Edge; 3] {
    [(a, b), (b, c), (c, a)].map(|(p, q)| Edge::new(p, q).unwrap())
}

impl<'a> Region<'a> {
    fn within(points: &'a PointSet, triangles: Vec<Triangle>, walls: &EdgeSet) -> Self {
        let mut inside: BTreeSet<usize> = (0..triangles.len()).collect();
        let shared = |side: Edge, among: &dyn Fn(usize) -> bool| {
            let at = |i: &usize| among(*i) && sides(triangles[*i]).contains(&side);
            (0..triangles.len()).filter(at).count()
        };
        loop {
            let is_reached = |&i: &usize| {
                sides(triangles[i]).into_iter().any(|side| {
                    let outside = |other: usize| !inside.contains(&other);
                    let on_hull = shared(side, &|_| true) == 1;
                    !walls.contains(side) && (on_hull || shared(side, &outside) > 0)
                })
            };
            let reached: Vec<usize> = inside.iter().copied().filter(is_reached).collect();
            if reached.is_empty() {
                break;
            }
            inside.retain(|i| !reached.contains(i));
        }
        Self {
            points,
            triangles,
            inside,
        }
    }

    fn boundary(&self) -> Vec<Pair> {
        let all: Vec<Edge> = self
            .inside
            .iter()
            .flat_map(|&i| sides(self.triangles[i]))
            .collect();
        let once = |side: &&Edge| all.iter().filter(|other| other == side).count() == 1;
        all.iter().filter(once).map(|side| side.ends()).collect()
    }

    fn length(&self, edges: &[Pair]) -> f64 {
        edges
            .iter()
            .map(|&[p, q]| self.points[p].distance(self.points[q]))
            .sum()
    }

    /// How much longer the boundary is with the triangle on the other side.
    fn growth(&self, triangle: usize) -> f64 {
        let boundary = self.boundary();
        let grows = |side: Edge| {
            let is_on = boundary.contains(&side.ends());
            let length = self.length(&[side.ends()]);
            if is_on { -length } else { length }
        };
        let mut grows = sides(self.triangles[triangle]).map(grows);
        grows.sort_unstable_by(f64::total_cmp);
        grows.iter().sum()
    }

    /// The squares of the lengths of its sides, ascending.
    fn squares(&self, triangle: usize) -> [f64; 3] {
        let mut squares = sides(self.triangles[triangle]).map(|side| {
            let [p, q] = side.ends();
            self.points[p].distance_squared(self.points[q])
        });
        squares.sort_unstable_by(f64::total_cmp);
        squares
    }

    fn interior(&self) -> Vec<PointId> {
        let boundary = self.boundary();
        let is_inside = |v: &PointId| {
            degree(&boundary, *v) == 0 && self.inside.iter().any(|&i| self.triangles[i].contains(v))
        };
        self.points.ids().filter(is_inside).collect()
    }

    fn least(&self, wanted: impl Fn(usize) -> bool) -> Option<usize> {
        let candidates = (0..self.triangles.len()).filter(|&i| wanted(i));
        candidates.min_by(|&i, &j| {
            let [a, b] = [i, j].map(|triangle| (self.growth(triangle), self.squares(triangle)));
            a.partial_cmp(&b).unwrap()
        })
    }

    fn inflate(&mut self) {
        loop {
            let (boundary, interior) = (self.boundary(), self.interior());
            let irregular = |v: &PointId| degree(&boundary, *v) != 2 && !interior.contains(v);
            let step = self
                .least(|i| !self.inside.contains(&i) && self.triangles[i].iter().any(irregular));
            let Some(step) = step else { break };
            self.inside.insert(step);
        }
    }

    fn sculpt(&mut self) {
        loop {
            let (boundary, interior) = (self.boundary(), self.interior());
            let step = self.least(|i| {
                let corners = self.triangles[i];
                let on_boundary = sides(corners).map(|side| boundary.contains(&side.ends()));
                let open = on_boundary.iter().position(|&is_on| is_on);
                let apex = open.map(|side| corners[(side + 2) % 3]);
                self.inside.contains(&i)
                    && on_boundary.iter().filter(|&&is_on| is_on).count() == 1
                    && apex.is_some_and(|apex| interior.contains(&apex))
            });
            let Some(step) = step else { break };
            self.inside.remove(&step);
        }
    }
}

/// The triangles as the library sees them: of the points along a Hilbert curve.
fn triangles(points: &PointSet) -> Vec<Triangle> {
    let (sorted, ids) = points.in_hilbert_order();
    let delaunay = Delaunay::new(&sorted);
    let named = delaunay
        .triangles()
        .map(|corners| corners.map(|v| ids[v.index()]));
    named.collect()
}

fn ring(points: &PointSet, triangles: Vec<Triangle>, walls: &EdgeSet) -> EdgeSet {
    let mut region = Region::within(points, triangles, walls);
    region.inflate();
    region.sculpt();
    edge_set(points, &region.boundary())
}

pub(crate) fn connect2d(points: &PointSet) -> EdgeSet {
    let tree = spanning_tree(points);
    let triangles = triangles(points);
    if triangles.is_empty() {
        return tree;
    }
    let pairs = delaunay_pairs(points);
    let mut outline: Vec<Pair> = tree.edges().iter().map(|edge| edge.ends()).collect();
    loop {
        let leaves: Vec<PointId> = points.ids().filter(|&v| degree(&outline, v) == 1).collect();
        let shortest = |v: PointId| {
            let further = pairs.iter().filter(|pair| !outline.contains(pair));
            further.copied().find(|pair| pair.contains(&v))
        };
        let taken: Vec<Pair> = leaves.into_iter().filter_map(shortest).collect();
        if taken.is_empty() {
            break;
        }
        outline.extend(taken);
        outline.sort_unstable();
        outline.dedup();
    }
    ring(points, triangles, &edge_set(points, &outline))
}

pub(crate) fn sig_connect2d(points: &PointSet) -> EdgeSet {
    let gabriel = beta_skeleton(points, 1.0);
    let nearest = |p: PointId| {
        let others = points.ids().filter(|&q| q != p);
        let distances = others.map(|q| points[p].distance(points[q]));
        distances.fold(f64::INFINITY, f64::min)
    };
    let meet = |&[p, q]: &Pair| points[p].distance(points[q]) <= nearest(p) + nearest(q);
    let pairs = delaunay_pairs(points);
    let mut graph: Vec<Pair> = pairs.iter().copied().filter(meet).collect();
    for &[p, q] in &pairs {
        let lacks = degree(&graph, p) < 2 || degree(&graph, q) < 2;
        let is_gabriel = gabriel.contains(Edge::new(p, q).unwrap());
        if lacks && is_gabriel && !graph.contains(&[p, q]) {
            graph.push([p, q]);
        }
    }
    let mut found = Vec::new();
    let mut left: Vec<PointId> = points.ids().collect();
    while let Some(&first) = left.first() {
        let mut members = super::family::component(&graph, first);
        members.sort_unstable();
        left.retain(|v| !members.contains(v));
        // The component as a set of its own, in the order that the library has it in.
        let (_, order) = points.in_hilbert_order();
        let members: Vec<PointId> = order.into_iter().filter(|v| members.contains(v)).collect();
        let own = PointSet::new(members.iter().map(|&v| points[v]).collect()).unwrap();
        let place =
            |v: PointId| PointId::new(members.iter().position(|&w| w == v).unwrap()).unwrap();
        let inside = graph.iter().filter(|pair| members.contains(&pair[0]));
        let walls: Vec<Pair> = inside.map(|pair| pair.map(place)).collect();
        let walls = edge_set(&own, &walls);
        let triangles: Vec<Triangle> = Delaunay::new(&own).triangles().collect();
        let edges = if triangles.is_empty() {
            walls
        } else {
            ring(&own, triangles, &walls)
        };
        found.extend(
            edges
                .edges()
                .iter()
                .map(|edge| edge.ends().map(|v| members[v.index()])),
        );
    }
    found.sort_by(|&e, &f| by_length(points, e, f));
    edge_set(points, &found)
}
