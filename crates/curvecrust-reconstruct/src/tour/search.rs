//! Lin-Kernighan: exchanges of edges one after another, each of which leaves a tour.

use std::collections::VecDeque;

use curvecrust_geometry::{Interrupt, Random};

use super::cost::Cost;
use super::near::Near;
use super::order::Order;

/// How many ways to go on are tried after each number of exchanges.
const BREADTH: [usize; 5] = [5, 3, 1, 1, 1];

/// A smaller gain, as a share of the lengths that it is the difference of, is rounding.
const ROUNDING: f64 = 1e-12;

/// The longest path of a perturbation.
const LONGEST_PATH: usize = 10;

/// Up to this number of gaps, each point is tried at the end beside one.
const MOST_GAPS: usize = 8;

/// An exchange that costs more, to be made good by others, moves at most this many vertices. In
/// tours of twice as many, none moves more.
const MOST_MOVED: usize = 1_000;

/// Perturbations for each vertex, and their number for any tour.
const PERTURBATIONS: usize = 10;
const MOST_PERTURBATIONS: usize = 30_000;

/// A difference of costs, and the size of the terms that it was computed from.
#[derive(Clone, Copy, Default)]
struct Change {
    cost: f64,
    size: f64,
}

impl Change {
    /// Whether the cost falls by more than rounding could feign.
    fn is_gain(self) -> bool {
        self.cost < -ROUNDING * self.size
    }
}

impl std::ops::Add for Change {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self {
            cost: self.cost + other.cost,
            size: self.size + other.size,
        }
    }
}

/// A tour whose cost is lowered.
pub(super) struct Search<'a> {
    cost: &'a Cost<'a>,
    near: &'a Near,
    tour: Order,
    /// The exchanges since the last state that is kept.
    done: Vec<[u32; 4]>,
    /// Vertices around which there may be something to gain.
    queue: VecDeque<u32>,
    is_queued: Vec<bool>,
}

impl<'a> Search<'a> {
    pub(super) fn new(cost: &'a Cost<'a>, near: &'a Near, tour: Order) -> Self {
        let is_queued = vec![false; tour.len()];
        Self {
            cost,
            near,
            tour,
            done: Vec::new(),
            queue: VecDeque::new(),
            is_queued,
        }
    }

    pub(super) fn into_order(self) -> Vec<u32> {
        self.tour.into_inner()
    }

    /// Improves the tour, and again after each of many perturbations.
    pub(super) fn run(&mut self) {
        let count = self.tour.len();
        for v in (0u32..).take(count) {
            self.enqueue(v);
        }
        self.improve();
        self.done.clear();
        // A perturbation takes five vertices; of the three tours through four, exchanges find the
        // shortest.
        if count < 5 {
            return;
        }
        let mut random = Random::new(1);
        for _ in 0..(PERTURBATIONS * count).min(MOST_PERTURBATIONS) {
            let change = self.perturb(&mut random) + self.improve();
            if change.is_gain() {
                self.done.clear();
            } else {
                while let Some([t1, t2, t3, t4]) = self.done.pop() {
                    self.tour.exchange([t1, t4, t3, t2]);
                }
            }
        }
    }

    fn enqueue(&mut self, v: u32) {
        if !self.is_queued[v as usize] {
            self.is_queued[v as usize] = true;
            self.queue.push_back(v);
        }
    }

    /// Improves the tour around the vertices in the queue, and where that changed something.
    ///
    /// Ends: the cost falls each time, by more than rounding could feign.
    fn improve(&mut self) -> Change {
        let interrupt = Interrupt::current();
        let mut sum = Change::default();
        while let Some(v) = self.queue.pop_front() {
            interrupt.check();
            self.is_queued[v as usize] = false;
            while let Some(change) = self.improved_at(v) {
                sum = sum + change;
            }
        }
        sum
    }

    fn improved_at(&mut self, t1: u32) -> Option<Change> {
        let partners = [self.tour.next(t1), self.tour.previous(t1)];
        partners
            .into_iter()
            .find_map(|t2| self.deepened(0, [t1, t2], Change::default()))
    }

    /// Replaces the edge t1 t2 and others so that the tour costs less than before a change, if it
    /// can.
    fn deepened(&mut self, depth: usize, [t1, t2]: [u32; 2], before: Change) -> Option<Change> {
        let gain = self.gain_without([t1, t2], before);
        let mut left = BREADTH[depth];
        let (near, cost) = (self.near, self.cost);
        let candidates = near
            .of(t2)
            .iter()
            .copied()
            .take_while(|&t3| cost.edge(t2, t3) < gain);
        for t3 in candidates.chain(self.gaps_for(t2)) {
            if self.tour.are_joined(t2, t3) || cost.edge(t2, t3) >= gain {
                continue;
            }
            let is_on = self.tour.next(t1) == t2;
            let t4 = if is_on {
                self.tour.previous(t3)
            } else {
                self.tour.next(t3)
            };
            let exchange = [t1, t2, t3, t4];
            let change = before + self.change_by(exchange);
            let is_gain = change.is_gain();
            let goes_on = depth + 1 < BREADTH.len()
                && self.may_go_on(exchange, change)
                && self.tour.moved_by(exchange) <= MOST_MOVED;
            if !is_gain && !goes_on {
                continue;
            }
            self.apply(exchange);
            let found = if is_gain {
                Some(change)
            } else {
                self.deepened(depth + 1, [t1, t4], change)
            };
            if found.is_some() {
                exchange.into_iter().for_each(|v| self.enqueue(v));
                return found;
            }
            self.undo();
            left -= 1;
            if left == 0 {
                break;
            }
        }
        None
    }

    /// What is gained if the edge t1 t2 is taken away, before a new edge at t2 is paid for.
    fn gain_without(&self, [t1, t2]: [u32; 2], before: Change) -> f64 {
        self.cost.edge(t1, t2) + self.vertex(t1) + self.vertex(t2) - before.cost
    }

    /// The gaps that a point may be joined to.
    fn gaps_for(&self, v: u32) -> impl Iterator<Item = u32> + use<> {
        let may_be_end = !self.cost.is_gap(v) && self.cost.may_be_end(v);
        self.cost
            .gaps()
            .take(if may_be_end { MOST_GAPS } else { 0 })
    }

    /// Whether after an exchange, which leaves t4 as the neighbour of t1, there may be another that
    /// pays.
    fn may_go_on(&self, [t1, t2, t3, t4]: [u32; 4], change: Change) -> bool {
        let others = [self.tour.beyond(t1, t2), self.tour.beyond(t4, t3)];
        let vertices = [(t1, others[0], t4), (t4, others[1], t1)];
        let vertices = vertices.map(|(v, p, q)| self.cost.vertex(v, p, q));
        let gain = self.cost.edge(t1, t4) + vertices[0] + vertices[1] - change.cost;
        let is_new = |t5: u32| t5 != t1 && t5 != others[1];
        let nearest = self.near.of(t4).iter().find(|&&t5| is_new(t5));
        nearest.is_some_and(|&t5| self.cost.edge(t4, t5) < gain)
            || self.cost.gaps().next().is_some()
    }

    fn apply(&mut self, exchange: [u32; 4]) {
        self.tour.exchange(exchange);
        self.done.push(exchange);
    }

    fn undo(&mut self) {
        if let Some([t1, t2, t3, t4]) = self.done.pop() {
            self.tour.exchange([t1, t4, t3, t2]);
        }
    }

    fn vertex(&self, v: u32) -> f64 {
        self.cost
            .vertex(v, self.tour.previous(v), self.tour.next(v))
    }

    /// What an exchange changes.
    fn change_by(&self, [t1, t2, t3, t4]: [u32; 4]) -> Change {
        let old = [self.cost.edge(t1, t2), self.cost.edge(t3, t4)];
        let new = [self.cost.edge(t2, t3), self.cost.edge(t4, t1)];
        let vertices = [(t1, t2, t4), (t2, t1, t3), (t3, t4, t2), (t4, t3, t1)];
        let bends = vertices.map(|(v, from, to)| {
            let other = self.tour.beyond(v, from);
            self.cost.vertex(v, other, to) - self.cost.vertex(v, other, from)
        });
        Change {
            cost: (new[0] - old[0]) + (new[1] - old[1]) + bends.into_iter().sum::<f64>(),
            size: old.into_iter().chain(new).map(f64::abs).sum(),
        }
    }

    /// Exchanges two neighbouring paths at a random place.
    fn perturb(&mut self, random: &mut Random) -> Change {
        let count = self.tour.len();
        let most = LONGEST_PATH.min((count - 2) / 2);
        let lengths = [random.below(most) + 1, random.below(most) + 1];
        #[expect(
            clippy::cast_possible_truncation,
            reason = "below the number of vertices"
        )]
        let a = random.below(count) as u32;
        let b = self.tour.next(a);
        let [c, d] = [lengths[0], lengths[0] + 1].map(|steps| self.tour.after(a, steps));
        let e = self.tour.after(a, lengths[0] + lengths[1]);
        let f = self.tour.next(e);
        // From a, b..c, d..e, f to a, d..e, b..c, f.
        let exchanges = [[a, b, f, e], [a, e, c, d], [e, c, f, b]];
        let mut sum = Change::default();
        for exchange in exchanges {
            sum = sum + self.change_by(exchange);
            self.apply(exchange);
        }
        for v in [a, b, c, d, e, f] {
            self.enqueue(v);
        }
        sum
    }
}
