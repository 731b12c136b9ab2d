//! Every constant of least detour. `docs/method.md` has them in one table: where each value comes
//! from, and how the result depends on it. A test compares the two.

use std::f64::consts::FRAC_1_SQRT_2;

/// The weight of turns: a turn by an angle t costs `TURN_WEIGHT` ln(1 + t^2 / `TURN_SCALE`).
pub(super) const TURN_WEIGHT: f64 = 0.67;

/// The square of the turn, in radians, from which turns count as corners.
pub(super) const TURN_SCALE: f64 = 1.45;

/// The weight of changes of length: consecutive edges of lengths a and b cost `RATIO_WEIGHT`
/// ln(1 + ln^2(a / b) / `RATIO_SCALE`).
pub(super) const RATIO_WEIGHT: f64 = 0.45;

/// The square of the logarithm of the ratio from which changes of length count as jumps.
pub(super) const RATIO_SCALE: f64 = 1.3;

/// The penalty of a free end.
pub(super) const END: f64 = 3.4;

/// The penalty of a free end where a run ends and something lies ahead, if the run is even.
pub(super) const RUN_END: f64 = 0.2;

/// The penalty of a free end where a run ends and nothing lies ahead, if the run is even.
pub(super) const LAST_END: f64 = 0.0;

/// Where a run ends and HNN-Crust turns aside, the edge aside is longer than this many mean edges
/// of the run; if it is shorter, the curve goes on by it.
pub(super) const ASIDE: f64 = 1.2;

/// What the deviation of a run adds to the penalty at its end, per unit.
pub(super) const UNEVEN: f64 = 2.2;

/// What the deviation of a run grows by if its last edge is longer than the others, per unit of the
/// logarithm.
pub(super) const LAST_EDGE: f64 = 0.4;

/// The deviation that runs are taken to have before their edges are seen.
pub(super) const PRIOR_DEVIATION: f64 = 0.4;

/// As many edges as that prior counts for.
pub(super) const PRIOR_EDGES: f64 = 2.0;

/// The penalty of an isolated point to which no curve nearby continues.
pub(super) const OUTLIER: f64 = 1.5;

/// The penalty of other isolated points.
pub(super) const ISOLATED: f64 = 3.5;

/// How much less an isolated point costs if its spacing exceeds that of its surroundings, per unit
/// of the logarithm.
pub(super) const SPARSE: f64 = 2.0;

/// The least penalty of an isolated point.
pub(super) const LEAST_ISOLATED: f64 = 0.3;

/// A gap is longer than this many spacings of the runs at both of its ends.
pub(super) const GAP: f64 = 1.2;

/// The logarithm of the length of a gap exceeds that of [`GAP`] spacings by this many deviations.
pub(super) const GAP_DEVIATIONS: f64 = 3.3;

/// A gap is longer than [`GAP`] times each of this many edges on both sides.
pub(super) const GAP_EDGES: usize = 64;

/// The largest number of edges of a run.
pub(super) const RUN_EDGES: usize = 5;

/// The least number of edges of a run. Fewer do not tell how even it is.
pub(super) const LEAST_RUN_EDGES: usize = 3;

/// The number of edges on each side of a point whose mean is its spacing.
pub(super) const SPACING_EDGES: usize = 3;

/// Points belong to one cluster if they are nearer to each other than this many of the longest edge
/// of HNN-Crust at one of them.
pub(super) const CLUSTER_EDGES: f64 = 3.0;

/// Two edges are equally long if one is not longer than this many times the other. Rounding makes
/// them differ by far less.
pub(super) const TIE: f64 = 1.0 + 1e-9;

/// The least cosine of the turn between certified edges: a turn of 31.8 degrees.
pub(super) const CERTIFIED_COSINE: f64 = 0.85;

/// The cosine of the turn up to which a point lies ahead of a run, and of the largest turn within a
/// run: 45 degrees.
pub(super) const AHEAD_COSINE: f64 = FRAC_1_SQRT_2;

/// The cosine of the turn up to which a curve goes straight on: 25.8 degrees.
pub(super) const STRAIGHT_COSINE: f64 = 0.9;

/// The largest detour of a turn that is possible, in lengths of the shorter edge.
///
/// Consecutive edges of a rho-sample turn by at most 4 asin(rho / 2) (SGP 2016, Lemma 8): for rho <
/// 0.9 by 107 degrees, which is a detour of 0.81 if their lengths are equal.
pub(super) const POSSIBLE_DETOUR: f64 = 0.82;

/// The number of closest candidates among which a curve continues straight on.
pub(super) const CONTINUATION_NEIGHBOURS: usize = 3;

/// The largest number of edges that an exchange adds. Three include the moves known as 2-opt, 3-opt
/// and or-opt, but one strand after another is put right only by many.
pub(super) const DEPTH: usize = 12;

/// In how many ways an alternating path continues after each added edge, the first one first.
pub(super) const BREADTH: [usize; DEPTH] = [5, 3, 2, 1, 1, 1, 1, 1, 1, 1, 1, 1];

/// The same for the searches that come first: they find most of what the others do, in a fraction
/// of the time.
pub(super) const FIRST_BREADTH: [usize; 4] = [3, 2, 1, 1];

/// An end is explained by the best of its closest candidates, at most this many.
pub(super) const EXPLAINED_CANDIDATES: usize = 8;

/// An exchange lowers the cost if it does so by more than this fraction of all that is added up for
/// it. Rounding cannot feign as much, so no exchange undoes another.
pub(super) const ROUNDING: f64 = 1e-12;
