//! Whether an algorithm still returns the manifold boundary after a step.

use curvecrust_geometry::{Component, DVec2, EdgeSet, PointSet};
use curvecrust_reconstruct::{HnnCrust, Reconstructor};

use super::chain::{Chains, Place};
use crate::arcs::Arcs;
use crate::condition::DeviationLimit;

/// Distances that differ by less than this fraction of their squares count as equal, and as a
/// failure.
const TIE: f64 = 1.0 + 1e-9;

/// What a sampling has to keep.
pub(crate) struct Oracle<'a> {
    algorithm: &'a dyn Reconstructor,
    limit: DeviationLimit,
    arcs: &'a [Arcs<'a>],
    is_hnn_crust: bool,
}

impl<'a> Oracle<'a> {
    pub(crate) fn new(
        algorithm: &'a dyn Reconstructor,
        limit: DeviationLimit,
        arcs: &'a [Arcs<'a>],
    ) -> Self {
        Self {
            algorithm,
            limit,
            arcs,
            is_hnn_crust: algorithm.info() == HnnCrust::MUTUAL.info(),
        }
    }

    /// Whether samples keep everything, when they did before the `touched` ones of a chain, which
    /// are in a row, were put in the place of others or became neighbours. The dense points in
    /// `added` are new samples.
    pub(crate) fn accepts(
        &self,
        chains: &Chains,
        chain: usize,
        touched: impl Iterator<Item = usize> + Clone,
        added: &[usize],
    ) -> bool {
        self.keeps_limit(chains, chain, touched.clone())
            && if self.is_hnn_crust {
                touched
                    .clone()
                    .all(|at| chooses_its_neighbours(chains, (chain, at)))
                    && added.iter().all(|&x| disturbs_none(chains, x))
            } else {
                self.reconstructs(chains)
            }
    }

    /// Whether the intervals between touched samples keep the limit.
    fn keeps_limit(
        &self,
        chains: &Chains,
        chain: usize,
        mut touched: impl Iterator<Item = usize>,
    ) -> bool {
        let this = &chains.chains[chain];
        let mut last: Option<usize> = None;
        touched.all(|at| {
            let to = this.samples[at];
            let keeps = last.is_none_or(|from| this.keeps(&self.arcs[chain], self.limit, from, to));
            last = Some(to);
            keeps
        })
    }

    fn reconstructs(&self, chains: &Chains) -> bool {
        let points = chains
            .places()
            .map(|(c, at)| chains.point(chains.chains[c].samples[at]));
        let Ok(points) = PointSet::new(points.collect()) else {
            return false;
        };
        let mut edges = Vec::with_capacity(points.len());
        let mut first = 0;
        for chain in &chains.chains {
            let order = Component {
                range: first..first + chain.samples.len(),
                closed: chain.component.closed,
            };
            edges.extend(order.edges());
            first = order.range.end;
        }
        self.algorithm.reconstruct(&points) == EdgeSet::new(first, edges)
    }
}

/// Whether HNN-Crust lets a sample choose its two neighbours on the curve, by a clear margin.
fn chooses_its_neighbours(chains: &Chains, (chain, at): Place) -> bool {
    let this = &chains.chains[chain];
    let dense = this.samples[at];
    let s = chains.point(dense);
    let [before, after] = this.neighbours(at);
    let (Some(before), Some(after)) = (before, after) else {
        return before
            .or(after)
            .is_some_and(|only| is_a_clear_end(chains, dense, only));
    };
    let choice = Choice::new(s, chains.point(before), chains.point(after));
    let others = all(chains).filter(|&q| q != dense && q != before && q != after);
    choice.is_clear() && others.into_iter().all(|q| choice.keeps(chains.point(q)))
}

/// Whether a new sample changes no choice of samples that are not beside it.
fn disturbs_none(chains: &Chains, added: usize) -> bool {
    let x = chains.point(added);
    chains.places().all(|(chain, at)| {
        let this = &chains.chains[chain];
        let dense = this.samples[at];
        match this.neighbours(at) {
            [Some(a), Some(b)] if dense != added && a != added && b != added => {
                Choice::new(chains.point(dense), chains.point(a), chains.point(b)).keeps(x)
            }
            [Some(only), None] | [None, Some(only)] if dense != added && only != added => {
                is_a_clear_end(chains, dense, only)
            }
            _ => true,
        }
    })
}

/// Whether an open end has its neighbour as the nearest sample, and no other open end as the half
/// neighbour: a sample inside a curve does not return the choice.
fn is_a_clear_end(chains: &Chains, end: usize, neighbour: usize) -> bool {
    let (s, n) = (chains.point(end), chains.point(neighbour));
    let nearest = s.distance_squared(n);
    let others = || all(chains).filter(|&q| q != end && q != neighbour);
    let is_nearest = others().all(|q| s.distance_squared(chains.point(q)) > TIE * nearest);
    let in_half_plane = |&q: &usize| {
        let q = chains.point(q);
        s.distance_squared(q) < TIE * n.distance_squared(q)
    };
    let half = others().filter(in_half_plane).min_by(|&p, &q| {
        let by = |q| s.distance_squared(chains.point(q));
        by(p).total_cmp(&by(q))
    });
    let is_end = |q: usize| {
        let open = chains.chains.iter().filter(|c| !c.component.closed);
        open.flat_map(|c| [c.samples.first(), c.samples.last()])
            .any(|end| end == Some(&q))
    };
    is_nearest && !half.is_some_and(is_end)
}

fn all<'a>(chains: &'a Chains<'_>) -> impl Iterator<Item = usize> + Clone + 'a {
    chains.chains.iter().flat_map(|c| c.samples.iter().copied())
}

/// A nearest and a half neighbour.
struct Choice {
    s: DVec2,
    nearest: DVec2,
    half: DVec2,
    /// Squared distances.
    to_nearest: f64,
    to_half: f64,
}

impl Choice {
    fn new(s: DVec2, a: DVec2, b: DVec2) -> Self {
        let (to_a, to_b) = (s.distance_squared(a), s.distance_squared(b));
        let [(to_nearest, nearest), (to_half, half)] = if to_a < to_b {
            [(to_a, a), (to_b, b)]
        } else {
            [(to_b, b), (to_a, a)]
        };
        Self {
            s,
            nearest,
            half,
            to_nearest,
            to_half,
        }
    }

    /// Whether it is one, if there were no other samples. Which of two is nearer does not matter.
    fn is_clear(&self) -> bool {
        TIE * self.to_half < self.half.distance_squared(self.nearest)
    }

    /// Whether it is still the choice when there is another sample.
    fn keeps(&self, q: DVec2) -> bool {
        let to_q = self.s.distance_squared(q);
        to_q > TIE * self.to_nearest
            && (to_q > TIE * self.to_half || to_q > TIE * q.distance_squared(self.nearest))
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::TAU;

    use proptest::prelude::*;

    use super::*;

    /// Chains, and their points: closed ones around a centre, open ones in a row, so close to each
    /// other and so uneven that about half of them are reconstructed.
    fn shaped() -> impl Strategy<Value = (Vec<(usize, bool)>, Vec<DVec2>)> {
        let uneven = prop::array::uniform2(-1.0..1.0);
        let chain = (any::<bool>(), prop::collection::vec(uneven, 3..7));
        let place = prop::array::uniform2(-2.0..2.0).prop_map(DVec2::from);
        prop::collection::vec((place, chain), 1..3).prop_map(|chains| {
            let shape = chains.iter().map(|(_, (closed, of))| (of.len(), *closed));
            let points = chains.iter().flat_map(|(place, (closed, of))| {
                let (closed, count) = (*closed, of.len() as f64);
                let point = move |(i, &[x, y]): (usize, &[f64; 2])| {
                    if closed {
                        let angle = (i as f64 + 0.3 * x) * TAU / count;
                        DVec2::from_angle(angle) * (1.0 + 0.3 * y)
                    } else {
                        DVec2::new(i as f64 + 0.5 * x, 0.5 * y)
                    }
                };
                of.iter().enumerate().map(move |at| *place + point(at))
            });
            (shape.collect(), points.collect())
        })
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(4_000))]

        /// An open end that chooses its neighbour only as the half neighbour is refused, though it
        /// may be joined.
        #[test]
        fn choices_are_those_of_hnn_crust(
            (shape, points) in shaped()
        ) {
            let chains = Chains::of_samples(&points, &shape);
            let all_choose = chains.places().all(|place| chooses_its_neighbours(&chains, place));
            let full = Oracle::new(&HnnCrust::MUTUAL, DeviationLimit::None, &[]);
            let found = full.reconstructs(&chains);
            if shape.iter().all(|&(_, closed)| closed) {
                prop_assert_eq!(all_choose, found);
            } else {
                prop_assert!(found || !all_choose);
            }
        }

        #[test]
        fn a_sample_disturbs_what_chooses_it(
            (shape, points) in shaped()
        ) {
            // The last sample is added.
            let chains = Chains::of_samples(&points, &shape);
            let added = points.len() - 1;
            let last = shape.len() - 1;
            let mut fewer = shape.clone();
            fewer[last].0 -= 1;
            let before = Chains::of_samples(&points[..added], &fewer);
            let is_beside = |(chain, at): Place| {
                let this = &chains.chains[chain];
                this.samples[at] == added || this.neighbours(at).contains(&Some(added))
            };
            let others = || chains.places().filter(|&place| !is_beside(place));
            let choose = |chains: &Chains| others().all(|place| chooses_its_neighbours(chains, place));
            // Those whose neighbours are the same with and without it.
            if choose(&before) {
                prop_assert_eq!(disturbs_none(&chains, added), choose(&chains));
            }
        }
    }

    #[test]
    fn ends_that_face_each_other_are_not_clear() {
        let at = |x: f64, y: f64| DVec2::new(x, y);
        // The ends see each other on the far side, at whatever distance.
        for gap in [0.9, 1.5, 3.0] {
            let points = [0.0, 1.0, 1.0 + gap, 2.0 + gap].map(|x| at(x, 0.0));
            let chains = Chains::of_samples(&points, &[(2, false), (2, false)]);
            assert!(!is_a_clear_end(&chains, 1, 0), "{gap}");
        }
        // A sample inside an open curve, or of a closed one, does not return the choice.
        let beyond = [
            at(0.0, 0.0),
            at(1.0, 0.0),
            at(3.0, 4.0),
            at(3.0, 0.0),
            at(3.0, -4.0),
        ];
        for closed in [true, false] {
            let chains = Chains::of_samples(&beyond, &[(2, false), (3, closed)]);
            assert!(is_a_clear_end(&chains, 1, 0));
        }
        // But it must not be the nearest.
        let near = beyond.map(|p| if p.x > 1.0 { p - at(1.5, 0.0) } else { p });
        let chains = Chains::of_samples(&near, &[(2, false), (3, true)]);
        assert!(!is_a_clear_end(&chains, 1, 0));
    }

    #[test]
    fn ties_are_no_choice_at_any_scale() {
        for scale in [1e-9, 1.0, 1e9] {
            let at = |x: f64, y: f64| scale * DVec2::new(x, y);
            let choice = Choice::new(at(0.0, 0.0), at(2.0, 0.0), at(-3.0, 0.0));
            assert!(choice.is_clear());
            // As near as the nearest; nearer; farther, on either side.
            assert!(!choice.keeps(at(0.0, 2.0)) && !choice.keeps(at(0.0, -1.0)));
            assert!(!choice.keeps(at(0.0, 2.5)) && choice.keeps(at(2.5, 0.0)));
            // As near as the half neighbour, which is in the half-plane; farther.
            assert!(!choice.keeps(at(0.0, 3.0)) && choice.keeps(at(0.0, 3.1)));
            // As far from the nearest as from here.
            assert!(!choice.keeps(at(1.0, 2.0)) && choice.keeps(at(1.1, 2.0)));
            assert!(!choice.keeps(at(0.9, 2.0)));
            // Its neighbours as far from each other as the half neighbour is.
            let height = 3.0 * 0.75f64.sqrt();
            assert!(!Choice::new(at(0.0, 0.0), at(3.0, 0.0), at(1.5, height)).is_clear());
            assert!(Choice::new(at(0.0, 0.0), at(3.0, 0.0), at(1.4, height)).is_clear());
            assert!(!Choice::new(at(0.0, 0.0), at(3.0, 0.0), at(1.6, height)).is_clear());
        }
    }
}
