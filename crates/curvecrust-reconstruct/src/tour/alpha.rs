//! The pairs of points that are joined in nearly cheapest 1-trees.
//!
//! K. Helsgaun, "An effective implementation of the Lin-Kernighan traveling salesman heuristic",
//! European Journal of Operational Research 126, 2000: the alpha-value of an edge is what the
//! cheapest 1-tree costs more if it must have that edge, at prices of the points for which 1-trees
//! are nearly tours. The edges of the shortest tour mostly are among those of least alpha-value at
//! each point, much more so than among the shortest.

use curvecrust_geometry::PointSet;

use super::near::Near;
use crate::held_karp::Ascent;

/// So many times the prices are changed: the most, and the least, which are done for many points;
/// between them rounds times points are [`WORK`].
const MOST_ROUNDS: usize = 100;
const LEAST_ROUNDS: usize = 40;
const WORK: usize = 4_000_000;

/// The steps fall from 1 to this share.
const LAST_STEP: f64 = 0.002;

/// So many points are tried at each.
const TRIED: usize = 6;

/// Candidates, prices, and a bound that the shortest tour of them keeps.
pub(super) struct Alpha {
    /// For every point those of the near ones whose edges have the least alpha-values, the least
    /// first.
    pub(super) near: Near,
    /// The prices of the points.
    pub(super) prices: Vec<f64>,
    /// No tour of the near edges is shorter.
    pub(super) bound: f64,
}

impl Alpha {
    /// Of the near points, where a tour of some length is known.
    pub(super) fn new(points: &PointSet, near: &Near, length: f64) -> Self {
        let links = near.links(points.points());
        let mut ascent = Ascent::new(vec![0.0; points.len()], &links);
        let rounds = (WORK / points.len().max(1)).clamp(LEAST_ROUNDS, MOST_ROUNDS);
        for round in 0..rounds {
            let share = libm::pow(LAST_STEP, round as f64 / rounds as f64);
            if ascent.step(&links, length, share).is_tour() {
                break;
            }
        }
        let (prices, tree) = ascent.best(&links);
        let mut lists = vec![Vec::new(); points.len()];
        for link in &links {
            let alpha = (link.cost(prices) - tree.replaced(link.ends)).max(0.0);
            let [v, w] = link.ends;
            lists[v as usize].push((alpha, link.length, w));
            lists[w as usize].push((alpha, link.length, v));
        }
        let least = |mut list: Vec<(f64, f64, u32)>| {
            list.sort_unstable_by(|e, f| {
                let alphas = e.0.total_cmp(&f.0);
                alphas.then(e.1.total_cmp(&f.1)).then(e.2.cmp(&f.2))
            });
            list.truncate(TRIED);
            list.into_iter().map(|(_, _, w)| w).collect()
        };
        let lists: Vec<Vec<u32>> = lists.into_iter().map(least).collect();
        Self {
            near: Near::of_own(&lists),
            prices: prices.to_vec(),
            bound: tree.bound,
        }
    }
}
