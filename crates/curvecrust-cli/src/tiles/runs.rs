//! The runs of all tiles: what is read together.

use super::plan::Folder;
use super::records;
use super::solve::{Counts, RUN};
use anyhow::Context;
use curvecrust::tiles::{Area, Atlas, Sample};
use std::fs::File;
use std::io::{self, Seek, SeekFrom};
use std::ops::Range;

/// Where the runs of all tiles are, and the number of the first one of each.
pub(super) struct Runs<'a> {
    folder: &'a Folder,
    /// That of the tile behind the last one, too.
    first: Vec<usize>,
    /// The number of samples of each tile.
    samples: Vec<u64>,
    /// The samples that are open in all tiles.
    pub(super) open: u64,
}

impl<'a> Runs<'a> {
    /// Finds the runs of tiles that are solved.
    pub(super) fn of_tiles(
        folder: &'a Folder,
        tiles: usize,
        is_wide: bool,
    ) -> anyhow::Result<(Self, Atlas)> {
        let mut runs = Runs {
            folder,
            first: vec![0],
            samples: Vec::new(),
            open: 0,
        };
        let mut areas: Vec<Area> = Vec::new();
        for tile in 0..tiles {
            let result = folder.result(tile);
            let (counts, mut reader) = Counts::open(&result, is_wide)?;
            runs.samples.push(counts.samples);
            // The rest follows behind the runs, and is read when its tile asks.
            let of_tile: Vec<Area> = records::get(&mut reader, counts.runs)
                .with_context(|| format!("cannot read {}", result.display()))?;
            areas.extend(of_tile);
            runs.first.push(areas.len());
            runs.open += counts.open;
        }
        Ok((runs, Atlas::new(areas)))
    }

    /// The runs of a tile.
    pub(super) fn of(&self, tile: usize) -> Range<usize> {
        self.first[tile]..self.first[tile + 1]
    }

    /// The samples of a run, by its number among those of all tiles.
    pub(super) fn read(&self, run: usize) -> anyhow::Result<Vec<Sample>> {
        let tile = self.first.partition_point(|&first| first <= run) - 1;
        let start = ((run - self.first[tile]) * RUN) as u64;
        let count = (self.samples[tile] - start).min(RUN as u64);
        self.samples(tile, start, count)
    }

    /// All samples of a tile.
    pub(super) fn read_tile(&self, tile: usize) -> anyhow::Result<Vec<Sample>> {
        self.samples(tile, 0, self.samples[tile])
    }

    fn samples(&self, tile: usize, start: u64, count: u64) -> anyhow::Result<Vec<Sample>> {
        let path = self.folder.samples(tile);
        let read = || -> io::Result<Vec<Sample>> {
            let mut file = File::open(&path)?;
            file.seek(SeekFrom::Start(24 * start))?;
            records::get(&mut file, count)
        };
        read().with_context(|| format!("cannot read {}", path.display()))
    }
}
