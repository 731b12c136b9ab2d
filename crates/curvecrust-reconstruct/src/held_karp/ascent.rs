//! Prices for which the cheapest 1-tree costs much.

use super::moats::Moats;
use super::one_tree::{Link, OneTree};

/// How much of the last direction is kept, so that prices do not swing.
const MEMORY: f64 = 0.3;

/// Prices that rise where the cheapest 1-tree has more than two edges and fall where it has less:
/// steps of a subgradient method. M. Held, P. Wolfe, H. P. Crowder, "Validation of Subgradient
/// Optimization", Mathematical Programming 6, 1974. Whole clusters change their prices too, each
/// the more the wider its moat is ([`Moats`]).
pub(crate) struct Ascent {
    prices: Vec<f64>,
    best: f64,
    best_prices: Vec<f64>,
    excess: Vec<f64>,
    moats: Moats,
    tree: OneTree,
}

impl Ascent {
    /// From these prices, one for each point, with moats of these edges.
    pub(crate) fn new(prices: Vec<f64>, links: &[Link]) -> Self {
        let count = prices.len();
        Self {
            best: f64::NEG_INFINITY,
            best_prices: prices.clone(),
            excess: vec![0.0; count],
            moats: Moats::new(count, links),
            tree: OneTree::default(),
            prices,
        }
    }

    /// The cheapest 1-tree at the present prices, which are changed.
    ///
    /// With a `share` of 1 the step would reach a bound that is the length of a tour if the bound
    /// went on to grow as it does here.
    pub(crate) fn step(&mut self, links: &[Link], length: f64, share: f64) -> &OneTree {
        self.tree.find(links, &self.prices);
        let bound = self.tree.bound;
        if bound > self.best {
            self.best = bound;
            self.best_prices.clone_from(&self.prices);
        }
        for (excess, &degree) in self.excess.iter_mut().zip(&self.tree.degrees) {
            *excess = MEMORY * *excess + (1.0 - MEMORY) * (f64::from(degree) - 2.0);
        }
        let (spread, squares) = self.moats.spread(&self.excess);
        if squares > 0.0 {
            let step = share * (1.001 * length - bound).max(0.0) / squares;
            for (price, spread) in self.prices.iter_mut().zip(spread) {
                *price += step * spread;
            }
        }
        &self.tree
    }

    /// Goes back to the prices of the greatest bound: these and the cheapest 1-tree there.
    pub(crate) fn best(&mut self, links: &[Link]) -> (&[f64], &OneTree) {
        self.prices.clone_from(&self.best_prices);
        self.excess.fill(0.0);
        self.tree.find(links, &self.prices);
        self.best = self.tree.bound;
        (&self.prices, &self.tree)
    }
}
