//! The header of a NumPy array: `\x93NUMPY`, a version and the text of a Python dictionary with the
//! keys `descr`, `fortran_order` and `shape`.
//!
//! <https://numpy.org/doc/stable/reference/generated/numpy.lib.format.html>

use super::{Flaw, Problem};
use crate::points::quote::quoted;
use std::io::{ErrorKind, Read};

/// NumPy itself refuses longer headers unless they are trusted.
const LONGEST: usize = 1 << 16;

/// No file system holds more.
const MOST_ROWS: u64 = 1 << 56;

/// How the numbers of an array are stored.
pub(super) struct Header {
    pub(super) number: Number,
    /// Whether all x come before all y.
    pub(super) by_columns: bool,
    pub(super) rows: usize,
    /// One, of an array of one dimension, two, or three.
    pub(super) columns: usize,
    /// The shape as it stands there, fit for a message.
    pub(super) shape: String,
}

/// How a number is stored.
pub(super) struct Number {
    pub(super) bytes: usize,
    pub(super) big_endian: bool,
}

pub(super) fn read(reader: &mut impl Read) -> Result<Header, Flaw> {
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
    let length = u32::from_le_bytes(length) as usize;
    if length > LONGEST {
        return Err(Problem::LongHeader(LONGEST).into());
    }
    let mut text = vec![0; length];
    read(&mut text)?;
    let fields = str::from_utf8(&text).ok().and_then(fields);
    let Some([descr, order, shape]) = fields else {
        return Err(Problem::NotNpy.into());
    };
    let (rows, columns) = shape_of(shape)?;
    Ok(Header {
        number: number(descr)?,
        by_columns: match order {
            "True" => true,
            "False" => false,
            other => return Err(Problem::Order(quoted(other.as_bytes())).into()),
        },
        rows,
        columns,
        shape: quoted(unwrapped(shape).as_bytes()),
    })
}

/// The values of `descr`, `fortran_order` and `shape`: all keys that a header has, each once.
fn fields(text: &str) -> Option<[&str; 3]> {
    let mut rest = text.trim().strip_prefix('{')?.strip_suffix('}')?.trim();
    let mut fields = [None; 3];
    while !rest.is_empty() {
        let (key, value_and_rest) = key(rest)?;
        let end = end_of_value(value_and_rest)?;
        let index = ["descr", "fortran_order", "shape"]
            .iter()
            .position(|name| *name == key)?;
        let value = value_and_rest[..end].trim();
        if fields[index].replace(value).is_some() {
            return None;
        }
        // The last one may have a comma behind it.
        rest = value_and_rest[end..]
            .strip_prefix(',')
            .unwrap_or_default()
            .trim_start();
    }
    let [descr, order, shape] = fields;
    Some([descr?, order?, shape?])
}

/// A quoted key, and what follows the colon behind it.
fn key(text: &str) -> Option<(&str, &str)> {
    let quote = text.chars().next().filter(|c| ['\'', '"'].contains(c))?;
    let (key, rest) = text[1..].split_once(quote)?;
    Some((key, rest.trim_start().strip_prefix(':')?))
}

/// Where a value ends: at a comma outside of quotes and brackets, or with the text. `None` if
/// quotes or brackets are not closed.
fn end_of_value(text: &str) -> Option<usize> {
    let mut open = 0usize;
    let mut quote = None;
    for (index, c) in text.char_indices() {
        match (quote, c) {
            (Some(mark), c) => quote = Some(mark).filter(|&mark| mark != c),
            (None, '\'' | '"') => quote = Some(c),
            (None, '(' | '[' | '{') => open += 1,
            (None, ')' | ']' | '}') => open = open.checked_sub(1)?,
            (None, ',') if open == 0 => return Some(index),
            _ => {}
        }
    }
    (open == 0 && quote.is_none()).then_some(text.len())
}

fn number(descr: &str) -> Result<Number, Problem> {
    let (bytes, big_endian) = match descr.trim_matches(['\'', '"']) {
        "<f8" => (8, false),
        "<f4" => (4, false),
        ">f8" => (8, true),
        ">f4" => (4, true),
        other => return Err(Problem::Type(quoted(other.as_bytes()))),
    };
    Ok(Number { bytes, big_endian })
}

/// A shape without its brackets.
fn unwrapped(shape: &str) -> &str {
    let inside = shape.strip_prefix('(').and_then(|s| s.strip_suffix(')'));
    inside.unwrap_or(shape)
}

/// The numbers of rows and of columns.
fn shape_of(shape: &str) -> Result<(usize, usize), Problem> {
    let inside = unwrapped(shape);
    let sides: Vec<&str> = inside.split(',').map(str::trim).collect();
    let (rows, columns) = match sides[..] {
        [rows, ""] => (rows.parse().ok(), 1),
        [rows, "2"] | [rows, "2", ""] => (rows.parse().ok(), 2),
        [rows, "3"] | [rows, "3", ""] => (rows.parse().ok(), 3),
        _ => (None, 0),
    };
    // More rows than a point set holds are refused there; here they must not overflow.
    match rows.filter(|&rows: &usize| rows as u64 <= MOST_ROWS) {
        Some(rows) => Ok((rows, columns)),
        None => Err(Problem::Shape(quoted(inside.as_bytes()))),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_header_has_three_keys_and_nothing_else() {
        let good = [
            "{'descr': '<f8', 'fortran_order': False, 'shape': (2, 2), }\n",
            r#"{"shape":(2,2),"descr":"<f8","fortran_order":False}"#,
        ];
        for text in good {
            let [_, order, shape] = fields(text).unwrap();
            assert_eq!(
                (order, shape.replace(' ', "")),
                ("False", "(2,2)".to_owned())
            );
        }
        let nested =
            "{'descr': [('shape', '<f8'), ('y', '<f8')], 'fortran_order': True, 'shape': (2,)}";
        let [descr, _, shape] = fields(nested).unwrap();
        assert_eq!(descr, "[('shape', '<f8'), ('y', '<f8')]");
        assert_eq!(shape, "(2,)");
        for text in [
            "",
            "{}",
            "{'descr': '<f8', 'shape': (2, 2)}",
            "{'descr': '<f8', 'fortran_order': False, 'shape': (2, 2",
            "{'descr': '<f8', 'fortran_order': False, 'shape': (2, 2), 'shape': (2, 2)}",
            "{'descr': '<f8, 'fortran_order': False, 'shape': (2, 2)}",
            "{'descr': '<f8', 'fortran_order': False, 'shape': (2, 2)), }",
        ] {
            assert_eq!(fields(text), None, "{text}");
        }
    }
}
