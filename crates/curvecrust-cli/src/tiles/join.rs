//! What no tile could decide alone: the choices of open samples, and edges across borders.

use super::Progress;
use super::plan::{Folder, Sizes};
use super::records;
use super::runs::Runs;
use super::solve::{Counts, Rest, put_edges};
use curvecrust::geometry::Progress as Listener;
use curvecrust::tiles::{Claim, Method, OpenSample, Partition, Query, joined, resolve};

/// Rows of a chunk that take as much memory as a question.
const QUESTION: usize = 8;

/// Asks and joins, unless an earlier run did; returns how many samples were open.
pub(super) fn join(
    folder: &Folder,
    partition: &Partition,
    method: Method,
    sizes: Sizes,
    is_wide: bool,
    progress: Progress<'_>,
) -> anyhow::Result<u64> {
    once(folder, is_wide, || {
        ask(folder, partition, method, sizes, is_wide, progress)
    })
}

/// Writes the edges that no tile has, unless an earlier run did; returns how many samples asked
/// other tiles, which stands before the edges.
pub(super) fn once(
    folder: &Folder,
    is_wide: bool,
    join: impl FnOnce() -> anyhow::Result<(u64, Vec<[u64; 2]>)>,
) -> anyhow::Result<u64> {
    let path = folder.joined();
    if path.exists() {
        return Ok(Counts::open(&path, is_wide)?.0.samples);
    }
    let (samples, edges) = join()?;
    let counts = Counts {
        samples,
        edges: edges.len() as u64,
        ..Counts::default()
    };
    records::write(&path, |out| {
        counts.put(out)?;
        put_edges(out, &edges, is_wide)
    })?;
    Ok(samples)
}

/// How many samples are open, and the edges that follow from the answers.
fn ask(
    folder: &Folder,
    partition: &Partition,
    method: Method,
    sizes: Sizes,
    is_wide: bool,
    progress: Progress<'_>,
) -> anyhow::Result<(u64, Vec<[u64; 2]>)> {
    let cells = partition.cells();
    let (runs, atlas) = Runs::of_tiles(folder, cells.len(), is_wide)?;
    let total = runs.open;
    let mut claims: Vec<Claim> = Vec::new();
    let mut queries = Vec::new();
    let mut done = 0;
    for (tile, &cell) in cells.iter().enumerate() {
        let rest = Rest::read(&folder.result(tile), is_wide)?;
        claims.extend(rest.claims);
        let query = |open: OpenSample| Query::new(open, cell, method.rule);
        queries.extend(rest.open.into_iter().map(query));
        if queries.len() >= sizes.chunk / QUESTION || tile + 1 == cells.len() {
            let asked = std::mem::take(&mut queries);
            let count = asked.len();
            let of = usize::try_from(total).unwrap_or(usize::MAX);
            let listen = |answered: usize, _: usize| progress(done + answered, of);
            let read = |run| runs.read(run);
            claims.extend(resolve(asked, &atlas, Listener::new(&listen), read)?);
            done += count;
        }
    }
    Ok((total, joined(claims, method.keep)))
}
