//! Sets of points whose prices change together.

use super::one_tree::Link;
use crate::clusters::Clusters;

/// The sets that Kruskal's algorithm makes on its way to a minimum spanning tree: each point by
/// itself, and all that an edge joins.
///
/// M. Jünger, W. R. Pulleyblank, "Geometric Duality and Combinatorial Optimization", Jahrbuch
/// Überblicke Mathematik, 1993: around each set lies a moat. It is as wide as the edge that joins
/// the set to another is longer than the edge that made it, so that clusters have wide ones. Before
/// a 1-tree leaves a cluster by two edges, its points must change their prices by about that much,
/// all of them. That takes very many steps if each point goes by its own edges alone.
pub(crate) struct Moats {
    /// The set that each is joined to, which comes later; the set itself if there is none. Points
    /// come first.
    above: Vec<usize>,
    width: Vec<f64>,
    /// What was last spread, for each set.
    spread: Vec<f64>,
}

impl Moats {
    /// Of so many points and the edges between them.
    pub(crate) fn new(count: usize, links: &[Link]) -> Self {
        let mut order: Vec<&Link> = links.iter().collect();
        order.sort_unstable_by(|e, f| {
            let lengths = e.length.total_cmp(&f.length);
            lengths.then(e.ends.cmp(&f.ends))
        });
        let mut above: Vec<usize> = (0..count).collect();
        let mut clusters = Clusters::new(count);
        // The set of each cluster, by the point that names it.
        let mut sets = above.clone();
        // The length of the edge that made each set.
        let mut made = vec![0.0; count];
        for link in order {
            let [v, w] = link.ends;
            let parts = [v, w].map(|v| sets[clusters.name(v) as usize]);
            if clusters.join(v, w) {
                let set = above.len();
                for part in parts {
                    above[part] = set;
                }
                above.push(set);
                sets[clusters.name(v) as usize] = set;
                made.push(link.length);
            }
        }
        let width = above.iter().zip(&made).map(|(&set, own)| made[set] - own);
        Self {
            width: width.collect(),
            spread: vec![0.0; above.len()],
            above,
        }
    }

    /// A value of each set is the sum of those of its points. Returned is for each point the sum of
    /// width times value over all its sets; and that of width times squared value over all sets.
    pub(crate) fn spread(&mut self, values: &[f64]) -> (&[f64], f64) {
        let spread = &mut self.spread;
        spread.fill(0.0);
        spread[..values.len()].copy_from_slice(values);
        let mut squares = 0.0;
        for (set, (&above, width)) in self.above.iter().zip(&self.width).enumerate() {
            let value = spread[set];
            squares += width * value * value;
            if above != set {
                spread[above] += value;
            }
        }
        for (set, (&above, width)) in self.above.iter().zip(&self.width).enumerate().rev() {
            spread[set] *= width;
            if above != set {
                spread[set] += spread[above];
            }
        }
        (&spread[..values.len()], squares)
    }
}
