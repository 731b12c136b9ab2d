//! Edges from the choices of all points.

use std::sync::atomic::{AtomicU64, Ordering};

use curvecrust_geometry::parallel::*;
use curvecrust_geometry::{Edge, EdgeSet, PointId};

use super::kernel::Choice;
use super::search::NONE;

/// Points that make a task.
const TASK: usize = 1 << 12;

/// Which of the edges that samples chose are kept.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Keep {
    /// Those that both ends chose: every vertex has degree 2 at most.
    Mutual,
    /// All: no choice is lost, but vertices may branch, and open curves whose termini are not
    /// marked get extra edges at their ends.
    Union,
}

/// The edges that points chose and `keep` keeps, from their ids and choices in spatial order.
///
/// Choices are compared in that order, in which those of neighbours are close in memory. Each point
/// then reports its edges to points with larger ids in a slot of its own. Reading the slots by id
/// gives the edges ascending, without a sort but for those that only the larger end chose: on
/// curves few or none.
pub(super) fn kept(order: &[PointId], chosen: &[Choice], keep: Keep) -> EdgeSet {
    let count = order.len();
    let empty = || AtomicU64::new(0);
    let slots: Vec<AtomicU64> = (0..count).into_par_iter().map(|_| empty()).collect();
    let points = order.par_iter().enumerate().with_min_len(TASK);
    let report = |at: usize, s: u32| {
        let reported = reported(order, chosen, at, keep);
        // Every point has its own slot, written once.
        let larger = reported.map(|id| if id > s { id } else { NONE });
        slots[s as usize].store(pair(larger), Ordering::Relaxed);
        reported
    };
    // Mutual choices report nothing to smaller ids; to look for it took a tenth of all the time.
    let to_smaller: Vec<Edge> = match keep {
        Keep::Mutual => {
            points.for_each(|(at, &s)| {
                report(at, s.into());
            });
            Vec::new()
        }
        Keep::Union => {
            let found = points.flat_map_iter(|(at, &s)| {
                let s = u32::from(s);
                let smaller = report(at, s).into_iter().filter(move |&id| id < s);
                smaller.filter_map(move |id| Edge::new(s.into(), id.into()))
            });
            found.collect()
        }
    };
    let mut edges = ascending(&slots);
    if !to_smaller.is_empty() {
        edges.extend(to_smaller);
        // A stable sort takes the sorted part as it is.
        edges.sort();
    }
    EdgeSet::new(count, edges)
}

/// The edges of all slots.
///
/// Whether a slot holds none, one or two is as good as random: they are compacted without a branch.
fn ascending(slots: &[AtomicU64]) -> Vec<Edge> {
    let mut edges = Vec::with_capacity(slots.len());
    let mut ends = [[0; 2]; 2 * TASK];
    let mut s = 0;
    for slots in slots.chunks(TASK) {
        let mut len = 0;
        for slot in slots {
            for id in parts(slot.load(Ordering::Relaxed)) {
                ends[len % (2 * TASK)] = [s, id];
                len += usize::from(id != NONE);
            }
            s += 1;
        }
        let found = ends[..len].iter();
        edges.extend(found.filter_map(|&[s, id]| Edge::new(s.into(), id.into())));
    }
    edges
}

/// The ids to which the point at a position reports an edge, or [`NONE`].
///
/// An edge that both ends chose is reported by the smaller id.
#[inline(always)]
fn reported(order: &[PointId], chosen: &[Choice], at: usize, keep: Keep) -> [u32; 2] {
    chosen[at].map(|q| {
        let Some(&id) = order.get(q as usize) else {
            return NONE;
        };
        let [nearest, half] = chosen[q as usize];
        let returned = (nearest as usize == at) | (half as usize == at);
        // Which end is smaller is as good as random: no branch.
        let smaller = returned & (order[at] < id);
        let is_reported = smaller | (!returned & (keep == Keep::Union));
        if is_reported { id.into() } else { NONE }
    })
}

/// Two numbers in one, the smaller first.
fn pair([p, q]: [u32; 2]) -> u64 {
    u64::from(p.max(q)) << 32 | u64::from(p.min(q))
}

#[expect(clippy::cast_possible_truncation, reason = "the two halves")]
fn parts(pair: u64) -> [u32; 2] {
    [pair as u32, (pair >> 32) as u32]
}
