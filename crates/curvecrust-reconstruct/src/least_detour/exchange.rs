//! Exchanges of edges along alternating paths, after S. Lin, B. W. Kernighan, "An Effective Heuristic
//! Algorithm for the Traveling-Salesman Problem", Operations Research 21(2), 1973; here without the
//! demand that the result be one tour, so that every alternating path is an exchange.
//!
//! They go on with a path while what it has parted outweighs what it has joined. Here what it parts
//! next counts too: a long edge in the place of two others would not be found otherwise.

use super::candidates::Candidates;
use super::joins::{Joins, NONE};

/// In how many ways a path is continued after each of its joins, the first join first: the cheapest.
const BREADTH: [usize; DEPTH] = [5, 3, 2, 2, 1, 1, 1, 1, 1, 1, 1, 1];
/// The most of them.
const BROADEST: usize = BREADTH[0];
/// How many joins a path may have: three include the moves known as 2-opt, 3-opt and or-opt, but one
/// strand after another is put right only by many.
const DEPTH: usize = 12;
/// Partings and joins of the longest path: it may begin with two partings.
const LONGEST: usize = 2 * DEPTH + 2;

/// An exchange lowers the cost if it does so by more than this fraction of all that is added up for it:
/// more than rounding could feign, so that no exchange is ever undone by another.
const ROUNDING: f64 = 1e-12;

/// A step of a path.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Step {
    Part(u32, u32),
    Join(u32, u32),
}

/// Alternating partings and joins.
#[derive(Clone, Copy, Debug)]
pub(super) struct Path {
    steps: [Step; LONGEST],
    len: usize,
}

impl Path {
    const EMPTY: Self = Self {
        steps: [Step::Part(NONE, NONE); LONGEST],
        len: 0,
    };

    pub(super) fn steps(&self) -> &[Step] {
        &self.steps[..self.len]
    }

    fn push(&mut self, step: Step) {
        self.steps[self.len] = step;
        self.len += 1;
    }

    fn parts(&self, v: u32, w: u32) -> bool {
        let steps = self.steps().iter();
        let mut parted = steps.filter_map(|step| match *step {
            Step::Part(a, b) => Some([a, b]),
            Step::Join(..) => None,
        });
        parted.any(|ends| ends == [v, w] || ends == [w, v])
    }

    fn joins(&self, v: u32, w: u32) -> bool {
        let wanted = [Step::Join(v, w), Step::Join(w, v)];
        self.steps().iter().any(|step| wanted.contains(step))
    }
}

/// An exchange, and what it adds to the cost.
#[derive(Clone, Copy, Debug)]
pub(super) struct Exchange {
    pub(super) path: Path,
    pub(super) cost: f64,
}

/// The search for the exchange that costs least among those that begin in one place.
pub(super) struct Search<'a, 'b> {
    joins: &'a mut Joins<'b>,
    candidates: &'a Candidates,
    path: Path,
    best: Exchange,
}

/// A path with an end that seeks a partner, and perhaps another in its first point.
#[derive(Clone, Copy)]
struct Hands {
    base: Option<u32>,
    end: u32,
    /// How many joins led here.
    joins: usize,
    /// What the path adds to the cost, with no price for the slots in hand.
    cost: f64,
    /// Of the lengths, detours and prices that add up to it.
    size: f64,
}

impl<'a, 'b> Search<'a, 'b> {
    /// Among exchanges that cost less than `limit`.
    pub(super) fn below(limit: f64, joins: &'a mut Joins<'b>, candidates: &'a Candidates) -> Self {
        let best = Exchange {
            path: Path::EMPTY,
            cost: limit,
        };
        Self {
            joins,
            candidates,
            path: Path::EMPTY,
            best,
        }
    }

    /// What was found.
    pub(super) fn best(self) -> Option<Exchange> {
        (self.best.path.len > 0).then_some(self.best)
    }

    /// Exchanges that begin at a point: by parting it from a partner that is not certified, or from
    /// both, or by finding one for an open slot.
    pub(super) fn from(mut self, v: u32) -> Self {
        let partners = self.joins.partners(v);
        let may_go = |p: u32, joins: &Joins| p != NONE && !joins.is_certified(v, p);
        for partner in partners {
            if may_go(partner, self.joins) {
                self = self.without(v, partner);
            }
        }
        if partners.into_iter().all(|p| may_go(p, self.joins)) {
            let [p, q] = partners;
            self = self.alone(v, [p, q]).alone(v, [q, p]);
        }
        self.filling(v)
    }

    /// Exchanges that begin by parting a point from both partners, which are then in hand.
    fn alone(mut self, v: u32, [p, q]: [u32; 2]) -> Self {
        let length = self.joins.length(v, p) + self.joins.length(v, q);
        let cost = |joins: &Joins, in_hand| {
            joins.cost(v, 0) + joins.cost(p, in_hand) + joins.cost(q, in_hand)
        };
        let before = cost(self.joins, 0);
        for partner in [p, q] {
            self.joins.part(v, partner);
            self.path.push(Step::Part(v, partner));
        }
        let after = cost(self.joins, 1);
        let hands = Hands {
            base: Some(p),
            end: q,
            joins: 0,
            cost: after - before - length,
            size: length + before + after,
        };
        self.leave_open(hands);
        self.extend(hands);
        self.path.len -= 2;
        for partner in [p, q] {
            self.joins.join(v, partner);
        }
        self
    }

    /// Exchanges that begin by parting two points that are joined.
    pub(super) fn without(mut self, v: u32, w: u32) -> Self {
        let length = self.joins.length(v, w);
        let before = self.joins.cost(v, 0) + self.joins.cost(w, 0);
        self.joins.part(v, w);
        self.path.push(Step::Part(v, w));
        let after = self.joins.cost(v, 1) + self.joins.cost(w, 1);
        let hands = Hands {
            base: Some(v),
            end: w,
            joins: 0,
            cost: after - before - length,
            size: length + before + after,
        };
        self.leave_open(hands);
        self.extend(hands);
        self.path.len -= 1;
        self.joins.join(v, w);
        self
    }

    /// Exchanges that begin by filling an open slot of a point; none if it has none.
    pub(super) fn filling(mut self, v: u32) -> Self {
        if self.joins.is_open(v) {
            let price = self.to_leave_open(v, 1);
            self.extend(Hands {
                base: None,
                end: v,
                joins: 0,
                cost: -price,
                size: self.joins.cost(v, 0),
            });
        }
        self
    }

    /// Ends the path: the slots in hand stay open.
    fn leave_open(&mut self, hands: Hands) {
        let Hands { base, end, .. } = hands;
        let other = base.filter(|&base| base != end);
        let at_end = if base == Some(end) { 2 } else { 1 };
        let prices =
            self.to_leave_open(end, at_end) + other.map_or(0.0, |base| self.to_leave_open(base, 1));
        let size = self.joins.cost(end, 0) + other.map_or(0.0, |base| self.joins.cost(base, 0));
        self.keep(hands.cost + prices, hands.size + size);
    }

    /// What it costs to leave slots open that are in hand.
    fn to_leave_open(&self, v: u32, in_hand: usize) -> f64 {
        self.joins.cost(v, 0) - self.joins.cost(v, in_hand)
    }

    fn keep(&mut self, cost: f64, size: f64) {
        if cost + ROUNDING * size < self.best.cost {
            self.best = Exchange {
                path: self.path,
                cost,
            };
        }
    }

    /// Joins the end to each of its candidates, which ends the path in an open slot or else takes the
    /// place of a partner.
    fn extend(&mut self, hands: Hands) {
        let candidates = self.candidates;
        let Some(&breadth) = BREADTH.get(hands.joins) else {
            return;
        };
        let mut cheapest = Cheapest::new(breadth);
        for &to in candidates.of(hands.end) {
            if self.joins.are_joined(hands.end, to) || self.path.parts(hands.end, to) {
                continue;
            }
            let cost = hands.cost + self.joins.length(hands.end, to);
            if self.joins.is_open(to) {
                if cost - self.joins.price(to) < self.best.cost {
                    self.fill(hands, to);
                }
                if let Some(next) = self.passing(hands, to)
                    && next.cost < self.best.cost
                {
                    cheapest.insert(to, next);
                }
            } else {
                for partner in self.joins.partners(to) {
                    if let Some(next) = self.replacing(hands, to, partner)
                        && next.cost < self.best.cost
                    {
                        cheapest.insert(to, next);
                    }
                }
            }
        }
        for &(to, next) in cheapest.all() {
            if next.cost < self.best.cost {
                self.follow(hands.end, to, next);
            }
        }
    }

    /// Ends the path in an open slot, perhaps that of its base.
    fn fill(&mut self, hands: Hands, to: u32) {
        if self.joins.would_close_triangle(hands.end, to) {
            return;
        }
        let is_base = hands.base == Some(to);
        let length = self.joins.length(hands.end, to);
        let before = self.joins.cost(hands.end, 1) + self.joins.cost(to, usize::from(is_base));
        self.joins.join(hands.end, to);
        self.path.push(Step::Join(hands.end, to));
        let after = self.joins.cost(hands.end, 0) + self.joins.cost(to, 0);
        let left_open = hands.base.filter(|_| !is_base);
        let price = left_open.map_or(0.0, |base| self.to_leave_open(base, 1));
        let size = left_open.map_or(0.0, |base| self.joins.cost(base, 0));
        self.keep(
            hands.cost + length + after - before + price,
            hands.size + length + after + before + size,
        );
        self.path.len -= 1;
        self.joins.part(hands.end, to);
    }

    /// What is in hand once the end has taken the place of a partner, which becomes the end; `None`
    /// where it may not.
    fn replacing(&mut self, hands: Hands, to: u32, partner: u32) -> Option<Hands> {
        let Hands { base, end, .. } = hands;
        // A terminus has one partner.
        if partner == NONE
            || partner == end
            || self.joins.is_certified(to, partner)
            || self.path.joins(to, partner)
        {
            return None;
        }
        let in_hand = usize::from(base == Some(partner));
        let lengths = [self.joins.length(end, to), self.joins.length(to, partner)];
        let before =
            self.joins.cost(to, 0) + self.joins.cost(end, 1) + self.joins.cost(partner, in_hand);
        self.joins.part(to, partner);
        let is_possible = !self.joins.would_close_triangle(end, to);
        self.joins.join(end, to);
        let after = self.joins.cost(to, 0)
            + self.joins.cost(end, 0)
            + self.joins.cost(partner, in_hand + 1);
        self.joins.part(end, to);
        self.joins.join(to, partner);
        is_possible.then(|| Hands {
            base,
            end: partner,
            joins: hands.joins + 1,
            cost: hands.cost + lengths[0] - lengths[1] + after - before,
            size: hands.size + lengths[0] + lengths[1] + after + before,
        })
    }

    /// What is in hand once the end has been joined to a point that is alone, which becomes the end;
    /// `None` for another point.
    fn passing(&mut self, hands: Hands, to: u32) -> Option<Hands> {
        let Hands { base, end, .. } = hands;
        if self.joins.open_slots(to) < 2 || base == Some(to) {
            return None;
        }
        let length = self.joins.length(end, to);
        let before = self.joins.cost(end, 1) + self.joins.cost(to, 0);
        self.joins.join(end, to);
        let after = self.joins.cost(end, 0) + self.joins.cost(to, 1);
        self.joins.part(end, to);
        Some(Hands {
            base,
            end: to,
            joins: hands.joins + 1,
            cost: hands.cost + length + after - before,
            size: hands.size + length + after + before,
        })
    }

    /// Goes on with what is in hand once `end` has been joined to a point, and perhaps has taken the
    /// place of a partner there.
    fn follow(&mut self, end: u32, to: u32, next: Hands) {
        let steps = self.path.len;
        let takes_place = next.end != to;
        if takes_place {
            self.joins.part(to, next.end);
        }
        self.joins.join(end, to);
        self.path.push(Step::Join(end, to));
        if takes_place {
            self.path.push(Step::Part(to, next.end));
            self.leave_open(next);
        }
        self.extend(next);
        self.path.len = steps;
        self.joins.part(end, to);
        if takes_place {
            self.joins.join(to, next.end);
        }
    }
}

/// The cheapest ways to go on, by the points that are joined.
struct Cheapest {
    ways: [(u32, Hands); BROADEST],
    len: usize,
    most: usize,
}

impl Cheapest {
    fn new(most: usize) -> Self {
        let nowhere = Hands {
            base: None,
            end: NONE,
            joins: 0,
            cost: f64::INFINITY,
            size: 0.0,
        };
        Self {
            ways: [(NONE, nowhere); BROADEST],
            len: 0,
            most,
        }
    }

    /// Of equals, the first stays.
    fn insert(&mut self, to: u32, next: Hands) {
        let at = self.all().partition_point(|(_, way)| way.cost <= next.cost);
        if at < self.most {
            self.len = (self.len + 1).min(self.most);
            self.ways[at..self.len].rotate_right(1);
            self.ways[at] = (to, next);
        }
    }

    fn all(&self) -> &[(u32, Hands)] {
        &self.ways[..self.len]
    }
}
