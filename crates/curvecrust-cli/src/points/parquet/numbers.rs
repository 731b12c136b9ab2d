//! Columns of numbers, whatever their type.

use super::super::quote::quoted;
use super::{Flaw, Place, Problem};
use parquet::column::reader::ColumnReader;
use parquet::schema::types::ColumnDescriptor;

/// The numbers of a column, read in pieces.
pub(super) struct Numbers {
    column: ColumnReader,
    name: String,
    /// The level of a row that has a number.
    whole: i16,
    levels: Vec<i16>,
}

impl Numbers {
    pub(super) fn new(column: ColumnReader, about: &ColumnDescriptor) -> Result<Self, Flaw> {
        let name = quoted(about.name().as_bytes());
        if matches!(
            column,
            ColumnReader::Int32ColumnReader(_)
                | ColumnReader::Int64ColumnReader(_)
                | ColumnReader::FloatColumnReader(_)
                | ColumnReader::DoubleColumnReader(_)
        ) && about.max_rep_level() == 0
        {
            let levels = Vec::new();
            let whole = about.max_def_level();
            return Ok(Self {
                column,
                name,
                whole,
                levels,
            });
        }
        let found = about.physical_type().to_string();
        Err(Problem::ColumnType { name, found }.into())
    }

    /// Reads some of the next rows, as many at most, behind those that were read before, and
    /// returns how many there are: none at the end.
    pub(super) fn read(
        &mut self,
        most: usize,
        before: u64,
        into: &mut Vec<f64>,
    ) -> Result<usize, Flaw> {
        into.clear();
        self.levels.clear();
        let Self {
            column,
            name,
            whole,
            levels,
        } = self;
        let nulls = (*whole > 0).then_some(&mut *levels);
        macro_rules! numbers {
            ($reader:expr, $convert:expr) => {{
                let mut values = Vec::new();
                let read = $reader.read_records(most, nulls, None, &mut values);
                into.extend(values.into_iter().map($convert));
                read
            }};
        }
        let read = match column {
            ColumnReader::Int32ColumnReader(reader) => numbers!(reader, f64::from),
            ColumnReader::Int64ColumnReader(reader) => numbers!(reader, |value| value as f64),
            ColumnReader::FloatColumnReader(reader) => numbers!(reader, f64::from),
            ColumnReader::DoubleColumnReader(reader) => numbers!(reader, |value: f64| value),
            _ => return Ok(0),
        };
        let (rows, _, _) = read.map_err(|error| {
            Problem::Parquet(error.to_string()).at(Place::Item("row", before + 1))
        })?;
        if let Some(index) = levels.iter().position(|level| level < whole) {
            let place = Place::Item("row", before + index as u64 + 1);
            return Err(Problem::NoNumber { name: name.clone() }.at(place));
        }
        Ok(rows)
    }
}
