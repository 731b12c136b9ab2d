//! What no tile could decide alone: the choices of open samples, and edges across borders.

use super::Progress;
use super::plan::{Folder, Sizes};
use super::records;
use super::solve::{Counts, RUN, Rest, put_edges};
use anyhow::Context;
use curvecrust::geometry::Progress as Listener;
use curvecrust::tiles::{
    Area, Atlas, Claim, Method, OpenSample, Partition, Query, Sample, joined, resolve,
};
use std::fs::File;
use std::io::{self, Seek, SeekFrom};

/// Rows of a chunk that take as much memory as a question.
const QUESTION: usize = 8;

/// Where the runs of all tiles are, and the number of the first one of each.
struct Runs<'a> {
    folder: &'a Folder,
    first: Vec<usize>,
    /// The number of samples of each tile.
    samples: Vec<u64>,
}

/// Asks and joins, unless an earlier run did; returns how many samples were open.
pub(super) fn join(
    folder: &Folder,
    partition: &Partition,
    method: Method,
    sizes: Sizes,
    is_wide: bool,
    progress: Progress<'_>,
) -> anyhow::Result<u64> {
    let path = folder.joined();
    if path.exists() {
        return Ok(Counts::open(&path, is_wide)?.0.samples);
    }
    let cells = partition.cells();
    let mut runs = Runs {
        folder,
        first: Vec::new(),
        samples: Vec::new(),
    };
    let mut areas: Vec<Area> = Vec::new();
    let mut total: u64 = 0;
    for tile in 0..cells.len() {
        let result = folder.result(tile);
        let (counts, mut reader) = Counts::open(&result, is_wide)?;
        runs.first.push(areas.len());
        runs.samples.push(counts.samples);
        // The rest follows behind the runs, and is read when its tile asks.
        let of_tile: Vec<Area> = records::get(&mut reader, counts.runs)
            .with_context(|| format!("cannot read {}", result.display()))?;
        areas.extend(of_tile);
        total += counts.open;
    }
    let atlas = Atlas::new(areas);
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
    let edges = joined(claims, method.keep);
    // Of no tile: the samples are those that were open.
    let counts = Counts {
        samples: total,
        edges: edges.len() as u64,
        ..Counts::default()
    };
    records::write(&path, |out| {
        counts.put(out)?;
        put_edges(out, &edges, is_wide)
    })?;
    Ok(total)
}

impl Runs<'_> {
    /// The samples of a run, by its number among those of all tiles.
    fn read(&self, run: usize) -> anyhow::Result<Vec<Sample>> {
        let tile = self.first.partition_point(|&first| first <= run) - 1;
        let start = ((run - self.first[tile]) * RUN) as u64;
        let count = (self.samples[tile] - start).min(RUN as u64);
        let path = self.folder.samples(tile);
        let read = || -> io::Result<Vec<Sample>> {
            let mut file = File::open(&path)?;
            file.seek(SeekFrom::Start(24 * start))?;
            records::get(&mut file, count)
        };
        read().with_context(|| format!("cannot read {}", path.display()))
    }
}
