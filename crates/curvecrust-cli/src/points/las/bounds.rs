//! Whether a LAS file can hold what its header promises: nothing is reserved for what is not there.

use super::packed::{self, Points};
use super::{Flaw, Problem};
use crate::input::Seekable;
use crate::points::unpacked;
use std::io::{BufReader, Read, Seek, SeekFrom};

/// Bytes of the header of a record.
const RECORD: usize = 54;

/// Bytes of the header of an extended record.
const EXTENDED: u64 = 60;

/// What the header promises, and the file can hold.
pub(super) struct Promise {
    pub(super) points: u64,
    /// Bytes of a point that is not packed.
    pub(super) record: u64,
}

/// The bits of the format of points, in byte 104, that packed ones have.
pub(super) const PACKED: u64 = 0xc0;

/// The fields of a header, at the places where they are in all versions that have them.
/// <https://www.asprs.org/wp-content/uploads/2019/07/LAS_1_4_r15.pdf>
struct Fields {
    bytes: [u8; 375],
    length: usize,
}

impl Fields {
    fn number<const N: usize>(&self, at: usize) -> u64 {
        let mut number = [0; 8];
        let field = &self.bytes[..self.length];
        if let Some(bytes) = field.get(at..at + N) {
            number[..N].copy_from_slice(bytes);
        }
        u64::from_le_bytes(number)
    }
}

/// Settles that the file is long enough for what its header promises.
pub(super) fn check(source: &mut Seekable) -> Result<Promise, Flaw> {
    let size = source.size()?;
    let mut bytes = [0; 375];
    let mut length = 0;
    while length < bytes.len() {
        match source.read(&mut bytes[length..])? {
            0 => break,
            read => length += read,
        }
    }
    let fields = Fields { bytes, length };
    if !bytes.starts_with(b"LASF") {
        return Err(Problem::Las("it starts otherwise".into()).into());
    }
    let is_new = fields.number::<1>(25) >= 4;
    let (start, format) = (fields.number::<4>(96), fields.number::<1>(104));
    let (is_packed, record) = (format & PACKED != 0, fields.number::<2>(105));
    let points = match (fields.number::<4>(107), is_new) {
        (0, true) => fields.number::<8>(247),
        (points, _) => points,
    };
    let extended = fields.number::<8>(235);
    if is_new && fields.number::<4>(243) > 0 {
        let cut = || Problem::Las("it is cut off before its extended records".into());
        source.seek(SeekFrom::Start(extended.saturating_add(20)))?;
        let mut length = [0; 8];
        source.read_exact(&mut length).map_err(|_| cut())?;
        let end = extended.saturating_add(EXTENDED);
        if end.saturating_add(u64::from_le_bytes(length)) > size {
            return Err(cut().into());
        }
    }
    let room = match is_packed {
        true => unpacked::most(size),
        false => size.saturating_sub(start),
    };
    if points.checked_mul(record).is_none_or(|bytes| bytes > room) {
        let found = room / record.max(1);
        let problem = match is_packed {
            true => Problem::Promise { points },
            false => Problem::CutOff {
                what: "points",
                promised: points,
                found,
            },
        };
        return Err(problem.into());
    }
    if record == 0 && points > 0 {
        return Err(Problem::Las("its points have no bytes".into()).into());
    }
    if is_packed && points > 0 {
        let about = about(source, fields.number::<2>(94), fields.number::<4>(100))?;
        let points = Points {
            start,
            size,
            count: points,
            record,
        };
        packed::check(source, &points, &about)?;
    }
    Ok(Promise { points, record })
}

/// The record about how points are packed, of those that follow the header.
fn about(source: &mut Seekable, start: u64, count: u64) -> Result<Vec<u8>, Flaw> {
    let mut source = BufReader::new(source);
    source.seek(SeekFrom::Start(start))?;
    for _ in 0..count {
        let mut head = [0; RECORD];
        if source.read_exact(&mut head).is_err() {
            break;
        }
        let length = u16::from_le_bytes([head[20], head[21]]);
        if head[2..].starts_with(b"laszip encoded") && head[18..20] == 22204u16.to_le_bytes() {
            // Others would take one of these for it, and the next for it otherwise.
            if head[16..18] != [0; 2] {
                break;
            }
            let mut data = vec![0; length.into()];
            if source.read_exact(&mut data).is_ok() {
                return Ok(data);
            }
        }
        source.seek_relative(length.into())?;
    }
    Err(Problem::Las("it does not say how its points are packed".into()).into())
}
