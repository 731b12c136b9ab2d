//! Edges that agree with what is known about the curves.
//!
//! - **One curve** goes through all points: the shortest tour or path, a simple polygon. Where the
//!   Delaunay triangulation holds none, other edges are used.
//! - **Closed curves**, their number unknown: the ends that the algorithm leaves open are joined,
//!   the nearest first.
//! - **Open curves**, their number unknown: each ring that the algorithm finds is cut at its
//!   longest edge.
//! - **Several curves**, their number known: what the algorithm finds if it agrees; else closed
//!   curves are joined or parted where that costs the least length, and open ones are the shortest
//!   that go through all points.

mod closed;
mod rings;

use std::collections::BTreeMap;

use curvecrust_geometry::{Edge, EdgeSet, PointId, PointSet};

use crate::algorithm::Reconstructor;
use crate::error::ReconstructError;
use crate::explanation::{ExplainedEdge, Explanation, Reason, Rejected};
use crate::known::{Known, Shape, are_on_a_line, distinct};
use crate::tour::{Goal, Task, short_tour};

/// The edges of an algorithm that honours termini, or others that agree with what is known.
pub(crate) fn reconstruct(
    algorithm: &dyn Reconstructor,
    points: &PointSet,
    known: &Known,
) -> Result<EdgeSet, ReconstructError> {
    known.check(points)?;
    if points.is_empty() {
        return Ok(EdgeSet::default());
    }
    let found = || algorithm.reconstruct_open(points, &known.termini);
    let Some(curves) = known.curves.map(|n| n.get() as usize) else {
        return match known.shape {
            Some(Shape::Closed) => closed::closed(points, &found()?, None),
            Some(Shape::Open) => Ok(cut(points, &found()?)),
            None => found(),
        };
    };
    if curves == 1 {
        return Ok(one(points, known, Goal::LengthAndDetours));
    }
    let found = found()?;
    let chains = found.chains();
    let has_shape = known.shape.is_none_or(|shape| {
        chains
            .iter()
            .all(|chain| chain.is_closed() == (shape == Shape::Closed))
    });
    if chains.len() == curves && found.isolated().is_empty() && has_shape {
        return Ok(found);
    }
    match known.shape {
        Some(Shape::Closed) => closed::closed(points, &found, Some(curves)),
        _ => Ok(through_all(points, known, curves, Goal::LengthAndDetours)),
    }
}

/// The reasons that the algorithm has for the edges; those that it would not have are required.
/// Ends are free where the algorithm leaves them, in the curves as they are known.
pub(crate) fn explain(
    algorithm: &dyn Reconstructor,
    points: &PointSet,
    known: &Known,
) -> Result<Option<Explanation>, ReconstructError> {
    let edges = algorithm.reconstruct_known(points, known)?;
    let Some(mut why) = algorithm.explain(points, &known.termini)? else {
        return Ok(None);
    };
    let reasons = why
        .edges
        .iter()
        .map(|why| (why.edge, *why))
        .collect::<BTreeMap<_, _>>();
    let required = |&edge: &Edge| ExplainedEdge {
        edge,
        reason: Reason::Required,
        margin_at_most: None,
    };
    let explained = edges.edges().iter();
    why.edges = explained
        .map(|e| reasons.get(e).copied().unwrap_or_else(|| required(e)))
        .collect();
    let degrees = edges.degrees();
    why.free_ends.retain(|end| {
        let free = 2 - degrees[end.point.index()].min(2);
        u32::from(end.count) == free
    });
    for end in &mut why.free_ends {
        let joined = |rejected: &Rejected| Edge::new(end.point, rejected.partner);
        end.rejected = end
            .rejected
            .filter(|rejected| joined(rejected).is_some_and(|edge| !edges.contains(edge)));
    }
    Ok(Some(why))
}

/// One curve through all points.
pub(crate) fn one(points: &PointSet, known: &Known, goal: Goal) -> EdgeSet {
    match known.shape() {
        Some(Shape::Closed) => closed_through_all(points, goal),
        Some(Shape::Open) => through_all(points, known, 1, goal),
        None => {
            let open = through_all(points, known, 1, goal);
            if open.chains().iter().all(|chain| !chain.is_closed()) {
                open
            } else {
                closed_through_all(points, goal)
            }
        }
    }
}

/// One closed curve through all points, of which there must be three, not all on one line.
pub(crate) fn closed_through_all(points: &PointSet, goal: Goal) -> EdgeSet {
    let (sorted, ids) = points.in_hilbert_order();
    let rings = short_tour(&sorted, &Task::closed(goal));
    let edges = rings
        .iter()
        .flat_map(|ring| edges(ring, Shape::Closed, &ids));
    EdgeSet::new(points.len(), edges)
}

/// This number of curves through all points, the shortest open ones; where the shape is not known,
/// those whose ends are near each other are closed.
pub(crate) fn through_all(points: &PointSet, known: &Known, curves: usize, goal: Goal) -> EdgeSet {
    let (sorted, ids) = points.in_hilbert_order();
    let termini = distinct(&known.termini);
    let is_terminus = ids
        .iter()
        .map(|id| termini.binary_search(id).is_ok())
        .collect();
    let task = Task {
        goal,
        gaps: curves,
        is_terminus,
    };
    let edges = short_tour(&sorted, &task).into_iter().flat_map(|path| {
        let has_terminus = [path.first(), path.last()]
            .into_iter()
            .flatten()
            .any(|&v| task.is_terminus[v as usize]);
        let closes = known.shape().is_none() && !has_terminus && closes(&sorted, &path);
        edges(
            &path,
            if closes { Shape::Closed } else { Shape::Open },
            &ids,
        )
        .collect::<Vec<_>>()
    });
    EdgeSet::new(points.len(), edges.collect::<Vec<_>>())
}

/// So many edges at either end of a path tell how long its edges are there.
const AT_ENDS: usize = 5;

/// A gap as long as this many edges is read as an end: people see an even chain as two from about
/// twice its spacing on (Zeng, Nguyen, Yan, Chen: "A distance-based parameter free algorithm for
/// curve reconstruction", CAD 2008).
const GAP: f64 = 2.05;

/// Whether the ends of a path are so near that it is seen as closed.
fn closes(points: &PointSet, path: &[u32]) -> bool {
    let length = |v: u32, w: u32| points[PointId::from(v)].distance(points[PointId::from(w)]);
    let (Some(&first), Some(&last)) = (path.first(), path.last()) else {
        return false;
    };
    let lengths = || path.windows(2).map(|edge| length(edge[0], edge[1]));
    let longest = lengths()
        .take(AT_ENDS)
        .chain(lengths().rev().take(AT_ENDS))
        .fold(0.0, f64::max);
    let ids = path.iter().map(|&v| PointId::from(v));
    path.len() > 2 && length(first, last) <= GAP * longest && !are_on_a_line(points, ids)
}

/// The edges along a curve, by the names that the caller has for the points.
fn edges<'a>(
    curve: &'a [u32],
    shape: Shape,
    ids: &'a [PointId],
) -> impl Iterator<Item = Edge> + 'a {
    let next = curve.iter().cycle().skip(1);
    let count = curve.len() - usize::from(shape == Shape::Open && !curve.is_empty());
    let pairs = curve.iter().zip(next).take(count);
    pairs.filter_map(|(&v, &w)| Edge::new(ids[v as usize], ids[w as usize]))
}

/// The edges without the longest of each ring.
fn cut(points: &PointSet, found: &EdgeSet) -> EdgeSet {
    let squared = |edge: &Edge| points[edge.a()].distance_squared(points[edge.b()]);
    let by_place = |edge: &Edge| {
        let [p, q] = edge.ends().map(|v| points[v].to_array());
        if p <= q { [p, q] } else { [q, p] }
    };
    let longest = |e: &Edge, f: &Edge| {
        let places = by_place(f).partial_cmp(&by_place(e));
        squared(e)
            .total_cmp(&squared(f))
            .then(places.unwrap_or(std::cmp::Ordering::Equal))
    };
    let edges = found.chains().into_iter().flat_map(|chain| {
        let edges: Vec<Edge> = chain.edges().collect();
        let removed = edges
            .iter()
            .copied()
            .max_by(longest)
            .filter(|_| chain.is_closed());
        edges.into_iter().filter(move |&edge| Some(edge) != removed)
    });
    EdgeSet::new(points.len(), edges.collect::<Vec<_>>())
}
