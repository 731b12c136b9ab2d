//! One tile at a time: its samples along a Hilbert curve, and what is certain about its edges.

use super::Progress;
use super::distribute::Chunks;
use super::plan::Folder;
use super::records::{self, put, put_words};
use super::way::Way;
use anyhow::Context;
use curvecrust::tiles::{Claim, Decided, OpenSample, Partition, Samples, solve_tile};
use std::fs::File;
use std::io::{self, BufReader, Read, Seek, SeekFrom, Write};
use std::path::Path;

/// Samples of a run: what is read together to answer a question.
pub(super) const RUN: usize = 2048;

/// What a file of results starts with.
const MAGIC: u64 = u64::from_le_bytes(*b"crvtile1");

/// The words of the header of a result.
const HEADER: u64 = 6;

/// How much there is in the file of a result. The edges come last.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Counts {
    pub(super) samples: u64,
    pub(super) runs: u64,
    pub(super) claims: u64,
    pub(super) open: u64,
    pub(super) edges: u64,
}

/// What one tile passes on, but for its runs and edges.
pub(super) struct Rest {
    pub(super) claims: Vec<Claim>,
    pub(super) open: Vec<OpenSample>,
}

/// Solves the tiles that are not solved yet.
pub(super) fn solve(
    chunks: &Chunks,
    folder: &Folder,
    partition: &Partition,
    way: Way,
    is_wide: bool,
    progress: Progress<'_>,
) -> anyhow::Result<()> {
    let cells = partition.cells();
    for (tile, &cell) in cells.iter().enumerate() {
        progress(tile, cells.len());
        let path = folder.result(tile);
        if path.exists() {
            continue;
        }
        let samples = Samples::new(chunks.samples(folder, tile)?)?;
        records::write(&folder.samples(tile), |out| put(out, samples.iter()))?;
        let (decided, open) = match way {
            Way::Choices(method) => {
                let solved = solve_tile(&samples, &[], cell, method)?;
                (solved.decided(), solved.open().to_vec())
            }
            // They are solved when it is known where the samples of all tiles are.
            Way::Stars(_) => (Decided::default(), Vec::new()),
        };
        let runs = samples.run_areas(RUN);
        let counts = Counts {
            samples: samples.len() as u64,
            runs: runs.len() as u64,
            claims: decided.claims.len() as u64,
            open: open.len() as u64,
            edges: decided.edges.len() as u64,
        };
        records::write(&path, |out| {
            counts.put(out)?;
            put(out, runs)?;
            put(out, decided.claims)?;
            put(out, open)?;
            put_edges(out, &decided.edges, is_wide)
        })?;
    }
    Ok(())
}

/// Writes edges, with numbers of 4 or 8 bytes.
pub(super) fn put_edges(out: &mut impl Write, edges: &[[u64; 2]], is_wide: bool) -> io::Result<()> {
    let bytes = edge_bytes(is_wide) / 2;
    let mut numbers = edges.iter().flatten();
    numbers.try_for_each(|number| out.write_all(&number.to_le_bytes()[..bytes]))
}

/// The edge that such bytes are.
pub(super) fn edge(bytes: &[u8]) -> [u64; 2] {
    let number = |half: &[u8]| {
        let mut number = [0; 8];
        number[..half.len()].copy_from_slice(half);
        u64::from_le_bytes(number)
    };
    let (a, b) = bytes.split_at(bytes.len() / 2);
    [number(a), number(b)]
}

/// The edges of a result.
pub(super) fn read_edges(path: &Path, is_wide: bool) -> anyhow::Result<Vec<[u64; 2]>> {
    let (counts, mut reader) = Counts::open(path, is_wide)?;
    let mut read = || -> io::Result<_> {
        reader.seek(SeekFrom::Start(counts.to_edges()))?;
        let mut edges = Vec::with_capacity(usize::try_from(counts.edges).unwrap_or(0));
        let mut buffer = [0; 16];
        let buffer = &mut buffer[..edge_bytes(is_wide)];
        for _ in 0..counts.edges {
            reader.read_exact(buffer)?;
            edges.push(edge(buffer));
        }
        Ok(edges)
    };
    read().with_context(|| format!("cannot read {}", path.display()))
}

/// The bytes of an edge.
pub(super) fn edge_bytes(is_wide: bool) -> usize {
    if is_wide { 16 } else { 8 }
}

impl Counts {
    pub(super) fn put(&self, out: &mut impl Write) -> io::Result<()> {
        let Self {
            samples,
            runs,
            claims,
            open,
            edges,
        } = *self;
        put_words(out, &[MAGIC, samples, runs, claims, open, edges])
    }

    /// Where the edges start.
    pub(super) fn to_edges(self) -> u64 {
        self.to_claims() + 16 * self.claims + 80 * self.open
    }

    /// The bytes before the claims.
    fn to_claims(self) -> u64 {
        8 * HEADER + 32 * self.runs
    }

    /// Opens a result, and checks that all of it is there.
    pub(super) fn open(path: &Path, is_wide: bool) -> anyhow::Result<(Self, BufReader<File>)> {
        let open = || -> io::Result<_> {
            let file = File::open(path)?;
            let length = file.metadata()?.len();
            let mut reader = BufReader::with_capacity(records::BUFFER, file);
            let [magic, samples, runs, claims, open, edges] = records::get_words(&mut reader)?;
            let counts = Self {
                samples,
                runs,
                claims,
                open,
                edges,
            };
            // A damaged header may have any numbers.
            let is_whole = magic == MAGIC
                && [samples, runs, claims, open, edges]
                    .into_iter()
                    .all(|n| n < 1 << 48)
                && length == counts.to_edges() + edges * edge_bytes(is_wide) as u64;
            if is_whole {
                Ok((counts, reader))
            } else {
                Err(io::Error::other("it is damaged"))
            }
        };
        open().with_context(|| {
            let path = path.display();
            format!("cannot read {path}: delete it and start again")
        })
    }
}

impl Rest {
    /// What a tile passes on.
    pub(super) fn read(path: &Path, is_wide: bool) -> anyhow::Result<Self> {
        let (counts, mut reader) = Counts::open(path, is_wide)?;
        Self::of(counts, &mut reader).with_context(|| format!("cannot read {}", path.display()))
    }

    fn of(counts: Counts, reader: &mut (impl Read + Seek)) -> io::Result<Self> {
        reader.seek(SeekFrom::Start(counts.to_claims()))?;
        Ok(Self {
            claims: records::get(reader, counts.claims)?,
            open: records::get(reader, counts.open)?,
        })
    }
}
