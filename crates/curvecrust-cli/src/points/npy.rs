//! NumPy arrays (`.npy`): n rows of x and y, or of x, y and z, of which z is left out, as 64 or 32
//! bit floating-point numbers.
//!
//! The format is a [`header`] and then the bare numbers, in either byte order, by rows or by
//! columns.

mod header;
mod rows;

use super::heights::Heights;
use super::{Flaw, Place, PointList, Problem, ReadOptions, in_double_range};
use curvecrust::DVec2;
use header::{Header, Number};
pub(crate) use rows::Rows;
use std::io::{ErrorKind, Read};

/// Numbers read at once.
const CHUNK: usize = 8192;

pub(super) fn read(mut reader: impl Read, options: &ReadOptions) -> Result<PointList, Flaw> {
    let header = header::read(&mut reader)?;
    let Header { rows, columns, .. } = header;
    if columns < 2 {
        return Err(Problem::Shape(header.shape).into());
    }
    if rows >= u32::MAX as usize {
        return Err(Problem::ManyRows { rows }.into());
    }
    // A header may promise more than follows: no more is reserved than was read.
    let mut points: Vec<DVec2> = Vec::new();
    let mut heights = Heights::new(options);
    let mut index = 0;
    each_number(&mut reader, &header, |value| {
        let (row, column) = if header.by_columns {
            (index % rows, index / rows)
        } else {
            (index / columns, index % columns)
        };
        index += 1;
        let place = Place::Row(row as u64 + 1, column + 1);
        if column > 1 {
            return heights
                .take(Some(value))
                .map_err(|problem| problem.at(place));
        }
        let value = in_double_range(value).map_err(|problem| problem.at(place))?;
        if column == 0 {
            points.push(DVec2::new(value, 0.0));
        } else {
            points[row].y = value;
        }
        Ok(())
    })?;
    settle_end(&mut reader, &header)?;
    if heights.are_kept() && columns < 3 {
        return Err(Problem::NoHeight.into());
    }
    Ok(PointList::new(points, heights))
}

/// Reads the numbers of an array of shape (n,).
#[cfg(feature = "npz")]
pub(super) fn read_column(mut reader: impl Read) -> Result<Vec<f64>, Flaw> {
    let header = header::read(&mut reader)?;
    if header.columns != 1 {
        return Err(Problem::ColumnShape(header.shape).into());
    }
    let mut values: Vec<f64> = Vec::new();
    each_number(&mut reader, &header, |value| {
        let place = Place::Row(values.len() as u64 + 1, 1);
        values.push(in_double_range(value).map_err(|problem| problem.at(place))?);
        Ok(())
    })?;
    settle_end(&mut reader, &header)?;
    Ok(values)
}

/// An error unless the file ends with its array.
fn settle_end(reader: &mut impl Read, header: &Header) -> Result<(), Flaw> {
    match reader.read(&mut [0])? {
        0 => Ok(()),
        _ => Err(Problem::Trailing { rows: header.rows }.into()),
    }
}

/// Reads all numbers, in the order in which they are stored.
fn each_number(
    reader: &mut impl Read,
    header: &Header,
    mut take: impl FnMut(f64) -> Result<(), Flaw>,
) -> Result<(), Flaw> {
    let size = header.number.bytes;
    let mut buffer = vec![0; CHUNK * size];
    let mut left = header.columns * header.rows;
    while left > 0 {
        let chunk = &mut buffer[..left.min(CHUNK) * size];
        reader
            .read_exact(chunk)
            .map_err(|error| match error.kind() {
                ErrorKind::UnexpectedEof => Problem::Truncated { rows: header.rows }.into(),
                _ => Flaw::from(error),
            })?;
        for bytes in chunk.chunks_exact(size) {
            take(header.number.value(bytes))?;
        }
        left -= chunk.len() / size;
    }
    Ok(())
}

impl Number {
    fn value(&self, bytes: &[u8]) -> f64 {
        match (bytes, self.big_endian) {
            (&[a, b, c, d], false) | (&[d, c, b, a], true) => {
                f32::from_le_bytes([a, b, c, d]).into()
            }
            (&[a, b, c, d, e, f, g, h], false) | (&[h, g, f, e, d, c, b, a], true) => {
                f64::from_le_bytes([a, b, c, d, e, f, g, h])
            }
            _ => f64::NAN,
        }
    }
}
