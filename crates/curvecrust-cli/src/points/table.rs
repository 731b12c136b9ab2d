//! Tables: two columns without names, or columns with names, of which two are known.
//!
//! A first line that is neither is a title, if the next one starts the table.

use super::columns::{ColumnNames, Columns, not_found};
use super::csv_records::CsvRecords;
use super::heights::Heights;
use super::records::Records;
use super::separator::{self, Separator};
use super::text_records::TextRecords;
use super::{Flaw, Place, PointList, Problem, ReadOptions, coordinate, is_number};
use crate::input::Source;
use curvecrust::DVec2;

/// Reads a table whose columns are separated as those of its first lines.
pub(super) fn read(
    mut source: Source,
    default: Separator,
    options: &ReadOptions,
) -> Result<PointList, Flaw> {
    let found = separator::find(&mut source, options.columns.as_ref())?;
    let input = source.into_reader();
    match found.unwrap_or(default) {
        Separator::Byte(byte) => Table::read(CsvRecords::new(input, byte), options),
        Separator::WhiteSpace => Table::read(TextRecords::new(input), options),
    }
}

/// What a record is, as far as it is known by itself.
enum Kind {
    Header(Columns),
    Point,
    Other,
}

struct Table<R> {
    records: R,
    columns: Columns,
    /// The number of columns.
    width: usize,
    points: Vec<DVec2>,
    heights: Heights,
    /// Whether only points are taken that are marked as ends of curves, where marks are.
    termini: bool,
    notes: Vec<String>,
}

impl<R: Records> Table<R> {
    fn read(mut records: R, options: &ReadOptions) -> Result<PointList, Flaw> {
        if !records.advance()? {
            return Ok(PointList::default());
        }
        let mut table = Self {
            records,
            columns: Columns::first(0),
            width: 0,
            points: Vec::new(),
            heights: Heights::new(options),
            termini: options.termini,
            notes: Vec::new(),
        };
        table.start(options.columns.as_ref())?;
        while table.records.advance()? {
            if table.records.len() != table.width {
                return Err(table.records.ragged(table.width));
            }
            table.take_point()?;
        }
        let mut list = PointList::new(table.points, table.heights);
        list.notes.extend(table.notes);
        Ok(list)
    }

    /// Takes the title, the header and, without a header, the first point.
    fn start(&mut self, names: Option<&ColumnNames>) -> Result<(), Flaw> {
        let first = kind(&self.records, names)?;
        if !matches!(first, Kind::Other) {
            return self.start_with(first);
        }
        let refusal = self.refusal(names);
        let (line, width) = (self.records.line(), self.records.len());
        if !self.records.advance()? {
            return Err(refusal);
        }
        let second = kind(&self.records, names)?;
        let other_width = self.records.len() != width;
        let is_title = match second {
            Kind::Header(_) => true,
            // The name of a wing section has two words as often as not.
            Kind::Point => other_width || (R::IS_TEXT && width == 2),
            Kind::Other => false,
        };
        if !is_title {
            return Err(refusal);
        }
        let note = format!("line {line} is taken for a title");
        self.notes.push(note);
        self.start_with(second)
    }

    fn start_with(&mut self, kind: Kind) -> Result<(), Flaw> {
        self.width = self.records.len();
        if let Kind::Header(columns) = kind {
            self.columns = columns;
            let note = columns.note(&self.records, self.heights.are_kept());
            self.notes.extend(note);
            return Ok(());
        }
        self.columns = Columns::first(self.width);
        match self.width {
            0..=2 => {}
            3 if self.heights.are_kept() => {}
            3 => {
                let note = "of three columns without names, the third is left out";
                self.notes.push(note.to_owned());
            }
            found => {
                return Err(Problem::Unnamed { found }.at(Place::Line(self.records.line())));
            }
        }
        self.take_point()
    }

    fn take_point(&mut self) -> Result<(), Flaw> {
        let records = &self.records;
        if let Some(column) = self.columns.terminus.filter(|_| self.termini)
            && matches!(records.field(column), b"" | b"0" | b"false")
        {
            return Ok(());
        }
        let value = |column: usize| {
            coordinate(records.field(column), records.has_decimal_commas())
                .map_err(|problem| problem.at(records.place(column)))
        };
        let point = DVec2::new(value(self.columns.x)?, value(self.columns.y)?);
        self.points.push(point);
        if self.heights.are_kept() {
            let (column, commas) = (self.columns.z, records.has_decimal_commas());
            let place = column.map_or(Place::Line(records.line()), |column| records.place(column));
            let height = self
                .heights
                .of_word(column.map(|column| records.field(column)), commas);
            let taken = height.and_then(|height| self.heights.take(height));
            taken.map_err(|problem| problem.at(place))?;
        }
        Ok(())
    }

    /// Why a record is neither a header nor a point.
    fn refusal(&self, names: Option<&ColumnNames>) -> Flaw {
        let records = &self.records;
        let has_commas = records.has_decimal_commas();
        let mut columns = 0..records.len();
        let has_number = columns.any(|i| is_number(records.field(i), has_commas));
        if names.is_some() || !has_number && (records.len() > 1 || !R::IS_TEXT) {
            return not_found(records, names);
        }
        if records.len() == 1 {
            return records.ragged(2);
        }
        let bad = (0..2).find_map(|column| {
            let read = coordinate(records.field(column), has_commas);
            read.err().map(|problem| problem.at(records.place(column)))
        });
        bad.unwrap_or_else(|| not_found(records, names))
    }
}

fn kind(records: &impl Records, names: Option<&ColumnNames>) -> Result<Kind, Flaw> {
    let has_commas = records.has_decimal_commas();
    let is_point =
        records.len() >= 2 && (0..2).all(|column| is_number(records.field(column), has_commas));
    if is_point && names.is_none() {
        return Ok(Kind::Point);
    }
    let columns = Columns::of_header(records, names)?;
    Ok(columns.map_or(Kind::Other, Kind::Header))
}
