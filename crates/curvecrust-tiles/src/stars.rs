//! Edges of the Delaunay triangulation and of the crust, as far as one tile can know them.
//!
//! The star of a sample is all of its edges. It is certain if no sample that the tile does not have
//! can change it; its edges are then those among all samples.
//!
//! **Delaunay.** The triangles around a sample are those among all samples if no missing sample
//! lies in their circumcircles, nor beyond the edges of the hull; if all samples lie on a line, on
//! both sides of it, nor between neighbours. Of cocircular samples the triangulation chooses
//! diagonals, by an order of insertion that all samples decide together. So only edges that every
//! Delaunay triangulation has count: those whose Voronoi edge is longer than a point.
//!
//! **Crust.** Each edge of the loaded samples is kept, ruled out or undecided
//! ([`partial_crust`](curvecrust_reconstruct::partial_crust)), and a sample knows how far away the
//! other ends of its edges may be. It does not depend on the choice of diagonals.

use curvecrust_geometry::{DVec2, PointId, PointSet};
use curvecrust_reconstruct::partial_crust::{Disc, circumdisc, is_in_all, partial_crust};
use curvecrust_voronoi::Delaunay;
use rayon::prelude::*;

use crate::area::Area;
use crate::crust_reach::{CrustReach, Directions};
use crate::elsewhere::{Asked, Elsewhere};
use crate::error::TilesError;
use crate::region::{Before, HalfPlane, Region};
use crate::sample::{Sample, Samples, named};

/// What a tile knows about the edges of its samples.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct Stars {
    /// The edges of the samples whose star is certain, ascending: of each those that lead to larger
    /// ids. So every edge is found once, where the star of its smaller id is certain.
    pub edges: Vec<[u64; 2]>,
    /// The other samples, in their order.
    pub open: Vec<OpenStar>,
}

/// A sample whose edges are not certain.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OpenStar {
    /// The sample.
    pub sample: Sample,
    /// All samples in this rectangle make the star certain, or show that more are needed; without
    /// an end on the hull of what is loaded and at the ends of curves.
    pub needs: Area,
    /// The area to read first: the nearest one of those elsewhere that may hold a missing sample of
    /// interest.
    pub ask: usize,
}

/// The edges that all Delaunay triangulations of the samples have, as far as they are certain.
///
/// `halo` are samples of other tiles; all others are `elsewhere`.
///
/// ```
/// use curvecrust_geometry::DVec2;
/// use curvecrust_tiles::{Area, Elsewhere, Sample, Samples, solve_delaunay_tile};
///
/// let at = |id: u64| Sample { id, point: DVec2::new(id as f64, (id * id % 7) as f64) };
/// let owned = Samples::new((0..20).map(at).collect())?;
/// let all = solve_delaunay_tile(&owned, &[], &Elsewhere::outside(Area::EVERYTHING))?;
/// assert!(all.open.is_empty());
/// let loaded = Area { low: DVec2::new(-9.0, -9.0), high: DVec2::new(29.0, 9.0) };
/// let some = solve_delaunay_tile(&owned, &[], &Elsewhere::outside(loaded))?;
/// assert!(!some.open.is_empty());
/// assert!(some.edges.iter().all(|edge| all.edges.contains(edge)));
/// # Ok::<(), curvecrust_tiles::TilesError>(())
/// ```
///
/// # Errors
/// An invalid sample of the halo, or two samples at one place: of one tile or of two.
pub fn solve_delaunay_tile(
    owned: &Samples,
    halo: &[Sample],
    elsewhere: &Elsewhere,
) -> Result<Stars, TilesError> {
    let points = &loaded(owned, halo)?;
    let delaunay = &Delaunay::new(points);
    let mut lacks = Lacks::new(owned.len());
    let triangles: Vec<[PointId; 3]> = delaunay.triangles().collect();
    let judged = triangles.into_par_iter().filter_map(|triangle| {
        let disc = circumdisc(points, triangle);
        Some((triangle, Lack::of(elsewhere, disc.from, &disc)?))
    });
    for (triangle, lack) in judged.collect::<Vec<_>>() {
        lacks.note(triangle, lack);
    }
    for dual in delaunay.edges() {
        let [from, to] = dual.ends.map(|end| points[end]);
        let [left, right] = dual.triangles;
        let beyond = [(left, to, from), (right, from, to)].into_iter();
        for (_, from, to) in beyond.filter(|(side, ..)| side.is_none()) {
            let lack = Lack::of(elsewhere, from, &HalfPlane { from, to });
            lacks.note(dual.ends, lack);
        }
    }
    note_row(points, delaunay, elsewhere, &mut lacks);
    let edges = delaunay.edges().filter(|dual| is_in_all(points, dual));
    let edges = edges.map(|dual| dual.ends);
    Ok(lacks.stars(owned, halo, edges))
}

/// The edges of the crust, as far as they are certain.
///
/// `halo` are samples of other tiles; all others are `elsewhere`.
///
/// ```
/// use curvecrust_geometry::DVec2;
/// use curvecrust_tiles::{Area, Elsewhere, Sample, Samples, solve_crust_tile};
///
/// let at = |id: u64| Sample { id, point: DVec2::new(id as f64, 0.0) };
/// let owned = Samples::new((0..10).map(at).collect())?;
/// // Nothing is known beyond x = 9.5: the last two samples may have other edges.
/// let loaded = Area { low: DVec2::NEG_INFINITY, high: DVec2::new(9.5, f64::INFINITY) };
/// let stars = solve_crust_tile(&owned, &[], &Elsewhere::outside(loaded))?;
/// assert_eq!(stars.edges, (0..8).map(|id| [id, id + 1]).collect::<Vec<_>>());
/// let open: Vec<u64> = stars.open.iter().map(|open| open.sample.id).collect();
/// assert_eq!(open, [8, 9]);
/// # Ok::<(), curvecrust_tiles::TilesError>(())
/// ```
///
/// # Errors
/// An invalid sample of the halo, or two samples at one place: of one tile or of two.
pub fn solve_crust_tile(
    owned: &Samples,
    halo: &[Sample],
    elsewhere: &Elsewhere,
) -> Result<Stars, TilesError> {
    let points = &loaded(owned, halo)?;
    let delaunay = &Delaunay::new(points);
    let mut lacks = Lacks::new(owned.len());
    let is_known = |disc: &Disc| elsewhere.nearest(disc.from, disc).is_none();
    let is_owned = |id: PointId| id.index() < owned.len();
    let found = partial_crust(points, delaunay, is_owned, is_known);
    for edge in found.undecided {
        let lack = Lack::of(elsewhere, edge.disc.from, &edge.disc);
        lacks.note(edge.ends, lack);
    }
    let neighbours = Neighbours::new(points.len(), delaunay);
    let directions = Directions::new();
    let judged = owned.points().points().par_iter().enumerate();
    let judged = judged.with_min_len(1 << 10).map(|(at, &p)| {
        let around = neighbours.of(at).iter().map(|&v| points[v]);
        Lack::of(elsewhere, p, &CrustReach::new(&directions, p, around))
    });
    let judged: Vec<Option<Lack>> = judged.collect();
    for (id, lack) in points.ids().zip(judged) {
        lacks.note([id], lack);
    }
    Ok(lacks.stars(owned, halo, found.kept))
}

/// What points on one line lack, but for both sides of the line.
fn note_row(points: &PointSet, delaunay: &Delaunay, elsewhere: &Elsewhere, lacks: &mut Lacks) {
    let mut ends: Vec<(PointId, DVec2)> = Vec::new();
    for dual in delaunay.edges().filter(|dual| dual.triangles == [None; 2]) {
        let [p, q] = dual.ends;
        let (from, to) = (points[p], points[q]);
        let to_centre = (to - from) / 2.0;
        let radius = to_centre.length() * (1.0 + 8.0 * f64::EPSILON);
        let between = Disc {
            from,
            to_centre,
            radius,
        };
        lacks.note(dual.ends, Lack::of(elsewhere, from, &between));
        ends.extend([(p, from - to), (q, to - from)]);
    }
    ends.sort_unstable_by_key(|&(id, _)| id);
    // A point that ends one edge alone is an end of the row.
    for end in ends.chunk_by(|a, b| a.0 == b.0) {
        if let &[(id, along)] = end {
            let from = points[id];
            lacks.note([id], Lack::of(elsewhere, from, &Before { from, along }));
        }
    }
    if let (&[from], Some(id)) = (points.points(), points.ids().next()) {
        let everything = Before {
            from,
            along: DVec2::ZERO,
        };
        lacks.note([id], Lack::of(elsewhere, from, &everything));
    }
}

/// The samples that a tile has: its own come first.
fn loaded(owned: &Samples, halo: &[Sample]) -> Result<PointSet, TilesError> {
    let places = owned.points().points().iter().copied();
    let places = places.chain(halo.iter().map(|s| s.point)).collect();
    PointSet::new(places).map_err(|error| {
        let ids = owned.ids().iter().copied().chain(halo.iter().map(|s| s.id));
        named(&error, &ids.collect::<Vec<_>>())
    })
}

/// What has to be known, and where to ask for it.
#[derive(Clone, Copy, Debug)]
struct Lack {
    needs: Area,
    ask: Asked,
}

impl Lack {
    /// `None` if all of the region is known.
    fn of(elsewhere: &Elsewhere, from: DVec2, region: &impl Region) -> Option<Self> {
        let ask = elsewhere.nearest(from, region)?;
        let needs = region.bounds();
        Some(Self { needs, ask })
    }

    /// All of both; what is nearer is asked first.
    fn and(self, other: Self) -> Self {
        Self {
            needs: self.needs.union(other.needs),
            ask: if other.ask.is_before(self.ask) {
                other.ask
            } else {
                self.ask
            },
        }
    }
}

/// What the samples of a tile lack, by their positions.
struct Lacks(Vec<Option<Lack>>);

impl Lacks {
    fn new(owned: usize) -> Self {
        Self(vec![None; owned])
    }

    /// Adds what some of the loaded samples lack; those of other tiles do not count.
    fn note(&mut self, of: impl IntoIterator<Item = PointId>, lack: impl Into<Option<Lack>>) {
        let Some(lack) = lack.into() else { return };
        for id in of {
            if let Some(known) = self.0.get_mut(id.index()) {
                *known = Some(known.map_or(lack, |known| known.and(lack)));
            }
        }
    }

    /// The edges of samples that lack nothing, out of all, and the others.
    fn stars(
        &self,
        owned: &Samples,
        halo: &[Sample],
        edges: impl IntoIterator<Item = [PointId; 2]>,
    ) -> Stars {
        let id_of = |at: PointId| match at.index().checked_sub(owned.len()) {
            None => owned.ids()[at.index()],
            Some(behind) => halo[behind].id,
        };
        let is_certain = |at: PointId| matches!(self.0.get(at.index()), Some(None));
        let mut found = Vec::new();
        for [p, q] in edges {
            let (from, to) = (id_of(p), id_of(q));
            let smaller = if from < to { p } else { q };
            if is_certain(smaller) {
                found.push([from.min(to), from.max(to)]);
            }
        }
        found.par_sort_unstable();
        let open = owned.iter().zip(&self.0).filter_map(|(sample, lack)| {
            lack.map(|Lack { needs, ask }| OpenStar {
                sample,
                needs,
                ask: ask.area,
            })
        });
        Stars {
            edges: found,
            open: open.collect(),
        }
    }
}

/// The Delaunay neighbours of all samples, one list after the other.
struct Neighbours {
    first: Vec<usize>,
    all: Vec<PointId>,
}

impl Neighbours {
    fn new(count: usize, delaunay: &Delaunay) -> Self {
        let both_ways = || {
            delaunay.edges().flat_map(|dual| {
                let [p, q] = dual.ends;
                [(p, q), (q, p)]
            })
        };
        let mut first = vec![0; count + 1];
        for (from, _) in both_ways() {
            first[from.index() + 1] += 1;
        }
        for at in 0..count {
            first[at + 1] += first[at];
        }
        let mut free = first.clone();
        let mut all = vec![PointId::from(0); first[count]];
        for (from, to) in both_ways() {
            all[free[from.index()]] = to;
            free[from.index()] += 1;
        }
        Self { first, all }
    }

    fn of(&self, at: usize) -> &[PointId] {
        &self.all[self.first[at]..self.first[at + 1]]
    }
}
