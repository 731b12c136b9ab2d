//! What a caller knows about the curves: that they are closed or open, and how many there are.
//!
//! Points alone leave open where a curve ends and whether two parts of it are one. A caller who
//! knows need not leave that to an estimate: with [`Known`] the search goes through the sets of
//! edges that agree with it, and through no others.
//!
//! - **One curve** goes through all points: the shortest [tour](crate::tour) or path, a simple
//!   polygon. Where the Delaunay triangulation holds none, other edges are used.
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
use std::num::NonZeroU32;

use curvecrust_geometry::{Edge, EdgeSet, PointId, PointSet, in_hilbert_order, orient2d};

use crate::algorithm::Reconstructor;
use crate::error::ReconstructError;
use crate::explanation::{ExplainedEdge, Explanation, Reason};
use crate::termini;
use crate::tour::{Task, short_tour};

/// What a caller knows about the curves; by default nothing.
///
/// ```
/// use curvecrust_geometry::{DVec2, PointSet};
/// use curvecrust_reconstruct::{Known, LeastDetour, Reconstruction};
///
/// // Four corners of a long rectangle: told nothing, two lines; told "one closed curve", a ring.
/// let corners = [(0.0, 0.0), (9.0, 0.0), (9.0, 1.0), (0.0, 1.0)].map(|(x, y)| DVec2::new(x, y));
/// let points = PointSet::new(corners.to_vec())?;
/// let ring = Reconstruction::by_known(&LeastDetour, &points, &Known::ONE_CLOSED_CURVE)?;
/// assert_eq!(ring.chains().len(), 1);
/// assert_eq!(ring.chains()[0].nesting, Some(0));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Known {
    /// Whether all curves are closed or all are open; `None` if that is not known.
    pub shape: Option<Shape>,
    /// How many curves there are, which then go through all points; `None` if that is not known.
    pub curves: Option<NonZeroU32>,
    /// Points that are ends of open curves, in any order; some of them or all.
    pub termini: Vec<PointId>,
}

/// Whether curves have ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shape {
    /// No curve ends: each point has two partners.
    Closed,
    /// Every curve has two ends.
    Open,
}

impl Known {
    /// One closed curve goes through all points.
    pub const ONE_CLOSED_CURVE: Self = Self {
        shape: Some(Shape::Closed),
        curves: Some(NonZeroU32::MIN),
        termini: Vec::new(),
    };

    /// One open curve goes through all points: sorts points along a line.
    ///
    /// ```
    /// use curvecrust_geometry::{DVec2, PointSet};
    /// use curvecrust_reconstruct::{Known, LeastDetour, Reconstruction};
    ///
    /// let shuffled = [4.0, 0.0, 7.0, 2.0, 30.0].map(|x| DVec2::new(x, x * x / 50.0));
    /// let points = PointSet::new(shuffled.to_vec())?;
    /// let line = Reconstruction::by_known(&LeastDetour, &points, &Known::ONE_OPEN_CURVE)?;
    /// let order = line.chains()[0].chain.vertices().iter();
    /// let order: Vec<usize> = order.map(|v| v.index()).collect();
    /// assert_eq!(order, [1, 3, 0, 2, 4]);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub const ONE_OPEN_CURVE: Self = Self {
        shape: Some(Shape::Open),
        curves: Some(NonZeroU32::MIN),
        termini: Vec::new(),
    };

    /// Whether no more than some termini is known.
    #[must_use]
    pub fn is_of_termini_alone(&self) -> bool {
        self.shape.is_none() && self.curves.is_none()
    }

    /// The shape, which termini may tell: one curve with an end is open.
    fn shape(&self) -> Option<Shape> {
        let is_open = self.curves == Some(NonZeroU32::MIN) && !self.termini.is_empty();
        self.shape.or(is_open.then_some(Shape::Open))
    }

    /// What no set of points, or not this one, can agree with.
    fn check(&self, points: &PointSet) -> Result<(), ReconstructError> {
        termini::check(points, &self.termini)?;
        let count = points.len();
        let closed = self.shape == Some(Shape::Closed);
        let termini = distinct(&self.termini).len();
        if closed && termini > 0 {
            return Err(ReconstructError::TerminiOfClosedCurves { termini });
        }
        let each = if closed { 3 } else { 2 };
        let curves = self
            .curves
            .map_or(usize::from(closed && count > 0), |n| n.get() as usize);
        let needed = curves.saturating_mul(each);
        if count < needed {
            return Err(ReconstructError::TooFewPoints {
                count,
                curves,
                needed,
            });
        }
        if self.curves.is_some() && termini > 2 * curves {
            return Err(ReconstructError::TooManyTermini { termini, curves });
        }
        if closed && count > 0 && are_on_a_line(points, points.ids()) {
            return Err(ReconstructError::ClosedOnALine { count });
        }
        Ok(())
    }
}

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
        return Ok(one(points, known));
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
        _ => Ok(through_all(points, known, curves)),
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
        margin: None,
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
    Ok(Some(why))
}

/// One curve through all points.
fn one(points: &PointSet, known: &Known) -> EdgeSet {
    match known.shape() {
        Some(Shape::Closed) => closed_through_all(points),
        Some(Shape::Open) => through_all(points, known, 1),
        None => {
            let open = through_all(points, known, 1);
            if open.chains().iter().all(|chain| !chain.is_closed()) {
                open
            } else {
                closed_through_all(points)
            }
        }
    }
}

fn closed_through_all(points: &PointSet) -> EdgeSet {
    let (sorted, ids) = in_hilbert_order(points);
    let rings = short_tour(&sorted, &Task::default());
    let edges = rings
        .iter()
        .flat_map(|ring| edges(ring, Shape::Closed, &ids));
    EdgeSet::new(points.len(), edges)
}

/// So many curves through all points, the shortest open ones; where the shape is not known, those
/// whose ends are near each other are closed.
fn through_all(points: &PointSet, known: &Known, curves: usize) -> EdgeSet {
    let (sorted, ids) = in_hilbert_order(points);
    let termini = distinct(&known.termini);
    let is_terminus = ids
        .iter()
        .map(|id| termini.binary_search(id).is_ok())
        .collect();
    let task = Task {
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

/// A gap of so many edges is read as an end: people see an even chain as two from about twice its
/// spacing on (Zeng, Nguyen, Yan, Chen: "A distance-based parameter free algorithm for curve
/// reconstruction", CAD 2008).
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

fn distinct(termini: &[PointId]) -> Vec<PointId> {
    let mut termini = termini.to_vec();
    termini.sort_unstable();
    termini.dedup();
    termini
}

/// Whether all points lie on one line, exactly; as fewer than three do.
fn are_on_a_line(points: &PointSet, mut ids: impl Iterator<Item = PointId>) -> bool {
    let [Some(a), Some(b)] = [ids.next(), ids.next()] else {
        return true;
    };
    ids.all(|c| orient2d(points[a], points[b], points[c]) == 0.0)
}
