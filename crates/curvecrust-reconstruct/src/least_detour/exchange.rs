//! Exchanges of edges along alternating paths, after S. Lin, B. W. Kernighan, "An Effective
//! Heuristic Algorithm for the Traveling-Salesman Problem", Operations Research 21(2), 1973; here
//! for 2-matchings, so that every alternating path is an exchange: the result need not be one tour.
//!
//! Points are named as theirs. A path removes the edge t1 t2, adds t2 t3, removes t3 t4, and so on;
//! t2i is its end. They continue a path while its gain, what is removed less what is added, is
//! positive. Here the next removal counts too: a long edge in the place of two others would not be
//! found otherwise. And since a bend depends on two edges, a path whose ends seek partners has not
//! paid for the bends there yet: what the best partners would cost counts too ([`Completions`]).
//! The cost of a path is what it adds to the cost of the matching: minus its gain.

use super::candidates::Candidates;
use super::completions::Completions;
use super::constants::{BREADTH, DEPTH, ROUNDING};
use super::matching::{Matching, NONE};

/// The largest breadth.
const BROADEST: usize = BREADTH[0];
/// The number of steps of the longest path: it may begin with two removals.
const LONGEST: usize = 2 * DEPTH + 2;

/// A step of a path.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Step {
    Remove(u32, u32),
    Add(u32, u32),
}

/// Edges that are removed and added alternately.
#[derive(Clone, Copy, Debug)]
pub(super) struct Path {
    steps: [Step; LONGEST],
    len: usize,
}

impl Path {
    const EMPTY: Self = Self {
        steps: [Step::Remove(NONE, NONE); LONGEST],
        len: 0,
    };

    pub(super) fn steps(&self) -> &[Step] {
        &self.steps[..self.len]
    }

    fn push(&mut self, step: Step) {
        self.steps[self.len] = step;
        self.len += 1;
    }

    fn removes(&self, v: u32, w: u32) -> bool {
        let steps = self.steps().iter();
        let mut removed = steps.filter_map(|step| match *step {
            Step::Remove(a, b) => Some([a, b]),
            Step::Add(..) => None,
        });
        removed.any(|ends| ends == [v, w] || ends == [w, v])
    }

    fn adds(&self, v: u32, w: u32) -> bool {
        let either = [Step::Add(v, w), Step::Add(w, v)];
        self.steps().iter().any(|step| either.contains(step))
    }
}

/// An exchange, and what it adds to the cost.
#[derive(Clone, Copy, Debug)]
pub(super) struct Exchange {
    pub(super) path: Path,
    pub(super) cost: f64,
}

/// The search for the cheapest exchange among those that begin in one place.
pub(super) struct Search<'a, 'b> {
    matching: &'a mut Matching<'b>,
    candidates: &'a Candidates,
    completions: &'a Completions,
    path: Path,
    best: Exchange,
}

/// A path whose end still seeks a partner, and perhaps its first point too: their free ends are
/// pending.
#[derive(Clone, Copy)]
struct OpenPath {
    /// The first point, if it seeks a partner.
    t1: Option<u32>,
    /// t2i.
    end: u32,
    /// The number of edges that the path adds.
    added: usize,
    /// What the path adds to the cost, without penalties for pending free ends.
    cost: f64,
    /// The sum of all amounts, removed or added, from which the cost results.
    magnitude: f64,
}

impl<'a, 'b> Search<'a, 'b> {
    /// Among exchanges that cost less than `limit`.
    pub(super) fn below(
        limit: f64,
        matching: &'a mut Matching<'b>,
        candidates: &'a Candidates,
        completions: &'a Completions,
    ) -> Self {
        let best = Exchange {
            path: Path::EMPTY,
            cost: limit,
        };
        Self {
            matching,
            candidates,
            completions,
            path: Path::EMPTY,
            best,
        }
    }

    /// What was found.
    pub(super) fn best(self) -> Option<Exchange> {
        (self.best.path.len > 0).then_some(self.best)
    }

    /// Exchanges that begin at a point: they remove one of its edges that are not certified, or
    /// both, or add one at a free end.
    pub(super) fn from(mut self, v: u32) -> Self {
        let partners = self.matching.partners(v);
        let is_removable = |p: u32, matching: &Matching| p != NONE && !matching.is_certified(v, p);
        for partner in partners {
            if is_removable(partner, self.matching) {
                self = self.removing(v, partner);
            }
        }
        if partners.into_iter().all(|p| is_removable(p, self.matching)) {
            let [p, q] = partners;
            self = self.isolating(v, [p, q]).isolating(v, [q, p]);
        }
        self.adding_at(v)
    }

    /// Exchanges that begin by removing both edges of a point; its partners seek others.
    fn isolating(mut self, v: u32, [p, q]: [u32; 2]) -> Self {
        let edges = [p, q].map(|partner| self.matching.edge_cost(v, partner));
        let cost = |matching: &Matching, pending| {
            matching.cost(v, 0) + matching.cost(p, pending) + matching.cost(q, pending)
        };
        let before = cost(self.matching, 0);
        for partner in [p, q] {
            self.matching.remove(v, partner);
            self.path.push(Step::Remove(v, partner));
        }
        let after = cost(self.matching, 1);
        let open = OpenPath {
            t1: Some(p),
            end: q,
            added: 0,
            cost: after - before - edges[0] - edges[1],
            magnitude: edges[0].abs() + edges[1].abs() + before + after,
        };
        self.stop(open);
        self.extend(open);
        self.path.len -= 2;
        for partner in [p, q] {
            self.matching.add(v, partner);
        }
        self
    }

    /// Exchanges that begin by removing the edge t1 t2.
    pub(super) fn removing(mut self, t1: u32, t2: u32) -> Self {
        let edge = self.matching.edge_cost(t1, t2);
        let before = self.matching.cost(t1, 0) + self.matching.cost(t2, 0);
        self.matching.remove(t1, t2);
        self.path.push(Step::Remove(t1, t2));
        let after = self.matching.cost(t1, 1) + self.matching.cost(t2, 1);
        let open = OpenPath {
            t1: Some(t1),
            end: t2,
            added: 0,
            cost: after - before - edge,
            magnitude: edge.abs() + before + after,
        };
        self.stop(open);
        self.extend(open);
        self.path.len -= 1;
        self.matching.add(t1, t2);
        self
    }

    /// Exchanges that begin by adding an edge at a free end of a point; none if it has none.
    pub(super) fn adding_at(mut self, v: u32) -> Self {
        if self.matching.has_free_end(v) {
            let penalty = self.pending_penalty(v, 1);
            self.extend(OpenPath {
                t1: None,
                end: v,
                added: 0,
                cost: -penalty,
                magnitude: self.matching.cost(v, 0),
            });
        }
        self
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

    /// What it costs if pending ends of a point stay free.
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
        let candidates = self.candidates;
        let Some(&breadth) = BREADTH.get(open.added) else {
            return;
        };
        let mut cheapest = Cheapest::new(breadth);
        for &to in candidates.of(open.end) {
            if self.matching.is_saturated(to)
                || self.matching.contains(open.end, to)
                || self.path.removes(open.end, to)
            {
                continue;
            }
            if self.matching.has_free_end(to) {
                self.stop_at(open, to);
                if let Some(next) = self.passing(open, to) {
                    let promised = next.cost + self.completion(to, Some(open.end), next);
                    self.consider(&mut cheapest, to, next, promised);
                }
            } else {
                for partner in self.matching.partners(to) {
                    if let Some(next) = self.replacing(open, to, partner) {
                        let mut partners = self.matching.partners(partner).into_iter();
                        let other = partners.find(|&p| p != NONE && p != to);
                        let promised = next.cost + self.completion(partner, other, next);
                        self.consider(&mut cheapest, to, next, promised);
                    }
                }
            }
        }
        for &(to, next, promised) in cheapest.all() {
            if promised < self.best.cost {
                self.follow(open.end, to, next);
            }
        }
    }

    fn consider(&self, cheapest: &mut Cheapest, to: u32, next: OpenPath, promised: f64) {
        if promised < self.best.cost {
            cheapest.insert(to, next, promised);
        }
    }

    /// What the pending ends of a path cost with the best partners; the end has one other edge, to
    /// `other`, or none.
    fn completion(&self, end: u32, other: Option<u32>, path: OpenPath) -> f64 {
        let least = |v, p| self.completions.least(self.candidates, v, p);
        if path.t1 == Some(end) {
            return 0.0;
        }
        let at_t1 = path.t1.map_or(0.0, |t1| {
            let mut partners = self.matching.partners(t1).into_iter();
            let partner = partners.find(|&p| p != NONE);
            partner.map_or(0.0, |p| least(t1, p))
        });
        at_t1 + other.map_or(0.0, |p| least(end, p))
    }

    /// Ends the path by an edge to a free end, perhaps that of t1.
    fn stop_at(&mut self, open: OpenPath, to: u32) {
        if self.matching.would_close_triangle(open.end, to) {
            return;
        }
        let is_t1 = open.t1 == Some(to);
        let edge = self.matching.edge_cost(open.end, to);
        let before = self.matching.cost(open.end, 1) + self.matching.cost(to, usize::from(is_t1));
        self.matching.add(open.end, to);
        self.path.push(Step::Add(open.end, to));
        let after = self.matching.cost(open.end, 0) + self.matching.cost(to, 0);
        let still_free = open.t1.filter(|_| !is_t1);
        let penalty = still_free.map_or(0.0, |t1| self.pending_penalty(t1, 1));
        let magnitude = still_free.map_or(0.0, |t1| self.matching.cost(t1, 0));
        self.keep(
            open.cost + edge + after - before + penalty,
            open.magnitude + edge.abs() + after + before + magnitude,
        );
        self.path.len -= 1;
        self.matching.remove(open.end, to);
    }

    /// The path once the edge from its end to a point has replaced the edge from there to a
    /// partner, which is the next end; `None` where that is not allowed.
    fn replacing(&mut self, open: OpenPath, to: u32, partner: u32) -> Option<OpenPath> {
        let OpenPath { t1, end, .. } = open;
        // A terminus has one partner.
        if partner == NONE
            || partner == end
            || self.matching.is_certified(to, partner)
            || self.path.adds(to, partner)
        {
            return None;
        }
        let pending = usize::from(t1 == Some(partner));
        let edges = [
            self.matching.edge_cost(end, to),
            self.matching.edge_cost(to, partner),
        ];
        let before = self.matching.cost(to, 0)
            + self.matching.cost(end, 1)
            + self.matching.cost(partner, pending);
        self.matching.remove(to, partner);
        let is_possible = !self.matching.would_close_triangle(end, to);
        self.matching.add(end, to);
        let after = self.matching.cost(to, 0)
            + self.matching.cost(end, 0)
            + self.matching.cost(partner, pending + 1);
        self.matching.remove(end, to);
        self.matching.add(to, partner);
        is_possible.then(|| OpenPath {
            t1,
            end: partner,
            added: open.added + 1,
            cost: open.cost + edges[0] - edges[1] + after - before,
            magnitude: open.magnitude + edges[0].abs() + edges[1].abs() + after + before,
        })
    }

    /// The path once it has an edge to an isolated point, which is the next end; `None` for other
    /// points.
    fn passing(&mut self, open: OpenPath, to: u32) -> Option<OpenPath> {
        let OpenPath { t1, end, .. } = open;
        if self.matching.free_ends(to) < 2 || t1 == Some(to) {
            return None;
        }
        let edge = self.matching.edge_cost(end, to);
        let before = self.matching.cost(end, 1) + self.matching.cost(to, 0);
        self.matching.add(end, to);
        let after = self.matching.cost(end, 0) + self.matching.cost(to, 1);
        self.matching.remove(end, to);
        Some(OpenPath {
            t1,
            end: to,
            added: open.added + 1,
            cost: open.cost + edge + after - before,
            magnitude: open.magnitude + edge.abs() + after + before,
        })
    }

    /// Searches on from `next`, the path after the edge from `end` to a point, and perhaps the
    /// removal of an edge there.
    fn follow(&mut self, end: u32, to: u32, next: OpenPath) {
        let steps = self.path.len;
        let removes = next.end != to;
        if removes {
            self.matching.remove(to, next.end);
        }
        self.matching.add(end, to);
        self.path.push(Step::Add(end, to));
        if removes {
            self.path.push(Step::Remove(to, next.end));
            self.stop(next);
        }
        self.extend(next);
        self.path.len = steps;
        self.matching.remove(end, to);
        if removes {
            self.matching.add(to, next.end);
        }
    }
}

/// The most promising ways to continue a path, each with the point that the next edge leads to, and
/// what it will cost at best.
struct Cheapest {
    ways: [(u32, OpenPath, f64); BROADEST],
    len: usize,
    most: usize,
}

impl Cheapest {
    fn new(most: usize) -> Self {
        let none = OpenPath {
            t1: None,
            end: NONE,
            added: 0,
            cost: f64::INFINITY,
            magnitude: 0.0,
        };
        Self {
            ways: [(NONE, none, f64::INFINITY); BROADEST],
            len: 0,
            most,
        }
    }

    /// Of equals, the first stays.
    fn insert(&mut self, to: u32, next: OpenPath, promised: f64) {
        let at = self.all().partition_point(|&(_, _, cost)| cost <= promised);
        if at < self.most {
            self.len = (self.len + 1).min(self.most);
            self.ways[at..self.len].rotate_right(1);
            self.ways[at] = (to, next, promised);
        }
    }

    fn all(&self) -> &[(u32, OpenPath, f64)] {
        &self.ways[..self.len]
    }
}
