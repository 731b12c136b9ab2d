//! What separates the columns of a table, found in its first lines.

use super::columns::{ColumnNames, Columns};
use super::csv_records::CsvRecords;
use super::is_number;
use super::records::Records;
use super::text_records::TextRecords;
use crate::input::Source;
use std::io;

/// What stands between two columns.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Separator {
    /// A comma, a semicolon or a tab.
    Byte(u8),
    /// White space.
    WhiteSpace,
}

const BYTES: &[u8] = b",;\t";

/// Lines that are looked at: the first may be a title.
const LINES: usize = 2;

/// The separator by which one of the first two lines is a header or a point. Without one, it is the
/// first byte of the first line that could be a separator; `None` if there is none.
pub(super) fn find(
    source: &mut Source,
    names: Option<&ColumnNames>,
) -> io::Result<Option<Separator>> {
    let head = source.peek(|head| lines(head).filter(|line| line.is_complete).count() >= LINES)?;
    let mut first = None;
    for line in lines(head).take(LINES) {
        let bytes = separators(line.text).map(Separator::Byte);
        let candidates = bytes.chain([Separator::WhiteSpace]);
        for candidate in candidates {
            if makes_sense(line.text, candidate, names) {
                return Ok(Some(candidate));
            }
        }
        first = first.or_else(|| separators(line.text).next().map(Separator::Byte));
    }
    Ok(first)
}

/// Whether a line is a header or starts with two numbers.
fn makes_sense(line: &[u8], separator: Separator, names: Option<&ColumnNames>) -> bool {
    match separator {
        Separator::Byte(byte) => is_sensible(CsvRecords::new(line, byte), names),
        Separator::WhiteSpace => is_sensible(TextRecords::new(line), names),
    }
}

fn is_sensible(mut records: impl Records, names: Option<&ColumnNames>) -> bool {
    if !records.advance().unwrap_or(false) {
        return false;
    }
    let has_commas = records.has_decimal_commas();
    let is_point =
        records.len() >= 2 && (0..2).all(|column| is_number(records.field(column), has_commas));
    // Two columns of one name are a header, if a bad one.
    is_point || !matches!(Columns::of_header(&records, names), Ok(None))
}

/// The different bytes of a line that could separate columns, in the order of their first places.
fn separators(line: &[u8]) -> impl Iterator<Item = u8> + '_ {
    let mut found = Vec::new();
    let mut quotes = Quotes::default();
    for &byte in line {
        if !quotes.step(byte) && BYTES.contains(&byte) && !found.contains(&byte) {
            found.push(byte);
        }
    }
    found.into_iter()
}

/// A line that is neither empty nor a comment.
struct Line<'a> {
    text: &'a [u8],
    /// Whether its end was seen.
    is_complete: bool,
}

fn lines(mut head: &[u8]) -> impl Iterator<Item = Line<'_>> {
    std::iter::from_fn(move || {
        while !head.is_empty() {
            let is_comment = head[0] == b'#';
            let mut quotes = Quotes::default();
            let mut bytes = head.iter();
            let end = bytes.position(|&byte| (is_comment || !quotes.step(byte)) && byte == b'\n');
            let (text, rest) = head.split_at(end.map_or(head.len(), |end| end + 1));
            head = rest;
            if !is_comment && !text.trim_ascii().is_empty() {
                let is_complete = end.is_some();
                return Some(Line { text, is_complete });
            }
        }
        None
    })
}

/// Whether bytes are in quotes, which open where a field starts.
struct Quotes {
    is_inside: bool,
    at_start: bool,
}

impl Default for Quotes {
    fn default() -> Self {
        Self {
            is_inside: false,
            at_start: true,
        }
    }
}

impl Quotes {
    /// Whether this byte is in quotes.
    fn step(&mut self, byte: u8) -> bool {
        if self.is_inside {
            self.is_inside = byte != b'"';
            // One that follows at once opens again: two stand for one.
            self.at_start = byte == b'"';
            return true;
        }
        self.is_inside = byte == b'"' && self.at_start;
        self.at_start = BYTES.contains(&byte);
        self.is_inside
    }
}
