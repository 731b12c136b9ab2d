//! What it costs, at best, to complete a point that has one edge.

use rayon::prelude::*;

use super::candidates::Candidates;
use super::matching::Matching;

/// Points that make a task.
const TASK: usize = 1 << 10;

/// For every point that is not saturated and every candidate of it, as if it were the only partner:
/// the least that the other end costs, free or with another candidate. An edge counts for half,
/// since it belongs to both of its ends.
pub(super) struct Completions {
    /// In the order of the candidates.
    least: Vec<f64>,
}

impl Completions {
    pub(super) fn new(points: usize, candidates: &Candidates, matching: &Matching<'_>) -> Self {
        let at = |v: u32| {
            let others = candidates.of(v);
            let least_with = |&p: &u32| {
                let second = |&q: &u32| matching.bend(v, p, q) + 0.5 * matching.edge_cost(v, q);
                let seconds = others.iter().filter(|&&q| q != p).map(second);
                seconds.fold(matching.penalty(v), f64::min)
            };
            if matching.is_saturated(v) {
                vec![0.0; others.len()]
            } else {
                others.iter().map(least_with).collect()
            }
        };
        let points: Vec<u32> = (0u32..).take(points).collect();
        let least = points.into_par_iter().with_min_len(TASK).flat_map_iter(at);
        Self {
            least: least.collect(),
        }
    }

    /// The least for the point `v` with the partner `p`.
    pub(super) fn least(&self, candidates: &Candidates, v: u32, p: u32) -> f64 {
        let place = candidates.of(v).iter().position(|&q| q == p);
        place.map_or(0.0, |place| self.least[candidates.first_of(v) + place])
    }
}
