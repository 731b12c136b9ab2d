//! Who is joined to whom, as lists one after another.

/// For every vertex those that an edge joins it to.
pub(crate) struct Adjacency {
    /// Those of `v` are `targets[first[v]..first[v + 1]]`.
    first: Vec<usize>,
    targets: Vec<u32>,
}

impl Adjacency {
    /// Of edges between the vertices `0..count`; the targets of each come in the order of the
    /// edges.
    pub(crate) fn new(count: usize, edges: &[[u32; 2]]) -> Self {
        Self::collect(count, || edges.iter().flat_map(|&[a, b]| [(a, b), (b, a)]))
    }

    /// The same with the numbers of the edges instead of the vertices that they lead to.
    pub(crate) fn of_numbers(count: usize, edges: &[[u32; 2]]) -> Self {
        Self::collect(count, || {
            (0u32..)
                .zip(edges)
                .flat_map(|(i, &[a, b])| [(a, i), (b, i)])
        })
    }

    fn collect<I: Iterator<Item = (u32, u32)>>(count: usize, both_ways: impl Fn() -> I) -> Self {
        let mut first = vec![0; count + 1];
        for (from, _) in both_ways() {
            first[from as usize + 1] += 1;
        }
        for v in 1..first.len() {
            first[v] += first[v - 1];
        }
        let mut free = first.clone();
        let mut targets = vec![0; free.last().copied().unwrap_or(0)];
        for (from, to) in both_ways() {
            let slot = &mut free[from as usize];
            targets[*slot] = to;
            *slot += 1;
        }
        Self { first, targets }
    }

    /// Of a list for each vertex.
    pub(crate) fn of_lists(lists: &[Vec<u32>]) -> Self {
        let first = std::iter::once(0).chain(lists.iter().scan(0, |sum, list| {
            *sum += list.len();
            Some(*sum)
        }));
        Self {
            first: first.collect(),
            targets: lists.concat(),
        }
    }

    /// Nothing for what is no vertex.
    pub(crate) fn of(&self, v: u32) -> &[u32] {
        let v = v as usize;
        if v + 1 < self.first.len() {
            &self.targets[self.first[v]..self.first[v + 1]]
        } else {
            &[]
        }
    }
}
