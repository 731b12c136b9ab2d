//! Whether points in LAZ are packed as their header says: what the crate `laz` relies on, and would
//! reserve memory for or fail over, is settled here.
//!
//! Points are in chunks. Those of formats 6 to 10 are in layers, each of a size that stands in
//! front; how many points a chunk has stands in a table at the end, if not all have as many.

use super::{Flaw, Problem};
use crate::input::Seekable;
use laz::LazVlr;
use laz::laszip::{ChunkTable, LazItem, LazItemType};
use std::io::{self, BufReader, ErrorKind, Read, Seek, SeekFrom};

/// What is known of the points.
pub(super) struct Points {
    /// Where they start in the file, and how long that is.
    pub(super) start: u64,
    pub(super) size: u64,
    pub(super) count: u64,
    /// Bytes of a point that is not packed.
    pub(super) record: u64,
}

fn problem(what: &str) -> Problem {
    Problem::Las(what.to_owned())
}

/// Settles that the points are packed as the record about it says.
pub(super) fn check(source: &mut Seekable, points: &Points, about: &[u8]) -> Result<(), Flaw> {
    let how = LazVlr::read_from(about);
    let how = how.map_err(|error| Problem::Las(error.to_string()))?;
    let layers = match about {
        [1 | 2, 0, ..] => layers(how.items(), false, points.record)?,
        [3, 0, ..] => layers(how.items(), true, points.record)?,
        _ => return Err(problem("its points are packed in a way that is not known").into()),
    };
    // All points are in one chunk, which needs no table.
    if about.starts_with(&[1, 0]) {
        return Ok(());
    }
    let cut = |error: io::Error| match error.kind() {
        ErrorKind::UnexpectedEof => problem("it is cut off").into(),
        _ => Flaw::from(error),
    };
    let mut source = BufReader::new(source);
    let table = table(&mut source, points, &how).map_err(cut)?;
    let has_as_many = !how.uses_variable_size_chunks();
    if has_as_many && how.chunk_size() == 0 {
        return Err(problem("its chunks have no points").into());
    }
    if let Some(table) = table.as_ref().filter(|_| !has_as_many) {
        let counts = table.into_iter().map(|chunk| chunk.point_count);
        let sum = counts.clone().try_fold(0u64, u64::checked_add);
        if counts.clone().any(|count| count == 0) || sum.is_none_or(|sum| sum < points.count) {
            return Err(problem("its chunks have other points than its header").into());
        }
    }
    if let Some(layers) = layers {
        let counts = table.as_ref().filter(|_| !has_as_many);
        let mut counts = counts.into_iter().flatten().map(|chunk| chunk.point_count);
        let fixed = has_as_many.then(|| u64::from(how.chunk_size()));
        walk(&mut source, points, layers, || {
            fixed.or_else(|| counts.next())
        })
        .map_err(cut)?;
    }
    Ok(())
}

/// How many layers a chunk has; `None` if its points are in none. What the items of a point are has
/// to agree with each other.
fn layers(items: &[LazItem], is_layered: bool, record: u64) -> Result<Option<usize>, Problem> {
    let size: u64 = items.iter().map(|item| u64::from(item.size())).sum();
    let mut layers = 0;
    for (index, item) in items.iter().enumerate() {
        let (of_layers, size, count) = match item.item_type() {
            LazItemType::Byte(size) => (false, size, 0),
            LazItemType::Point10 => (false, 20, 0),
            LazItemType::GpsTime => (false, 8, 0),
            LazItemType::RGB12 => (false, 6, 0),
            LazItemType::WavePacket13 => (false, 29, 0),
            LazItemType::Point14 => (true, 30, 9),
            LazItemType::RGB14 => (true, 6, 1),
            LazItemType::RGBNIR14 => (true, 8, 2),
            LazItemType::WavePacket14 => (true, 29, 1),
            LazItemType::Byte14(size) => (true, size, usize::from(size)),
        };
        let is_point = matches!(
            item.item_type(),
            LazItemType::Point10 | LazItemType::Point14
        );
        if of_layers != is_layered || size != item.size() || is_point != (index == 0) {
            return Err(problem("its points are packed otherwise than it says"));
        }
        layers += count;
    }
    if items.is_empty() || size != record {
        return Err(problem("its points are packed otherwise than it says"));
    }
    Ok(is_layered.then_some(layers))
}

/// The table of the chunks, if there is one that can be read.
fn table(
    source: &mut BufReader<&mut Seekable>,
    points: &Points,
    how: &LazVlr,
) -> io::Result<Option<ChunkTable>> {
    let mut number = [0; 8];
    source.seek(SeekFrom::Start(points.start))?;
    source.read_exact(&mut number)?;
    let is_there =
        |number| i64::from_le_bytes(number) > points.start.try_into().unwrap_or(i64::MAX);
    if !is_there(number) {
        source.seek(SeekFrom::End(-8))?;
        source.read_exact(&mut number)?;
        if !is_there(number) {
            return Ok(None);
        }
    }
    // A version, and the number of chunks, of which each has a byte at least.
    source.seek(SeekFrom::Start(u64::from_le_bytes(number)))?;
    let read = source.read_exact(&mut number);
    let [_, _, _, _, a, b, c, d] = number;
    if read.is_ok() && u64::from(u32::from_le_bytes([a, b, c, d])) > points.size {
        return Err(ErrorKind::UnexpectedEof.into());
    }
    source.seek(SeekFrom::Start(points.start))?;
    Ok(ChunkTable::read_from(source, how).ok())
}

/// Settles that every chunk is as long as its layers; `count` has the points of the next chunk, if
/// that is known.
fn walk(
    source: &mut BufReader<&mut Seekable>,
    points: &Points,
    layers: usize,
    mut count: impl FnMut() -> Option<u64>,
) -> io::Result<()> {
    let mut at = points.start + 8;
    let mut left = points.count;
    let mut sizes = vec![0; 4 * (layers + 1)];
    while left > 0 {
        // A point that is not packed, the number of points, and the sizes of the layers.
        source.seek(SeekFrom::Start(at + points.record))?;
        source.read_exact(&mut sizes)?;
        let mut numbers = sizes.chunks_exact(4).map(|bytes| match *bytes {
            [a, b, c, d] => u64::from(u32::from_le_bytes([a, b, c, d])),
            _ => 0,
        });
        let points_here = numbers.next().unwrap_or_default();
        let length: u64 = numbers.sum();
        at += points.record + sizes.len() as u64 + length;
        let points_here = count().unwrap_or(points_here);
        if at > points.size || points_here == 0 {
            return Err(ErrorKind::UnexpectedEof.into());
        }
        left = left.saturating_sub(points_here);
    }
    Ok(())
}
