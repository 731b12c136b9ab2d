//! Tiles that are solved with runs of other tiles, until all of their edges are certain.

use super::Progress;
use super::join;
use super::plan::Folder;
use super::records::{self, put};
use super::runs::Runs;
use super::solve::{Counts, Rest, put_edges};
use curvecrust::geometry::Progress as Listener;
use curvecrust::reconstruct::Keep;
use curvecrust::tiles::{
    Claim, Elsewhere, Ids, Partition, Samples, SolveStars, close_stars, joined,
};
use std::path::Path;
use std::sync::OnceLock;

/// Solves the tiles that are not solved yet, and joins what crosses borders; returns how many
/// samples asked other tiles.
pub(super) fn close(
    folder: &Folder,
    partition: &Partition,
    solve: SolveStars,
    is_wide: bool,
    progress: Progress<'_>,
) -> anyhow::Result<u64> {
    join::once(folder, is_wide, || {
        close_tiles(folder, partition, solve, is_wide, progress)
    })
}

/// How many samples asked other tiles, and the edges across borders.
fn close_tiles(
    folder: &Folder,
    partition: &Partition,
    solve: SolveStars,
    is_wide: bool,
    progress: Progress<'_>,
) -> anyhow::Result<(u64, Vec<[u64; 2]>)> {
    let cells = partition.cells();
    let (runs, atlas) = Runs::of_tiles(folder, cells.len(), is_wide)?;
    let mut claims = Vec::new();
    let mut asked = 0;
    for (tile, &cell) in cells.iter().enumerate() {
        progress(tile, cells.len());
        let path = folder.stars(tile);
        if !path.exists() {
            let owned = Samples::new(runs.read_tile(tile)?)?;
            let mut elsewhere = Elsewhere::within(atlas.clone(), cell);
            runs.of(tile).for_each(|run| elsewhere.note_read(run));
            let (edges, asked) = close_tile(solve, &owned, elsewhere, &runs)?;
            write(&path, &owned, edges, asked, is_wide)?;
        }
        let (counts, _) = Counts::open(&path, is_wide)?;
        asked += counts.samples;
        claims.extend(Rest::read(&path, is_wide)?.claims);
    }
    // An edge is found once, so its only claim has to do.
    Ok((asked, joined(claims, Keep::Union)))
}

/// The edges of a tile, and how many of its samples asked others.
fn close_tile(
    solve: SolveStars,
    owned: &Samples,
    elsewhere: Elsewhere,
    runs: &Runs<'_>,
) -> anyhow::Result<(Vec<[u64; 2]>, usize)> {
    let all = Ids::new(owned.ids().to_vec());
    let after_first = OnceLock::new();
    let listen = |certain: usize, of: usize| {
        after_first.get_or_init(|| of - certain);
    };
    let read = |run| runs.read(run);
    let edges = close_stars(solve, owned, all, elsewhere, Listener::new(&listen), read)?;
    Ok((edges, after_first.into_inner().unwrap_or(0)))
}

/// Writes the edges of a tile; those that lead to other tiles as claims.
fn write(
    path: &Path,
    owned: &Samples,
    edges: Vec<[u64; 2]>,
    asked: usize,
    is_wide: bool,
) -> anyhow::Result<()> {
    let ids = Ids::new(owned.ids().to_vec());
    let is_inside = |edge: &[u64; 2]| edge.iter().all(|&id| ids.position(id).is_some());
    let (inside, across): (Vec<_>, Vec<_>) = edges.into_iter().partition(is_inside);
    let counts = Counts {
        samples: asked as u64,
        claims: across.len() as u64,
        edges: inside.len() as u64,
        ..Counts::default()
    };
    records::write(path, |out| {
        counts.put(out)?;
        put(out, across.into_iter().map(|[from, to]| Claim { from, to }))?;
        put_edges(out, &inside, is_wide)
    })
}
