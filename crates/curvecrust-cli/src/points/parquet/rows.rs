//! The rows of tables that memory cannot hold, read part by part: of one file, or of all files of a
//! folder in the order of their names. Each row is a point.

use super::super::in_double_range;
use super::{
    Flaw, Gathered, Layout, Numbers, Place, Problem, ROWS, ReadOptions, Reader, column, flaw,
    layout, open, wkb,
};
use crate::format::Format;
use crate::input::Source;
use curvecrust::DVec2;
use parquet::column::reader::{ColumnReader, ColumnReaderImpl};
use parquet::data_type::{ByteArray, ByteArrayType};
use parquet::file::reader::FileReader;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

/// Tables, one after the other.
pub(crate) struct Rows {
    tables: Vec<Table>,
    options: ReadOptions,
    notes: Vec<String>,
    count: usize,
    /// Where the next rows are likely to be wanted.
    cursor: Option<Cursor>,
    /// The table that was read last.
    last: usize,
}

/// A file.
struct Table {
    path: PathBuf,
    /// The number of its first row among those of all tables.
    first: usize,
    /// The number of rows of each group.
    groups: Vec<usize>,
}

/// A place between two rows.
struct Cursor {
    /// How many rows of all tables come before it.
    before: usize,
    reader: Reader,
    layout: Layout,
    table: usize,
    group: usize,
    /// How many rows of the group come before it.
    row: usize,
    points: Points,
}

/// The rows of a group that were not read yet.
enum Points {
    Numbers(Box<[Numbers; 2]>),
    Geometries {
        column: Box<ColumnReaderImpl<ByteArrayType>>,
        /// The level of a row that has a geometry.
        whole: i16,
    },
}

impl Rows {
    /// Opens a file or the files of a folder that are named `.parquet`, and counts their rows.
    pub(crate) fn open(path: &Path, options: ReadOptions) -> Result<Self, (PathBuf, Flaw)> {
        let at = |flaw: Flaw| (path.to_owned(), flaw);
        let mut rows = Self {
            tables: Vec::new(),
            options,
            notes: Vec::new(),
            count: 0,
            cursor: None,
            last: 0,
        };
        for path in files(path).map_err(|error| at(error.into()))? {
            let opened = rows.add(&path);
            opened.map_err(|flaw| (path, flaw))?;
        }
        if rows.count == 0 {
            return Err(at(Problem::NoPoints.into()));
        }
        Ok(rows)
    }

    fn add(&mut self, path: &Path) -> Result<(), Flaw> {
        let reader = reader(path)?;
        let mut found = Gathered::new(&self.options);
        layout(&reader, &self.options, &mut found)?;
        for note in found.finish().notes {
            if !self.notes.contains(&note) {
                self.notes.push(note);
            }
        }
        let first = self.count;
        let groups = reader.file.metadata().row_groups().iter();
        let groups = groups.map(|group| usize::try_from(group.num_rows()).unwrap_or(0));
        let groups: Vec<usize> = groups.collect();
        // Each file was found to promise no more than it can hold.
        self.count += groups.iter().sum::<usize>();
        self.tables.push(Table {
            path: path.to_owned(),
            first,
            groups,
        });
        Ok(())
    }

    /// The number of rows, at least one.
    pub(crate) fn len(&self) -> usize {
        self.count
    }

    /// What the user should know about how points are read.
    pub(crate) fn notes(&self) -> &[String] {
        &self.notes
    }

    /// The files.
    pub(crate) fn paths(&self) -> impl Iterator<Item = &Path> {
        self.tables.iter().map(|table| table.path.as_path())
    }

    /// The file that was read last.
    pub(crate) fn path(&self) -> &Path {
        &self.tables[self.last].path
    }

    /// Reads the points of some rows, all of which must be there, and adds them to `points`.
    pub(crate) fn read(
        &mut self,
        first: usize,
        count: usize,
        points: &mut Vec<DVec2>,
    ) -> Result<(), Flaw> {
        points.reserve(count);
        let mut cursor = match self.cursor.take().filter(|cursor| cursor.before == first) {
            Some(cursor) => cursor,
            None => self.seek(first)?,
        };
        let end = first + count;
        while cursor.before < end {
            if cursor.row == self.tables[cursor.table].groups[cursor.group] {
                cursor = self.next_group(cursor)?;
                continue;
            }
            let left = self.tables[cursor.table].groups[cursor.group] - cursor.row;
            let count = ROWS.min(left).min(end - cursor.before);
            cursor.read(count, points)?;
        }
        self.cursor = Some(cursor);
        Ok(())
    }

    /// Goes to a row, by reading those of its group that come before it.
    fn seek(&mut self, row: usize) -> Result<Cursor, Flaw> {
        let table = self.tables.partition_point(|table| table.first <= row);
        let table = table.saturating_sub(1);
        let mut before = self.tables[table].first;
        let mut group = 0;
        for rows in &self.tables[table].groups {
            if before + rows > row {
                break;
            }
            before += rows;
            group += 1;
        }
        let mut cursor = self.open_group(table, group, before)?;
        let mut skipped = Vec::new();
        while cursor.before < row {
            skipped.clear();
            cursor.read(ROWS.min(row - cursor.before), &mut skipped)?;
        }
        Ok(cursor)
    }

    /// Opens a table at the start of a group.
    fn open_group(&mut self, table: usize, group: usize, before: usize) -> Result<Cursor, Flaw> {
        self.last = table;
        let reader = reader(&self.tables[table].path)?;
        let layout = layout(&reader, &self.options, &mut Gathered::new(&self.options))?;
        Ok(Cursor {
            points: Points::open(&reader, layout, group)?,
            before,
            reader,
            layout,
            table,
            group,
            row: 0,
        })
    }

    /// Goes on to the next group, perhaps of the next table.
    fn next_group(&mut self, cursor: Cursor) -> Result<Cursor, Flaw> {
        let group = cursor.group + 1;
        if group == self.tables[cursor.table].groups.len() {
            // A table may have no group.
            let next = cursor.table + 1;
            let rest = self.tables.get(next..).unwrap_or_default();
            let empty = rest.iter().take_while(|table| table.groups.is_empty());
            let next = next + empty.count();
            if next == self.tables.len() {
                return Err(Problem::NoPoints.into());
            }
            return self.open_group(next, 0, cursor.before);
        }
        Ok(Cursor {
            points: Points::open(&cursor.reader, cursor.layout, group)?,
            group,
            row: 0,
            ..cursor
        })
    }
}

/// The file itself, or the files of a folder.
fn files(path: &Path) -> io::Result<Vec<PathBuf>> {
    if !path.is_dir() {
        return Ok(vec![path.to_owned()]);
    }
    let mut files = Vec::new();
    for entry in fs::read_dir(path)? {
        let path = entry?.path();
        if Format::of_name(&path) == Some(Format::Parquet) {
            files.push(path);
        }
    }
    files.sort();
    Ok(files)
}

fn reader(path: &Path) -> Result<Reader, Flaw> {
    open(Source::open(path)?.into_seekable()?)
}

impl Points {
    fn open(reader: &Reader, layout: Layout, group: usize) -> Result<Self, Flaw> {
        let metadata = reader.file.metadata();
        let schema = metadata.file_metadata().schema_descr();
        let group = reader.file.get_row_group(group).map_err(flaw)?;
        match layout {
            Layout::Numbers { columns, .. } => {
                let axis = |number| {
                    let numbers = column(metadata, &*group, number, reader.size)?;
                    Numbers::new(numbers, &schema.column(number))
                };
                let [x, y] = columns.map(axis);
                Ok(Self::Numbers(Box::new([x?, y?])))
            }
            Layout::Geometries(number) => {
                let about = schema.column(number);
                match column(metadata, &*group, number, reader.size)? {
                    ColumnReader::ByteArrayColumnReader(column) if about.max_rep_level() == 0 => {
                        Ok(Self::Geometries {
                            column: Box::new(column),
                            whole: about.max_def_level(),
                        })
                    }
                    _ => {
                        Err(Problem::Parquet("its column of geometries holds others".into()).into())
                    }
                }
            }
        }
    }
}

impl Cursor {
    /// Reads some rows of the group, all of which must be there.
    fn read(&mut self, count: usize, points: &mut Vec<DVec2>) -> Result<(), Flaw> {
        let group = self.group as u64 + 1;
        let mut done = 0;
        while done < count {
            let before = self.row as u64;
            let read = match &mut self.points {
                Points::Numbers(axes) => numbers(axes, count - done, before, points),
                Points::Geometries { column, whole } => {
                    geometries(column, *whole, count - done, before, points)
                }
            };
            let read = read.map_err(|Flaw { place, problem }| match place {
                Place::Item("row", row) => problem.at(Place::GroupRow(group, row)),
                place => problem.at(place),
            })?;
            if read == 0 {
                return Err(Problem::Parquet("it is cut off".into()).into());
            }
            done += read;
            self.row += read;
            self.before += read;
        }
        Ok(())
    }
}

/// Reads rows of two columns, as many at most; returns how many.
fn numbers(
    [x_axis, y_axis]: &mut [Numbers; 2],
    most: usize,
    before: u64,
    points: &mut Vec<DVec2>,
) -> Result<usize, Flaw> {
    let [mut xs, mut ys] = [Vec::new(), Vec::new()];
    let count = x_axis.read(most, before, &mut xs)?;
    if y_axis.read(most, before, &mut ys)? != count || xs.len() != ys.len() {
        return Err(Problem::Parquet("its columns differ in length".into()).into());
    }
    for ((x, y), row) in xs.into_iter().zip(ys).zip(before + 1..) {
        let value = |value| in_double_range(value).map_err(|p| p.at(Place::Item("row", row)));
        // -0.0 + 0.0 is 0.0, as in point sets.
        points.push(DVec2::new(value(x)?, value(y)?) + DVec2::ZERO);
    }
    Ok(count)
}

/// Reads rows of geometries, each a point, as many at most; returns how many.
fn geometries(
    column: &mut ColumnReaderImpl<ByteArrayType>,
    whole: i16,
    most: usize,
    before: u64,
    points: &mut Vec<DVec2>,
) -> Result<usize, Flaw> {
    let (mut levels, mut values) = (Vec::new(), Vec::<ByteArray>::new());
    let nulls = (whole > 0).then_some(&mut levels);
    let read = column.read_records(most, nulls, None, &mut values);
    let at = |row: usize| Place::Item("row", before + row as u64 + 1);
    let (rows, _, _) = read.map_err(|e| Problem::Parquet(e.to_string()).at(at(0)))?;
    let missing = levels.iter().position(|&level| level < whole);
    let mut found = Gathered::new(&ReadOptions::default());
    for (row, value) in values.iter().enumerate().take(missing.unwrap_or(rows)) {
        found.go_to(at(row));
        wkb::collect(&mut found, value.data())?;
        if found.count() != row + 1 {
            return Err(Problem::OnePoint.at(at(row)));
        }
    }
    if let Some(row) = missing {
        return Err(Problem::OnePoint.at(at(row)));
    }
    let read = found.finish().points;
    if read.len() != rows {
        return Err(Problem::Parquet("it is cut off".into()).into());
    }
    points.extend(read.into_iter().map(|point| point + DVec2::ZERO));
    Ok(rows)
}
