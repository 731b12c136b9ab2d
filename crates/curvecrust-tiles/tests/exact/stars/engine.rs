//! An engine for stars: each tile reads runs of the others until its stars are certain.

use curvecrust_geometry::{DVec2, Edge, EdgeSet, PointSet, Progress};
use curvecrust_reconstruct::crust;
use curvecrust_reconstruct::partial_crust::is_in_all;
use curvecrust_tiles::{
    Area, Atlas, Elsewhere, Ids, Sample, Samples, SolveStars, TilesError, close_stars,
    solve_crust_tile, solve_delaunay_tile,
};
use curvecrust_voronoi::Delaunay;

use crate::engine::{Plan, halo, pairs, split};

/// What is found.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Kind {
    Delaunay,
    Crust,
}

impl Kind {
    pub(crate) const ALL: [Self; 2] = [Self::Delaunay, Self::Crust];

    fn solve(self) -> SolveStars {
        match self {
            Self::Delaunay => solve_delaunay_tile,
            Self::Crust => solve_crust_tile,
        }
    }
}

/// The reference: all points at once.
pub(crate) fn at_once(points: &PointSet, kind: Kind) -> Vec<[u64; 2]> {
    let edges = match kind {
        Kind::Delaunay => {
            let delaunay = Delaunay::new(points);
            let in_all = delaunay.edges().filter(|dual| is_in_all(points, dual));
            let edges = in_all.filter_map(|dual| Edge::new(dual.ends[0], dual.ends[1]));
            EdgeSet::new(points.len(), edges)
        }
        Kind::Crust => crust(points),
    };
    pairs(&edges)
}

/// The edges by tiles, sorted: first with a halo alone, then what is open from runs of others.
pub(crate) fn by_tiles(
    points: &[DVec2],
    kind: Kind,
    plan: Plan,
) -> Result<Vec<[u64; 2]>, TilesError> {
    let tiles = split(points, plan.split);
    let owned = tiles
        .iter()
        .map(|(samples, _)| Samples::new(samples.clone()));
    let owned: Vec<Samples> = owned.collect::<Result<_, _>>()?;
    let (mut areas, mut runs) = (Vec::new(), Vec::new());
    for (number, samples) in owned.iter().enumerate() {
        areas.extend(samples.run_areas(plan.run));
        let list: Vec<Sample> = samples.iter().collect();
        runs.extend(list.chunks(plan.run).map(|run| (number, run.to_vec())));
    }
    let atlas = Atlas::new(areas);
    let mut edges = Vec::new();
    for (number, samples) in owned.iter().enumerate() {
        let (loaded, halo) = halo(&tiles, number, plan.halo);
        let mut stars = kind.solve()(samples, &halo, &Elsewhere::outside(loaded))?;
        assert!(stars.edges.is_sorted());
        edges.append(&mut stars.edges);
        let mut elsewhere = Elsewhere::within(atlas.clone(), Area::NOTHING);
        let own = (0..runs.len()).filter(|&run| runs[run].0 == number);
        own.for_each(|run| elsewhere.note_read(run));
        let read = |run: usize| Ok::<_, TilesError>(runs[run].1.clone());
        let solve = kind.solve();
        let open = Ids::new(stars.open.iter().map(|star| star.sample.id).collect());
        edges.extend(close_stars(
            solve,
            samples,
            open,
            elsewhere,
            Progress::default(),
            read,
        )?);
    }
    edges.sort_unstable();
    Ok(edges)
}
