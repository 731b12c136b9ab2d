//! Lin-Kernighan: sequential exchanges of edges, as long as there are some that pay.
//!
//! S. Lin, B. W. Kernighan, "An Effective Heuristic Algorithm for the Traveling-Salesman Problem",
//! Operations Research 21(2), 1973, in the form of K. Helsgaun, "An effective implementation of the
//! Lin-Kernighan traveling salesman heuristic", European Journal of Operational Research 126, 2000:
//! up to four edges are replaced at once, and what is between the first and the last of them need
//! be no tour. If none of these exchanges pays, the one that is best before it is closed is made
//! all the same, and goes on from its last end: a chain of exchanges, taken back unless it pays in
//! the end. Around vertices where nothing was found, nothing is sought until a neighbour changes
//! (don't-look bits: J. L. Bentley, "Fast Algorithms for Geometric Traveling Salesman Problems",
//! ORSA Journal on Computing 4(4), 1992).

use std::collections::VecDeque;

use curvecrust_geometry::Interrupt;

use super::cost::{Change, Cost};
use super::exchange::{Exchange, MOST};
use super::near::Near;
use super::order::{Order, Segment};

/// How many ways to take away a second edge are tried, a third one, and a fourth one.
const BREADTH: [usize; MOST - 1] = [5, 5, 3];

/// A chain has at most so many exchanges.
const LONGEST_CHAIN: usize = 8;

/// An exchange that does not pay by itself moves at most so many vertices.
const MOST_MOVED: usize = 1_000;

/// Of so many gaps each point is tried at the end beside one.
const MOST_GAPS: usize = 8;

/// A way to go on: t3, t4, and what it gains before the next edge is put in.
#[derive(Clone, Copy, Default)]
struct Way {
    gain: f64,
    t3: u32,
    t4: u32,
}

/// The ways that gain most, the best first.
struct Ways {
    ways: [Way; BREADTH[0]],
    count: usize,
    most: usize,
}

impl Ways {
    fn push(&mut self, way: Way) {
        let better = self.as_slice().iter().take_while(|w| w.gain >= way.gain);
        let rank = better.count();
        if rank < self.most {
            self.count = (self.count + 1).min(self.most);
            self.ways[rank..self.count].rotate_right(1);
            self.ways[rank] = way;
        }
    }

    fn as_slice(&self) -> &[Way] {
        &self.ways[..self.count]
    }
}

/// Exchanges that were made one after another, and do not pay so far.
#[derive(Default)]
struct Chain {
    /// What they change, with the edge that closes the tour.
    change: Change,
    /// Their ends, as an [`Exchange`] has them.
    ends: Vec<u32>,
    /// The best exchange to go on with, and what it gains before it is closed.
    open: Option<(f64, Exchange)>,
}

impl Chain {
    /// Whether an edge is among those put in, but for those that closed an exchange.
    fn adds(&self, v: u32, w: u32) -> bool {
        let exchanges = self.ends.chunks_exact(2 * MOST);
        let mut added = exchanges.flat_map(|ends| ends[1..2 * MOST - 1].chunks_exact(2));
        added.any(|edge| edge == [v, w] || edge == [w, v])
    }
}

/// A tour whose cost is lowered.
pub(super) struct Search<'a> {
    pub(super) cost: &'a Cost<'a>,
    pub(super) near: Near,
    pub(super) tour: Order,
    /// Vertices around which there may be something to gain.
    queue: VecDeque<u32>,
    is_queued: Vec<bool>,
    /// Whether each exchange is kept at once.
    pub(super) keeps: bool,
    /// How many exchanges were sought.
    pub(super) sought: usize,
}

impl<'a> Search<'a> {
    pub(super) fn new(cost: &'a Cost<'a>, near: Near, tour: Order) -> Self {
        let is_queued = vec![false; tour.len()];
        Self {
            cost,
            near,
            tour,
            queue: VecDeque::new(),
            is_queued,
            keeps: true,
            sought: 0,
        }
    }

    /// The lengths of the edges of a tour without gaps.
    pub(super) fn lengths(&self) -> impl Iterator<Item = f64> {
        let points = self.cost.points();
        let place = |v: u32| points[v as usize];
        let edges = self.tour.edges();
        edges.map(move |[v, w]| place(v).distance(place(w)))
    }

    /// Another tour, improved everywhere.
    pub(super) fn restart(&mut self, tour: Vec<u32>) {
        self.tour = Order::new(tour);
        self.keeps = true;
        self.improve_all();
    }

    pub(super) fn into_order(self) -> Vec<u32> {
        self.tour.into_inner()
    }

    /// Improves the tour everywhere.
    pub(super) fn improve_all(&mut self) {
        for v in (0u32..).take(self.tour.len()) {
            self.enqueue(v);
        }
        self.improve();
    }

    pub(super) fn enqueue(&mut self, v: u32) {
        if !self.is_queued[v as usize] {
            self.is_queued[v as usize] = true;
            self.queue.push_back(v);
        }
    }

    /// Improves the tour around the vertices in the queue, and where that changed something.
    ///
    /// Ends: the cost falls each time, by more than rounding could feign.
    pub(super) fn improve(&mut self) -> Change {
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
        partners.into_iter().find_map(|t2| self.chained(t1, t2))
    }

    /// Exchanges the edge t1 t2 and others, if that pays.
    fn chained(&mut self, t1: u32, mut t2: u32) -> Option<Change> {
        let before = self.tour.mark();
        let mut chain = Chain::default();
        for _ in 0..LONGEST_CHAIN {
            self.sought += 1;
            let opened = self.cost.edge(t1, t2) + self.vertex(t1) + self.vertex(t2);
            let exchange = Exchange::new(&self.tour, t1, t2);
            let found = self.deepened(&exchange, opened - chain.change.cost, &mut chain);
            if let Some((exchange, change)) = found {
                self.apply(&exchange, &mut chain);
                chain.ends.iter().for_each(|&v| self.enqueue(v));
                if self.keeps {
                    self.tour.keep();
                }
                return Some(chain.change + change);
            }
            let Some((_, open)) = chain.open.take() else {
                break;
            };
            chain.change = chain.change + open.change(&self.tour, self.cost);
            self.apply(&open, &mut chain);
            t2 = open.last();
        }
        self.tour.undo(before);
        None
    }

    /// An exchange that begins with another and lets the chain pay, if there is one; else the chain
    /// has the one to go on with.
    ///
    /// `gain` is what is gained before the last end is joined to another vertex.
    fn deepened(
        &self,
        exchange: &Exchange,
        gain: f64,
        chain: &mut Chain,
    ) -> Option<(Exchange, Change)> {
        let ways = self.ways(exchange, gain, chain);
        let and = |way: &Way| exchange.and(&self.tour, way.t3, way.t4);
        let closed = ways.as_slice().iter().find_map(|way| {
            let pays = self.cost.edge(way.t4, exchange.first()) < way.gain;
            pays.then(|| self.gaining(and(way), chain)).flatten()
        });
        if closed.is_some() {
            return closed;
        }
        if exchange.len() == BREADTH.len() {
            for way in ways.as_slice() {
                if chain.open.is_none_or(|(most, _)| way.gain > most) {
                    let next = Some(and(way)).filter(|next| self.is_open(next));
                    chain.open = next.map(|next| (way.gain, next)).or(chain.open);
                }
            }
            return None;
        }
        let mut each = ways.as_slice().iter();
        each.find_map(|way| self.deepened(&and(way), way.gain, chain))
    }

    /// Whether a chain may go on from an exchange.
    fn is_open(&self, exchange: &Exchange) -> bool {
        let leaves_tour = |(segments, count): ([Segment; MOST], usize)| {
            self.tour.moved(&segments[..count]) <= MOST_MOVED
        };
        exchange.first() != exchange.last() && exchange.segments().is_some_and(leaves_tour)
    }

    /// The exchange, if it leaves a tour that costs less than before the chain.
    fn gaining(&self, exchange: Exchange, chain: &Chain) -> Option<(Exchange, Change)> {
        exchange.segments()?;
        let change = exchange.change(&self.tour, self.cost);
        let is_gain = (chain.change + change).is_gain();
        is_gain.then_some((exchange, change))
    }

    /// The ways to go on that gain most so far.
    fn ways(&self, exchange: &Exchange, gain: f64, chain: &Chain) -> Ways {
        let mut ways = Ways {
            ways: Default::default(),
            count: 0,
            most: BREADTH[exchange.len() - 1],
        };
        let t2 = exchange.last();
        for t3 in self.near.of(t2).iter().copied().chain(self.gaps_for(t2)) {
            let left = gain - self.cost.edge(t2, t3);
            if left <= 0.0 || self.tour.are_joined(t2, t3) || exchange.adds(t2, t3) {
                continue;
            }
            for t4 in [self.tour.next(t3), self.tour.previous(t3)] {
                if !exchange.removes(t3, t4) && !chain.adds(t3, t4) {
                    let removed = self.cost.edge(t3, t4) + self.gain_at_vertices(exchange, t3, t4);
                    let gain = left + removed;
                    ways.push(Way { gain, t3, t4 });
                }
            }
        }
        ways
    }

    /// What is gained at vertices, those of the edge t3 t4 and t2, which then has its new edges:
    /// an estimate where an end was one before.
    fn gain_at_vertices(&self, exchange: &Exchange, t3: u32, t4: u32) -> f64 {
        if !self.cost.has_vertices() {
            return 0.0;
        }
        let ends = exchange.ends();
        let t2 = exchange.last();
        let t1 = ends[ends.len() - 2];
        let mut gain = 0.0;
        for v in [t3, t4] {
            if !ends.contains(&v) {
                gain += self.vertex(v);
            }
        }
        if !ends[..ends.len() - 1].contains(&t2) {
            gain -= self.cost.vertex(t2, self.tour.beyond(t2, t1), t3);
        }
        if !ends.contains(&t3) {
            gain -= self.cost.vertex(t3, self.tour.beyond(t3, t4), t2);
        }
        gain
    }

    /// The gaps that a point may be joined to.
    fn gaps_for(&self, v: u32) -> impl Iterator<Item = u32> + use<> {
        let may_be_end = !self.cost.is_gap(v) && self.cost.may_be_end(v);
        self.cost
            .gaps()
            .take(if may_be_end { MOST_GAPS } else { 0 })
    }

    pub(super) fn vertex(&self, v: u32) -> f64 {
        self.cost
            .vertex(v, self.tour.previous(v), self.tour.next(v))
    }

    fn apply(&mut self, exchange: &Exchange, chain: &mut Chain) {
        if let Some((mut segments, count)) = exchange.segments() {
            self.tour.join(&mut segments[..count]);
        }
        chain.ends.extend(exchange.ends());
    }
}
