//! NumPy arrays.

use std::io::{self, Write};

/// Writes pairs of point numbers, as 32 bit unsigned integers.
pub(crate) fn write_u32(
    out: &mut dyn Write,
    pairs: impl ExactSizeIterator<Item = [u32; 2]>,
) -> io::Result<()> {
    pairs_header(out, "<u4", pairs.len())?;
    for [a, b] in pairs {
        out.write_all(&a.to_le_bytes())?;
        out.write_all(&b.to_le_bytes())?;
    }
    Ok(())
}

/// Writes points, as 64 bit floating-point numbers.
pub(crate) fn write_f64(
    out: &mut dyn Write,
    pairs: impl ExactSizeIterator<Item = [f64; 2]>,
) -> io::Result<()> {
    pairs_header(out, "<f8", pairs.len())?;
    for [x, y] in pairs {
        out.write_all(&x.to_le_bytes())?;
        out.write_all(&y.to_le_bytes())?;
    }
    Ok(())
}

/// Writes pairs of point numbers one by one, given how many there are: as 32 bit unsigned integers,
/// or as 64 bit ones where there are more points.
pub(crate) struct Pairs<'a> {
    out: &'a mut dyn Write,
    is_wide: bool,
}

impl<'a> Pairs<'a> {
    pub(crate) fn new(out: &'a mut dyn Write, rows: usize, is_wide: bool) -> io::Result<Self> {
        pairs_header(out, if is_wide { "<u8" } else { "<u4" }, rows)?;
        Ok(Self { out, is_wide })
    }

    pub(crate) fn write(&mut self, pair: [u64; 2]) -> io::Result<()> {
        let bytes = if self.is_wide { 8 } else { 4 };
        for number in pair {
            self.out.write_all(&number.to_le_bytes()[..bytes])?;
        }
        Ok(())
    }
}

/// The header of an array of two columns.
fn pairs_header(out: &mut dyn Write, kind: &str, rows: usize) -> io::Result<()> {
    header(out, &format!("'{kind}'"), &format!("({rows}, 2)"))
}

/// The header of an array, given the type of its elements and its shape as Python writes them.
/// Version 1.0; the elements start at a multiple of 64 bytes.
pub(crate) fn header(out: &mut dyn Write, descr: &str, shape: &str) -> io::Result<()> {
    let fields = format!("{{'descr': {descr}, 'fortran_order': False, 'shape': {shape}, }}");
    let length = (10 + fields.len() + 1).next_multiple_of(64) - 10;
    out.write_all(b"\x93NUMPY\x01\x00")?;
    // 118 bytes for pairs, for any number of rows.
    out.write_all(&u16::try_from(length).unwrap_or(u16::MAX).to_le_bytes())?;
    writeln!(out, "{fields:<width$}", width = length - 1)
}
