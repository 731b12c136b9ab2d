//! The samples of all components, which the search changes.

use std::ops::Range;

use curvecrust_geometry::{Component, DVec2};
use curvecrust_medial_axis::MeasuredCurve;

use crate::arcs::Arcs;
use crate::condition::DeviationLimit;
use crate::placed::PlacedSamples;
use crate::sampled_curve::SampledCurve;

/// The samples of a component, by the dense points that they are.
#[derive(Clone, Debug)]
pub(crate) struct Chain {
    /// Ascending, but for one place where a closed chain passes the first dense point.
    pub(crate) samples: Vec<usize>,
    /// The dense points.
    pub(crate) component: Component,
}

/// A sample: index of its chain, and of itself there.
pub(crate) type Place = (usize, usize);

/// The samples of all components.
#[derive(Clone, Debug)]
pub(crate) struct Chains<'a> {
    points: &'a [DVec2],
    /// Dense points that stay samples, ascending.
    fixed: Vec<usize>,
    pub(crate) chains: Vec<Chain>,
}

impl Chain {
    /// The samples before and after one; an open end has one of them.
    pub(crate) fn neighbours(&self, at: usize) -> [Option<usize>; 2] {
        let order = self.order();
        [order.previous(at), order.next(at)].map(|at| at.map(|at| self.samples[at]))
    }

    /// The samples by their index in the chain.
    pub(crate) fn order(&self) -> Component {
        Component {
            range: 0..self.samples.len(),
            closed: self.component.closed,
        }
    }

    /// The fewest samples that make a chain.
    pub(crate) fn least(&self) -> usize {
        if self.component.closed { 3 } else { 2 }
    }

    /// The dense points strictly between two.
    pub(crate) fn between(&self, from: usize, to: usize) -> usize {
        self.component.steps(from, to) - 1
    }

    /// Whether the curve between two samples keeps the limit.
    pub(crate) fn keeps(&self, arcs: &Arcs, limit: DeviationLimit, from: usize, to: usize) -> bool {
        let first = from - self.component.range.start;
        arcs.keeps(limit, first, first + self.component.steps(from, to))
    }
}

impl<'a> Chains<'a> {
    /// The samples, of which those at the given places stay.
    pub(crate) fn new(
        measured: &'a MeasuredCurve,
        placed: &PlacedSamples,
        fixed: &[DVec2],
    ) -> Self {
        let components = measured.dense().components().iter();
        let chain = |(component, samples): (&Component, Range<usize>)| Chain {
            samples: placed.placements()[samples]
                .iter()
                .map(|p| p.dense)
                .collect(),
            component: component.clone(),
        };
        let ranges = placed.components().iter().cloned();
        let fixed = placed
            .placements()
            .iter()
            .filter(|p| fixed.contains(&p.point));
        let mut fixed: Vec<usize> = fixed.map(|p| p.dense).collect();
        fixed.sort_unstable();
        Self {
            points: measured.dense().points(),
            fixed,
            chains: components.zip(ranges).map(chain).collect(),
        }
    }

    /// Every point a sample, from one chain after the other, each with its number of points.
    #[cfg(test)]
    pub(crate) fn of_samples(points: &'a [DVec2], chains: &[(usize, bool)]) -> Self {
        let mut start = 0;
        let chain = |&(count, closed): &(usize, bool)| {
            let range = start..start + count;
            start = range.end;
            Chain {
                samples: range.clone().collect(),
                component: Component { range, closed },
            }
        };
        let chains = chains.iter().map(chain).collect();
        Self {
            points,
            fixed: Vec::new(),
            chains,
        }
    }

    pub(crate) fn len(&self) -> usize {
        self.chains.iter().map(|chain| chain.samples.len()).sum()
    }

    /// Whether a dense point stays a sample.
    pub(crate) fn is_fixed(&self, dense: usize) -> bool {
        self.fixed.binary_search(&dense).is_ok()
    }

    pub(crate) fn point(&self, dense: usize) -> DVec2 {
        self.points[dense]
    }

    /// Every sample.
    pub(crate) fn places(&self) -> impl Iterator<Item = Place> + '_ {
        let chains = self.chains.iter().enumerate();
        chains.flat_map(|(chain, c)| (0..c.samples.len()).map(move |at| (chain, at)))
    }

    /// A component and its sample after which the curve is beyond the limit.
    pub(crate) fn beyond(&self, arcs: &[Arcs], limit: DeviationLimit) -> Option<(usize, usize)> {
        self.places().find_map(|(chain, at)| {
            let this = &self.chains[chain];
            let (from, to) = (this.samples[at], this.neighbours(at)[1]?);
            (!this.keeps(&arcs[chain], limit, from, to)).then_some((chain, from))
        })
    }

    pub(crate) fn sampled(&self, measured: &MeasuredCurve) -> SampledCurve {
        let mut sampled = SampledCurve::default();
        for chain in &self.chains {
            let mut samples = chain.samples.clone();
            samples.sort_unstable();
            sampled.push_component(
                measured.dense(),
                samples.into_iter(),
                chain.component.closed,
            );
        }
        sampled
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn chain(closed: bool, samples: &[usize]) -> Chain {
        Chain {
            samples: samples.to_vec(),
            component: Component {
                range: 10..30,
                closed,
            },
        }
    }

    #[test]
    fn closed_chains_go_on_behind_their_last_point() {
        let (closed, open) = (chain(true, &[25, 12, 19]), chain(false, &[10, 14, 29]));
        let ends = [Some(25), Some(12), Some(19)];
        for at in 0..3 {
            let [before, after] = [ends[(at + 2) % 3], ends[(at + 1) % 3]];
            assert_eq!(closed.neighbours(at), [before, after]);
        }
        assert_eq!(open.neighbours(0), [None, Some(14)]);
        assert_eq!(open.neighbours(1), [Some(10), Some(29)]);
        assert_eq!(open.neighbours(2), [Some(14), None]);
        for (from, to, between) in [
            (12, 19, 6),
            (12, 13, 0),
            (25, 12, 6),
            (29, 10, 0),
            (12, 12, 19),
        ] {
            assert_eq!(closed.between(from, to), between);
            // One point after the last of them is the other sample.
            assert_eq!(closed.component.after(from, between + 1), to);
        }
    }
}
