//! Records with a comma, a semicolon or a tab between the fields (`.csv`, `.tsv`), which may be
//! quoted. Lines that start with a `#` do not count.

use super::quote::quoted;
use super::records::Records;
use super::{Flaw, Place, Problem};
use csv_core::{ReadRecordResult, Reader, ReaderBuilder};
use std::io::{self, BufRead, ErrorKind};

/// The records of a reader, by the crate `csv-core`, which counts lines.
pub(super) struct CsvRecords<R> {
    input: R,
    reader: Reader,
    separator: u8,
    /// The fields of the record, one after the other.
    bytes: Vec<u8>,
    /// Where each of them ends.
    ends: Vec<usize>,
    len: usize,
    /// Whether the last byte of the record was the line feed behind it.
    has_line_feed: bool,
}

impl<R: BufRead> CsvRecords<R> {
    pub(super) fn new(input: R, separator: u8) -> Self {
        let mut builder = ReaderBuilder::new();
        Self {
            input,
            reader: builder.comment(Some(b'#')).delimiter(separator).build(),
            separator,
            bytes: vec![0; 1024],
            ends: vec![0; 16],
            len: 0,
            has_line_feed: false,
        }
    }

    fn read(&mut self) -> io::Result<bool> {
        let mut written = 0;
        self.len = 0;
        loop {
            let input = match self.input.fill_buf() {
                Err(error) if error.kind() == ErrorKind::Interrupted => continue,
                input => input?,
            };
            let (result, read, bytes, fields) = self.reader.read_record(
                input,
                &mut self.bytes[written..],
                &mut self.ends[self.len..],
            );
            self.has_line_feed = input[..read].last() == Some(&b'\n');
            self.input.consume(read);
            written += bytes;
            self.len += fields;
            match result {
                ReadRecordResult::InputEmpty => {}
                ReadRecordResult::OutputFull => self.bytes.resize(2 * self.bytes.len(), 0),
                ReadRecordResult::OutputEndsFull => self.ends.resize(2 * self.ends.len(), 0),
                ReadRecordResult::Record => return Ok(true),
                ReadRecordResult::End => return Ok(false),
            }
        }
    }
}

impl<R: BufRead> Records for CsvRecords<R> {
    const IS_TEXT: bool = false;

    fn advance(&mut self) -> io::Result<bool> {
        while self.read()? {
            if self.len > 1 || !self.field(0).is_empty() {
                return Ok(true);
            }
        }
        Ok(false)
    }

    fn len(&self) -> usize {
        self.len
    }

    fn field(&self, index: usize) -> &[u8] {
        let start = index.checked_sub(1).map_or(0, |before| self.ends[before]);
        self.bytes[start..self.ends[index]].trim_ascii()
    }

    fn line(&self) -> u64 {
        let bytes = &self.bytes[..self.ends[self.len - 1]];
        let inside = bytes.iter().filter(|&&byte| byte == b'\n').count();
        self.reader.line() - inside as u64 - u64::from(self.has_line_feed)
    }

    fn place(&self, index: usize) -> Place {
        Place::Field(self.line(), index + 1)
    }

    fn has_decimal_commas(&self) -> bool {
        self.separator != b','
    }

    fn ragged(&self, expected: usize) -> Flaw {
        let problem = match self.len {
            1 => Problem::Short(quoted(self.field(0))),
            found => Problem::Ragged { found, expected },
        };
        problem.at(Place::Line(self.line()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The first field of each record, and its line.
    fn lines(text: &str) -> Vec<(String, u64)> {
        let mut records = CsvRecords::new(text.as_bytes(), b',');
        let mut found = Vec::new();
        while records.advance().unwrap() {
            let field = String::from_utf8(records.field(0).to_vec()).unwrap();
            found.push((field, records.line()));
        }
        found
    }

    #[test]
    fn records_know_their_lines() {
        let expected = |fields: [(&str, u64); 3]| fields.map(|(f, line)| (f.to_owned(), line));
        let plain = expected([("a", 1), ("b", 2), ("c", 3)]);
        let spaced = expected([("a", 2), ("b", 5), ("c", 6)]);
        for end in ["\n", "\r\n"] {
            assert_eq!(lines(&["a,1", "b,2", "c,3"].join(end)), plain);
            let text = ["# one", "a,1", "", "# two", "b,2", "c,3", "", "  ", ""];
            assert_eq!(lines(&text.join(end)), spaced);
        }
        let quoted = expected([("a\nA", 1), ("b", 3), ("c\n\nC", 4)]);
        assert_eq!(lines("\"a\nA\",1\nb,2\n\"c\n\nC\",3\n"), quoted);
        // A quote that is never closed.
        assert_eq!(lines("a,1\nb,\"2\n"), plain[..2]);
    }

    #[test]
    fn long_records_are_read() {
        let long = "1".repeat(5000);
        let fields = vec!["2"; 100].join(",");
        let text = format!("{long},{fields}\n3,4\n");
        assert_eq!(lines(&text), [(long, 1), (String::from("3"), 2)]);
    }
}
