//! The rows of an array that memory cannot hold, read part by part.

use super::super::{Flaw, Place, Problem, in_double_range};
use super::header::{self, Header};
use curvecrust::DVec2;
use std::fs::File;
use std::io::{self, BufReader, Read, Seek, SeekFrom};
use std::path::Path;

/// Rows that are read from the system at once.
const BLOCK: usize = 1 << 14;

/// An array in a file, stored by rows.
pub(crate) struct Rows {
    file: File,
    header: Header,
    /// Where its numbers start.
    start: u64,
}

impl Rows {
    /// Opens an array, and checks that all of it is there.
    pub(crate) fn open(path: &Path) -> Result<Self, Flaw> {
        let mut reader = BufReader::new(File::open(path)?);
        let header = header::read(&mut reader)?;
        if header.columns < 2 {
            return Err(Problem::Shape(header.shape).into());
        }
        if header.by_columns {
            return Err(Problem::ByColumns.into());
        }
        if header.rows == 0 {
            return Err(Problem::NoPoints.into());
        }
        let start = reader.stream_position()?;
        let file = reader.into_inner();
        let rows = Self {
            file,
            header,
            start,
        };
        let count = rows.len();
        match rows.file.metadata()?.len().cmp(&rows.offset(count)) {
            std::cmp::Ordering::Less => Err(Problem::Truncated { rows: count }.into()),
            std::cmp::Ordering::Equal => Ok(rows),
            std::cmp::Ordering::Greater => Err(Problem::Trailing { rows: count }.into()),
        }
    }

    /// The number of rows, at least one.
    pub(crate) fn len(&self) -> usize {
        self.header.rows
    }

    /// Whether the rows have a third number, which is left out.
    pub(crate) fn has_heights(&self) -> bool {
        self.header.columns > 2
    }

    fn row_bytes(&self) -> usize {
        self.header.columns * self.header.number.bytes
    }

    fn offset(&self, row: usize) -> u64 {
        self.start + row as u64 * self.row_bytes() as u64
    }

    /// Reads the points of some rows, all of which must be there, and adds them to `points`.
    pub(crate) fn read(
        &mut self,
        first: usize,
        count: usize,
        points: &mut Vec<DVec2>,
    ) -> Result<(), Flaw> {
        points.reserve(count);
        let offset = self.offset(first);
        self.file.seek(SeekFrom::Start(offset))?;
        let mut buffer = vec![0; BLOCK.min(count) * self.row_bytes()];
        let size = self.header.number.bytes;
        let end = first + count;
        let mut row = first;
        while row < end {
            let bytes = &mut buffer[..(end - row).min(BLOCK) * self.header.columns * size];
            self.file
                .read_exact(bytes)
                .map_err(|error| match error.kind() {
                    io::ErrorKind::UnexpectedEof => Problem::Truncated {
                        rows: self.header.rows,
                    }
                    .into(),
                    _ => Flaw::from(error),
                })?;
            for bytes in bytes.chunks_exact(self.header.columns * size) {
                let value = |column: usize| {
                    let value = self.header.number.value(&bytes[column * size..][..size]);
                    in_double_range(value)
                        .map_err(|problem| problem.at(Place::Row(row as u64 + 1, column + 1)))
                };
                // -0.0 + 0.0 is 0.0, as in point sets.
                points.push(DVec2::new(value(0)?, value(1)?) + DVec2::ZERO);
                row += 1;
            }
        }
        Ok(())
    }
}
