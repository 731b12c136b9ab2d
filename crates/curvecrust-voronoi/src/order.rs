//! The order of insertion.
//!
//! N. Amenta, S. Choi, G. Rote, *Incremental constructions con BRIO*, SoCG 2003: rounds of doubling
//! size, each a random subset of what is left, keep randomised incremental construction optimal in
//! expectation; inside a round any order may be taken, so one that is kind to the walk and the
//! cache: along the Hilbert curve.

use curvecrust_geometry::{PointId, PointSet, hilbert_order};

/// Rounds below this size are one: there is nothing to gain among so few points.
const FIRST_ROUND: usize = 256;

/// A biased randomised insertion order: every id once.
///
/// The order depends on the coordinates alone, not on the order of the points, so that what is built
/// from it does not either; and it stays the same when the points are scaled by a power of two or
/// shifted exactly. The randomness has a fixed seed. Cost: O(n log n).
#[must_use]
pub fn brio_order(points: &PointSet) -> Vec<PointId> {
    let last_round = (points.len() / FIRST_ROUND).checked_ilog2().unwrap_or(0);
    let mut rounds: Vec<Vec<PointId>> = vec![Vec::new(); last_round as usize + 1];
    for (rank, id) in (0u64..).zip(hilbert_order(points)) {
        // The last round takes a point with probability 1/2, the one before with 1/4, and so on.
        let heads = mixed(rank).trailing_zeros().min(last_round);
        rounds[(last_round - heads) as usize].push(id);
    }
    // Every other round runs backwards: it starts near where the one before ended.
    for round in rounds.iter_mut().skip(1).step_by(2) {
        round.reverse();
    }
    rounds.concat()
}

/// A bijection that looks random, bit by bit (the finaliser of `splitmix64`).
fn mixed(rank: u64) -> u64 {
    let mut z = rank.wrapping_add(0x9e37_79b9_7f4a_7c15);
    z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^ (z >> 31)
}
