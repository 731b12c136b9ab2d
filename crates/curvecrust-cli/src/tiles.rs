//! Points that memory cannot hold, reconstructed tile by tile in a folder.
//!
//! The steps are those of `curvecrust-tiles`; this is what reads and writes. Each step leaves files
//! behind, which are there completely or not at all, and does what an earlier run has not done: a
//! run that was killed goes on where it stopped.
//!
//! | step | file | what for |
//! |---|---|---|
//! | survey | [`input`], [`plan`] | reads all points, checks them, and cuts the plane into tiles |
//! | distribute | [`distribute`] | sorts the rows by tiles, chunk by chunk |
//! | solve | [`solve`] | finds the edges of each tile, and what it cannot decide |
//! | join | [`join`], [`stars`] | asks the tiles for what is open |
//! | merge | [`merge`] | writes the edges of all |
//! | order | [`polylines`] | writes the curves, tile by tile |

mod distribute;
mod input;
mod join;
mod merge;
mod plan;
mod polylines;
mod records;
mod runs;
mod solve;
mod stars;
mod way;

use crate::console::Console;
use crate::format::Format;
use crate::output::Output;
use crate::output::npy::Pairs;
use crate::points::ColumnNames;
use anyhow::Context;
use curvecrust::tiles::Partition;
use distribute::Chunks;
use input::Input;
use merge::Merge;
use plan::{Folder, Job, Plan, Sizes};
use polylines::Solved;
pub(crate) use polylines::{Found, Place};
use solve::{Counts, edge, edge_bytes};
use std::fs;
use std::io;
use std::path::{Path, PathBuf};
pub(crate) use way::Way;

/// Hears how much of how much is done.
type Progress<'a> = &'a (dyn Fn(usize, usize) + Sync);

/// Bytes that the program takes whatever the points are.
const BASE: u64 = 32 << 20;

/// The number of points of the fastest tiles, if memory holds them: larger ones leave the cache.
const TILE: usize = 1 << 18;

/// More tiles than this would leave too few points of each in a chunk: they are larger then.
const MOST_TILES: usize = 1 << 11;

/// Bytes that are needed for each point of a tile whose samples make choices.
const POINT: u64 = 128;

/// Rows of a chunk for each such point that memory holds: a row takes about half as much.
const ROWS: usize = 2;

/// The least memory that a run can be limited to.
pub(crate) const LEAST_MEMORY: u64 = 2 * BASE;

/// How a job is divided.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Limits {
    /// Bytes of memory that may be used.
    pub(crate) memory: u64,
    /// Points of a tile; `None`: as many as the memory allows.
    pub(crate) tile_points: Option<usize>,
}

/// What was done.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Done {
    pub(crate) points: usize,
    pub(crate) tiles: usize,
    /// Samples whose choice their tile did not know.
    pub(crate) open: u64,
    /// The number of edges, if they were written.
    pub(crate) edges: Option<u64>,
    pub(crate) curves: Option<Found>,
}

/// What is written: edges, curves or both.
#[derive(Debug)]
pub(crate) struct Wanted {
    pub(crate) edges: Option<Output>,
    pub(crate) curves: Option<Place>,
}

impl Limits {
    /// The sizes of tiles and chunks for a number of points.
    fn sizes(self, points: usize, way: Way) -> Sizes {
        let fits = self.memory.saturating_sub(BASE);
        let points_of = |bytes: u64| {
            let fits = usize::try_from(fits / bytes).unwrap_or(usize::MAX);
            fits.clamp(1, u32::MAX as usize / 4)
        };
        let fast = TILE.max(points / MOST_TILES);
        Sizes {
            tile: self.tile_points.unwrap_or(points_of(way.bytes()).min(fast)),
            chunk: ROWS * self.tile_points.unwrap_or(points_of(POINT)),
        }
    }
}

/// Where the points are.
#[derive(Debug)]
pub(crate) struct Points {
    /// A file, or a folder of tables.
    pub(crate) path: PathBuf,
    /// Arrays or tables.
    pub(crate) format: Format,
    pub(crate) columns: Option<ColumnNames>,
}

/// Reconstructs points in a folder, and writes what is wanted.
pub(crate) fn run(
    points: &Points,
    folder: &Path,
    algorithm: &str,
    way: Way,
    limits: Limits,
    wanted: &Wanted,
    console: &Console,
) -> anyhow::Result<Done> {
    let name = crate::input::name(&points.path);
    let columns = points.columns.as_ref();
    let mut input = Input::open(&points.path, points.format, columns)?;
    let print = input.fingerprint(columns)?;
    for note in input.notes() {
        console.note(format_args!("{name}: {note}"));
    }
    let points = input.len();
    let sizes = limits.sizes(points, way);
    let job = Job::new(algorithm, points, sizes, print);
    let folder = Folder::open(folder)?;
    let plan = match folder.plan(&job)? {
        Some(plan) => plan,
        None => {
            let survey = |progress: Progress<'_>| input.survey(sizes.tile, progress);
            let partition = console.during(&format!("reading {name}"), survey)?;
            let plan = Plan::new(job, &partition);
            folder.write_plan(&plan)?;
            plan
        }
    };
    let partition = plan.partition();
    let is_wide = points > u32::MAX as usize;
    let chunks = Chunks::new(points, sizes.chunk, partition.cells().len());
    solved(
        &mut input, &folder, &partition, &chunks, way, is_wide, console,
    )?;
    let open = console.during("asking other tiles", |progress| match way {
        Way::Choices(method) => join::join(&folder, &partition, method, sizes, is_wide, progress),
        Way::Stars(solve) => stars::close(&folder, &partition, solve, is_wide, progress),
    })?;
    let tiles = partition.cells().len();
    let write_edges = |output: &Output| {
        console.during("writing", |progress| {
            write(&folder, tiles, way, is_wide, output, progress)
        })
    };
    let edges = wanted.edges.as_ref().map(write_edges).transpose()?;
    let solved = Solved {
        folder: &folder,
        partition: &partition,
        sizes,
        way,
        is_wide,
    };
    let write_curves = |place| solved.write_polylines(place, console);
    Ok(Done {
        points,
        tiles,
        open,
        edges,
        curves: wanted.curves.as_ref().map(write_curves).transpose()?,
    })
}

/// Sees to it that every tile is solved.
fn solved(
    input: &mut Input,
    folder: &Folder,
    partition: &Partition,
    chunks: &Chunks,
    way: Way,
    is_wide: bool,
    console: &Console,
) -> anyhow::Result<()> {
    let mut tiles = 0..partition.cells().len();
    // Without any result, chunks are missing because they are not written yet.
    if !tiles.clone().any(|tile| folder.result(tile).exists()) {
        console.during("sorting by tiles", |progress| {
            chunks.write(input, folder, partition, progress)
        })?;
    }
    if !tiles.all(|tile| folder.result(tile).exists()) {
        console.during("solving tiles", |progress| {
            solve::solve(chunks, folder, partition, way, is_wide, progress)
        })?;
    }
    for path in (0..chunks.len()).map(|number| folder.chunk(number)) {
        match fs::remove_file(&path) {
            Err(error) if error.kind() != io::ErrorKind::NotFound => {
                let context = || format!("cannot remove {}", path.display());
                return Err(error).with_context(context);
            }
            _ => {}
        }
    }
    Ok(())
}

/// Writes the edges of all tiles; returns their number.
fn write(
    folder: &Folder,
    tiles: usize,
    way: Way,
    is_wide: bool,
    output: &Output,
    progress: Progress<'_>,
) -> anyhow::Result<u64> {
    let mut merge = Merge::new(edge_bytes(is_wide));
    let results = (0..tiles).map(|tile| folder.edges(tile, way));
    for path in results.chain([folder.joined()]) {
        let (counts, _) = Counts::open(&path, is_wide)?;
        merge.add(path, counts.to_edges(), counts.edges);
    }
    let count = merge.count;
    let total = usize::try_from(count)?;
    output.write(|out| {
        let mut pairs = Pairs::new(out, total, is_wide)?;
        let mut done = 0;
        merge.run(edge, |_, edge, _| {
            if done % (1 << 16) == 0 {
                progress(done, total);
            }
            done += 1;
            pairs.write(edge)
        })
    })?;
    Ok(count)
}
