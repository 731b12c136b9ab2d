//! A short tour through all points: one closed curve, or a number of open ones.
//!
//! A curve sampled densely enough is the shortest tour of its samples (Giesen, "Curve
//! Reconstruction, the Traveling Salesman Problem and Menger's Theorem on Length", SoCG 1999),
//! which also holds at corners. Sought is that tour, or the one of least length and detours, which
//! is the cost of [least detour](mod@crate::least_detour): where samples are sparse it is right
//! more often than the shortest. An open curve is a tour with a [gap](cost::Cost), and several open
//! curves are one with several gaps.
//!
//! 1. **Start.** Edges are taken greedily, the shortest first ([`greedy`]).
//! 2. **Improve.** Lin-Kernighan: chains of exchanges of up to four edges, as long as that lowers
//!    the cost ([`search`]), first among near points. For a closed tour of least length, a
//!    Held-Karp bound then tells which edges the shortest tour may have, and has prices of the
//!    points with which right exchanges are found more often ([`alpha`]); if it is the length of
//!    the tour found, step 3 is left out.
//! 3. **Perturb.** Four edges at random are exchanged and the tour is improved around them, many
//!    times ([`perturb`]); for a closed tour of least length, from several starts ([`merge`]).
//! 4. **Uncross.** Edges that still meet elsewhere than at a common end are exchanged
//!    ([`uncross`](mod@uncross)): a simple polygon remains.
//!
//! The result depends on the points alone, if they come in an order that does so: step 3 has a
//! fixed seed.

mod alpha;
mod around;
mod cost;
mod exchange;
mod greedy;
mod merge;
mod near;
mod order;
mod perturb;
mod search;
mod uncross;

use curvecrust_geometry::PointSet;
use curvecrust_voronoi::Delaunay;

use alpha::Alpha;
use cost::Cost;
pub(crate) use near::Near;
use order::Order;
use search::Search;

/// Lengths of tours, or a length and a bound, are one if they differ by less than this share.
const ROUNDING: f64 = 1e-12;

/// What that may hide of the shortest edge.
const LEAST_PART: f64 = 1e-6;

/// Perturbations for each vertex, and of any tour, but for the shortest closed one. Detours leave
/// fewer tours that are nearly as good, and each perturbation takes longer.
const PERTURBATIONS: [usize; 2] = [12, 14_000];
const PERTURBATIONS_WITH_DETOURS: [usize; 2] = [5, 5_000];

/// What a tour is to have little of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Goal {
    /// Length.
    Length,
    /// Length and detours.
    LengthAndDetours,
}

/// What a tour has to keep.
#[derive(Clone, Debug)]
pub(crate) struct Task {
    pub(crate) goal: Goal,
    /// So many gaps: the number of open curves; 0 for a closed one.
    pub(crate) gaps: usize,
    /// For every point whether a gap must be next to it; at most two for each gap.
    pub(crate) is_terminus: Vec<bool>,
}

impl Task {
    /// One closed curve.
    pub(crate) const fn closed(goal: Goal) -> Self {
        Self {
            goal,
            gaps: 0,
            is_terminus: Vec::new(),
        }
    }
}

/// The points in the order of a short tour, divided at the gaps: one closed curve without gaps,
/// else as many open ones, each of two points or more.
///
/// There must be three points or more for a closed curve, which is a simple polygon unless all
/// points lie on one line; and two for each gap.
pub(crate) fn short_tour(points: &PointSet, task: &Task) -> Vec<Vec<u32>> {
    let delaunay = Delaunay::new(points);
    let cost = Cost::new(points.points(), task);
    let near = Near::new(points, &delaunay);
    let start = greedy::tour(points, &near, &cost);
    let mut search = Search::new(&cost, near, Order::new(start));
    search.improve_all();
    let tour = if task.goal == Goal::Length && task.gaps == 0 {
        shortened(points, &cost, search)
    } else {
        let [times, most] = match task.goal {
            Goal::Length => PERTURBATIONS,
            Goal::LengthAndDetours => PERTURBATIONS_WITH_DETOURS,
        };
        search.perturb_often((times * search.tour.len()).min(most), 1);
        search.into_order()
    };
    let tour = uncross::uncrossed(&cost, tour);
    divided(&cost, tour)
}

/// A shorter closed tour, from one that was improved among near points.
fn shortened(points: &PointSet, cost: &Cost<'_>, search: Search<'_>) -> Vec<u32> {
    let near = search.near.and_around(points);
    let alpha = Alpha::new(points, &near, search.lengths().sum());
    let cost = cost.with_prices(&alpha.prices);
    let mut search = Search::new(&cost, alpha.near, search.tour);
    search.improve_all();
    let length: f64 = search.lengths().sum();
    let shortest_edge = search.lengths().fold(f64::INFINITY, f64::min);
    // Rounding hides no more than a small part of any edge.
    let is_fine = ROUNDING * length <= LEAST_PART * shortest_edge;
    if !is_fine || length > alpha.bound * (1.0 + ROUNDING) {
        search.merge_tours();
    }
    search.into_order()
}

/// The paths between the gaps.
fn divided(cost: &Cost<'_>, mut tour: Vec<u32>) -> Vec<Vec<u32>> {
    if let Some(gap) = tour.iter().position(|&v| cost.is_gap(v)) {
        tour.rotate_left(gap + 1);
    }
    let paths = tour.split(|&v| cost.is_gap(v));
    paths
        .filter(|path| !path.is_empty())
        .map(<[u32]>::to_vec)
        .collect()
}
