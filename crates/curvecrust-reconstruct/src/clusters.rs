//! Clusters of points: disjoint sets, as of R. E. Tarjan, "Efficiency of a Good But Not Linear Set
//! Union Algorithm", Journal of the ACM 22(2), 1975.

/// A partition of points.
pub(crate) struct Clusters {
    /// Another point of the cluster, or the point itself if it names the cluster.
    parents: Vec<u32>,
}

impl Clusters {
    /// Every point alone.
    pub(crate) fn new(points: usize) -> Self {
        Self {
            parents: (0u32..).take(points).collect(),
        }
    }

    /// Makes the clusters of two points one; whether they were two.
    pub(crate) fn join(&mut self, v: u32, w: u32) -> bool {
        let [v, w] = [v, w].map(|id| self.name(id));
        self.parents[v.max(w) as usize] = v.min(w);
        v != w
    }

    /// The point that names the cluster.
    pub(crate) fn name(&mut self, v: u32) -> u32 {
        let mut at = v;
        loop {
            let parent = self.parents[at as usize];
            if parent == at {
                return at;
            }
            let grandparent = self.parents[parent as usize];
            self.parents[at as usize] = grandparent;
            at = grandparent;
        }
    }
}
