//! The choices of the samples of one tile, as far as the tile can know them.
//!
//! Of a sample s, let D be the disc about s through the farther of the two samples that it chooses
//! among those of the tile and its halo. A sample that is not loaded lies outside the loaded area.
//! If D lies inside of that, no such sample is in D: none is closer than either choice, nor as
//! close, and whether a choice lies in the half-plane depends on it, s and the nearest neighbour
//! alone. So the choice is the one among all samples, ties included.

use curvecrust_geometry::{PointId, PointSet};
use curvecrust_reconstruct::neighbours::{Keep, Neighbours, neighbours};
use rayon::prelude::*;

use crate::area::Area;
use crate::claim::Claim;
use crate::error::TilesError;
use crate::method::Method;
use crate::open_sample::{Lack, OpenSample};
use crate::sample::{Sample, Samples, named};

/// The choice of a sample, as far as it is certain.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct Choice {
    /// The nearest neighbour; `None` if it is not certain or if there is none.
    pub nearest: Option<u64>,
    /// The half neighbour; `None` if it is not certain or if there is none.
    pub half: Option<u64>,
}

/// What one tile knows about the choices of its samples.
#[derive(Clone, Debug)]
pub struct Solved<'a> {
    method: Method,
    owned: &'a Samples,
    /// The ids of the halo, whose positions follow those of the owned samples.
    halo: Vec<u64>,
    /// What is certain about the owned samples.
    chosen: Vec<Neighbours>,
    /// The positions of the open samples, ascending.
    open_at: Vec<usize>,
    open: Vec<OpenSample>,
}

/// What follows from the certain choices of one tile.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct Decided {
    /// Edges between its samples that hold whatever other tiles find, ascending.
    pub edges: Vec<[u64; 2]>,
    /// Choices that turn into edges or not when those of the other sample are known, in no order.
    pub claims: Vec<Claim>,
}

/// Makes the choices of the samples of one tile.
///
/// `halo` are samples of other tiles. `loaded` is an area of which every sample is either owned or
/// in the halo; [`Area::EVERYTHING`] if there are no others, [`Area::NOTHING`] if nothing is known.
/// Owned samples may lie outside of it, and have nothing certain then.
///
/// ```
/// use curvecrust_geometry::DVec2;
/// use curvecrust_tiles::{Area, Lack, Method, Sample, Samples, solve_tile};
///
/// let row = |ids: std::ops::Range<u64>| -> Vec<Sample> {
///     let at = |id| Sample { id, point: DVec2::new(id as f64, 0.0) };
///     ids.map(at).collect()
/// };
/// // The samples 0 to 3 of a longer row, and what is known up to x = 4.5.
/// let owned = Samples::new(row(0..4))?;
/// let loaded = Area { low: DVec2::NEG_INFINITY, high: DVec2::new(4.5, f64::INFINITY) };
/// let solved = solve_tile(&owned, &row(4..5), loaded, Method::HNN_CRUST)?;
/// let certain = solved.choice(2).unwrap();
/// assert_eq!((certain.nearest, certain.half), (Some(1), Some(3)));
///
/// // The first one may have a half neighbour anywhere on its other side.
/// let [first] = solved.open() else { panic!() };
/// assert_eq!((first.sample.id, first.lacks, first.radius()), (0, Lack::Half, f64::INFINITY));
/// # Ok::<(), curvecrust_tiles::TilesError>(())
/// ```
///
/// # Errors
/// An invalid sample of the halo, or two samples at one place: of one tile or of two.
pub fn solve_tile<'a>(
    owned: &'a Samples,
    halo: &[Sample],
    loaded: Area,
    method: Method,
) -> Result<Solved<'a>, TilesError> {
    if halo.is_empty() {
        let all = neighbours(owned.points(), method.rule);
        return Ok(Solved::new(method, owned, &[], owned.points(), all, loaded));
    }
    let places = owned.points().points().iter().copied();
    let places = places.chain(halo.iter().map(|s| s.point)).collect();
    let points = PointSet::new(places).map_err(|error| {
        let ids = owned.ids().iter().copied().chain(halo.iter().map(|s| s.id));
        named(&error, &ids.collect::<Vec<_>>())
    })?;
    let all = neighbours(&points, method.rule);
    Ok(Solved::new(method, owned, halo, &points, all, loaded))
}

impl<'a> Solved<'a> {
    /// Takes back what is not certain from the choices among the loaded points.
    fn new(
        method: Method,
        owned: &'a Samples,
        halo: &[Sample],
        points: &PointSet,
        mut chosen: Vec<Neighbours>,
        loaded: Area,
    ) -> Self {
        chosen.truncate(owned.len());
        let sample = |at: PointId| {
            let id = id_of(owned, halo, at)?;
            let point = points[at];
            Some(Sample { id, point })
        };
        let judged = chosen.par_iter_mut().enumerate().with_min_len(1 << 12);
        let (open_at, open) = judged
            .filter_map(|(at, chosen)| {
                let found = *chosen;
                let lacks = judge(points, at, chosen, loaded)?;
                let open = OpenSample {
                    sample: owned.get(at)?,
                    lacks,
                    nearest: found.nearest.and_then(sample),
                    half: found.half.and_then(sample),
                };
                Some((at, open))
            })
            .unzip();
        Self {
            method,
            owned,
            halo: halo.iter().map(|s| s.id).collect(),
            chosen,
            open_at,
            open,
        }
    }

    /// What is certain about the owned sample at a position; `None` behind the last one.
    #[must_use]
    pub fn choice(&self, position: usize) -> Option<Choice> {
        let &Neighbours { nearest, half, .. } = self.chosen.get(position)?;
        Some(Choice {
            nearest: nearest.map(|at| self.id(at)),
            half: half.map(|at| self.id(at)),
        })
    }

    /// The owned samples whose choice is not certain, in their order.
    #[must_use]
    pub fn open(&self) -> &[OpenSample] {
        &self.open
    }

    fn id(&self, at: PointId) -> u64 {
        let behind = at.index().checked_sub(self.owned.len());
        behind.map_or_else(|| self.owned.ids()[at.index()], |at| self.halo[at])
    }

    /// The edges that follow from the certain choices, and the claims that other tiles or the
    /// choices of [`open`](Self::open) samples decide.
    ///
    /// Every certain choice is in one of both, but for those that nothing can make an edge.
    #[must_use]
    pub fn decided(&self) -> Decided {
        let mut is_open = vec![false; self.owned.len()];
        for &at in &self.open_at {
            is_open[at] = true;
        }
        let ids = self.owned.ids();
        let mut decided = Decided::default();
        decided.edges.reserve(ids.len());
        for (at, chosen) in self.chosen.iter().enumerate() {
            for to in [chosen.nearest, chosen.half].into_iter().flatten() {
                let (from, id) = (ids[at], self.id(to));
                let Some(returned) = self.chosen.get(to.index()).map(|of| has(of, at)) else {
                    decided.claims.push(Claim { from, to: id });
                    continue;
                };
                // What both ends chose is reported by the smaller id.
                if returned {
                    decided.edges.extend((from < id).then_some([from, id]));
                } else if is_open[to.index()] {
                    decided.claims.push(Claim { from, to: id });
                } else if self.method.keep == Keep::Union {
                    decided.edges.push([from.min(id), from.max(id)]);
                }
            }
        }
        decided.edges.par_sort_unstable();
        decided
    }
}

fn id_of(owned: &Samples, halo: &[Sample], at: PointId) -> Option<u64> {
    match at.index().checked_sub(owned.len()) {
        None => owned.ids().get(at.index()).copied(),
        Some(behind) => halo.get(behind).map(|s| s.id),
    }
}

/// Whether a point is among the neighbours.
fn has(neighbours: &Neighbours, at: usize) -> bool {
    let is_it = |to: Option<PointId>| to.is_some_and(|to| to.index() == at);
    is_it(neighbours.nearest) | is_it(neighbours.half)
}

/// Leaves only what is certain of the choice of a point; says what is missing, if anything is.
fn judge(points: &PointSet, at: usize, chosen: &mut Neighbours, loaded: Area) -> Option<Lack> {
    let s = points.points()[at];
    let inside = loaded.inside_squared(s);
    // Without a candidate the disc has no end.
    let is_certain = |to: Option<PointId>| match to {
        Some(to) => (points[to] - s).length_squared() < inside,
        None => inside == f64::INFINITY,
    };
    if !is_certain(chosen.nearest) {
        *chosen = Neighbours::default();
        Some(Lack::Nearest)
    } else if chosen.nearest.is_some() && !is_certain(chosen.half) {
        chosen.half = None;
        Some(Lack::Half)
    } else {
        None
    }
}
