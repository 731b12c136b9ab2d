//! Points from a file, as the algorithms take them: valid, and without duplicates.

use crate::args;
use crate::console::Console;
use crate::{input, points};
use anyhow::{Context, anyhow, bail};
use curvecrust::DVec2;
use curvecrust::geometry::{PointId, PointSet, PointSetError};

/// Distinct points, and the rows of the input that they come from.
///
/// People know points by their row: the position in the input, from 0, duplicates included.
#[derive(Debug)]
pub(crate) struct BarePoints {
    /// The distinct points.
    pub(crate) points: PointSet,
    /// What was merged; `None` if nothing was.
    merged: Option<Merged>,
}

#[derive(Debug)]
struct Merged {
    /// The point of each row.
    point_of: Vec<PointId>,
    /// The first row of each point.
    row_of: Vec<u32>,
}

impl BarePoints {
    /// Reads points and settles that they are distinct.
    pub(crate) fn read(args: &args::Points, console: &Console) -> anyhow::Result<Self> {
        let name = input::name(&args.path);
        let rows = console.during(&format!("reading {name}"), |_| {
            points::read(&args.path, args.from)
        })?;
        Self::new(rows, args.merge_duplicates).with_context(|| name)
    }

    fn new(rows: Vec<DVec2>, merge_duplicates: bool) -> anyhow::Result<Self> {
        if merge_duplicates {
            let found = PointSet::merging_duplicates(rows)?;
            let merged = (found.duplicates() > 0).then(|| Merged::new(found.representative));
            return Ok(Self {
                points: found.points,
                merged,
            });
        }
        match PointSet::new(rows) {
            Ok(points) => Ok(Self {
                points,
                merged: None,
            }),
            Err(PointSetError::Duplicate {
                first,
                second,
                x,
                y,
            }) => bail!(
                "points {first} and {second} are both ({x}, {y}): remove one, or pass --merge-duplicates"
            ),
            Err(error) => Err(error.into()),
        }
    }

    /// The number of rows.
    pub(crate) fn row_count(&self) -> usize {
        match &self.merged {
            Some(merged) => merged.point_of.len(),
            None => self.points.len(),
        }
    }

    /// The row of a point: the first, if several were merged.
    pub(crate) fn row(&self, point: PointId) -> u32 {
        match &self.merged {
            Some(merged) => merged.row_of[point.index()],
            None => point.into(),
        }
    }

    /// The point of a row.
    pub(crate) fn point(&self, row: u32) -> anyhow::Result<PointId> {
        let count = self.row_count();
        let missing = || anyhow!("there is no point {row}: there are {count}, counted from 0");
        let point = match &self.merged {
            Some(merged) => merged.point_of.get(row as usize).copied(),
            None => Some(PointId::from(row)).filter(|id| id.index() < count),
        };
        point.ok_or_else(missing)
    }

    /// The coordinates of every row.
    pub(crate) fn rows(&self) -> impl Iterator<Item = DVec2> + '_ {
        let at = |row: usize| match &self.merged {
            Some(merged) => self.points[merged.point_of[row]],
            None => self.points.points()[row],
        };
        (0..self.row_count()).map(at)
    }

    /// The rows that were merged into an earlier one, each with that.
    pub(crate) fn duplicates(&self) -> impl Iterator<Item = [u32; 2]> + '_ {
        self.merged.iter().flat_map(|merged| {
            let rows = (0u32..).zip(&merged.point_of);
            rows.map(|(row, id)| [row, merged.row_of[id.index()]])
                .filter(|[row, first]| row != first)
        })
    }
}

impl Merged {
    fn new(point_of: Vec<PointId>) -> Self {
        let mut row_of = Vec::new();
        // Points are numbered in the order of their first appearance.
        for (row, point) in (0u32..).zip(&point_of) {
            if point.index() == row_of.len() {
                row_of.push(row);
            }
        }
        Self { point_of, row_of }
    }
}
