//! The bytes of a Parquet file, as the crate asks for them. No page is read that says it unpacks to
//! more than the size of the file allows: the crate would reserve that much.

use crate::input::Seekable;
use crate::points::unpacked;
use bytes::Bytes;
use parquet::errors::{ParquetError, Result};
use parquet::file::reader::{ChunkReader, Length};
use std::fs::File;
use std::io::{self, Cursor, Read};

/// Bytes behind the last page: the length of the metadata, and a magic number.
const FOOTER: u64 = 8;

/// Bytes of the start of the header of a page that hold its sizes.
const START: u64 = 32;

pub(super) struct Chunks {
    bytes: Inner,
    size: u64,
}

enum Inner {
    File(File),
    Memory(Bytes),
}

impl Chunks {
    pub(super) fn new(source: Seekable) -> io::Result<Self> {
        let size = source.size()?;
        let bytes = match source {
            Seekable::File(file) => Inner::File(file),
            Seekable::Memory(bytes) => Inner::Memory(bytes.into_inner().into()),
        };
        Ok(Self { bytes, size })
    }

    /// How much may come out of the file.
    pub(super) fn most(&self) -> u64 {
        unpacked::most(self.size)
    }

    fn from(&self, start: u64) -> Result<Box<dyn Read>> {
        Ok(match &self.bytes {
            Inner::File(file) => Box::new(file.get_read(start)?),
            Inner::Memory(bytes) => Box::new(bytes.get_read(start)?),
        })
    }
}

impl Length for Chunks {
    fn len(&self) -> u64 {
        self.size
    }
}

impl ChunkReader for Chunks {
    type T = Box<dyn Read>;

    fn get_read(&self, start: u64) -> Result<Box<dyn Read>> {
        let mut rest = self.from(start)?;
        if start.saturating_add(FOOTER) >= self.size {
            return Ok(rest);
        }
        let mut head = Vec::new();
        rest.by_ref().take(START).read_to_end(&mut head)?;
        match unpacked(&head) {
            Some(size) if size <= self.most() => Ok(Box::new(Cursor::new(head).chain(rest))),
            Some(_) => {
                let most = format!("{} times the file and 64 MiB", unpacked::RATIO);
                let message = format!("a page unpacks to more than {most}");
                Err(ParquetError::General(message))
            }
            None => Err(ParquetError::General("a page has no header".into())),
        }
    }

    fn get_bytes(&self, start: u64, length: usize) -> Result<Bytes> {
        if start.saturating_add(length as u64) > self.size {
            return Err(ParquetError::EOF("it is cut off".into()));
        }
        match &self.bytes {
            Inner::File(file) => file.get_bytes(start, length),
            Inner::Memory(bytes) => bytes.get_bytes(start, length),
        }
    }
}

/// The size that the header of a page says it unpacks to: the second of its fields, which come in
/// order, each a byte of its kind and a number.
fn unpacked(head: &[u8]) -> Option<u64> {
    const WHOLE_NUMBER: u8 = 0x15;
    let (_, rest) = number(head.strip_prefix(&[WHOLE_NUMBER])?)?;
    let (size, _) = number(rest.strip_prefix(&[WHOLE_NUMBER])?)?;
    // Of two numbers that follow each other, the odd one stands for one below zero.
    (size % 2 == 0).then_some(size / 2)
}

/// A number of seven bits a byte, and what follows it.
fn number(bytes: &[u8]) -> Option<(u64, &[u8])> {
    let mut value = 0;
    for (index, &byte) in bytes.iter().enumerate().take(9) {
        value |= u64::from(byte & 0x7f) << (7 * index);
        if byte & 0x80 == 0 {
            return Some((value, &bytes[index + 1..]));
        }
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_sizes_of_pages_are_known() {
        assert_eq!(unpacked(&[0x15, 0x00, 0x15, 0x06, 0x15]), Some(3));
        assert_eq!(unpacked(&[0x15, 0x04, 0x15, 0xac, 0x02, 0x15]), Some(150));
        for head in [
            &[][..],
            &[0x15],
            &[0x15, 0, 0x15, 0x80],
            &[0x15, 0, 0x25, 2],
            &[0x15, 0, 0x15, 3],
        ] {
            assert_eq!(unpacked(head), None);
        }
    }
}
