//! The points of the input by tiles: a chunk of rows a file, sorted by their tiles.
//!
//! A chunk starts with the numbers of its tiles and, for each tile, how many samples of earlier
//! tiles it has; behind the last tile stands the number of all. The samples follow.

use super::Progress;
use super::input::Input;
use super::plan::Folder;
use super::records;
use anyhow::Context;
use curvecrust::DVec2;
use curvecrust::tiles::{Partition, Sample};
use rayon::prelude::*;
use std::fs::File;
use std::io::{self, BufReader, Read, Seek, SeekFrom, Write};
use std::path::Path;

/// The chunks of a job.
pub(super) struct Chunks {
    rows: usize,
    points: usize,
    tiles: usize,
}

impl Chunks {
    pub(super) fn new(points: usize, rows: usize, tiles: usize) -> Self {
        Self {
            rows,
            points,
            tiles,
        }
    }

    pub(super) fn len(&self) -> usize {
        self.points.div_ceil(self.rows)
    }

    /// Writes the chunks that are not there yet.
    pub(super) fn write(
        &self,
        input: &mut Input,
        folder: &Folder,
        partition: &Partition,
        progress: Progress<'_>,
    ) -> anyhow::Result<()> {
        let mut points = Vec::new();
        for number in 0..self.len() {
            let first = number * self.rows;
            let path = folder.chunk(number);
            if path.exists() {
                continue;
            }
            points.clear();
            let part = first..self.points.min(first + self.rows);
            input.read_part(part, &mut points, progress)?;
            let (starts, samples) = sorted(&points, first as u64, partition);
            records::write(&path, |out| {
                records::put_words(out, &[self.tiles as u64])?;
                records::put_words(out, &starts)?;
                records::put(out, samples)?;
                out.flush()
            })?;
        }
        Ok(())
    }

    /// The samples of a tile, by their ids.
    pub(super) fn samples(&self, folder: &Folder, tile: usize) -> anyhow::Result<Vec<Sample>> {
        let mut samples = Vec::new();
        for number in 0..self.len() {
            let path = folder.chunk(number);
            self.part(&path, tile, &mut samples).with_context(|| {
                let tile = folder.result(tile);
                format!(
                    "{} is missing, and {}, from which it is made, cannot be read: delete the \
                     folder and start again",
                    tile.display(),
                    path.display()
                )
            })?;
        }
        Ok(samples)
    }

    fn part(&self, path: &Path, tile: usize, samples: &mut Vec<Sample>) -> io::Result<()> {
        let mut reader = BufReader::with_capacity(records::BUFFER, File::open(path)?);
        let [tiles] = records::get_words(&mut reader)?;
        if tiles != self.tiles as u64 {
            return Err(io::Error::other("it is of another job"));
        }
        reader.seek_relative(8 * tile as i64)?;
        let [start, end] = records::get_words(&mut reader)?;
        let header = 8 * (self.tiles as u64 + 2);
        reader.seek(SeekFrom::Start(header + 24 * start))?;
        let count = end.saturating_sub(start);
        samples.reserve(usize::try_from(count).unwrap_or(0));
        records::each(&mut reader.take(24 * count), count, |sample| {
            samples.push(sample);
        })
    }
}

/// Samples sorted by their tiles, those of each by their ids; and where each tile starts.
fn sorted(points: &[DVec2], first: u64, partition: &Partition) -> (Vec<u64>, Vec<Sample>) {
    #[expect(clippy::cast_possible_truncation, reason = "tiles are far fewer")]
    let tiles: Vec<u32> = points
        .par_iter()
        .with_min_len(1 << 12)
        .map(|&point| partition.cell_of(point) as u32)
        .collect();
    let mut starts = vec![0u64; partition.cells().len() + 1];
    for &tile in &tiles {
        starts[tile as usize + 1] += 1;
    }
    for tile in 1..starts.len() {
        starts[tile] += starts[tile - 1];
    }
    let mut next = starts.clone();
    let nothing = Sample {
        id: 0,
        point: DVec2::ZERO,
    };
    let mut samples = vec![nothing; points.len()];
    for ((id, &point), &tile) in (first..).zip(points).zip(&tiles) {
        let place = &mut next[tile as usize];
        if let Some(sample) = usize::try_from(*place)
            .ok()
            .and_then(|at| samples.get_mut(at))
        {
            *sample = Sample { id, point };
        }
        *place += 1;
    }
    (starts, samples)
}
