//! Ordered polylines, tile by tile, and a table of all curves.
//!
//! | step | file | what for |
//! |---|---|---|
//! | trace | [`trace`] | the pieces of curves of each tile; those that cross no border are whole |
//! | link | [`link`] | the curves across tiles, from the summaries of their pieces |
//! | number | [`number`] | the number of each curve among those of all tiles |
//! | nest | [`nest`] | the rings around each ring |
//! | write | [`write`] | the arrays that the user gets |
//!
//! What is traced is kept for a run that goes on; the other steps start anew, and take much less
//! time.

mod link;
mod nest;
mod number;
mod place;
mod row;
mod summary;
mod trace;
mod write;

use super::Progress;
use super::plan::{Folder, Sizes};
use super::way::Way;
use crate::console::Console;
use curvecrust::tiles::Partition;
use link::Across;
use nest::Nest;
pub(crate) use place::Place;

/// Pairs of a place and a ring around it for each row of a chunk, which take as much memory.
const PAIRS: usize = 4;

/// At least so many, which take hardly any memory.
const LEAST_PAIRS: usize = 1 << 10;

/// What was found.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Found {
    pub(crate) curves: u64,
    pub(crate) closed: u64,
    /// Curves that lie in several tiles.
    pub(crate) across: u64,
}

/// A job whose edges are known.
#[derive(Clone, Copy)]
pub(super) struct Solved<'a> {
    pub(super) folder: &'a Folder,
    pub(super) partition: &'a Partition,
    pub(super) sizes: Sizes,
    pub(super) way: Way,
    pub(super) is_wide: bool,
}

impl Solved<'_> {
    fn tiles(&self) -> usize {
        self.partition.cells().len()
    }

    /// Orders the edges into curves and writes them.
    pub(super) fn write_polylines(
        &self,
        place: &Place,
        console: &Console,
    ) -> anyhow::Result<Found> {
        console.during("tracing curves", |progress| trace::trace(self, progress))?;
        let across = console.during("linking curves", |_| Across::new(self))?;
        console.during("numbering curves", |_| number::number(self))?;
        console.during("nesting rings", |progress| {
            let most = (self.sizes.chunk / PAIRS).max(LEAST_PAIRS);
            Nest::new(self, &across, most)?.run(progress)
        })?;
        console.during("writing curves", |progress| {
            let folder = place.begin()?;
            write::tiles(self, &across, &folder, progress)?;
            let [curves, closed] = write::table(self, &folder)?;
            place.finish()?;
            Ok(Found {
                curves,
                closed,
                across: across.rows.len() as u64,
            })
        })
    }
}
