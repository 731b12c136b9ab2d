//! Records: files of CSV with a line for each, which are read back.

use crate::table::{Field, Table};
use anyhow::{Context, bail};
use std::str::FromStr;

/// What a line of a file holds.
pub trait Record: Sized {
    /// The names of the columns.
    fn columns() -> Vec<String>;

    /// What stands in them, in their order.
    fn fields(&self) -> Vec<Field>;

    /// A record from its line.
    ///
    /// # Errors
    /// If a field cannot be read: with its line and column.
    fn of_line(line: &Line<'_>) -> anyhow::Result<Self>;
}

/// A line as it was read.
pub struct Line<'a> {
    fields: csv::StringRecord,
    columns: &'a [String],
}

/// Records as a table.
#[must_use]
pub fn table<R: Record>(records: &[R]) -> Table {
    Table {
        header: R::columns(),
        rows: records.iter().map(R::fields).collect(),
    }
}

/// Reads what [`table`] gave as CSV.
///
/// # Errors
/// If the columns are others, or a field cannot be read: with its line.
pub fn read<R: Record>(text: &str) -> anyhow::Result<Vec<R>> {
    let columns = R::columns();
    let mut reader = csv::Reader::from_reader(text.as_bytes());
    let found = reader.headers().context("the file is no CSV")?;
    if *found != columns {
        let found: Vec<&str> = found.iter().collect();
        bail!("the columns are {found:?}, not {columns:?}: the file is of another version");
    }
    let line = |fields| Line {
        fields,
        columns: &columns,
    };
    let records = reader.records();
    records
        .map(|fields| R::of_line(&line(fields.context("the file is no CSV")?)))
        .collect()
}

impl Line<'_> {
    /// A field as it stands there.
    #[must_use]
    pub fn text(&self, column: usize) -> &str {
        self.fields.get(column).unwrap_or_default()
    }

    /// A field as a value.
    ///
    /// # Errors
    /// If it is none: with its line and column.
    pub fn parse<T: FromStr>(&self, column: usize) -> anyhow::Result<T> {
        let value = self.text(column);
        let Ok(parsed) = value.parse() else {
            let line = self.fields.position().map_or(0, csv::Position::line);
            let name = self.columns.get(column).map_or("?", String::as_str);
            bail!("line {line}, column {name}: {value:?} cannot be read");
        };
        Ok(parsed)
    }

    /// A field as a value, if it is not empty.
    ///
    /// # Errors
    /// If it is none: with its line and column.
    pub fn optional<T: FromStr>(&self, column: usize) -> anyhow::Result<Option<T>> {
        if self.text(column).is_empty() {
            return Ok(None);
        }
        self.parse(column).map(Some)
    }
}
