//! Which rings lie around which: how many, and the one right around each.
//!
//! A ring lies around another if it lies around its leftmost sample. A ring that crosses no border
//! lies in the box of its tile, so it lies only around samples of that tile. Each tile holds its
//! own rings against the leftmost samples in it. Only the rings across tiles are held against those
//! of all tiles, of as many tiles at once as memory allows.

use super::link::Across;
use super::number::read_words;
use super::row::{Nested, Row};
use super::trace::Traced;
use super::{Progress, Solved};
use crate::tiles::records::{self, NONE, put, put_words};
use curvecrust::DVec2;
use curvecrust::tiles::{Crossings, Sample, surrounding};
use std::io::Write;
use std::ops::Range;

/// Finds what lies around rings.
pub(super) struct Nest<'a> {
    job: &'a Solved<'a>,
    across: &'a Across,
    /// The rings among the curves across tiles, each with the tile of its leftmost sample.
    rings: Vec<(usize, usize)>,
    /// For each curve across tiles how many rings lie around it, and its number among all curves.
    nesting: Vec<u64>,
    ranks: Vec<u64>,
    /// More places, or pairs of a place and a ring around it, are not looked at at once.
    most: usize,
}

/// What is known of the rings that may lie around others.
#[derive(Clone, Copy)]
struct Outer<'a> {
    nesting: &'a [u64],
    ranks: &'a [u64],
}

/// How a number that belongs to a ring changes with rings around it: given how many lie around it
/// in all, if that is known, their positions in a list, and that list.
type Change = fn(&mut u64, u64, &[usize], Outer<'_>);

/// Consecutive lists whose rings are looked at together.
struct Batch {
    lists: Range<usize>,
    /// The leftmost samples of the rings.
    places: Vec<DVec2>,
    /// Where the rings of each list start; behind them their number.
    starts: Vec<usize>,
}

impl<'a> Nest<'a> {
    pub(super) fn new(
        job: &'a Solved<'a>,
        across: &'a Across,
        most: usize,
    ) -> anyhow::Result<Self> {
        let rings = across.rows.iter().enumerate().filter(|(_, row)| row.closed);
        let rings = rings.map(|(ring, row)| (ring, job.partition.cell_of(row.leftmost)));
        Ok(Self {
            job,
            across,
            rings: rings.collect(),
            nesting: vec![0; across.rows.len()],
            ranks: read_words(&job.folder.ranks(job.tiles()))?,
            most,
        })
    }

    /// Writes what is known of the curves of each list.
    pub(super) fn run(mut self, progress: Progress<'_>) -> anyhow::Result<()> {
        let lists = self.job.tiles() + 1;
        self.nesting = self.count(&|done| progress(done, 2 * lists))?;
        self.find_parents(&|done| progress(lists + done, 2 * lists))
    }

    /// Counts the rings around the rings of each tile, and around those across tiles.
    fn count(&self, progress: &dyn Fn(usize)) -> anyhow::Result<Vec<u64>> {
        let mut of_across = vec![0; self.across.rows.len()];
        let count: Change = |count, _, around, _| *count += around.len() as u64;
        self.each_batch(|batch| {
            progress(batch.lists.end);
            let mut counts = vec![0; batch.places.len()];
            self.change(batch, count, &mut counts, &mut of_across)?;
            for list in batch.lists.clone() {
                let counts = &counts[batch.of(list)];
                if list == self.job.tiles() {
                    self.add_to_across(&mut of_across, counts, |all, more| *all += more);
                    continue;
                }
                let path = self.job.folder.nesting(list);
                records::write(&path, |out| {
                    put_words(out, counts).and_then(|()| out.flush())
                })?;
            }
            Ok(())
        })?;
        Ok(of_across)
    }

    /// Finds the ring right around each ring, as soon as it is known how many lie around each, and
    /// writes the curves.
    fn find_parents(&self, progress: &dyn Fn(usize)) -> anyhow::Result<()> {
        let mut of_across = vec![NONE; self.across.rows.len()];
        let choose: Change = |parent, nesting, around, outer| {
            let is_right_around = |&&ring: &&usize| outer.nesting[ring] + 1 == nesting;
            let found = around.iter().find(is_right_around);
            // In each list the first one has the least number.
            *parent = found.map_or(*parent, |&ring| outer.ranks[ring].min(*parent));
        };
        self.each_batch(|batch| {
            progress(batch.lists.end);
            let mut parents = vec![NONE; batch.places.len()];
            self.change(batch, choose, &mut parents, &mut of_across)?;
            for list in batch.lists.clone() {
                let parents = &parents[batch.of(list)];
                if list < self.job.tiles() {
                    self.write(list, &self.nesting_of(list)?, parents)?;
                    continue;
                }
                self.add_to_across(&mut of_across, parents, |all, one| *all = one.min(*all));
                let rings = self.rings.iter().map(|&(ring, _)| ring);
                let known = rings.map(|ring| (self.nesting[ring], of_across[ring]));
                let (nesting, parents): (Vec<_>, Vec<_>) = known.unzip();
                self.write(list, &nesting, &parents)?;
            }
            Ok(())
        })
    }

    /// Changes the numbers of rings across tiles by those that were found for them.
    fn add_to_across(&self, all: &mut [u64], found: &[u64], change: impl Fn(&mut u64, u64)) {
        for (&(ring, _), &found) in self.rings.iter().zip(found) {
            change(&mut all[ring], found);
        }
    }

    /// Writes the curves of a list, given what is known of its rings.
    fn write(&self, list: usize, nesting: &[u64], parents: &[u64]) -> anyhow::Result<()> {
        let mut rings = nesting.iter().zip(parents);
        let nested = self.rows(list)?.into_iter().map(|row| {
            let ring = if row.closed { rings.next() } else { None };
            let (nesting, parent) = ring.map_or((NONE, NONE), |(&n, &p)| (n, p));
            Nested {
                row,
                nesting,
                parent,
            }
        });
        records::write(&self.job.folder.curves(list), |out| {
            put(out, nested)?;
            out.flush()
        })
    }

    /// How many rings lie around those of a tile, as found before.
    fn nesting_of(&self, tile: usize) -> anyhow::Result<Vec<u64>> {
        read_words(&self.job.folder.nesting(tile))
    }

    /// The curves of a list.
    fn rows(&self, list: usize) -> anyhow::Result<Vec<Row>> {
        if list == self.job.tiles() {
            return Ok(self.across.rows.clone());
        }
        Traced::open(self.job.folder.pieces(list))?.rows()
    }

    /// Takes the rings of all lists in batches, those across tiles last.
    fn each_batch(&self, mut take: impl FnMut(&Batch) -> anyhow::Result<()>) -> anyhow::Result<()> {
        let lists = self.job.tiles() + 1;
        let mut next = 0;
        while next < lists {
            let mut batch = Batch {
                lists: next..next,
                places: Vec::new(),
                starts: vec![0],
            };
            while batch.lists.end < lists
                && (batch.lists.is_empty() || batch.places.len() < self.most)
            {
                let rows = self.rows(batch.lists.end)?;
                let rings = rows.iter().filter(|row| row.closed);
                batch.places.extend(rings.map(|row| row.leftmost));
                batch.starts.push(batch.places.len());
                batch.lists.end += 1;
            }
            next = batch.lists.end;
            take(&batch)?;
        }
        Ok(())
    }

    /// Changes the numbers of the rings of a batch by the rings around them, and those of rings
    /// across tiles by the rings of the tiles of the batch.
    fn change(
        &self,
        batch: &Batch,
        change: Change,
        values: &mut [u64],
        of_across: &mut [u64],
    ) -> anyhow::Result<()> {
        let known = self.known(batch)?;
        let outer = Outer {
            nesting: &self.nesting,
            ranks: &self.ranks,
        };
        if !self.rings.is_empty() {
            let sides = |crossings: &mut Crossings| self.sides_across(crossings);
            surrounding(&batch.places, self.most, sides, |at, around| {
                change(&mut values[at], known[at], around, outer);
            })?;
        }
        for tile in batch.lists.clone().filter(|&list| list < self.job.tiles()) {
            let range = batch.of(tile);
            self.change_in_tile(
                tile,
                &batch.places[range.clone()],
                &known[range.clone()],
                change,
                &mut values[range],
                of_across,
            )?;
        }
        Ok(())
    }

    /// How many rings lie around the rings of a batch; zeros as long as that is not known.
    fn known(&self, batch: &Batch) -> anyhow::Result<Vec<u64>> {
        let mut known = Vec::with_capacity(batch.places.len());
        for list in batch.lists.clone() {
            let range = batch.of(list);
            if list == self.job.tiles() {
                known.extend(self.rings.iter().map(|&(ring, _)| self.nesting[ring]));
            } else if self.job.folder.nesting(list).exists() {
                known.extend(self.nesting_of(list)?);
            }
            known.resize(range.end, 0);
        }
        Ok(known)
    }

    /// The part of [`change`](Self::change) by the rings that lie in one tile.
    fn change_in_tile(
        &self,
        tile: usize,
        places: &[DVec2],
        known: &[u64],
        change: Change,
        values: &mut [u64],
        of_across: &mut [u64],
    ) -> anyhow::Result<()> {
        if places.is_empty() {
            return Ok(());
        }
        let mut traced = Traced::open(self.job.folder.pieces(tile))?;
        let (rows, mut vertices) = (traced.rows()?, None);
        let ranks = read_words(&self.job.folder.ranks(tile))?;
        let closed = rows.iter().zip(ranks).filter(|(row, _)| row.closed);
        let ranks: Vec<u64> = closed.map(|(_, rank)| rank).collect();
        let outer = Outer {
            nesting: known,
            ranks: &ranks,
        };
        let guests = self.rings.iter().filter(|&&(_, of)| of == tile);
        let guests: Vec<usize> = guests.map(|&(ring, _)| ring).collect();
        let mut places = places.to_vec();
        places.extend(guests.iter().map(|&ring| self.across.rows[ring].leftmost));
        let sides = |crossings: &mut Crossings| {
            let wanted = rows
                .iter()
                .map(|row| row.closed && crossings.may_have(row.area));
            let wanted: Vec<bool> = wanted.collect();
            // Most rings have none in their boxes.
            if wanted.contains(&true) {
                let vertices = match &mut vertices {
                    Some(vertices) => vertices,
                    none => none.insert(traced.whole_vertices()?),
                };
                pass_rings(crossings, &rows, &wanted, vertices);
            }
            anyhow::Ok(())
        };
        surrounding(&places, self.most, sides, |at, around| {
            if let Some(value) = values.get_mut(at) {
                change(value, known[at], around, outer);
            } else if let Some(&ring) = guests.get(at - values.len()) {
                change(&mut of_across[ring], self.nesting[ring], around, outer);
            }
        })
    }

    /// All sides of the rings across tiles.
    fn sides_across(&self, crossings: &mut Crossings) -> anyhow::Result<()> {
        for &(ring, side) in &self.across.borders {
            crossings.pass(ring, self.across.rows[ring].area, side);
        }
        for tile in 0..self.job.tiles() {
            let pieces = self.across.of_tile(tile);
            let wanted = pieces.iter().map(|&(ring, _)| {
                let row = &self.across.rows[ring];
                row.closed && crossings.may_have(row.area)
            });
            let wanted: Vec<bool> = wanted.collect();
            if !wanted.contains(&true) {
                continue;
            }
            let mut traced = Traced::open(self.job.folder.pieces(tile))?;
            let counts = traced.summaries()?.into_iter().map(|piece| piece.count);
            let counts: Vec<u64> = counts.collect();
            let vertices = traced.part_vertices()?;
            let parts = parts(&vertices, counts).zip(pieces).zip(wanted);
            for ((part, &(ring, _)), _) in parts.filter(|(_, is_wanted)| *is_wanted) {
                let area = self.across.rows[ring].area;
                for pair in part.windows(2) {
                    crossings.pass(ring, area, [pair[0].point, pair[1].point]);
                }
            }
        }
        Ok(())
    }
}

/// Gives the sides of the wanted ones among the curves of a tile.
fn pass_rings(crossings: &mut Crossings, rows: &[Row], wanted: &[bool], vertices: &[Sample]) {
    let counts = rows.iter().map(|row| row.count);
    let mut ring = 0;
    for ((row, part), is_wanted) in rows.iter().zip(parts(vertices, counts)).zip(wanted) {
        if *is_wanted {
            let next = part.iter().cycle().skip(1);
            for (a, b) in part.iter().zip(next) {
                crossings.pass(ring, row.area, [a.point, b.point]);
            }
        }
        ring += usize::from(row.closed);
    }
}

/// Samples in parts of so many, one after the other.
fn parts(
    samples: &[Sample],
    counts: impl IntoIterator<Item = u64>,
) -> impl Iterator<Item = &[Sample]> {
    let mut rest = samples;
    counts.into_iter().map(move |count| {
        let count = usize::try_from(count).unwrap_or(0).min(rest.len());
        let part;
        (part, rest) = rest.split_at(count);
        part
    })
}

impl Batch {
    /// The positions of the rings of a list.
    fn of(&self, list: usize) -> Range<usize> {
        let at = list - self.lists.start;
        self.starts[at]..self.starts[at + 1]
    }
}
