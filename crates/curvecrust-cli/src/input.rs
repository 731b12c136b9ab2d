//! Where data come from: a file, or stdin by the name `-`.

use std::fs::File;
use std::io::{self, BufRead, BufReader, Cursor, Read};
use std::path::Path;

/// Bytes that are looked at in one go before a source is read.
const HEAD: usize = 4096;
/// Bytes that are looked at at most; a file may start with a long comment.
const LONGEST_HEAD: usize = 1 << 24;
/// Read from the system at once.
const BUFFER: usize = 1 << 16;

/// An opened source, of which the first bytes are known.
pub(crate) struct Source {
    head: Vec<u8>,
    rest: Box<dyn BufRead>,
}

impl Source {
    /// Opens it and reads its first bytes.
    pub(crate) fn open(path: &Path) -> io::Result<Self> {
        if is_standard(path) {
            Self::new(io::stdin().lock())
        } else {
            Self::new(BufReader::with_capacity(BUFFER, File::open(path)?))
        }
    }

    /// Reads its first bytes; the byte order mark of UTF-8 is left out.
    pub(crate) fn new(mut rest: impl BufRead + 'static) -> io::Result<Self> {
        let mut head = Vec::with_capacity(HEAD);
        rest.by_ref().take(HEAD as u64).read_to_end(&mut head)?;
        if head.starts_with(b"\xef\xbb\xbf") {
            head.drain(..3);
        }
        let rest = Box::new(rest);
        Ok(Self { head, rest })
    }

    /// The first bytes, all there are if they are few.
    pub(crate) fn head(&self) -> &[u8] {
        &self.head
    }

    /// Reads until the first bytes are enough, or all there are.
    pub(crate) fn peek(&mut self, is_enough: impl Fn(&[u8]) -> bool) -> io::Result<&[u8]> {
        while self.head.len() < LONGEST_HEAD && !is_enough(&self.head) {
            let more = self.head.len().max(HEAD) as u64;
            if self.rest.by_ref().take(more).read_to_end(&mut self.head)? == 0 {
                break;
            }
        }
        Ok(&self.head)
    }

    /// Everything, from the start.
    pub(crate) fn into_reader(self) -> impl BufRead {
        Cursor::new(self.head).chain(self.rest)
    }

    /// Everything at once.
    pub(crate) fn into_bytes(mut self) -> io::Result<Vec<u8>> {
        self.rest.read_to_end(&mut self.head)?;
        Ok(self.head)
    }
}

/// Whether a path means stdin or stdout.
pub(crate) fn is_standard(path: &Path) -> bool {
    path.as_os_str() == "-"
}

/// How messages call a source.
pub(crate) fn name(path: &Path) -> String {
    if is_standard(path) {
        String::from("stdin")
    } else {
        path.display().to_string()
    }
}
