//! One tile after the other: its edges as pieces of curves.

use super::row::{ROW_BYTES, Row};
use super::{Progress, Solved, summary};
use crate::tiles::plan::Folder;
use crate::tiles::records::{self, put, put_words};
use crate::tiles::solve::read_edges;
use anyhow::Context;
use curvecrust::tiles::{Ids, PieceSummary, Sample, join_pieces, pieces};
use rayon::prelude::*;
use std::fs::{self, File};
use std::io::{self, BufReader, Seek, SeekFrom, Write};
use std::path::PathBuf;

/// What a file of pieces starts with.
const MAGIC: u64 = u64::from_le_bytes(*b"crvpiec1");

/// The bytes of a header.
const HEADER: u64 = 8 * 6;

/// The pieces of a tile.
#[derive(Default)]
pub(super) struct Pieces {
    /// Whole curves, sorted by their names, and their samples. They start and run as in the result.
    pub(super) rows: Vec<Row>,
    whole: Vec<Sample>,
    /// The other pieces, and theirs.
    parts: Vec<PieceSummary>,
    part_samples: Vec<Sample>,
}

/// A file of [`Pieces`].
pub(super) struct Traced {
    path: PathBuf,
    reader: BufReader<File>,
    /// The number of whole curves, of their samples, of other pieces and of theirs.
    pub(super) whole: u64,
    pub(super) whole_samples: u64,
    pub(super) parts: u64,
    part_samples: u64,
    summary_words: u64,
}

/// Traces the tiles that are not traced yet.
pub(super) fn trace(job: &Solved<'_>, progress: Progress<'_>) -> anyhow::Result<()> {
    let folder = job.folder;
    let mut links = None;
    for tile in 0..job.tiles() {
        progress(tile, job.tiles());
        if folder.pieces(tile).exists() {
            continue;
        }
        if links.is_none() {
            links = Some(both_ways(&read_edges(&folder.joined(), job.is_wide)?));
        }
        let samples = samples(folder, tile)?;
        let mut edges = read_edges(&folder.edges(tile, job.way), job.is_wide)?;
        add_links(&samples, links.as_deref().unwrap_or_default(), &mut edges);
        write_pieces(folder, tile, &samples, edges)?;
    }
    Ok(())
}

/// The samples of a tile, by their ids.
fn samples(folder: &Folder, tile: usize) -> anyhow::Result<Vec<Sample>> {
    let path = folder.samples(tile);
    let read = || -> io::Result<Vec<Sample>> {
        let count = fs::metadata(&path)?.len() / 24;
        records::get(&mut File::open(&path)?, count)
    };
    let mut samples = read().with_context(|| format!("cannot read {}", path.display()))?;
    samples.par_sort_unstable_by_key(|sample| sample.id);
    Ok(samples)
}

/// Each edge from both of its ends, sorted.
fn both_ways(edges: &[[u64; 2]]) -> Vec<[u64; 2]> {
    let mut both: Vec<_> = edges.iter().flat_map(|&[a, b]| [[a, b], [b, a]]).collect();
    both.par_sort_unstable();
    both
}

/// Adds the links of the samples, both sorted.
fn add_links(samples: &[Sample], links: &[[u64; 2]], edges: &mut Vec<[u64; 2]>) {
    let mut links = links.iter().copied().peekable();
    for sample in samples {
        while links.next_if(|link| link[0] < sample.id).is_some() {}
        while let Some(link) = links.next_if(|link| link[0] == sample.id) {
            edges.push(link);
        }
    }
}

fn write_pieces(
    folder: &Folder,
    tile: usize,
    samples: &[Sample],
    edges: Vec<[u64; 2]>,
) -> anyhow::Result<()> {
    let ids = Ids::new(samples.iter().map(|sample| sample.id).collect());
    let found = pieces(ids.as_slice(), &edges);
    drop(edges);
    let mut pieces = Pieces {
        rows: Vec::new(),
        parts: Vec::new(),
        // Room that is not used takes no memory.
        whole: Vec::with_capacity(samples.len()),
        part_samples: Vec::with_capacity(samples.len()),
    };
    let mut places = Vec::new();
    for piece in found {
        // Pieces name samples of the tile alone.
        let positions = piece.vertices().iter().filter_map(|&id| ids.position(id));
        let of_piece = positions.map(|at| samples[at]);
        if !piece.is_whole() {
            let start = pieces.part_samples.len();
            pieces.part_samples.extend(of_piece);
            places.clear();
            places.extend(pieces.part_samples[start..].iter().map(|s| s.point));
            pieces.parts.push(piece.summary_of(&places));
            continue;
        }
        let start = pieces.whole.len();
        pieces.whole.extend(of_piece);
        let of_piece = &mut pieces.whole[start..];
        places.clear();
        places.extend(of_piece.iter().map(|sample| sample.point));
        let joined = join_pieces(&[piece.summary_of(&places)])?;
        if joined.curves.iter().any(|curve| curve.signed_area < 0.0) {
            // From the same one on.
            of_piece[1..].reverse();
        }
        pieces.rows.extend(joined.curves.iter().map(Row::from));
    }
    pieces.write(folder.pieces(tile))
}

impl Pieces {
    /// Curves without their samples.
    pub(super) fn of_curves(rows: Vec<Row>) -> Self {
        Self {
            rows,
            ..Self::default()
        }
    }

    /// Writes a file of pieces.
    pub(super) fn write(&self, path: PathBuf) -> anyhow::Result<()> {
        let header = [
            MAGIC,
            self.rows.len() as u64,
            self.whole.len() as u64,
            self.parts.len() as u64,
            self.part_samples.len() as u64,
            self.parts.iter().map(summary::length).sum::<usize>() as u64,
        ];
        records::write(&path, |out| {
            put_words(out, &header)?;
            put(out, self.rows.iter().copied())?;
            for part in &self.parts {
                summary::put(out, part)?;
            }
            put(out, self.whole.iter().copied())?;
            put(out, self.part_samples.iter().copied())?;
            out.flush()
        })
    }
}

impl Traced {
    /// Opens a file of pieces, and checks that all of it is there.
    pub(super) fn open(path: PathBuf) -> anyhow::Result<Self> {
        let open = || -> io::Result<_> {
            let file = File::open(&path)?;
            let bytes = file.metadata()?.len();
            let mut reader = BufReader::with_capacity(records::BUFFER, file);
            let header: [u64; 6] = records::get_words(&mut reader)?;
            let [
                magic,
                whole,
                whole_samples,
                parts,
                part_samples,
                summary_words,
            ] = header;
            // A damaged header may have any numbers.
            let is_whole = magic == MAGIC
                && header[1..].iter().all(|&n| n < 1 << 48)
                && bytes
                    == HEADER
                        + ROW_BYTES as u64 * whole
                        + 8 * summary_words
                        + 24 * (whole_samples + part_samples);
            if is_whole {
                let counts = (whole, whole_samples, parts, part_samples, summary_words);
                Ok((reader, counts))
            } else {
                Err(io::Error::other("it is damaged"))
            }
        };
        let (reader, (whole, whole_samples, parts, part_samples, summary_words)) =
            open().with_context(|| Self::advice(&path))?;
        Ok(Self {
            path,
            reader,
            whole,
            whole_samples,
            parts,
            part_samples,
            summary_words,
        })
    }

    /// The whole curves.
    pub(super) fn rows(&mut self) -> anyhow::Result<Vec<Row>> {
        let (whole, samples) = (self.whole, self.whole_samples);
        self.at(Self::rows_start(), |reader| {
            let rows: Vec<Row> = records::get(reader, whole)?;
            ensure_sum(rows.iter().map(|row| row.count), samples)?;
            Ok(rows)
        })
    }

    /// The other pieces.
    pub(super) fn summaries(&mut self) -> anyhow::Result<Vec<PieceSummary>> {
        let (parts, samples) = (self.parts, self.part_samples);
        self.at(self.summaries_start(), |reader| {
            let parts = (0..parts).map(|_| summary::get(reader));
            let parts: Vec<PieceSummary> = parts.collect::<io::Result<_>>()?;
            ensure_sum(parts.iter().map(|part| part.count), samples)?;
            Ok(parts)
        })
    }

    /// The samples of whole curves, one curve after the other.
    pub(super) fn whole_vertices(&mut self) -> anyhow::Result<Vec<Sample>> {
        let count = self.whole_samples;
        self.at(self.vertices_start(), |reader| records::get(reader, count))
    }

    /// The samples of the other pieces.
    pub(super) fn part_vertices(&mut self) -> anyhow::Result<Vec<Sample>> {
        let (skipped, count) = (self.whole_samples, self.part_samples);
        let start = self.vertices_start() + 24 * skipped;
        self.at(start, |reader| records::get(reader, count))
    }

    /// Where the whole curves are.
    pub(super) fn rows_start() -> u64 {
        HEADER
    }

    fn summaries_start(&self) -> u64 {
        HEADER + ROW_BYTES as u64 * self.whole
    }

    fn vertices_start(&self) -> u64 {
        self.summaries_start() + 8 * self.summary_words
    }

    fn at<T>(
        &mut self,
        start: u64,
        read: impl FnOnce(&mut BufReader<File>) -> io::Result<T>,
    ) -> anyhow::Result<T> {
        let sought = self.reader.seek(SeekFrom::Start(start));
        let read = sought.and_then(|_| read(&mut self.reader));
        read.with_context(|| Self::advice(&self.path))
    }

    fn advice(path: &std::path::Path) -> String {
        format!("cannot read {}: delete it and start again", path.display())
    }
}

/// An error unless pieces have as many samples as there are.
fn ensure_sum(counts: impl Iterator<Item = u64>, samples: u64) -> io::Result<()> {
    if counts.fold(0, u64::saturating_add) == samples {
        Ok(())
    } else {
        Err(io::Error::other("it is damaged"))
    }
}
