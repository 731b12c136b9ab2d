//! A proof that a tour is the shortest: M. Held, R. M. Karp, "The Traveling-Salesman Problem and
//! Minimum Spanning Trees: Part II", Mathematical Programming 1, 1971.
//!
//! Let every point have a price, and an edge cost its length and the prices of both ends. Every
//! tour then costs its length and twice all prices, so the cheapest tour is the shortest. A 1-tree
//! is a spanning tree of all points but the first, and two edges at the first; a tour is one. So if
//! the cheapest 1-tree is a tour, it is the shortest tour. The prices rise where the cheapest
//! 1-tree has more than two edges, and fall where it has less.

use curvecrust_geometry::{DVec2, EdgeSet};

/// How many times the prices are changed.
const ROUNDS: usize = 3_000;

/// After this many rounds without a better bound, steps are halved.
const PATIENCE: usize = 30;

/// How much of the last direction is kept, so that prices do not swing.
const MEMORY: f64 = 0.3;

/// What counts as equally long, as a share of the tour.
const ROUNDING: f64 = 1e-12;

/// Whether a tour through the points, of which there are three or more, is proven to be the
/// shortest.
pub(crate) fn proves(points: &[DVec2], tour: &EdgeSet) -> bool {
    let lengths = tour.edges().iter().map(|edge| {
        let [p, q] = edge.ends().map(|id| points[id.index()]);
        p.distance(q)
    });
    let length: f64 = lengths.sum();
    let mut prices = vec![0.0; points.len()];
    let mut excess = vec![0.0; points.len()];
    let (mut best, mut best_prices) = (0.0, prices.clone());
    let (mut waited, mut share) = (0, 1.0);
    for _ in 0..ROUNDS {
        let tree = OneTree::cheapest(points, &prices);
        if tree.degrees.iter().all(|&degree| degree == 2) {
            return length <= tree.length * (1.0 + ROUNDING);
        }
        let bound = tree.cost - 2.0 * prices.iter().sum::<f64>();
        if bound > best {
            (best, waited) = (bound, 0);
            best_prices.clone_from(&prices);
        } else {
            waited += 1;
            if waited == PATIENCE {
                (waited, share) = (0, share / 2.0);
                prices.clone_from(&best_prices);
            }
        }
        for (excess, &degree) in excess.iter_mut().zip(&tree.degrees) {
            *excess = MEMORY * *excess + (1.0 - MEMORY) * (f64::from(degree) - 2.0);
        }
        let squares: f64 = excess.iter().map(|x| x * x).sum();
        let step = share * (1.001 * length - bound).max(0.0) / squares;
        for (price, excess) in prices.iter_mut().zip(&excess) {
            *price += step * excess;
        }
    }
    false
}

struct OneTree {
    degrees: Vec<u32>,
    length: f64,
    /// The length, and the prices of the ends of all edges.
    cost: f64,
}

impl OneTree {
    /// By Prim's algorithm on all pairs.
    fn cheapest(points: &[DVec2], prices: &[f64]) -> Self {
        let count = points.len();
        let cost = |v: usize, w: usize| points[v].distance(points[w]) + prices[v] + prices[w];
        let mut tree = Self {
            degrees: vec![0; count],
            length: 0.0,
            cost: 0.0,
        };
        let mut add = |v: usize, w: usize| {
            tree.degrees[v] += 1;
            tree.degrees[w] += 1;
            tree.length += points[v].distance(points[w]);
            tree.cost += cost(v, w);
        };
        // Of every point outside of the tree the cheapest edge to it.
        let mut nearest: Vec<(f64, usize)> = (0..count).map(|v| (cost(1, v), 1)).collect();
        let mut outside: Vec<usize> = (2..count).collect();
        while let Some(place) = cheapest(outside.iter().map(|&v| nearest[v].0)) {
            let v = outside.swap_remove(place);
            add(nearest[v].1, v);
            for &w in &outside {
                let further = cost(v, w);
                if further < nearest[w].0 {
                    nearest[w] = (further, v);
                }
            }
        }
        let first = cheapest((1..count).map(|v| cost(0, v))).map_or(1, |place| place + 1);
        let others = || (1..count).filter(|&v| v != first);
        let second = cheapest(others().map(|v| cost(0, v))).and_then(|place| others().nth(place));
        add(0, first);
        add(0, second.unwrap_or(first));
        tree
    }
}

/// The place of the least number.
fn cheapest(costs: impl Iterator<Item = f64>) -> Option<usize> {
    let least = costs.enumerate().min_by(|a, b| a.1.total_cmp(&b.1));
    least.map(|(place, _)| place)
}
