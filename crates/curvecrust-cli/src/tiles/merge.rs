//! The sorted edges of all tiles in one sorted list.

use super::plan::Folder;
use super::solve::{Counts, edge_bytes};
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

/// The edges of one tile that are left.
struct List {
    path: PathBuf,
    /// Where the next ones are that are not read yet, and how many.
    offset: u64,
    left: u64,
    buffer: Vec<u8>,
    at: usize,
    is_wide: bool,
}

/// All lists, to be merged.
pub(super) struct Merge {
    lists: Vec<List>,
    /// The number of edges.
    pub(super) count: u64,
}

impl Merge {
    /// Opens the lists of all tiles, and of what was joined.
    pub(super) fn open(folder: &Folder, tiles: usize, is_wide: bool) -> anyhow::Result<Self> {
        let mut lists = Vec::new();
        let mut total = 0;
        let paths = (0..tiles).map(|tile| folder.result(tile));
        for path in paths.chain([folder.joined()]) {
            let (counts, _) = Counts::open(&path, is_wide)?;
            total += counts.edges;
            lists.push(List {
                path,
                offset: counts.to_edges(),
                left: counts.edges,
                buffer: Vec::new(),
                at: 0,
                is_wide,
            });
        }
        Ok(Self {
            lists,
            count: total,
        })
    }

    /// Gives all edges to `take`, ascending.
    pub(super) fn run(
        mut self,
        mut take: impl FnMut([u64; 2]) -> io::Result<()>,
    ) -> io::Result<()> {
        let at_once = (ALL / self.lists.len()).clamp(1 << 12, MOST);
        let mut heap = BinaryHeap::with_capacity(self.lists.len());
        for (number, list) in self.lists.iter_mut().enumerate() {
            heap.extend(list.next(at_once)?.map(|edge| Reverse((edge, number))));
        }
        while let Some(mut least) = heap.peek_mut() {
            let Reverse((edge, number)) = *least;
            take(edge)?;
            match self.lists[number].next(at_once)? {
                // The heap is put in order once the new one is let go.
                Some(next) => *least = Reverse((next, number)),
                None => drop(PeekMut::pop(least)),
            }
        }
        Ok(())
    }
}

impl List {
    fn next(&mut self, at_once: usize) -> io::Result<Option<[u64; 2]>> {
        if self.at == self.buffer.len() && !self.fill(at_once)? {
            return Ok(None);
        }
        let bytes = edge_bytes(self.is_wide);
        let edge = &self.buffer[self.at..self.at + bytes];
        self.at += bytes;
        let number = |half: &[u8]| {
            let mut number = [0; 8];
            number[..half.len()].copy_from_slice(half);
            u64::from_le_bytes(number)
        };
        let (a, b) = edge.split_at(bytes / 2);
        Ok(Some([number(a), number(b)]))
    }

    /// Reads more; opens the file anew, as many lists are more than a system lets be open.
    fn fill(&mut self, at_once: usize) -> io::Result<bool> {
        let bytes = edge_bytes(self.is_wide);
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
