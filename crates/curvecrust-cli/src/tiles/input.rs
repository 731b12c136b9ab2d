//! The points, read part by part, and how they are cut into tiles.

use super::Progress;
use crate::format::Format;
use crate::input::name;
use crate::points::{CLOSING, ColumnNames, Flaw, HEIGHTS, PointsError, Problem, npy};
#[cfg(feature = "parquet")]
use crate::points::{ReadOptions, parquet};
use curvecrust::DVec2;
use curvecrust::geometry::Random;
use curvecrust::tiles::Partition;
use serde::{Deserialize, Serialize};
use std::fs;
use std::ops::Range;
use std::path::{Path, PathBuf};
use std::time::UNIX_EPOCH;

/// Points that are looked at for each tile, so that the points of a tile are known within 12 %, as
/// two standard deviations.
const LOOKS: usize = 256;

/// So many are looked at in all: few tiles may have more for each.
const ALL_LOOKS: std::ops::RangeInclusive<usize> = 1 << 14..=1 << 20;

/// Rows between two reports of progress.
const BLOCK: usize = 1 << 16;

/// The points.
pub(super) struct Input {
    rows: Rows,
    /// The rows that are points: without a last one that repeats the first.
    count: usize,
}

/// What holds the points.
enum Rows {
    Npy(PathBuf, npy::Rows),
    #[cfg(feature = "parquet")]
    Parquet(Box<parquet::Rows>),
}

/// What tells an input from others.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(super) struct Fingerprint {
    /// The size of all files in bytes.
    pub(super) bytes: u64,
    /// When the last of them was changed: seconds and nanoseconds.
    modified: (u64, u32),
    /// The columns of x and y that were asked for.
    columns: Option<(String, String)>,
}

impl Input {
    /// Opens an array or, if `columns` of a table may be asked for, tables.
    pub(super) fn open(
        path: &Path,
        format: Format,
        columns: Option<&ColumnNames>,
    ) -> anyhow::Result<Self> {
        let rows = match format {
            #[cfg(feature = "parquet")]
            Format::Parquet => {
                let options = ReadOptions {
                    columns: columns.cloned(),
                    ..ReadOptions::default()
                };
                let rows = parquet::Rows::open(path, options);
                let rows = rows.map_err(|(path, flaw)| PointsError::new(name(&path), flaw))?;
                Rows::Parquet(Box::new(rows))
            }
            _ => {
                let rows = match columns {
                    None => npy::Rows::open(path),
                    Some(_) => Err(Problem::NoTable(Format::Npy).into()),
                };
                let rows = rows.map_err(|flaw| PointsError::new(name(path), flaw))?;
                Rows::Npy(path.to_owned(), rows)
            }
        };
        let mut input = Self {
            count: rows.len(),
            rows,
        };
        let mut ends = [Vec::new(), Vec::new()];
        let last = input.count - 1;
        for (points, row) in ends.iter_mut().zip([last, 0]) {
            input.read(row, 1, points)?;
        }
        // As where all points are read at once.
        input.count -= usize::from(input.count > 3 && ends[0] == ends[1]);
        Ok(input)
    }

    /// The number of points.
    pub(super) fn len(&self) -> usize {
        self.count
    }

    /// What the user should know about how points are read.
    pub(super) fn notes(&self) -> Vec<String> {
        let mut notes: Vec<String> = match &self.rows {
            Rows::Npy(_, rows) => rows
                .has_heights()
                .then(|| HEIGHTS.to_owned())
                .into_iter()
                .collect(),
            #[cfg(feature = "parquet")]
            Rows::Parquet(rows) => rows.notes().to_vec(),
        };
        notes.extend((self.count < self.rows.len()).then(|| CLOSING.to_owned()));
        notes
    }

    pub(super) fn fingerprint(&self, columns: Option<&ColumnNames>) -> anyhow::Result<Fingerprint> {
        let paths: Vec<&Path> = match &self.rows {
            Rows::Npy(path, _) => vec![path],
            #[cfg(feature = "parquet")]
            Rows::Parquet(rows) => rows.paths().collect(),
        };
        let mut print = Fingerprint {
            bytes: 0,
            modified: (0, 0),
            columns: columns.map(|ColumnNames { x, y }| (x.clone(), y.clone())),
        };
        for path in paths {
            let found = fs::metadata(path);
            let found = found.map_err(|error| PointsError::new(name(path), error.into()))?;
            let modified = found.modified().ok();
            let modified = modified.and_then(|time| time.duration_since(UNIX_EPOCH).ok());
            let modified = modified.unwrap_or_default();
            print.bytes = print.bytes.saturating_add(found.len());
            print.modified = print
                .modified
                .max((modified.as_secs(), modified.subsec_nanos()));
        }
        Ok(print)
    }

    fn flaw(&self, flaw: Flaw) -> anyhow::Error {
        let path = match &self.rows {
            Rows::Npy(path, _) => path,
            #[cfg(feature = "parquet")]
            Rows::Parquet(rows) => rows.path(),
        };
        PointsError::new(name(path), flaw).into()
    }

    /// Reads some points and adds them to `points`.
    pub(super) fn read(
        &mut self,
        first: usize,
        count: usize,
        points: &mut Vec<DVec2>,
    ) -> anyhow::Result<()> {
        let read = match &mut self.rows {
            Rows::Npy(_, rows) => rows.read(first, count, points),
            #[cfg(feature = "parquet")]
            Rows::Parquet(rows) => rows.read(first, count, points),
        };
        read.map_err(|flaw| self.flaw(flaw))
    }

    /// The same, and tells how many of all points are read.
    pub(super) fn read_part(
        &mut self,
        part: Range<usize>,
        points: &mut Vec<DVec2>,
        progress: Progress<'_>,
    ) -> anyhow::Result<()> {
        points.reserve(part.len());
        for first in part.clone().step_by(BLOCK) {
            progress(first, self.count);
            self.read(first, BLOCK.min(part.end - first), points)?;
        }
        Ok(())
    }

    /// Reads all points, checks them, and cuts the plane into tiles of about equally many.
    pub(super) fn survey(
        &mut self,
        tile_points: usize,
        progress: Progress<'_>,
    ) -> anyhow::Result<Partition> {
        let tiles = self.count.div_ceil(tile_points).max(1);
        let looks = (LOOKS * tiles).clamp(*ALL_LOOKS.start(), *ALL_LOOKS.end());
        let looks = looks.min(self.count);
        let mut random = Random::new(26);
        // One of each of as many equal parts of the file.
        let start = |look: usize| (look as u128 * self.count as u128 / looks as u128) as usize;
        let wanted = (0..looks).map(|look| {
            let (from, to) = (start(look), start(look + 1));
            from + random.below(to - from)
        });
        let wanted: Vec<usize> = wanted.collect();
        let mut wanted = wanted.into_iter().peekable();
        let mut seen = Vec::with_capacity(looks);
        let mut points = Vec::new();
        for first in (0..self.count).step_by(BLOCK) {
            progress(first, self.count);
            let count = BLOCK.min(self.count - first);
            points.clear();
            self.read(first, count, &mut points)?;
            while let Some(row) = wanted.next_if(|&row| row < first + count) {
                seen.push(points[row - first]);
            }
        }
        Ok(Partition::of(seen, tiles))
    }
}

impl Rows {
    fn len(&self) -> usize {
        match self {
            Self::Npy(_, rows) => rows.len(),
            #[cfg(feature = "parquet")]
            Self::Parquet(rows) => rows.len(),
        }
    }
}
