//! Records with white space between the fields (`.xy`, `.txt`, `.p2d`). What follows a `#` does not
//! count.

use super::quote::quoted;
use super::records::Records;
use super::{Flaw, Place, Problem};
use std::io::{self, BufRead};
use std::ops::Range;

/// The lines of a reader that hold anything.
pub(super) struct TextRecords<R> {
    input: R,
    line: Vec<u8>,
    fields: Vec<Range<usize>>,
    number: u64,
}

impl<R: BufRead> TextRecords<R> {
    pub(super) fn new(input: R) -> Self {
        Self {
            input,
            line: Vec::new(),
            fields: Vec::new(),
            number: 0,
        }
    }
}

impl<R: BufRead> Records for TextRecords<R> {
    const IS_TEXT: bool = true;

    fn advance(&mut self) -> io::Result<bool> {
        loop {
            self.line.clear();
            if self.input.read_until(b'\n', &mut self.line)? == 0 {
                return Ok(false);
            }
            self.number += 1;
            self.fields.clear();
            self.fields.extend(words(&self.line));
            if !self.fields.is_empty() {
                return Ok(true);
            }
        }
    }

    fn len(&self) -> usize {
        self.fields.len()
    }

    fn field(&self, index: usize) -> &[u8] {
        &self.line[self.fields[index].clone()]
    }

    fn line(&self) -> u64 {
        self.number
    }

    fn place(&self, index: usize) -> Place {
        let before = &self.line[..self.fields[index].start];
        let column = String::from_utf8_lossy(before).chars().count() + 1;
        Place::Column(self.number, column)
    }

    fn has_decimal_commas(&self) -> bool {
        false
    }

    fn ragged(&self, expected: usize) -> Flaw {
        match (self.len(), expected) {
            (1, _) => Problem::Short(quoted(self.field(0))).at(Place::Line(self.number)),
            (_, 2) => Problem::Long(quoted(self.field(2))).at(self.place(2)),
            (found, _) => Problem::Ragged { found, expected }.at(Place::Line(self.number)),
        }
    }
}

/// The words of a line.
pub(super) fn words(line: &[u8]) -> impl Iterator<Item = Range<usize>> + '_ {
    let line = line.split(|&byte| byte == b'#').next().unwrap_or_default();
    let mut end = 0;
    std::iter::from_fn(move || {
        let rest = &line[end..];
        let start = end + rest.iter().position(|b| !b.is_ascii_whitespace())?;
        let length = line[start..].iter().position(u8::is_ascii_whitespace);
        end = length.map_or(line.len(), |length| start + length);
        Some(start..end)
    })
}
