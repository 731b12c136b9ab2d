//! NumPy arrays of two columns.

use std::io::{self, Write};

/// Writes pairs of point numbers, as 32 bit unsigned integers.
pub(crate) fn write_u32(
    out: &mut dyn Write,
    pairs: impl ExactSizeIterator<Item = [u32; 2]>,
) -> io::Result<()> {
    header(out, "<u4", pairs.len())?;
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
    header(out, "<f8", pairs.len())?;
    for [x, y] in pairs {
        out.write_all(&x.to_le_bytes())?;
        out.write_all(&y.to_le_bytes())?;
    }
    Ok(())
}

/// Version 1.0; the numbers start at a multiple of 64 bytes.
fn header(out: &mut dyn Write, descr: &str, rows: usize) -> io::Result<()> {
    let fields = format!("{{'descr': '{descr}', 'fortran_order': False, 'shape': ({rows}, 2), }}");
    let length = (10 + fields.len() + 1).next_multiple_of(64) - 10;
    out.write_all(b"\x93NUMPY\x01\x00")?;
    // 118 bytes, for any number of rows.
    out.write_all(&u16::try_from(length).unwrap_or(u16::MAX).to_le_bytes())?;
    writeln!(out, "{fields:<width$}", width = length - 1)
}
