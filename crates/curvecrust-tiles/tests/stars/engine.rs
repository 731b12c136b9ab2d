//! An engine for tests: all tiles in memory, split and loaded in many ways.

use curvecrust_geometry::{DVec2, PointId, PointSet, Progress, Random};
use curvecrust_reconstruct::crust;
use curvecrust_reconstruct::partial_crust::is_in_all;
use curvecrust_tiles::{
    Area, Atlas, Elsewhere, Ids, Partition, Sample, Samples, SolveStars, TilesError, close_stars,
    solve_crust_tile, solve_delaunay_tile,
};
use curvecrust_voronoi::Delaunay;

/// How points are split into tiles.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Split {
    /// Into cells of about equally many.
    Cells(usize),
    /// By their numbers, each so many: the areas of tiles may lie over each other.
    Blocks(usize),
    /// At random, into so many, some of which may be empty.
    Random(usize, u64),
    /// Into columns of some width: all points may be in one of them.
    Columns(f64),
}

/// A way to reconstruct from tiles.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Plan {
    pub(crate) split: Split,
    /// How far around its samples each tile is loaded; negative: nothing is known to be loaded.
    pub(crate) halo: f64,
    /// Samples that are read together.
    pub(crate) run: usize,
}

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
    let pair = |ends: [PointId; 2]| {
        let [p, q] = ends.map(|id| u64::from(u32::from(id)));
        [p.min(q), p.max(q)]
    };
    let mut edges: Vec<[u64; 2]> = match kind {
        Kind::Delaunay => {
            let delaunay = Delaunay::new(points);
            let in_all = delaunay.edges().filter(|dual| is_in_all(points, dual));
            in_all.map(|dual| pair(dual.ends)).collect()
        }
        Kind::Crust => crust(points)
            .edges()
            .iter()
            .map(|e| pair(e.ends()))
            .collect(),
    };
    edges.sort_unstable();
    edges
}

type Tile = (Vec<Sample>, Option<Area>);

/// The tiles, each with the cell that it has for itself, if it has one.
pub(crate) fn split(points: &[DVec2], split: Split) -> Vec<Tile> {
    let sample = |(id, &point): (usize, &DVec2)| Sample {
        id: id as u64,
        point,
    };
    let all: Vec<Sample> = points.iter().enumerate().map(sample).collect();
    let into = |count: usize, of: &mut dyn FnMut(&Sample) -> usize| {
        let mut tiles = vec![Vec::new(); count];
        for sample in &all {
            tiles[of(sample)].push(*sample);
        }
        tiles
    };
    let without_cells = |tiles: Vec<Vec<Sample>>| tiles.into_iter().map(|t| (t, None)).collect();
    match split {
        Split::Cells(count) => {
            let partition = Partition::of(points.to_vec(), count);
            let cells = partition.cells().iter().map(|&cell| Some(cell));
            let tiles = into(cells.len(), &mut |s| partition.cell_of(s.point));
            tiles.into_iter().zip(cells).collect()
        }
        Split::Blocks(size) => without_cells(all.chunks(size).map(<[Sample]>::to_vec).collect()),
        Split::Random(count, seed) => {
            let mut random = Random::new(seed);
            without_cells(into(count, &mut |_| random.below(count)))
        }
        Split::Columns(width) => {
            let borders = || (-4..4).map(|i| f64::from(i) * width);
            let column = |s: &Sample| borders().filter(|&border| s.point.x >= border).count();
            without_cells(into(9, &mut |s| column(s)))
        }
    }
}

/// What a tile may take for loaded, and the samples of other tiles that it needs for that.
fn halo(tiles: &[Tile], number: usize, margin: f64) -> (Area, Vec<Sample>) {
    let (owned, cell) = &tiles[number];
    let loaded = match cell {
        _ if margin < 0.0 => Area::NOTHING,
        Some(cell) => cell.grown(margin),
        None => Area::of(owned.iter().map(|s| s.point)).grown(margin),
    };
    let others = tiles.iter().enumerate();
    let others = others.filter(|(other, _)| *other != number);
    let others = others.flat_map(|(_, (samples, _))| samples);
    let inside = others.filter(|s| loaded.contains(s.point)).copied();
    (loaded, inside.collect())
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
