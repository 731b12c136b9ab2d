//! An engine for tests: all tiles in memory, split and loaded in many ways.

use std::collections::BTreeMap;

use curvecrust_geometry::{DVec2, EdgeSet, PointId, PointSet, Progress, Random};
use curvecrust_reconstruct::{HnnCrust, NnCrust, Reconstructor};
use curvecrust_tiles::{
    Area, Atlas, Curve, CurveId, Method, Partition, Piece, Query, Sample, Samples, TilesError,
    join_pieces, joined, pieces, resolve, solve_tile,
};

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

/// The reference: all points at once.
pub(crate) fn in_memory(points: &PointSet, method: Method) -> EdgeSet {
    if method == Method::NN_CRUST {
        NnCrust.reconstruct(points)
    } else {
        HnnCrust { keep: method.keep }.reconstruct(points)
    }
}

/// The tiles, each with the cell that it has for itself, if it has one.
pub(crate) fn split(points: &[DVec2], split: Split) -> Vec<(Vec<Sample>, Option<Area>)> {
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
            assert_eq!(Partition::from_cuts(&partition.cuts()), partition);
            let cells = partition.cells().iter().map(|&cell| Some(cell));
            let tiles = into(cells.len(), &mut |s| partition.cell_of(s.point));
            tiles.into_iter().zip(cells).collect()
        }
        Split::Blocks(size) => {
            let size = size.max(1);
            without_cells(all.chunks(size).map(<[Sample]>::to_vec).collect())
        }
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
pub(crate) fn halo(
    tiles: &[(Vec<Sample>, Option<Area>)],
    number: usize,
    margin: f64,
) -> (Area, Vec<Sample>) {
    let (owned, cell) = &tiles[number];
    let loaded = match cell {
        _ if margin < 0.0 => Area::NOTHING,
        Some(cell) => cell.grown(margin),
        None => Area::of(owned.iter().map(|s| s.point)).grown(margin),
    };
    let others = tiles
        .iter()
        .enumerate()
        .filter(|(other, _)| *other != number);
    let others = others.flat_map(|(_, (samples, _))| samples);
    let inside = others.filter(|s| loaded.contains(s.point)).copied();
    (loaded, inside.collect())
}

/// The edges by tiles, sorted.
pub(crate) fn by_tiles(
    points: &[DVec2],
    method: Method,
    plan: Plan,
) -> Result<Vec<[u64; 2]>, TilesError> {
    let tiles = split(points, plan.split);
    edges_of(&tiles, method, plan)
}

/// The chains by tiles, put together from their pieces.
pub(crate) fn chains_by_tiles(
    points: &[DVec2],
    method: Method,
    plan: Plan,
) -> Result<Vec<(Curve, Vec<u64>)>, TilesError> {
    let tiles = split(points, plan.split);
    let edges = edges_of(&tiles, method, plan)?;
    let of_tile = |(samples, _): &(Vec<Sample>, Option<Area>)| {
        let ids: Vec<u64> = samples.iter().map(|s| s.id).collect();
        pieces(&ids, &edges)
    };
    let all: Vec<Piece> = tiles.iter().rev().flat_map(of_tile).collect();
    let place = |id: u64| points[usize::try_from(id).unwrap_or(0)];
    let (mut all, across): (Vec<Piece>, _) = all.into_iter().partition(Piece::is_whole);
    // Whole curves are joined with nothing, each by itself; then what crosses borders.
    let (mut curves, mut places) = (Vec::new(), Vec::new());
    for piece in &all {
        let alone = join_pieces(&[piece.summary(place)])?;
        curves.extend(alone.curves);
        places.extend(alone.places);
    }
    let summaries: Vec<_> = across.iter().map(|piece| piece.summary(place)).collect();
    let joined = join_pieces(&summaries)?;
    all.extend(across);
    curves.extend(joined.curves);
    places.extend(joined.places);
    curves.sort_by_key(|curve| curve.id);
    let mut chains: BTreeMap<CurveId, Vec<Option<u64>>> = curves
        .iter()
        .map(|curve| (curve.id, (0..curve.count).map(|_| None).collect()))
        .collect();
    for (piece, at) in all.iter().zip(places) {
        let chain = chains.entry(at.curve).or_default();
        let mut vertices = piece.vertices().to_vec();
        if at.reversed {
            vertices.reverse();
        }
        for (index, vertex) in (at.start..).zip(vertices) {
            let index = usize::try_from(index).unwrap_or(0) % chain.len();
            assert_eq!(
                chain[index].replace(vertex),
                None,
                "two samples at one position"
            );
        }
    }
    let whole = |curve: Curve| {
        let vertices = chains.remove(&curve.id).into_iter().flatten().flatten();
        (curve, vertices.collect())
    };
    Ok(curves.into_iter().map(whole).collect())
}

fn edges_of(
    tiles: &[(Vec<Sample>, Option<Area>)],
    method: Method,
    plan: Plan,
) -> Result<Vec<[u64; 2]>, TilesError> {
    edges_and_reads(tiles, method, plan).map(|(edges, _)| edges)
}

/// The edges, and how many questions there were and how often a run was read.
pub(crate) fn edges_and_reads(
    tiles: &[(Vec<Sample>, Option<Area>)],
    method: Method,
    plan: Plan,
) -> Result<(Vec<[u64; 2]>, [usize; 2]), TilesError> {
    let (mut edges, mut claims, mut queries) = (Vec::new(), Vec::new(), Vec::new());
    let (mut areas, mut runs) = (Vec::new(), Vec::new());
    for number in 0..tiles.len() {
        let (loaded, halo) = halo(tiles, number, plan.halo);
        let owned = Samples::new(tiles[number].0.clone())?;
        let solved = solve_tile(&owned, &halo, loaded, method)?;
        let decided = solved.decided();
        assert!(decided.edges.is_sorted());
        edges.extend(decided.edges);
        claims.extend(decided.claims);
        let open = solved.open().iter();
        queries.extend(open.map(|&open| Query::new(open, loaded, method.rule)));
        let samples: Vec<Sample> = owned.iter().collect();
        areas.extend(owned.run_areas(plan.run));
        runs.extend(samples.chunks(plan.run.max(1)).map(<[Sample]>::to_vec));
    }
    let mut counts = [queries.len(), 0];
    let read = |run: usize| {
        counts[1] += 1;
        Ok::<_, TilesError>(runs[run].clone())
    };
    claims.extend(resolve(
        queries,
        &Atlas::new(areas),
        Progress::default(),
        read,
    )?);
    edges.extend(joined(claims, method.keep));
    edges.sort_unstable();
    Ok((edges, counts))
}

/// The same edges as pairs of numbers.
pub(crate) fn pairs(edges: &EdgeSet) -> Vec<[u64; 2]> {
    let number = |id: PointId| u64::from(u32::from(id));
    let edges = edges.edges().iter();
    edges.map(|edge| edge.ends().map(number)).collect()
}
