//! An exchange of edges of a tour, one after another, and whether it leaves a tour.

use super::cost::{Change, Cost};
use super::order::{Order, Segment};

/// An exchange replaces at most so many edges.
pub(super) const MOST: usize = 4;

/// A sequential exchange: the edges t1 t2, t3 t4, ... of a tour are taken away, and t2 t3, t4 t5,
/// ... put in, where the last of the ends is joined to t1.
///
/// What is left of the tour are segments. K. Helsgaun, "General k-opt submoves for the
/// Lin-Kernighan TSP heuristic", Mathematical Programming Computation 1, 2009: the ends in the
/// order in which they are on the tour say whether the new edges join the segments to one tour, in
/// a time that depends on their number alone. So exchanges are judged before the tour is changed.
#[derive(Clone, Copy)]
pub(super) struct Exchange {
    /// t1, t2, ...; an end of a removed edge is at an even index, its other end at the next.
    ends: [u32; 2 * MOST],
    /// Where each end is on the tour: twice its place, and one more if its segment ends there, not
    /// starts.
    keys: [u32; 2 * MOST],
    /// The indices of the ends in the order of their keys.
    sorted: [u8; 2 * MOST],
    /// The number of ends.
    count: usize,
}

impl Exchange {
    /// Takes away the edge t1 t2 alone.
    pub(super) fn new(tour: &Order, t1: u32, t2: u32) -> Self {
        let empty = Self {
            ends: [0; 2 * MOST],
            keys: [0; 2 * MOST],
            sorted: [0; 2 * MOST],
            count: 0,
        };
        empty.and(tour, t1, t2)
    }

    /// Joins the last end to t3, and takes away the edge t3 t4.
    pub(super) fn and(mut self, tour: &Order, t3: u32, t4: u32) -> Self {
        let is_on = tour.next(t3) == t4;
        for (v, is_segment_end) in [(t3, is_on), (t4, !is_on)] {
            let key = 2 * tour.place(v) + u32::from(is_segment_end);
            let mut rank = self.count;
            while rank > 0 && self.keys[usize::from(self.sorted[rank - 1])] > key {
                self.sorted[rank] = self.sorted[rank - 1];
                rank -= 1;
            }
            #[expect(clippy::cast_possible_truncation, reason = "below 2 MOST")]
            let index = self.count as u8;
            self.sorted[rank] = index;
            self.ends[self.count] = v;
            self.keys[self.count] = key;
            self.count += 1;
        }
        self
    }

    /// The ends, t1 first.
    pub(super) fn ends(&self) -> &[u32] {
        &self.ends[..self.count]
    }

    pub(super) fn first(&self) -> u32 {
        self.ends[0]
    }

    pub(super) fn last(&self) -> u32 {
        self.ends[self.count - 1]
    }

    /// How many edges are taken away.
    pub(super) fn len(&self) -> usize {
        self.count / 2
    }

    /// Whether an edge is among those taken away.
    pub(super) fn removes(&self, v: u32, w: u32) -> bool {
        let mut removed = self.ends().chunks_exact(2);
        removed.any(|edge| edge == [v, w] || edge == [w, v])
    }

    /// Whether an edge is among those put in, but for the last one.
    pub(super) fn adds(&self, v: u32, w: u32) -> bool {
        let mut added = self.ends[1..self.count - 1].chunks_exact(2);
        added.any(|edge| edge == [v, w] || edge == [w, v])
    }

    /// The index of the end that a new edge joins to one.
    fn joined(&self, index: usize) -> usize {
        if index == 0 {
            self.count - 1
        } else if index + 1 == self.count {
            0
        } else if index.is_multiple_of(2) {
            index - 1
        } else {
            index + 1
        }
    }

    /// The segments in the order and direction in which the new edges join them; `None` if that is
    /// no tour.
    pub(super) fn segments(&self) -> Option<([Segment; MOST], usize)> {
        let count = self.count;
        // From the first start of a segment on.
        let shift = self.keys[usize::from(self.sorted[0])] as usize & 1;
        let mut rank_of = [0; 2 * MOST];
        let mut at = [0; 2 * MOST];
        for (rank, at) in at.iter_mut().enumerate().take(count) {
            let place = rank + shift;
            let index = usize::from(self.sorted[if place < count { place } else { 0 }]);
            *at = index;
            rank_of[index] = rank;
        }
        let mut segments = [Segment::default(); MOST];
        let (mut rank, mut done) = (0, 0);
        loop {
            let [from, to] = [at[rank], at[rank ^ 1]];
            segments[done] = Segment {
                from: self.keys[from] / 2,
                to: self.keys[to] / 2,
                is_on: rank.is_multiple_of(2),
            };
            done += 1;
            rank = rank_of[self.joined(to)];
            if rank == 0 || done == count / 2 {
                break;
            }
        }
        (rank == 0 && done == count / 2).then_some((segments, done))
    }

    /// What an exchange changes that leaves a tour.
    pub(super) fn change(&self, tour: &Order, cost: &Cost<'_>) -> Change {
        let mut change = Change::default();
        for i in (0..self.count).step_by(2) {
            change.remove(cost.edge(self.ends[i], self.ends[i + 1]));
            change.add(cost.edge(self.ends[i], self.ends[self.joined(i)]));
        }
        if cost.has_vertices() {
            for i in 0..self.count {
                change.cost += self.change_at(i, tour, cost);
            }
        }
        change
    }

    /// What it changes at an end, where that is not an earlier one too.
    fn change_at(&self, index: usize, tour: &Order, cost: &Cost<'_>) -> f64 {
        let v = self.ends[index];
        if self.ends[..index].contains(&v) {
            return 0.0;
        }
        let old = [tour.previous(v), tour.next(v)];
        let mut new = old;
        for i in (0..self.count).filter(|&i| self.ends[i] == v) {
            let side = usize::from(self.keys[i] % 2 == 1);
            new[side] = self.ends[self.joined(i)];
        }
        cost.vertex(v, new[0], new[1]) - cost.vertex(v, old[0], old[1])
    }
}
