//! Every constant of least detour. `docs/method.md` has them in one table: where each value comes
//! from, and how the result depends on it. A test compares the two.

use std::f64::consts::FRAC_1_SQRT_2;

/// The least cosine of the turn between certified edges: a turn of 49.5 degrees.
///
/// Consecutive edges of an epsilon-sample turn by at most 4 asin(epsilon / (2 - 2 epsilon)) (SGP
/// 2016, Lemma 9), which is less than that for epsilon < 0.3.
pub(super) const CERTIFIED_COSINE: f64 = 0.65;

/// The penalty of a free end, in expected lengths of an edge.
pub(super) const PENALTY: f64 = 2.25;

/// The penalty of the free end of an even run, in lengths of its edges.
pub(super) const RUN_PENALTY: f64 = 1.3;

/// The number of edges of a run. With turns of less than 45 degrees they turn by less than half a
/// circle together, so a run does not come back to where it began.
pub(super) const RUN_EDGES: usize = 5;

/// The largest ratio between the lengths of two edges of an even run.
pub(super) const EVEN_RATIO: f64 = 2.0;

/// The largest ratio between the trusted edges at the end of a run and its spacing. A longer edge
/// shows that the samples are uneven, so the run does not tell what follows.
pub(super) const UNEVEN_RATIO: f64 = 3.0;

/// The cosine of the turn up to which a point lies ahead of a run: 45 degrees.
pub(super) const AHEAD_COSINE: f64 = FRAC_1_SQRT_2;

/// The cosine of the turn up to which a curve goes straight on: 25.8 degrees.
pub(super) const STRAIGHT_COSINE: f64 = 0.9;

/// The largest detour between trusted edges, in lengths of the shorter one.
///
/// Consecutive edges of a rho-sample turn by at most 4 asin(rho / 2) (SGP 2016, Lemma 8): for rho <
/// 0.9 by 107 degrees, which is a detour of 0.81 if their lengths are equal.
pub(super) const TRUSTED_DETOUR: f64 = 0.82;

/// The number of closest candidates whose spacing counts for the expected length of an edge.
pub(super) const SPACING_NEIGHBOURS: usize = 2;

/// The number of closest candidates among which a curve continues straight on.
pub(super) const CONTINUATION_NEIGHBOURS: usize = 3;

/// The largest number of edges that an exchange adds. Three include the moves known as 2-opt, 3-opt
/// and or-opt, but one strand after another is put right only by many.
pub(super) const DEPTH: usize = 12;

/// In how many ways an alternating path continues after each added edge, the first one first.
pub(super) const BREADTH: [usize; DEPTH] = [5, 3, 2, 2, 1, 1, 1, 1, 1, 1, 1, 1];

/// An exchange lowers the cost if it does so by more than this fraction of all lengths, detours and
/// penalties that are added up for it. Rounding cannot feign as much, so no exchange undoes
/// another.
pub(super) const ROUNDING: f64 = 1e-12;
