//! Paths that grow by edges between their ends.

/// Instead of a partner.
const NONE: u32 = u32::MAX;

/// Disjoint paths through the vertices `0..count`, at first of one vertex each; a path may close to
/// a ring.
pub(crate) struct Paths {
    partners: Vec<[u32; 2]>,
    /// Of the end of a path its other end.
    far: Vec<u32>,
}

impl Paths {
    pub(crate) fn new(count: usize) -> Self {
        Self {
            partners: vec![[NONE; 2]; count],
            far: (0u32..).take(count).collect(),
        }
    }

    /// The number of vertices.
    pub(crate) fn len(&self) -> usize {
        self.partners.len()
    }

    /// The vertices that it is joined to, in the order in which they were.
    pub(crate) fn partners(&self, v: u32) -> impl Iterator<Item = u32> + '_ {
        let partners = self.partners[v as usize].iter().copied();
        partners.filter(|&w| w != NONE)
    }

    /// Whether no edge leads to the vertex.
    pub(crate) fn is_free(&self, v: u32) -> bool {
        self.partners[v as usize][0] == NONE
    }

    /// Whether a further edge may lead to the vertex.
    pub(crate) fn is_end(&self, v: u32) -> bool {
        self.partners[v as usize][1] == NONE
    }

    /// The other end of the path that an end belongs to: itself if it is free.
    pub(crate) fn far_end(&self, v: u32) -> u32 {
        self.far[v as usize]
    }

    /// The vertex before the end of a path.
    pub(crate) fn before(&self, end: u32) -> Option<u32> {
        self.partners(end).next()
    }

    pub(crate) fn are_joined(&self, v: u32, w: u32) -> bool {
        self.partners[v as usize].contains(&w)
    }

    /// Joins two ends, which no edge joins yet; returns the ends of the path, the same as `v` and
    /// `w` if it is a ring now.
    pub(crate) fn join(&mut self, v: u32, w: u32) -> [u32; 2] {
        for (from, to) in [(v, w), (w, v)] {
            let [first, second] = &mut self.partners[from as usize];
            *(if *first == NONE { first } else { second }) = to;
        }
        let ends = [v, w].map(|end| self.far_end(end));
        for (end, other) in [(0, 1), (1, 0)] {
            self.far[ends[end] as usize] = ends[other];
        }
        ends
    }

    /// All edges, each once.
    pub(crate) fn pairs(&self) -> impl Iterator<Item = [u32; 2]> + '_ {
        let vertices = (0u32..).take(self.len());
        vertices.flat_map(|v| {
            let up = self.partners(v).filter(move |&w| v < w);
            up.map(move |w| [v, w])
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn paths_know_their_ends() {
        let mut paths = Paths::new(6);
        assert!(paths.is_free(3) && paths.is_end(3));
        assert_eq!((paths.far_end(3), paths.before(3)), (3, None));
        assert_eq!(paths.join(3, 1), [3, 1]);
        assert_eq!(paths.join(4, 5), [4, 5]);
        assert_eq!(paths.join(1, 4), [3, 5]);
        assert!(!paths.is_end(1) && paths.is_end(5) && paths.are_joined(4, 1));
        assert_eq!((paths.far_end(5), paths.before(5)), (3, Some(4)));
        assert_eq!(paths.join(5, 3), [3, 5]);
        let pairs: Vec<_> = paths.pairs().collect();
        assert_eq!(pairs, [[1, 3], [1, 4], [3, 5], [4, 5]]);
    }
}
