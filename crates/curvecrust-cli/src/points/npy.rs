//! NumPy arrays (`.npy`): n rows of x and y, as 64 or 32 bit floating-point numbers.
//!
//! The format is a header, `\x93NUMPY`, a version and the text of a Python dictionary, and then the
//! bare numbers: <https://numpy.org/doc/stable/reference/generated/numpy.lib.format.html>

use super::{Flaw, Place, Problem, flaw::shown, in_range};
use curvecrust::DVec2;
use std::io::{ErrorKind, Read};

/// What the header tells.
struct Header {
    number: Number,
    /// Whether all x come before all y.
    by_columns: bool,
    rows: usize,
}

/// How a number is stored.
struct Number {
    bytes: usize,
    big_endian: bool,
}

/// Numbers read at once.
const CHUNK: usize = 8192;

pub(super) fn read(mut reader: impl Read) -> Result<Vec<DVec2>, Flaw> {
    let header = header(&mut reader)?;
    let Header { rows, .. } = header;
    let mut points: Vec<DVec2> = Vec::new();
    // A header may lie about what follows: no more is reserved than can be read at once.
    let mut index = 0;
    each_number(&mut reader, &header, |value| {
        let (row, column) = if header.by_columns {
            (index % rows, index / rows)
        } else {
            (index / 2, index % 2)
        };
        index += 1;
        let value = in_range(value, || value.to_string())
            .map_err(|problem| problem.at(Place::Field(row as u64 + 1, column + 1)))?;
        if column == 0 {
            points.push(DVec2::new(value, 0.0));
        } else {
            points[row].y = value;
        }
        Ok(())
    })?;
    match reader.read(&mut [0])? {
        0 => Ok(points),
        _ => Err(Problem::Trailing { rows }.into()),
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
    let mut left = 2 * header.rows;
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

fn header(reader: &mut impl Read) -> Result<Header, Flaw> {
    let mut read = |bytes: &mut [u8]| {
        reader
            .read_exact(bytes)
            .map_err(|error| match error.kind() {
                ErrorKind::UnexpectedEof => Problem::NotNpy.into(),
                _ => Flaw::from(error),
            })
    };
    let mut start = [0; 8];
    read(&mut start)?;
    let mut length = [0; 4];
    match start {
        [0x93, b'N', b'U', b'M', b'P', b'Y', 1, _] => read(&mut length[..2])?,
        [0x93, b'N', b'U', b'M', b'P', b'Y', 2 | 3, _] => read(&mut length)?,
        _ => return Err(Problem::NotNpy.into()),
    }
    // NumPy itself refuses longer ones.
    let length = u32::from_le_bytes(length).min(1 << 16) as usize;
    let mut text = vec![0; length];
    read(&mut text)?;
    let text = String::from_utf8_lossy(&text);
    let field = |name: &str| {
        let (_, value) = text.split_once(&format!("'{name}':"))?;
        Some(value.trim_start())
    };
    let (Some(descr), Some(order), Some(shape)) =
        (field("descr"), field("fortran_order"), field("shape"))
    else {
        return Err(Problem::NotNpy.into());
    };
    Ok(Header {
        number: number(descr)?,
        by_columns: order.starts_with("True"),
        rows: rows(shape)?,
    })
}

fn number(descr: &str) -> Result<Number, Problem> {
    let quoted = descr
        .strip_prefix('\'')
        .and_then(|rest| rest.split_once('\''));
    let (bytes, big_endian) = match quoted.map(|(name, _)| name) {
        Some("<f8") => (8, false),
        Some("<f4") => (4, false),
        Some(">f8") => (8, true),
        Some(">f4") => (4, true),
        Some(other) => return Err(Problem::Type(shown(other.as_bytes()))),
        None => {
            let end = descr.find(']').map_or(descr.len(), |bracket| bracket + 1);
            return Err(Problem::Type(shown(&descr.as_bytes()[..end])));
        }
    };
    Ok(Number { bytes, big_endian })
}

fn rows(shape: &str) -> Result<usize, Problem> {
    let inside = shape
        .strip_prefix('(')
        .and_then(|rest| rest.split_once(')'));
    let inside = inside.map_or(shape, |(inside, _)| inside);
    let sides: Vec<&str> = inside.split(',').map(str::trim).collect();
    let rows = match sides[..] {
        [rows, "2"] | [rows, "2", ""] => rows.parse().ok(),
        _ => None,
    };
    // More rows than a point set holds are refused there; here they must not overflow.
    rows.filter(|&rows: &usize| rows <= u32::MAX as usize)
        .ok_or_else(|| Problem::Shape(shown(inside.as_bytes())))
}
