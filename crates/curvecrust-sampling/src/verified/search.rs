//! Local search: steps that remove, merge or move samples.

use curvecrust_geometry::Random;

use super::chain::{Chains, Place};
use super::oracle::Oracle;

/// Places between two samples at which a new one is tried.
const TRIES: usize = 24;
/// Random places that are tried for a sample when samples are perturbed.
const PLACES: usize = 3;

/// A sampling that the oracle accepts, and the steps from it to others.
pub(crate) struct Search<'a> {
    chains: Chains<'a>,
    oracle: Oracle<'a>,
    random: Random,
}

impl<'a> Search<'a> {
    pub(crate) fn new(chains: Chains<'a>, oracle: Oracle<'a>, seed: u64) -> Self {
        Self {
            chains,
            oracle,
            random: Random::new(seed),
        }
    }

    pub(crate) fn chains(&self) -> &Chains<'a> {
        &self.chains
    }

    /// Removes single samples, and merges two into one, until neither goes any more.
    pub(crate) fn shrink(&mut self) {
        loop {
            let mut order = self.order();
            let mut shrunk = false;
            while let Some((chain, at)) = order.pop() {
                if self.replace(chain, at, 1, None) || self.merge(chain, at) {
                    shrunk = true;
                    // Where a chain begins elsewhere now, this is another random order.
                    let moved = |p: &mut Place| {
                        if p.0 == chain && p.1 > at {
                            p.1 -= 1;
                        }
                    };
                    order.iter_mut().for_each(moved);
                }
            }
            if !shrunk {
                return;
            }
        }
    }

    /// Moves every sample along the curve to a random place between its neighbours, if that is
    /// accepted.
    pub(crate) fn perturb(&mut self) {
        for (chain, at) in self.order() {
            for _ in 0..PLACES {
                let share = self.random.fine_between(0.0, 1.0);
                let Some((from, room)) = self.room(chain, at, 1) else {
                    break;
                };
                let by = 1 + portion(room, share);
                let place = self.chains.chains[chain].component.after(from, by);
                if self.replace(chain, at, 1, Some(place)) {
                    break;
                }
            }
        }
    }

    /// Replaces a sample and the next by one between them and their neighbours.
    fn merge(&mut self, chain: usize, at: usize) -> bool {
        let Some((from, room)) = self.room(chain, at, 2) else {
            return false;
        };
        let shift = self.random.fine_between(0.0, 1.0);
        (0..TRIES).any(|i| {
            let by = 1 + portion(room, (i as f64 + shift) / TRIES as f64);
            let place = self.chains.chains[chain].component.after(from, by);
            self.replace(chain, at, 2, Some(place))
        })
    }

    /// The sample before `count` in a row, and the number of dense points from it to the one after
    /// them; `None` where an open end or a sample that stays is in the way.
    fn room(&self, chain: usize, at: usize, count: usize) -> Option<(usize, usize)> {
        let this = &self.chains.chains[chain];
        let len = this.samples.len();
        if at + count > len && !this.component.closed {
            return None;
        }
        let last = this.order().after(at, count - 1);
        let mut row = (0..count).map(|steps| this.samples[this.order().after(at, steps)]);
        if row.any(|sample| self.chains.is_fixed(sample)) {
            return None;
        }
        let (before, after) = (this.neighbours(at)[0]?, this.neighbours(last)[1]?);
        Some((before, this.between(before, after)))
    }

    /// Puts one sample or none in the place of `count` in a row, if that is accepted. Where the row
    /// runs over the seam of a closed chain, that chain begins elsewhere afterwards.
    fn replace(&mut self, chain: usize, at: usize, count: usize, by: Option<usize>) -> bool {
        let added = usize::from(by.is_some());
        let this = &self.chains.chains[chain];
        let enough = this.samples.len() + added >= this.least() + count;
        if !enough || self.room(chain, at, count).is_none() {
            return false;
        }
        let samples = &mut self.chains.chains[chain].samples;
        let before = samples.clone();
        let over = (at + count).saturating_sub(samples.len());
        samples.rotate_left(over);
        let first = at - over;
        samples.splice(first..first + count, by);
        let len = samples.len();
        let touched = (0..added + 2).map(|i| (first + len - 1 + i) % len);
        let accepted = self
            .oracle
            .accepts(&self.chains, chain, touched, by.as_slice());
        if !accepted {
            self.chains.chains[chain].samples = before;
        }
        accepted
    }

    /// Every sample, in random order.
    fn order(&mut self) -> Vec<Place> {
        let mut order: Vec<Place> = self.chains.places().collect();
        for i in (1..order.len()).rev() {
            let j = portion(i + 1, self.random.fine_between(0.0, 1.0));
            order.swap(i, j);
        }
        order
    }
}

/// The index in 0..count at a share of the count.
fn portion(count: usize, share: f64) -> usize {
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "from 0 to count"
    )]
    let part = (share * count as f64) as usize;
    part.min(count.saturating_sub(1))
}
