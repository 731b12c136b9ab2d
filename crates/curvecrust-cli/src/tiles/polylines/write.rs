//! The arrays that the user gets: of each tile its pieces and their points, and all curves.

use super::link::Across;
use super::number::read_words;
use super::place::Folder;
use super::row::{NESTED_BYTES, Nested, Row, id};
use super::trace::Traced;
use super::{Progress, Solved};
use crate::output::npy;
use crate::tiles::merge::Merge;
use crate::tiles::records::{self, NONE, Record};
use curvecrust::tiles::{PieceSummary, Sample};
use std::fs;
use std::io::{self, Write};

/// The fields of a piece, each a 64 bit unsigned integer.
const PIECE: &str = "[('curve', '<u8'), ('start', '<u8'), ('offset', '<u8'), ('count', '<u8'), \
                     ('after', '<u8')]";

/// The fields of a curve.
const CURVE: &str = "[('first', '<u8'), ('count', '<u8'), ('length', '<f8'), ('area', '<f8'), \
                     ('low', '<f8', (2,)), ('high', '<f8', (2,)), ('parent', '<i8'), \
                     ('nesting', '<i4'), ('closed', '|b1')]";

/// Consecutive points of a curve.
struct Piece {
    /// The number of the curve, and the position of the first point on it.
    curve: u64,
    start: u64,
    /// Where the points are among those of the tile, and in which order.
    first: usize,
    count: usize,
    reversed: bool,
    /// The point that follows; the last one itself where the curve ends.
    after: u64,
}

/// Writes the pieces and points of all tiles.
pub(super) fn tiles(
    job: &Solved<'_>,
    across: &Across,
    folder: &Folder,
    progress: Progress<'_>,
) -> anyhow::Result<()> {
    let across_ranks = read_words(&job.folder.ranks(job.tiles()))?;
    for tile in 0..job.tiles() {
        progress(tile, job.tiles());
        let mut traced = Traced::open(job.folder.pieces(tile))?;
        let rows = traced.rows()?;
        let ranks = read_words(&job.folder.ranks(tile))?;
        let mut vertices = traced.whole_vertices()?;
        let mut pieces = Vec::with_capacity(rows.len());
        whole_pieces(&rows, &ranks, &vertices, &mut pieces);
        let first_part = vertices.len();
        let summaries = traced.summaries()?;
        vertices.extend(traced.part_vertices()?);
        let mut first = first_part;
        for (&(curve, place), summary) in across.of_tile(tile).iter().zip(&summaries) {
            let count = usize::try_from(summary.count)?;
            let piece = Piece {
                curve: across_ranks.get(curve).copied().unwrap_or(NONE),
                start: place.start,
                first,
                count,
                reversed: place.reversed,
                after: after(summary, place.reversed),
            };
            first += count;
            let turn = across.rows[curve].count;
            pieces.extend(cut(piece, turn, &vertices));
        }
        pieces.sort_unstable_by_key(|piece| (piece.curve, piece.start));
        write_tile(job, folder, tile, &pieces, &vertices)?;
    }
    Ok(())
}

/// The pieces that are whole curves.
fn whole_pieces(rows: &[Row], ranks: &[u64], vertices: &[Sample], pieces: &mut Vec<Piece>) {
    let mut first = 0;
    for (row, &curve) in rows.iter().zip(ranks) {
        let count = usize::try_from(row.count).unwrap_or(0);
        let after = if row.closed { first } else { first + count - 1 };
        pieces.push(Piece {
            curve,
            start: 0,
            first,
            count,
            reversed: false,
            after: vertices.get(after).map_or(NONE, |sample| sample.id),
        });
        first += count;
    }
}

/// The point behind a piece of a curve across tiles.
fn after(summary: &PieceSummary, reversed: bool) -> u64 {
    let side = usize::from(!reversed);
    summary.links[side].unwrap_or(summary.ends[side])
}

/// A piece as it is, or in two where a ring starts anew in its middle.
fn cut(piece: Piece, turn: u64, vertices: &[Sample]) -> impl Iterator<Item = Piece> {
    let before = usize::try_from(turn - piece.start).unwrap_or(usize::MAX);
    if before >= piece.count {
        return [Some(piece), None].into_iter().flatten();
    }
    let rest = piece.count - before;
    let middle = if piece.reversed { rest - 1 } else { before };
    let head = Piece {
        first: piece.first + if piece.reversed { rest } else { 0 },
        count: before,
        after: vertices[piece.first + middle].id,
        ..piece
    };
    let tail = Piece {
        start: 0,
        first: piece.first + if piece.reversed { 0 } else { before },
        count: rest,
        ..piece
    };
    [Some(head), Some(tail)].into_iter().flatten()
}

fn write_tile(
    job: &Solved<'_>,
    folder: &Folder,
    tile: usize,
    pieces: &[Piece],
    vertices: &[Sample],
) -> anyhow::Result<()> {
    records::write(&folder.points(tile), |out| {
        npy::header(
            out,
            if job.is_wide { "'<u8'" } else { "'<u4'" },
            &format!("({},)", vertices.len()),
        )?;
        let bytes = if job.is_wide { 8 } else { 4 };
        for piece in pieces {
            let points = &vertices[piece.first..piece.first + piece.count];
            let mut write = |point: &Sample| out.write_all(&point.id.to_le_bytes()[..bytes]);
            if piece.reversed {
                points.iter().rev().try_for_each(&mut write)?;
            } else {
                points.iter().try_for_each(&mut write)?;
            }
        }
        out.flush()
    })?;
    records::write(&folder.pieces(tile), |out| {
        npy::header(out, PIECE, &format!("({},)", pieces.len()))?;
        let mut offset = 0;
        for piece in pieces {
            let count = piece.count as u64;
            let fields = [piece.curve, piece.start, offset, count, piece.after];
            records::put_words(out, &fields)?;
            offset += count;
        }
        out.flush()
    })
}

/// Writes the table of all curves; returns how many there are and how many are closed.
pub(super) fn table(job: &Solved<'_>, folder: &Folder) -> anyhow::Result<[u64; 2]> {
    let mut merge = Merge::new(NESTED_BYTES);
    for list in 0..=job.tiles() {
        let path = job.folder.curves(list);
        let bytes = fs::metadata(&path)?.len();
        merge.add(path, 0, bytes / NESTED_BYTES as u64);
    }
    let (count, mut closed) = (merge.count, 0);
    records::write(&folder.table(), |out| {
        npy::header(out, CURVE, &format!("({count},)"))?;
        merge.run(id, |_, _, bytes| {
            let (words, _) = bytes.as_chunks::<8>();
            let (records, _) = words.as_chunks::<14>();
            for record in records {
                let nested = Nested::of(record.map(u64::from_le_bytes));
                closed += u64::from(nested.row.closed);
                write_curve(out, &nested)?;
            }
            Ok(())
        })?;
        out.flush()
    })?;
    Ok([count, closed])
}

fn write_curve(out: &mut impl Write, nested: &Nested) -> io::Result<()> {
    let Nested {
        row,
        nesting,
        parent,
    } = nested;
    records::put_words(out, &[row.id.first, row.count])?;
    let area = row.area;
    let numbers = [
        row.length,
        row.inside,
        area.low.x,
        area.low.y,
        area.high.x,
        area.high.y,
    ];
    records::put_words(out, &numbers.map(f64::to_bits))?;
    // NONE is -1.
    let nesting = i32::try_from(nesting.cast_signed()).unwrap_or(i32::MAX);
    records::put_words(out, &[*parent])?;
    out.write_all(&nesting.to_le_bytes())?;
    out.write_all(&[u8::from(row.closed)])
}
