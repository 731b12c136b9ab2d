//! Records with a comma, a semicolon or a tab between the fields (`.csv`, `.tsv`), which may be
//! quoted. Lines that start with a `#` do not count.

use super::quote::quoted;
use super::records::Records;
use super::{Flaw, Place, Problem};
use csv_core::{ReadRecordResult, Reader, ReaderBuilder};
use std::io::{self, BufRead, ErrorKind};

/// The records of a reader, by the crate `csv-core`. Lines end with a line feed, a carriage return,
/// or both.
pub(super) struct CsvRecords<R> {
    input: R,
    reader: Reader,
    separator: u8,
    /// The fields of the record, one after the other.
    bytes: Vec<u8>,
    /// Where each of them ends.
    ends: Vec<usize>,
    len: usize,
    /// The ends of lines up to the end of the record.
    line_ends: u64,
    /// The last byte that was read.
    last: Option<u8>,
    /// Whether that was the end of a line behind the record.
    has_line_end: bool,
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
            line_ends: 0,
            last: None,
            has_line_end: false,
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
            self.line_ends += line_ends(self.last, &input[..read]);
            let last = input[..read].last().copied();
            self.has_line_end = matches!(last, Some(b'\n' | b'\r'));
            self.last = last.or(self.last);
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
        let starts = std::iter::once(0).chain(self.ends.iter().copied());
        let fields = starts.zip(&self.ends[..self.len]);
        let inside = fields.map(|(start, &end)| line_ends(None, &self.bytes[start..end]));
        1 + self.line_ends - inside.sum::<u64>() - u64::from(self.has_line_end)
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

/// How many lines end in some bytes, of which another one may stand before.
fn line_ends(before: Option<u8>, bytes: &[u8]) -> u64 {
    let each_before = std::iter::once(before).chain(bytes.iter().copied().map(Some));
    let ends = each_before
        .zip(bytes)
        .filter(|&(before, &byte)| match byte {
            b'\r' => true,
            b'\n' => before != Some(b'\r'),
            _ => false,
        });
    ends.count() as u64
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
        assert_eq!(lines("a,1\rb,2\rc,3\r"), plain);
        for end in ["\n", "\r\n"] {
            assert_eq!(lines(&["a,1", "b,2", "c,3"].join(end)), plain);
            let text = ["# one", "a,1", "", "# two", "b,2", "c,3", "", "  ", ""];
            assert_eq!(lines(&text.join(end)), spaced);
        }
        let quoted = expected([("a\nA", 1), ("b", 3), ("c\n\nC", 4)]);
        assert_eq!(lines("\"a\nA\",1\nb,2\n\"c\n\nC\",3\n"), quoted);
        assert_eq!(lines("\"a\nA\",1\r\nb,2\r\n\"c\n\nC\",3\r\n"), quoted);
        // A quote that is never closed.
        assert_eq!(lines("a,1\nb,\"2\n"), plain[..2]);
    }

    /// A reader that is interrupted before each piece that it gives.
    struct Interrupted<'a>(&'a [u8], bool);

    impl io::Read for Interrupted<'_> {
        fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
            self.1 = !self.1;
            if self.1 {
                return Err(ErrorKind::Interrupted.into());
            }
            let few = buffer.len().min(3);
            self.0.read(&mut buffer[..few])
        }
    }

    #[test]
    fn what_interrupts_a_read_does_not_end_it() {
        let input = io::BufReader::with_capacity(3, Interrupted(b"a,1\r\nb,2\r\n", false));
        let mut records = CsvRecords::new(input, b',');
        for line in 1..3 {
            assert!(records.advance().unwrap());
            assert_eq!(records.line(), line);
        }
        assert!(!records.advance().unwrap());
    }

    #[test]
    fn long_records_are_read() {
        let long = "1".repeat(5000);
        let fields = vec!["2"; 100].join(",");
        let text = format!("{long},{fields}\n3,4\n");
        assert_eq!(lines(&text), [(long, 1), (String::from("3"), 2)]);
    }
}
