//! What the search works on: the points that certified edges do not saturate, the edges that may
//! join them, and what these cost.

use std::ops::Range;

use curvecrust_geometry::parallel::*;

use super::candidates::Candidates;
use super::certificates::{Certificates, NONE};
use super::measure::{Arm, Measure};
use super::penalties::Penalty;

/// Nodes that make a task.
const TASK: usize = 1 << 10;

/// Nodes with more arcs have no table of bends, since it grows with the square of their number.
const MOST_ARCS: usize = 16;

/// No arc.
pub(super) const NO_ARC: usize = usize::MAX;

/// Points are nodes here, numbered in the order of their ids. Each edge is two arcs, one from each
/// end.
///
/// A point is a node if it may get another edge, or if a certified edge joins it to such a point.
pub(super) struct SearchGraph<'a> {
    measure: Measure<'a>,
    nodes: Vec<Node>,
    arcs: Vec<Arc>,
    completions: Vec<Completion>,
    /// The tables of all nodes.
    bends: Vec<f64>,
}

struct Node {
    /// Its arcs are `first..end`: those by which it may be joined, the shortest first, and from
    /// `certified` on those of certified edges.
    first: usize,
    certified: usize,
    end: usize,
    /// Where the table of its bends begins: those of its arcs 0 and 1, 0 and 2, and so on.
    first_bend: usize,
    penalty: Penalty,
    point: u32,
    is_terminus: bool,
    is_saturated: bool,
}

impl Node {
    fn all(&self) -> Range<usize> {
        self.first..self.end
    }

    fn has_table(&self) -> bool {
        self.all().len() <= MOST_ARCS
    }
}

struct Arc {
    target: u32,
    /// The arc from the other end.
    twin: usize,
    /// What the edge costs.
    cost: f64,
}

/// What a node costs at least once it has one arc and, if it may, another one. The edge of that
/// counts for half, since it belongs to both of its ends.
#[derive(Clone, Copy)]
struct Completion {
    least: f64,
    /// The other arc then; [`NO_ARC`] if the end stays free.
    arc: usize,
    /// The least with any other.
    second: f64,
}

impl<'a> SearchGraph<'a> {
    /// With the logarithm of the spacing and the penalties of every point that is not saturated.
    pub(super) fn new(
        measure: Measure<'a>,
        candidates: &Candidates,
        certificates: &Certificates<'_>,
        log_spacings: &[f64],
        penalties: &[Penalty],
    ) -> Self {
        let is_node = |&v: &u32| {
            let mut certified = certificates.of(v);
            !certificates.saturate(v) || certified.any(|w| !certificates.saturate(w))
        };
        let points: Vec<u32> = (0u32..).take(certificates.len()).filter(is_node).collect();
        let mut graph = Self {
            measure,
            nodes: Vec::with_capacity(points.len()),
            arcs: Vec::new(),
            completions: Vec::new(),
            bends: Vec::new(),
        };
        graph.join(&points, candidates, certificates, penalties);
        graph.pair();
        graph.weigh(log_spacings);
        graph.bend();
        graph.complete();
        graph
    }

    /// Makes the nodes and their arcs.
    fn join(
        &mut self,
        points: &[u32],
        candidates: &Candidates,
        certificates: &Certificates<'_>,
        penalties: &[Penalty],
    ) {
        let mut node_of = vec![NONE; certificates.len()];
        for (node, &v) in (0u32..).zip(points) {
            node_of[v as usize] = node;
        }
        let to = |w: u32| Arc {
            target: node_of[w as usize],
            twin: NO_ARC,
            cost: 0.0,
        };
        let mut first_bend = 0;
        for &v in points {
            let is_saturated = certificates.saturate(v);
            let first = self.arcs.len();
            if !is_saturated {
                let is_open = |w: &u32| !certificates.saturate(*w) && !certificates.contain(v, *w);
                let open = candidates.of(v).iter().copied().filter(is_open);
                self.arcs.extend(open.map(to));
            }
            let certified = self.arcs.len();
            let is_arc = |w: &u32| !is_saturated || !certificates.saturate(*w);
            self.arcs.extend(certificates.of(v).filter(is_arc).map(to));
            let node = Node {
                first,
                certified,
                end: self.arcs.len(),
                first_bend,
                penalty: penalties[v as usize],
                point: v,
                is_terminus: certificates.end_at(v),
                is_saturated,
            };
            if node.has_table() {
                let arcs = node.all().len();
                first_bend += arcs * arcs.saturating_sub(1) / 2;
            }
            self.nodes.push(node);
        }
    }

    /// Finds the twin of each arc.
    fn pair(&mut self) {
        let mut ends: Vec<([u32; 2], usize)> = Vec::with_capacity(self.arcs.len());
        for v in self.nodes() {
            for arc in self.node(v).all() {
                let w = self.target(arc);
                ends.push(([v.min(w), v.max(w)], arc));
            }
        }
        ends.sort_unstable();
        for pair in ends.chunks_exact(2) {
            let [a, b] = [pair[0].1, pair[1].1];
            self.arcs[a].twin = b;
            self.arcs[b].twin = a;
        }
    }

    /// Finds what edges cost: the logarithm of the length, less the mean logarithm of the spacings
    /// at both ends. Below 0 for edges shorter than those.
    fn weigh(&mut self, log_spacings: &[f64]) {
        let cost = |arc: usize| {
            let [v, w] = self.ends(arc).map(|node| self.point(node));
            let [at_v, at_w] = [v, w].map(|id| log_spacings[id as usize]);
            self.measure.log_length(v, w) - 0.5 * (at_v + at_w)
        };
        let arcs = (0..self.arcs.len()).into_par_iter();
        let costs: Vec<f64> = arcs.with_min_len(TASK).map(cost).collect();
        for (arc, cost) in self.arcs.iter_mut().zip(costs) {
            arc.cost = cost;
        }
    }

    /// Makes the tables of bends.
    fn bend(&mut self) {
        let of_node = |node: &Node| {
            let mut arms = Vec::new();
            if node.has_table() {
                arms.extend(node.all().map(|arc| self.arm(node, arc)));
            }
            let mut bends = Vec::new();
            for (i, p) in arms.iter().enumerate() {
                bends.extend(arms[i + 1..].iter().map(|q| p.bend(q)));
            }
            bends
        };
        let nodes = self.nodes.par_iter().with_min_len(TASK);
        self.bends = nodes.flat_map_iter(of_node).collect();
    }

    /// Finds the completions of all arcs.
    fn complete(&mut self) {
        let of_node = |v: &u32| -> Vec<Completion> {
            let (v, all) = (*v, self.node(*v).all());
            if self.node(v).has_table() {
                let with = |p| self.completion_with(v, p, |q| self.bend_of(v, p, q));
                all.map(with).collect()
            } else {
                // As if there were no bends: the same for all arcs.
                vec![self.completion_with(v, NO_ARC, |_| 0.0); all.len()]
            }
        };
        let nodes: Vec<u32> = self.nodes().collect();
        let nodes = nodes.par_iter().with_min_len(TASK);
        self.completions = nodes.flat_map_iter(of_node).collect();
    }

    fn completion_with(&self, v: u32, p: usize, bend: impl Fn(usize) -> f64) -> Completion {
        let free = if self.is_terminus(v) {
            0.0
        } else {
            self.node(v).penalty.one
        };
        let mut completion = Completion {
            least: free,
            arc: NO_ARC,
            second: free,
        };
        for q in self.of(v).filter(|&q| q != p) {
            let cost = bend(q) + 0.5 * self.cost(q);
            if cost < completion.least {
                completion.second = completion.least;
                (completion.least, completion.arc) = (cost, q);
            } else {
                completion.second = completion.second.min(cost);
            }
        }
        completion
    }

    fn arm(&self, node: &Node, arc: usize) -> Arm {
        self.measure.arm(node.point, self.point(self.target(arc)))
    }

    fn node(&self, v: u32) -> &Node {
        &self.nodes[v as usize]
    }

    pub(super) fn nodes(&self) -> impl Iterator<Item = u32> + use<> {
        (0u32..).take(self.nodes.len())
    }

    /// The point of a node.
    pub(super) fn point(&self, v: u32) -> u32 {
        self.node(v).point
    }

    /// The arcs by which a node may be joined, the shortest first. Those of certified edges are not
    /// among them.
    pub(super) fn of(&self, v: u32) -> Range<usize> {
        let node = self.node(v);
        node.first..node.certified
    }

    /// The arcs of certified edges at a node.
    pub(super) fn certified_at(&self, v: u32) -> Range<usize> {
        let node = self.node(v);
        node.certified..node.end
    }

    /// Whether the arc from a node is of a certified edge.
    pub(super) fn is_certified(&self, v: u32, arc: usize) -> bool {
        self.certified_at(v).contains(&arc)
    }

    /// The node to which an arc leads.
    pub(super) fn target(&self, arc: usize) -> u32 {
        self.arcs[arc].target
    }

    /// The nodes from which and to which an arc leads.
    pub(super) fn ends(&self, arc: usize) -> [u32; 2] {
        [self.target(self.twin(arc)), self.target(arc)]
    }

    /// The arc from the other end of the edge.
    pub(super) fn twin(&self, arc: usize) -> usize {
        self.arcs[arc].twin
    }

    /// What the edge of an arc costs.
    pub(super) fn cost(&self, arc: usize) -> f64 {
        self.arcs[arc].cost
    }

    /// What a node costs at least once it has the edge of an arc from there, and one more if it
    /// may, but not the one that is given.
    pub(super) fn completion(&self, arc: usize, but: usize) -> f64 {
        let completion = &self.completions[arc];
        if completion.arc == but && but != NO_ARC {
            completion.second
        } else {
            completion.least
        }
    }

    /// What it costs that a curve goes from one arc of a node to another.
    pub(super) fn bend_of(&self, v: u32, p: usize, q: usize) -> f64 {
        let node = self.node(v);
        if node.has_table() {
            let [i, j] = [p.min(q) - node.first, p.max(q) - node.first];
            let before = i * (2 * node.all().len() - i - 1) / 2;
            self.bends[node.first_bend + before + j - i - 1]
        } else {
            self.arm(node, p).bend(&self.arm(node, q))
        }
    }

    /// What the free ends of a node cost, by their number.
    pub(super) fn penalty(&self, v: u32, free_ends: usize) -> f64 {
        let penalty = &self.node(v).penalty;
        match free_ends {
            0 => 0.0,
            1 => penalty.one,
            _ => penalty.both,
        }
    }

    pub(super) fn is_terminus(&self, v: u32) -> bool {
        self.node(v).is_terminus
    }

    /// Whether certified edges saturate the node: it gets no other edge.
    pub(super) fn is_saturated(&self, v: u32) -> bool {
        self.node(v).is_saturated
    }
}
