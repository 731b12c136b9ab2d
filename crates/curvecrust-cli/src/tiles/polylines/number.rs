//! The number of each curve: its position among those of all tiles, sorted by their names.

use super::Solved;
use super::row::{ROW_BYTES, id};
use super::trace::Traced;
use crate::tiles::merge::Merge;
use crate::tiles::records::{get_words, put_words};
use anyhow::Context;
use std::fs::{File, OpenOptions};
use std::io::{self, BufReader, BufWriter};
use std::path::{Path, PathBuf};

/// Numbers of a list that are held before they are written.
const HELD: usize = 1 << 9;

/// A list of numbers that grows.
struct Ranks {
    path: PathBuf,
    held: Vec<u64>,
}

/// Writes the numbers of the curves of each list: of each tile, and of those across tiles.
pub(super) fn number(job: &Solved<'_>) -> anyhow::Result<()> {
    let mut merge = Merge::new(ROW_BYTES);
    let mut lists = Vec::new();
    for list in 0..=job.tiles() {
        let path = if list < job.tiles() {
            job.folder.pieces(list)
        } else {
            job.folder.across()
        };
        let whole = Traced::open(path.clone())?.whole;
        merge.add(path, Traced::rows_start(), whole);
        let path = job.folder.ranks(list);
        let context = || format!("cannot write {}", path.display());
        File::create(&path).with_context(context)?;
        let held = Vec::new();
        lists.push(Ranks { path, held });
    }
    let mut rank = 0;
    let numbered = merge.run(id, |list, _, _| {
        let ranks = &mut lists[list];
        ranks.held.push(rank);
        rank += 1;
        if ranks.held.len() == HELD {
            ranks.flush()?;
        }
        Ok(())
    });
    numbered.context("cannot number curves")?;
    for list in &mut lists {
        let flushed = list.flush();
        flushed.with_context(|| format!("cannot write {}", list.path.display()))?;
    }
    Ok(())
}

impl Ranks {
    /// Opens the file anew, as many lists are more than a system lets be open.
    fn flush(&mut self) -> io::Result<()> {
        if !self.held.is_empty() {
            let file = OpenOptions::new().append(true).open(&self.path)?;
            let mut out = BufWriter::new(file);
            put_words(&mut out, &self.held)?;
            out.into_inner()?;
            self.held.clear();
        }
        Ok(())
    }
}

/// The words of a file that has nothing else.
pub(super) fn read_words(path: &Path) -> anyhow::Result<Vec<u64>> {
    let read = || -> io::Result<Vec<u64>> {
        let file = File::open(path)?;
        let words = file.metadata()?.len() / 8;
        let mut reader = BufReader::new(file);
        let word = |_| get_words(&mut reader).map(|[word]| word);
        (0..words).map(word).collect()
    };
    read().with_context(|| format!("cannot read {}", path.display()))
}
