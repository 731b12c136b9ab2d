//! A tour as an array, and where each vertex is in it.

/// A closed tour through the vertices `0..n`.
pub(super) struct Order {
    at: Vec<u32>,
    place: Vec<u32>,
}

impl Order {
    /// Each vertex once.
    pub(super) fn new(at: Vec<u32>) -> Self {
        let mut place = vec![0; at.len()];
        for (i, &v) in (0u32..).zip(&at) {
            place[v as usize] = i;
        }
        Self { at, place }
    }

    pub(super) fn len(&self) -> usize {
        self.at.len()
    }

    pub(super) fn into_inner(self) -> Vec<u32> {
        self.at
    }

    /// The edges in the direction of the tour.
    pub(super) fn edges(&self) -> impl Iterator<Item = [u32; 2]> + '_ {
        let next = self.at.iter().cycle().skip(1);
        self.at.iter().zip(next).map(|(&v, &w)| [v, w])
    }

    /// The vertex `steps` steps after another.
    pub(super) fn after(&self, v: u32, steps: usize) -> u32 {
        self.at[(self.place[v as usize] as usize + steps) % self.at.len()]
    }

    pub(super) fn next(&self, v: u32) -> u32 {
        let place = self.place[v as usize] as usize + 1;
        self.at[if place == self.at.len() { 0 } else { place }]
    }

    pub(super) fn previous(&self, v: u32) -> u32 {
        let place = self.place[v as usize] as usize;
        self.at[(if place == 0 { self.at.len() } else { place }) - 1]
    }

    /// Of the two neighbours of a vertex the one that is not the other.
    pub(super) fn beyond(&self, v: u32, from: u32) -> u32 {
        let next = self.next(v);
        if next == from { self.previous(v) } else { next }
    }

    pub(super) fn are_joined(&self, v: u32, w: u32) -> bool {
        self.next(v) == w || self.previous(v) == w
    }

    /// How many vertices an [`exchange`](Self::exchange) moves.
    pub(super) fn moved_by(&self, [_, t2, _, t4]: [u32; 4]) -> usize {
        let [i, j] = [t2, t4].map(|v| self.place[v as usize] as usize);
        let inside = i.abs_diff(j) + 1;
        inside.min(self.at.len() - inside)
    }

    /// Replaces the edges t1 t2 and t3 t4 by t2 t3 and t4 t1, where a way around the tour meets t1,
    /// t2, t4, t3 in this order.
    pub(super) fn exchange(&mut self, [t1, t2, _, t4]: [u32; 4]) {
        if self.next(t1) == t2 {
            self.reverse(t2, t4);
        } else {
            self.reverse(t4, t2);
        }
    }

    /// Turns the path from `first` on to `last` round, or the rest of the tour, which is the same.
    fn reverse(&mut self, first: u32, last: u32) {
        let count = self.at.len();
        let [mut i, mut j] = [first, last].map(|v| self.place[v as usize] as usize);
        let mut inside = if i <= j { j - i } else { j + count - i } + 1;
        if 2 * inside > count {
            (i, j) = (
                if j + 1 == count { 0 } else { j + 1 },
                if i == 0 { count - 1 } else { i - 1 },
            );
            inside = count - inside;
        }
        for _ in 0..inside / 2 {
            self.at.swap(i, j);
            for k in [i, j] {
                #[expect(
                    clippy::cast_possible_truncation,
                    reason = "below the number of vertices"
                )]
                let place = k as u32;
                self.place[self.at[k] as usize] = place;
            }
            i = if i + 1 == count { 0 } else { i + 1 };
            j = if j == 0 { count - 1 } else { j - 1 };
        }
    }
}
