//! Points from a file, as the algorithms take them: valid, and without duplicates.

use crate::console::Console;
use crate::format::Format;
use crate::number::Number;
use crate::points::{self, ColumnNames, ReadOptions, System};
use crate::{args, args::Distance, input};
use anyhow::{Context, anyhow, bail};
use curvecrust::DVec2;
use curvecrust::geometry::{MergedPoints, PointId, PointSet, PointSetError};
use std::borrow::Cow;
use std::collections::HashMap;
use std::path::PathBuf;

/// A file of points, and how it is read.
#[derive(Debug)]
pub(crate) struct PointSource {
    path: PathBuf,
    /// `None`: the format of the name, else of the content.
    format: Option<Format>,
    options: ReadOptions,
    duplicates: Duplicates,
}

/// What is done with equal points.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Duplicates {
    Refuse,
    Merge,
    /// And with points that are nearly equal.
    MergeWithin(Distance),
}

/// Distinct points, and the rows of the input that they come from.
///
/// People know points by their row: the position in the input, from 0, duplicates included.
#[derive(Debug)]
pub(crate) struct BarePoints {
    /// The distinct points.
    pub(crate) points: PointSet,
    /// The height of every row, if heights are kept.
    heights: Option<Vec<f64>>,
    /// The reference system of the coordinates, if the file names one.
    pub(crate) system: Option<System>,
    /// What was merged; `None` if nothing was.
    merged: Option<Merged>,
}

#[derive(Debug)]
struct Merged {
    /// The point of each row.
    point_of: Vec<PointId>,
    /// The row that each point comes from.
    row_of: Vec<u32>,
    /// The coordinates of every row; `None` where they are those of its point.
    rows: Option<Vec<DVec2>>,
}

impl From<args::Points> for PointSource {
    fn from(args: args::Points) -> Self {
        Self::new(args.path, args.reading)
    }
}

impl PointSource {
    pub(crate) fn new(path: PathBuf, reading: args::Reading) -> Self {
        let args::Reading {
            from,
            x,
            y,
            vertices,
            merge_duplicates,
            merge_within,
        } = reading;
        let duplicates = match merge_within {
            Some(distance) => Duplicates::MergeWithin(distance),
            None if merge_duplicates => Duplicates::Merge,
            None => Duplicates::Refuse,
        };
        Self {
            path,
            format: from,
            options: ReadOptions {
                columns: x.zip(y).map(|(x, y)| ColumnNames { x, y }),
                vertices,
                heights: false,
                termini: false,
            },
            duplicates,
        }
    }

    /// The same with the heights of the points, all of which must have one.
    pub(crate) fn with_heights(mut self) -> Self {
        self.options.heights = true;
        self
    }

    /// A file of points some of which are marked as ends of curves: those, or all without marks.
    pub(crate) fn of_termini(path: PathBuf) -> Self {
        Self {
            path,
            format: None,
            options: ReadOptions {
                termini: true,
                ..ReadOptions::default()
            },
            duplicates: Duplicates::Merge,
        }
    }

    /// How messages name it.
    pub(crate) fn name(&self) -> String {
        input::name(&self.path)
    }

    /// Reads points and settles that they are distinct.
    pub(crate) fn read(&self, console: &Console) -> anyhow::Result<BarePoints> {
        let name = self.name();
        let list = console.during(&format!("reading {name}"), |_| {
            points::read(&self.path, self.format, &self.options)
        })?;
        let points::PointList {
            points: rows,
            heights,
            system,
            mut notes,
        } = list;
        let bare = match self.duplicates {
            Duplicates::Merge => BarePoints::merging(rows),
            Duplicates::MergeWithin(distance) => BarePoints::merging_within(rows, distance),
            Duplicates::Refuse if repeats_its_start(&rows) => {
                notes.push(points::CLOSING.to_owned());
                BarePoints::closing(rows)
            }
            Duplicates::Refuse => BarePoints::distinct(rows),
        };
        let mut bare = bare.with_context(|| name.clone())?;
        (bare.heights, bare.system) = (heights, system);
        for note in &notes {
            console.note(format_args!("{name}: {note}"));
        }
        Ok(bare)
    }
}

/// Whether points end where they start, as those of a ring often do.
fn repeats_its_start(rows: &[DVec2]) -> bool {
    rows.len() > 3 && rows.first() == rows.last()
}

impl BarePoints {
    /// Points of which no more is known yet than their places.
    fn new(points: PointSet, merged: Option<Merged>) -> Self {
        Self {
            points,
            heights: None,
            system: None,
            merged,
        }
    }

    fn merging(rows: Vec<DVec2>) -> anyhow::Result<Self> {
        let found = PointSet::merging_duplicates(rows)?;
        Ok(Self::merged(found, None))
    }

    fn merging_within(rows: Vec<DVec2>, distance: Distance) -> anyhow::Result<Self> {
        let bounds = rows.iter().fold(None, |bounds, &row| {
            let (low, high) = bounds.unwrap_or((row, row));
            Some((row.min(low), row.max(high)))
        });
        let extent = bounds.map_or(0.0, |(low, high)| (high - low).max_element());
        let found = PointSet::merging_within(rows.clone(), distance.of_extent(extent))?;
        Ok(Self::merged(found, Some(rows)))
    }

    /// With the rows, where they are not those of the points that stand for them.
    fn merged(found: MergedPoints, rows: Option<Vec<DVec2>>) -> Self {
        let merged = (found.duplicates() > 0).then(|| Merged {
            point_of: found.representative,
            row_of: found.origin.into_iter().map(row_number).collect(),
            rows,
        });
        Self::new(found.points, merged)
    }

    /// Points of which the last equals the first.
    fn closing(mut rows: Vec<DVec2>) -> anyhow::Result<Self> {
        rows.pop();
        let Self { points, .. } = Self::distinct(rows)?;
        let merged = Merged {
            point_of: points.ids().chain(points.ids().take(1)).collect(),
            row_of: points.ids().map(u32::from).collect(),
            rows: None,
        };
        Ok(Self::new(points, Some(merged)))
    }

    fn distinct(rows: Vec<DVec2>) -> anyhow::Result<Self> {
        match PointSet::new(rows) {
            Ok(points) => Ok(Self::new(points, None)),
            Err(PointSetError::Duplicate {
                first,
                second,
                x,
                y,
            }) => bail!(
                "points {first} and {second} are both ({}, {}): remove one, or pass --merge-duplicates",
                Number(x),
                Number(y)
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

    /// The row of a point: the one that stands for all, if several were merged.
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

    /// The height of every row, if heights are kept.
    pub(crate) fn heights(&self) -> Option<&[f64]> {
        self.heights.as_deref()
    }

    /// The height of a point: that of its row, if heights are kept.
    pub(crate) fn height(&self, point: PointId) -> Option<f64> {
        let heights = self.heights.as_ref()?;
        heights.get(self.row(point) as usize).copied()
    }

    /// The heights of all points, if heights are kept.
    pub(crate) fn point_heights(&self) -> Option<Cow<'_, [f64]>> {
        let heights = self.heights.as_ref()?;
        Some(match &self.merged {
            None => Cow::Borrowed(heights),
            Some(merged) => {
                let rows = merged.row_of.iter();
                rows.map(|&row| heights[row as usize]).collect()
            }
        })
    }

    /// The points at the places of others; an error names the first that is at none.
    pub(crate) fn points_at(&self, others: &Self) -> anyhow::Result<Vec<PointId>> {
        // Zero has two signs.
        let key = |p: DVec2| (p + DVec2::ZERO).to_array().map(f64::to_bits);
        let rows = self.rows().zip(self.points_of_rows());
        let places: HashMap<[u64; 2], PointId> = rows.map(|(p, id)| (key(p), id)).collect();
        let found = others.rows().map(|p| {
            let point = places.get(&key(p)).copied();
            point
                .with_context(|| format!("there is no point at ({}, {})", Number(p.x), Number(p.y)))
        });
        found.collect()
    }

    /// The coordinates of every row.
    pub(crate) fn rows(&self) -> impl Iterator<Item = DVec2> + '_ {
        let at = |row: usize| match &self.merged {
            Some(Merged {
                rows: Some(rows), ..
            }) => rows[row],
            Some(merged) => self.points[merged.point_of[row]],
            None => self.points.points()[row],
        };
        (0..self.row_count()).map(at)
    }

    /// The point of every row.
    pub(crate) fn points_of_rows(&self) -> impl Iterator<Item = PointId> + '_ {
        (0..self.row_count()).filter_map(|row| match &self.merged {
            Some(merged) => merged.point_of.get(row).copied(),
            None => PointId::new(row),
        })
    }

    /// The rows that another one stands for, each with that.
    pub(crate) fn duplicates(&self) -> impl Iterator<Item = [u32; 2]> + '_ {
        self.merged.iter().flat_map(|merged| {
            let rows = (0u32..).zip(&merged.point_of);
            rows.map(|(row, id)| [row, merged.row_of[id.index()]])
                .filter(|[row, first]| row != first)
        })
    }
}

/// The number of a row: point sets hold no more than such numbers.
fn row_number(index: usize) -> u32 {
    u32::try_from(index).unwrap_or(u32::MAX)
}
