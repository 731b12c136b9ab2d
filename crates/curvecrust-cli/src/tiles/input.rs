//! The points, read part by part, and how they are cut into tiles.

use super::Progress;
use crate::input::name;
use crate::points::npy::Rows;
use crate::points::{CLOSING, Flaw, HEIGHTS, PointsError};
use curvecrust::DVec2;
use curvecrust::geometry::Random;
use curvecrust::tiles::Partition;
use std::fs::Metadata;
use std::ops::Range;
use std::path::{Path, PathBuf};

/// Points that are looked at for each tile, so that the points of a tile are known within 12 %, as
/// two standard deviations.
const LOOKS: usize = 256;

/// So many are looked at in all: few tiles may have more for each.
const ALL_LOOKS: std::ops::RangeInclusive<usize> = 1 << 14..=1 << 20;

/// Rows between two reports of progress.
const BLOCK: usize = 1 << 16;

/// The file of points.
pub(super) struct Input {
    path: PathBuf,
    rows: Rows,
    /// The rows that are points: without a last one that repeats the first.
    count: usize,
}

impl Input {
    pub(super) fn open(path: &Path) -> anyhow::Result<Self> {
        let path = path.to_owned();
        let rows = Rows::open(&path).map_err(|flaw| PointsError::new(name(&path), flaw))?;
        let mut input = Self {
            count: rows.len(),
            path,
            rows,
        };
        let mut ends = [Vec::new(), Vec::new()];
        let last = input.count - 1;
        for (points, row) in ends.iter_mut().zip([0, last]) {
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
    pub(super) fn notes(&self) -> Vec<&'static str> {
        let heights = self.rows.has_heights().then_some(HEIGHTS);
        let closing = (self.count < self.rows.len()).then_some(CLOSING);
        heights.into_iter().chain(closing).collect()
    }

    pub(super) fn metadata(&self) -> anyhow::Result<Metadata> {
        let found = self.rows.file().metadata();
        found.map_err(|error| self.flaw(error.into()))
    }

    fn flaw(&self, flaw: Flaw) -> anyhow::Error {
        PointsError::new(name(&self.path), flaw).into()
    }

    /// Reads some points and adds them to `points`.
    pub(super) fn read(
        &mut self,
        first: usize,
        count: usize,
        points: &mut Vec<DVec2>,
    ) -> anyhow::Result<()> {
        let read = self.rows.read(first, count, points);
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
