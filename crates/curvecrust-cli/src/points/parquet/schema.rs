//! The columns of a Parquet file, which lie in each other. The crate calls itself for each level,
//! so that too many would fill the stack; here they are counted first.
//!
//! Of fields that the crate does not know it passes as many things as a list promises, and truth
//! values take it no byte: few bytes could keep it busy for hours. So no list may have more things
//! than bytes are left.
//!
//! The metadata are Thrift in its compact form:
//! <https://github.com/apache/thrift/blob/master/doc/specs/thrift-compact-protocol.md>

use super::chunks::Chunks;
use crate::points::Problem;
use parquet::file::metadata::ParquetMetaDataReader;
use parquet::file::reader::{ChunkReader, Length};
use parquet::schema::types::SchemaDescPtr;

/// Columns in each other that are read.
const DEEPEST: usize = 64;

/// Kinds of fields.
const INTEGER: u8 = 5;
const TEXT: u8 = 8;
const LIST: u8 = 9;
const STRUCT: u8 = 12;

/// The columns; `None` where they cannot be read and are not damaged, which the crate says better.
pub(super) fn of(chunks: &Chunks) -> Result<Option<SchemaDescPtr>, Problem> {
    let Some(metadata) = metadata(chunks) else {
        return Ok(None);
    };
    if Thrift(&metadata).skip(STRUCT, DEEPEST).is_none() {
        return Err(Problem::Parquet("its metadata are damaged".into()));
    }
    if Thrift(&metadata)
        .depth()
        .is_some_and(|depth| depth > DEEPEST)
    {
        let says = format!("its columns are more than {DEEPEST} levels deep");
        return Err(Problem::Parquet(says));
    }
    Ok(ParquetMetaDataReader::decode_schema(&metadata).ok())
}

/// The bytes of the metadata, of which the last but four tell the length.
fn metadata(chunks: &Chunks) -> Option<impl AsRef<[u8]> + std::ops::Deref<Target = [u8]>> {
    let end = chunks.len().checked_sub(8)?;
    let tail = chunks.get_bytes(end, 8).ok()?;
    let (length, _) = tail.split_first_chunk()?;
    let length = u32::from_le_bytes(*length);
    let start = end.checked_sub(length.into())?;
    chunks.get_bytes(start, length as usize).ok()
}

/// What is left of the metadata. All that is read of it is `None` where it is damaged.
struct Thrift<'a>(&'a [u8]);

impl Thrift<'_> {
    /// How deep the columns lie in each other, as far as they can be read.
    fn depth(&mut self) -> Option<usize> {
        let mut id = 0;
        loop {
            let kind;
            (kind, id) = self.field(id)?;
            if id == 2 {
                return self.depth_of_list();
            }
            self.skip(kind, DEEPEST)?;
        }
    }

    /// That of the list of columns: each says how many of those behind it lie in it.
    fn depth_of_list(&mut self) -> Option<usize> {
        let (_, count) = self.list()?;
        // The columns that are still to come at each level.
        let mut open: Vec<u64> = Vec::new();
        let mut deepest = 0;
        for _ in 0..count {
            // The crate meets the damage too, and the columns before it have been counted.
            let Some(children) = self.column() else {
                break;
            };
            while open.last() == Some(&0) {
                open.pop();
            }
            if let Some(left) = open.last_mut() {
                *left -= 1;
            }
            if children > 0 {
                open.push(children);
                deepest = deepest.max(open.len());
            }
            if deepest > DEEPEST {
                break;
            }
        }
        Some(deepest)
    }

    /// The number of columns in the next one.
    fn column(&mut self) -> Option<u64> {
        let (mut id, mut children) = (0, 0);
        loop {
            let kind;
            (kind, id) = self.field(id)?;
            match (kind, id) {
                (0, _) => return Some(children),
                // Of numbers below zero, the odd ones, there are none.
                (INTEGER, 5) => children = self.number()? / 2,
                (INTEGER, 1..=9) | (TEXT, 4) | (STRUCT, 10) | (_, 11..) => {
                    self.skip(kind, DEEPEST)?;
                }
                _ => return None,
            }
        }
    }

    fn byte(&mut self) -> Option<u8> {
        let (&byte, rest) = self.0.split_first()?;
        self.0 = rest;
        Some(byte)
    }

    fn number(&mut self) -> Option<u64> {
        let mut value = 0;
        for shift in (0..64).step_by(7) {
            let byte = self.byte()?;
            value |= u64::from(byte & 0x7f) << shift;
            if byte & 0x80 == 0 {
                return Some(value);
            }
        }
        None
    }

    /// The kind and the number of the next field of a struct, from the number of the one before;
    /// the kind 0 ends it.
    fn field(&mut self, before: u64) -> Option<(u8, u64)> {
        let head = self.byte()?;
        let number = match (head & 15, head >> 4) {
            (0, _) => 0,
            (_, 0) => self.number()? / 2,
            (_, step) => before + u64::from(step),
        };
        Some((head & 15, number))
    }

    /// The kind of the things in a list, and how many they are.
    fn list(&mut self) -> Option<(u8, u64)> {
        let head = self.byte()?;
        let count = match head >> 4 {
            15 => self.number()?,
            count => count.into(),
        };
        Some((head & 15, count))
    }

    /// Goes behind a value.
    fn skip(&mut self, kind: u8, levels: usize) -> Option<()> {
        let levels = levels.checked_sub(1)?;
        match kind {
            1 | 2 => {}
            3 => self.pass(1)?,
            4..=6 => {
                self.number()?;
            }
            7 => self.pass(8)?,
            TEXT => {
                let length = self.number()?;
                self.pass(length)?;
            }
            LIST | 10 => {
                let (kind, count) = self.list()?;
                if count > self.0.len() as u64 {
                    return None;
                }
                for _ in 0..count {
                    self.skip(kind, levels)?;
                }
            }
            STRUCT => loop {
                match self.field(0)? {
                    (0, _) => break,
                    (kind, _) => self.skip(kind, levels)?,
                }
            },
            // Maps, which metadata have none of.
            _ => return None,
        }
        Some(())
    }

    fn pass(&mut self, count: u64) -> Option<()> {
        self.0 = self.0.get(usize::try_from(count).ok()?..)?;
        Some(())
    }
}
