//! The order of insertion.
//!
//! N. Amenta, S. Choi, G. Rote, *Incremental constructions con BRIO*, SoCG 2003: rounds of growing
//! size, each a random subset of what is left, keep randomised incremental construction optimal in
//! expectation; inside a round any order may be taken, so one that is kind to the walk and the
//! cache: along the Hilbert curve.
//!
//! Here a round is eight times the one before, and of every eight points in a row along the curve
//! just one is left to earlier rounds. Most insertions then happen next to the last one, where
//! vertices and edges are at hand: on a million points this is half again as fast as rounds that
//! double, and as fast as any other factor from 4 to 32.

use curvecrust_geometry::{PointId, PointSet, Random};

/// Rounds of this size are not divided: there is nothing to gain among so few points.
const FIRST_ROUND: usize = 256;

/// How many times the round before a round is.
const GROWTH: usize = 8;

/// A biased randomised insertion order: every id once.
///
/// The order depends on the coordinates alone, not on the order of the points, so that what is
/// built from it does not either; and it stays the same when the points are scaled by a power of
/// two or shifted exactly. The randomness has a fixed seed. Cost: O(n log n).
#[must_use]
pub fn brio_order(points: &PointSet) -> Vec<PointId> {
    let mut earlier = points.hilbert_order().to_vec();
    let mut rounds = Vec::new();
    let mut groups = 0;
    while earlier.len() > FIRST_ROUND {
        let mut round = Vec::with_capacity(earlier.len());
        let mut chosen = Vec::with_capacity(earlier.len() / GROWTH + 1);
        for group in earlier.chunks(GROWTH) {
            groups += 1;
            let (before, from) = group.split_at(Random::new(groups).below(group.len()));
            round.extend_from_slice(before);
            if let Some((&first, after)) = from.split_first() {
                chosen.push(first);
                round.extend_from_slice(after);
            }
        }
        rounds.push(round);
        earlier = chosen;
    }
    rounds.push(earlier);
    rounds.reverse();
    // Every other round runs backwards: it starts near where the one before ended.
    for round in rounds.iter_mut().skip(1).step_by(2) {
        round.reverse();
    }
    rounds.concat()
}
