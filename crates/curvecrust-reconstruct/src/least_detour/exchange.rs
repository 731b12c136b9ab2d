//! Exchanges of edges along alternating paths, after S. Lin, B. W. Kernighan, "An Effective
//! Heuristic Algorithm for the Traveling-Salesman Problem", Operations Research 21(2), 1973; here
//! for 2-matchings, so that every alternating path is an exchange: the result need not be one tour.
//!
//! Points are named as theirs. A path removes the edge t1 t2, adds t2 t3, removes t3 t4, and so on;
//! t2i is its end. They continue a path while its gain, the cost of removed edges less that of
//! added ones, is positive. Here the next removal counts too: a long edge in the place of two
//! others would not be found otherwise. And since a bend depends on two edges, a path whose ends
//! seek partners has not paid for the bends there yet: what the best partners would cost counts
//! too. The cost of a path is what it adds to the cost of the matching: minus its gain.

use std::ops::Range;

use super::constants::ROUNDING;
use super::matching::{Arcs, Matching, with, without};
use super::path::{Path, Step};
use super::plan::{Bounds, Plan};
use super::search_graph::NO_ARC;
use super::ways::{Cheapest, OpenPath, Way};

/// An exchange, and what it adds to the cost.
#[derive(Clone, Copy, Debug)]
pub(super) struct Exchange {
    pub(super) path: Path,
    pub(super) cost: f64,
}

/// The search for the cheapest exchange among those that begin in one place.
pub(super) struct Search<'a, 'b> {
    matching: &'a mut Matching<'b>,
    plan: Plan,
    path: Path,
    best: Exchange,
}

impl<'a, 'b> Search<'a, 'b> {
    /// Among exchanges that cost less than `limit`.
    pub(super) fn below(limit: f64, matching: &'a mut Matching<'b>, plan: Plan) -> Self {
        let best = Exchange {
            path: Path::EMPTY,
            cost: limit,
        };
        Self {
            matching,
            plan,
            path: Path::EMPTY,
            best,
        }
    }

    /// What was found.
    pub(super) fn best(self) -> Option<Exchange> {
        (self.best.path.len > 0).then_some(self.best)
    }

    /// Exchanges that begin at a node: they remove one of its edges that are not certified, or
    /// both, or add one at a free end.
    pub(super) fn from(mut self, v: u32) -> Self {
        let arcs = self.matching.arcs(v);
        let is_removable = arcs.map(|arc| self.may_remove(v, arc));
        for (arc, is_removable) in arcs.into_iter().zip(is_removable) {
            if is_removable {
                self = self.removing(v, arc);
            }
        }
        if is_removable == [true; 2] {
            let [p, q] = arcs;
            self = self.isolating(v, [p, q]).isolating(v, [q, p]);
        }
        self.adding_at(v)
    }

    /// Whether exchanges may remove the edge of an arc from a node.
    fn may_remove(&self, v: u32, arc: usize) -> bool {
        let graph = self.matching.graph;
        arc != NO_ARC
            && !graph.is_certified(v, arc)
            && match self.plan.bounds {
                Bounds::Keep(node) => node != v && node != graph.target(arc),
                _ => true,
            }
    }

    /// Whether exchanges may add the edge of an arc.
    fn may_add(&self, arc: usize) -> bool {
        match self.plan.bounds {
            Bounds::Avoid(out) => out != arc && out != self.matching.graph.twin(arc),
            _ => true,
        }
    }

    /// Exchanges that begin by removing both edges of a node; its partners seek others.
    fn isolating(mut self, v: u32, arcs: Arcs) -> Self {
        let graph = self.matching.graph;
        let [p, q] = arcs.map(|arc| graph.target(arc));
        let edges = arcs.map(|arc| graph.cost(arc));
        let cost = |matching: &Matching, pending| {
            matching.cost(v, 0) + matching.cost(p, pending) + matching.cost(q, pending)
        };
        let before = cost(self.matching, 0);
        for arc in arcs {
            self.matching.remove(arc);
            self.path.push(Step::Remove(arc));
        }
        let after = cost(self.matching, 1);
        let open = OpenPath {
            t1: Some(p),
            end: q,
            removed: graph.twin(arcs[1]),
            added: 0,
            cost: after - before - edges[0] - edges[1],
            magnitude: edges[0].abs() + edges[1].abs() + before + after,
        };
        self.stop(open);
        self.begin(open);
        self.path.len -= 2;
        for arc in arcs {
            self.matching.add(arc);
        }
        self
    }

    /// Exchanges that begin by removing the edge of an arc from t1.
    pub(super) fn removing(mut self, t1: u32, arc: usize) -> Self {
        let t2 = self.matching.graph.target(arc);
        let edge = self.matching.graph.cost(arc);
        let before = self.matching.cost(t1, 0) + self.matching.cost(t2, 0);
        self.matching.remove(arc);
        self.path.push(Step::Remove(arc));
        let after = self.matching.cost(t1, 1) + self.matching.cost(t2, 1);
        let open = OpenPath {
            t1: Some(t1),
            end: t2,
            removed: self.matching.graph.twin(arc),
            added: 0,
            cost: after - before - edge,
            magnitude: edge.abs() + before + after,
        };
        self.stop(open);
        self.begin(open);
        self.path.len -= 1;
        self.matching.add(arc);
        self
    }

    /// Exchanges that begin by adding an edge at a free end of a node; none if it has no free end.
    fn adding_at(mut self, v: u32) -> Self {
        if self.matching.has_free_end(v) {
            let open = self.open_at(v);
            self.begin(open);
        }
        self
    }

    /// Exchanges that begin by adding the edge of an arc at a free end of a node.
    pub(super) fn adding(mut self, v: u32, arc: usize) -> Self {
        let open = self.open_at(v);
        self.extend_by(open, arc..arc + 1);
        self
    }

    /// The path whose end is a free end of a node.
    fn open_at(&self, v: u32) -> OpenPath {
        OpenPath {
            t1: None,
            end: v,
            removed: NO_ARC,
            added: 0,
            cost: -self.pending_penalty(v, 1),
            magnitude: self.matching.cost(v, 0),
        }
    }

    /// Searches on if the path may cost less than the best.
    fn begin(&mut self, open: OpenPath) {
        if open.cost + self.completion(open, self.matching.arcs(open.end)) < self.best.cost {
            self.extend(open);
        }
    }

    /// Ends the path: its pending ends stay free.
    fn stop(&mut self, open: OpenPath) {
        let OpenPath { t1, end, .. } = open;
        let other = t1.filter(|&t1| t1 != end);
        let at_end = if t1 == Some(end) { 2 } else { 1 };
        let penalties =
            self.pending_penalty(end, at_end) + other.map_or(0.0, |t1| self.pending_penalty(t1, 1));
        let magnitude =
            self.matching.cost(end, 0) + other.map_or(0.0, |t1| self.matching.cost(t1, 0));
        self.keep(open.cost + penalties, open.magnitude + magnitude);
    }

    /// What it costs if pending ends of a node stay free.
    fn pending_penalty(&self, v: u32, pending: usize) -> f64 {
        self.matching.cost(v, 0) - self.matching.cost(v, pending)
    }

    fn keep(&mut self, cost: f64, magnitude: f64) {
        if cost + ROUNDING * magnitude < self.best.cost {
            self.best = Exchange {
                path: self.path,
                cost,
            };
        }
    }

    /// Adds edges from the end to each of its candidates. The path stops at a free end there, or
    /// continues by removing an edge of the candidate.
    fn extend(&mut self, open: OpenPath) {
        let arcs = self.matching.graph.of(open.end);
        self.extend_by(open, arcs);
    }

    fn extend_by(&mut self, open: OpenPath, arcs: Range<usize>) {
        let Some(&breadth) = self.plan.breadth.get(open.added) else {
            return;
        };
        let graph = self.matching.graph;
        let mut cheapest = Cheapest::new(breadth);
        for arc in arcs {
            if self.matching.contains(open.end, arc)
                || self.path.removes(graph, arc)
                || !self.may_add(arc)
            {
                continue;
            }
            let to = graph.target(arc);
            if self.matching.has_free_end(to) {
                self.stop_at(open, arc);
                self.pass(open, arc, &mut cheapest);
            } else {
                for removed in self.matching.arcs(to) {
                    self.replace(open, arc, removed, &mut cheapest);
                }
            }
        }
        for way in cheapest.all() {
            if way.promised < self.best.cost {
                self.follow(way);
            }
        }
    }

    /// What the end of a path with these arcs and t1 cost at least with the best partners.
    ///
    /// The path may yet take away the other edge of t1 too, so that the edge that it removed there
    /// counts as a partner.
    fn completion(&self, open: OpenPath, arcs: Arcs) -> f64 {
        let least = |arcs: Arcs, but| {
            let arc = arcs.into_iter().find(|&arc| arc != NO_ARC);
            arc.map_or(0.0, |arc| self.matching.graph.completion(arc, but))
        };
        match open.t1 {
            _ if !self.plan.leaves_early => 0.0,
            Some(t1) if t1 == open.end => 0.0,
            Some(t1) => least(arcs, open.removed) + least(self.matching.arcs(t1), NO_ARC),
            None => least(arcs, open.removed),
        }
    }

    /// Ends the path by an edge to a free end, perhaps that of t1.
    fn stop_at(&mut self, open: OpenPath, arc: usize) {
        let OpenPath { t1, end, .. } = open;
        let graph = self.matching.graph;
        let to = graph.target(arc);
        let [at_end, at_to] = [end, to].map(|v| self.matching.arcs(v));
        if self.matching.share_partner(at_end, at_to) {
            return;
        }
        let is_t1 = t1 == Some(to);
        let edge = graph.cost(arc);
        let before = self.matching.cost(end, 1) + self.matching.cost(to, usize::from(is_t1));
        let after = self.matching.cost_with(end, with(at_end, arc), 0)
            + self.matching.cost_with(to, with(at_to, graph.twin(arc)), 0);
        // The end may be t1 too, with another end pending.
        let still_free = t1.filter(|_| !is_t1).map(|t1| {
            let arcs = self.matching.arcs(t1);
            (t1, if t1 == end { with(arcs, arc) } else { arcs })
        });
        let cost_of_t1 = |pending| {
            still_free.map_or(0.0, |(t1, arcs)| self.matching.cost_with(t1, arcs, pending))
        };
        let magnitude = cost_of_t1(0);
        let penalty = magnitude - cost_of_t1(1);
        self.path.push(Step::Add(arc));
        self.keep(
            open.cost + edge + after - before + penalty,
            open.magnitude + edge.abs() + after + before + magnitude,
        );
        self.path.len -= 1;
    }

    /// Considers the edge of an arc in the place of another at its target; the path goes on from
    /// the other end of that.
    fn replace(&self, open: OpenPath, arc: usize, removed: usize, cheapest: &mut Cheapest) {
        let OpenPath { t1, end, .. } = open;
        let (matching, graph) = (&*self.matching, self.matching.graph);
        let to = graph.target(arc);
        // A terminus has one partner.
        if !self.may_remove(to, removed) {
            return;
        }
        let partner = graph.target(removed);
        if partner == end || self.path.adds(graph, removed) {
            return;
        }
        let pending = usize::from(t1 == Some(partner));
        let [at_end, at_to, at_partner] = [end, to, partner].map(|v| matching.arcs(v));
        let kept = without(at_to, removed);
        let left = without(at_partner, graph.twin(removed));
        if matching.share_partner(at_end, kept) {
            return;
        }
        let edges = [graph.cost(arc), graph.cost(removed)];
        let before = matching.cost_with(to, at_to, 0)
            + matching.cost_with(end, at_end, 1)
            + matching.cost_with(partner, at_partner, pending);
        let after = matching.cost_with(to, with(kept, graph.twin(arc)), 0)
            + matching.cost_with(end, with(at_end, arc), 0)
            + matching.cost_with(partner, left, pending + 1);
        let next = OpenPath {
            t1,
            end: partner,
            removed: graph.twin(removed),
            added: open.added + 1,
            cost: open.cost + edges[0] - edges[1] + after - before,
            magnitude: open.magnitude + edges[0].abs() + edges[1].abs() + after + before,
        };
        self.consider(arc, removed, next, left, cheapest);
    }

    /// Considers an edge to an isolated node, from which the path goes on.
    fn pass(&self, open: OpenPath, arc: usize, cheapest: &mut Cheapest) {
        let OpenPath { t1, end, .. } = open;
        let (matching, graph) = (&*self.matching, self.matching.graph);
        let to = graph.target(arc);
        if matching.free_ends(to) < 2 || t1 == Some(to) {
            return;
        }
        let edge = graph.cost(arc);
        let there = [graph.twin(arc), NO_ARC];
        let before = matching.cost(end, 1) + matching.cost(to, 0);
        let after = matching.cost_with(end, with(matching.arcs(end), arc), 0)
            + matching.cost_with(to, there, 1);
        let next = OpenPath {
            t1,
            end: to,
            removed: NO_ARC,
            added: open.added + 1,
            cost: open.cost + edge + after - before,
            magnitude: open.magnitude + edge.abs() + after + before,
        };
        self.consider(arc, NO_ARC, next, there, cheapest);
    }

    /// Considers a way whose end has these arcs.
    fn consider(
        &self,
        adds: usize,
        removes: usize,
        next: OpenPath,
        at_end: Arcs,
        cheapest: &mut Cheapest,
    ) {
        let promised = next.cost + self.completion(next, at_end);
        if promised < self.best.cost {
            cheapest.insert(Way {
                adds,
                removes,
                next,
                promised,
            });
        }
    }

    /// Searches on along a way.
    fn follow(&mut self, way: &Way) {
        let steps = self.path.len;
        let removes = way.removes != NO_ARC;
        if removes {
            self.matching.remove(way.removes);
        }
        self.matching.add(way.adds);
        self.path.push(Step::Add(way.adds));
        if removes {
            self.path.push(Step::Remove(way.removes));
            self.stop(way.next);
        }
        self.extend(way.next);
        self.path.len = steps;
        self.matching.remove(way.adds);
        if removes {
            self.matching.add(way.removes);
        }
    }
}
