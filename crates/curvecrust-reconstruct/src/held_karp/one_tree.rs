//! Cheapest 1-trees of a graph whose points have prices.

use curvecrust_geometry::DVec2;

/// An edge that a tour may have.
#[derive(Clone, Copy)]
pub(crate) struct Link {
    pub(crate) ends: [u32; 2],
    pub(crate) length: f64,
    /// Whether it must be in every 1-tree.
    pub(crate) is_required: bool,
}

impl Link {
    pub(crate) fn new(points: &[DVec2], [v, w]: [u32; 2]) -> Self {
        let ends = [v.min(w), v.max(w)];
        let [p, q] = ends.map(|v| points[v as usize]);
        Self {
            ends,
            length: p.distance(q),
            is_required: false,
        }
    }

    /// What it costs: its length and the prices of its ends.
    pub(crate) fn cost(&self, prices: &[f64]) -> f64 {
        let [p, q] = self.ends.map(|v| prices[v as usize]);
        self.length + p + q
    }
}

/// The cheapest 1-tree: a spanning tree of all points but the first, and two edges at the first.
///
/// The tree is that of Kruskal. Its sets of joined points are a forest in which the smaller set
/// hangs below the larger, so that a path to a root has at most log2(n) steps; and each step has
/// the cost of the edge that joined the sets, which grow towards the root. So the forest also tells
/// the most expensive edge on the path between two points of the tree.
#[derive(Default)]
pub(crate) struct OneTree {
    /// How many of its edges are at each point.
    pub(crate) degrees: Vec<u32>,
    /// The indices of its edges.
    pub(crate) links: Vec<u32>,
    /// The sum of its lengths.
    pub(crate) length: f64,
    /// The least cost of a tour: that of the 1-tree less twice all prices.
    pub(crate) bound: f64,
    /// Whether it has as many edges as there are points, all required ones among them.
    pub(crate) is_whole: bool,
    parent: Vec<u32>,
    size: Vec<u32>,
    /// The cost of the edge that joined a set to the parent's.
    step: Vec<f64>,
    /// The costs of the two edges at the first point.
    at_first: [f64; 2],
    /// The costs and indices of all edges, the cheapest first.
    order: Vec<(f64, u32)>,
}

impl OneTree {
    /// Makes it the cheapest one for these prices.
    pub(crate) fn find(&mut self, links: &[Link], prices: &[f64]) {
        self.clear(prices.len());
        let mut order = std::mem::take(&mut self.order);
        order.clear();
        order.extend((0u32..).zip(links).map(|(i, link)| {
            let least = f64::NEG_INFINITY;
            let is_free = !link.is_required;
            (if is_free { link.cost(prices) } else { least }, i)
        }));
        order.sort_unstable_by(|e, f| e.0.total_cmp(&f.0).then(e.1.cmp(&f.1)));
        let (mut cost, mut at_first, mut fits) = (0.0, 0, true);
        for &(key, i) in &order {
            let link = &links[i as usize];
            let is_taken = if link.ends.contains(&0) {
                if let Some(slot) = self.at_first.get_mut(at_first) {
                    *slot = key;
                }
                at_first += 1;
                at_first <= 2
            } else {
                self.unite(link.ends, key)
            };
            if is_taken {
                self.links.push(i);
                self.length += link.length;
                cost += link.cost(prices);
                for v in link.ends {
                    self.degrees[v as usize] += 1;
                }
            } else {
                fits &= !link.is_required;
            }
        }
        self.order = order;
        self.bound = cost - 2.0 * prices.iter().sum::<f64>();
        self.is_whole = fits && self.links.len() == prices.len();
    }

    fn clear(&mut self, count: usize) {
        self.degrees.clear();
        self.degrees.resize(count, 0);
        self.parent.clear();
        self.parent.extend((0u32..).take(count));
        self.size.clear();
        self.size.resize(count, 1);
        self.step.clear();
        self.step.resize(count, f64::INFINITY);
        self.at_first = [f64::INFINITY; 2];
        self.links.clear();
        self.length = 0.0;
    }

    fn root(&self, mut v: u32) -> u32 {
        while self.parent[v as usize] != v {
            v = self.parent[v as usize];
        }
        v
    }

    /// Joins the sets of two points, if they are apart.
    fn unite(&mut self, ends: [u32; 2], cost: f64) -> bool {
        let [mut low, mut high] = ends.map(|v| self.root(v));
        if low == high {
            return false;
        }
        if self.size[low as usize] > self.size[high as usize] {
            std::mem::swap(&mut low, &mut high);
        }
        self.parent[low as usize] = high;
        self.step[low as usize] = cost;
        self.size[high as usize] += self.size[low as usize];
        true
    }

    /// Whether it is a tour, and so the cheapest one.
    pub(crate) fn is_tour(&self) -> bool {
        self.is_whole && self.degrees.iter().all(|&degree| degree == 2)
    }

    /// The edge that an edge between two points, if it has to be in the 1-tree, replaces: its cost.
    pub(crate) fn replaced(&self, [mut v, mut w]: [u32; 2]) -> f64 {
        if v == 0 || w == 0 {
            return self.at_first[1];
        }
        let mut most = f64::NEG_INFINITY;
        while v != w {
            if self.step[v as usize] > self.step[w as usize] {
                std::mem::swap(&mut v, &mut w);
            }
            most = self.step[v as usize];
            v = self.parent[v as usize];
        }
        most
    }
}
