//! Sorted lists of many files in one sorted list.

use std::cmp::Reverse;
use std::collections::BinaryHeap;
use std::collections::binary_heap::PeekMut;
use std::fs::File;
use std::io::{self, Read, Seek, SeekFrom};
use std::path::PathBuf;

/// Bytes that are read from one list at once, at most.
const MOST: usize = 1 << 20;

/// Bytes that are read from all lists at once, about.
const ALL: usize = 1 << 24;

/// The records of one file that are left.
struct List {
    path: PathBuf,
    /// Where the next ones are that are not read yet, and how many.
    offset: u64,
    left: u64,
    buffer: Vec<u8>,
    at: usize,
}

/// All lists, to be merged.
pub(super) struct Merge {
    lists: Vec<List>,
    /// The bytes of a record.
    bytes: usize,
    /// The number of records.
    pub(super) count: u64,
}

impl Merge {
    /// Without a list, for records of so many bytes.
    pub(super) fn new(bytes: usize) -> Self {
        Self {
            lists: Vec::new(),
            bytes,
            count: 0,
        }
    }

    /// Adds a list: `count` records of a file from an offset on.
    pub(super) fn add(&mut self, path: PathBuf, offset: u64, count: u64) {
        self.count += count;
        self.lists.push(List {
            path,
            offset,
            left: count,
            buffer: Vec::new(),
            at: 0,
        });
    }

    /// Gives all records to `take`, ascending by their keys, with the number of their list.
    pub(super) fn run<K: Ord + Copy>(
        mut self,
        key: impl Fn(&[u8]) -> K,
        mut take: impl FnMut(usize, K, &[u8]) -> io::Result<()>,
    ) -> io::Result<()> {
        let at_once = (ALL / self.lists.len().max(1)).clamp(1 << 12, MOST);
        let bytes = self.bytes;
        let mut heap = BinaryHeap::with_capacity(self.lists.len());
        for (number, list) in self.lists.iter_mut().enumerate() {
            let first = list.peek(bytes, at_once)?;
            heap.extend(first.map(|record| Reverse((key(record), number))));
        }
        while let Some(mut least) = heap.peek_mut() {
            let Reverse((found, number)) = *least;
            let list = &mut self.lists[number];
            take(number, found, &list.buffer[list.at..list.at + bytes])?;
            list.at += bytes;
            match list.peek(bytes, at_once)? {
                // The heap is put in order once the new one is let go.
                Some(next) => *least = Reverse((key(next), number)),
                None => drop(PeekMut::pop(least)),
            }
        }
        Ok(())
    }
}

impl List {
    /// The next record, which stays the next.
    fn peek(&mut self, bytes: usize, at_once: usize) -> io::Result<Option<&[u8]>> {
        if self.at == self.buffer.len() && !self.fill(bytes, at_once)? {
            return Ok(None);
        }
        Ok(Some(&self.buffer[self.at..self.at + bytes]))
    }

    /// Reads more; opens the file anew, as many lists are more than a system lets be open.
    fn fill(&mut self, bytes: usize, at_once: usize) -> io::Result<bool> {
        let count = (at_once / bytes).min(usize::try_from(self.left).unwrap_or(usize::MAX));
        self.buffer.resize(count * bytes, 0);
        self.at = 0;
        if count == 0 {
            return Ok(false);
        }
        let mut read = || -> io::Result<()> {
            let mut file = File::open(&self.path)?;
            file.seek(SeekFrom::Start(self.offset))?;
            file.read_exact(&mut self.buffer)
        };
        read().map_err(|error| {
            let message = format!("cannot read {}: {error}", self.path.display());
            io::Error::new(error.kind(), message)
        })?;
        self.offset += (count * bytes) as u64;
        self.left -= count as u64;
        Ok(true)
    }
}
