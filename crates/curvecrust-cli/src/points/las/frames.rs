//! What the process that unpacks says: frames of a tag, the length of what follows, and this. All
//! numbers are little-endian.

use super::{Part, place};
use crate::points::{Flaw, Place, Problem, System};
use std::io::{BufReader, Read};

/// Read from the pipe at once.
const BUFFER: usize = 1 << 16;

const POINTS: u8 = b'p';
const CODE: u8 = b'c';
const TEXT: u8 = b't';
const FLAW: u8 = b'f';
const END: u8 = b'e';

/// One message of the process.
pub(super) enum Frame<'a> {
    /// A part of what is in the file.
    Part(Part<'a>),
    /// Why there is no more.
    Flaw(Flaw),
    /// This was all.
    End,
}

/// Makes a frame the content of a buffer.
pub(super) fn encode(frame: &Frame<'_>, bytes: &mut Vec<u8>) {
    bytes.clear();
    bytes.extend([0; 5]);
    let tag = match frame {
        Frame::Part(Part::Points(points)) => {
            bytes.extend(points.as_flattened().iter().flat_map(|n| n.to_le_bytes()));
            POINTS
        }
        Frame::Part(Part::System(system)) => match (system.text(), system.epsg()) {
            (Some(text), _) => {
                bytes.extend(text.bytes());
                TEXT
            }
            (None, code) => {
                bytes.extend(code.unwrap_or_default().to_le_bytes());
                CODE
            }
        },
        Frame::Flaw(flaw) => {
            let number = match flaw.place {
                Place::Item(_, number) => number,
                _ => 0,
            };
            bytes.extend(number.to_le_bytes());
            bytes.extend(flaw.problem.to_string().bytes());
            FLAW
        }
        Frame::End => END,
    };
    bytes[0] = tag;
    // Points of one piece, or a text: far fewer bytes.
    let length = u32::try_from(bytes.len() - 5).unwrap_or(u32::MAX);
    bytes[1..5].copy_from_slice(&length.to_le_bytes());
}

/// The frames that come out of a pipe.
pub(super) struct Frames<R> {
    pipe: BufReader<R>,
    bytes: Vec<u8>,
    points: Vec<[f64; 3]>,
}

impl<R: Read> Frames<R> {
    pub(super) fn new(pipe: R) -> Self {
        Self {
            pipe: BufReader::with_capacity(BUFFER, pipe),
            bytes: Vec::new(),
            points: Vec::new(),
        }
    }

    /// The next one; `None` if there is none, or none that is whole.
    pub(super) fn next(&mut self) -> Option<Frame<'_>> {
        let mut head = [0; 5];
        self.pipe.read_exact(&mut head).ok()?;
        let [tag, length @ ..] = head;
        let length = u32::from_le_bytes(length).into();
        self.bytes.clear();
        let mut content = self.pipe.by_ref().take(length);
        let read = content.read_to_end(&mut self.bytes).ok()?;
        if read as u64 != length {
            return None;
        }
        Some(match tag {
            POINTS => {
                self.points.clear();
                self.points.extend(self.bytes.chunks_exact(24).map(point));
                Frame::Part(Part::Points(&self.points))
            }
            CODE => {
                let code = u32::from_le_bytes(*self.bytes.first_chunk()?);
                Frame::Part(Part::System(System::of_epsg(code)))
            }
            TEXT => {
                let text = String::from_utf8_lossy(&self.bytes);
                Frame::Part(Part::System(System::of_wkt(&text)?))
            }
            FLAW => {
                let (number, text) = self.bytes.split_first_chunk()?;
                let problem = Problem::Said(String::from_utf8_lossy(text).into_owned());
                Frame::Flaw(problem.at(match u64::from_le_bytes(*number) {
                    0 => Place::File,
                    number => place(number),
                }))
            }
            END => Frame::End,
            _ => return None,
        })
    }
}

/// A point of its 24 bytes.
fn point(bytes: &[u8]) -> [f64; 3] {
    let (numbers, _) = bytes.as_chunks();
    let mut numbers = numbers.iter().map(|bytes| f64::from_le_bytes(*bytes));
    [(); 3].map(|()| numbers.next().unwrap_or_default())
}

#[cfg(test)]
#[allow(clippy::unwrap_used, clippy::panic, reason = "a test")]
mod tests {
    use super::*;

    /// The frames that were written, one after another, and how they are read again.
    fn again(frames: &[Frame<'_>], cut: usize) -> Vec<String> {
        let (mut all, mut one) = (Vec::new(), Vec::new());
        for frame in frames {
            encode(frame, &mut one);
            all.extend(&one);
        }
        all.truncate(all.len() - cut);
        let mut read = Frames::new(&all[..]);
        let mut found = Vec::new();
        while let Some(frame) = read.next() {
            found.push(match frame {
                Frame::Part(Part::Points(points)) => format!("{points:?}"),
                Frame::Part(Part::System(system)) => format!("{system:?}"),
                Frame::Flaw(flaw) => format!("{}: {}", flaw.place, flaw.problem),
                Frame::End => "end".to_owned(),
            });
        }
        found
    }

    #[test]
    fn frames_are_read_as_they_were_written() {
        let points = [[1.0, -0.0, f64::NAN], [f64::MAX, 5e-324, 0.1]];
        let text = "PROJCS[\"a \u{e4}\",AUTHORITY[\"EPSG\",\"1\"]]";
        let of_text = System::of_wkt(text).unwrap();
        let frames = || {
            [
                Frame::Part(Part::System(System::of_epsg(4326))),
                Frame::Part(Part::System(of_text.clone())),
                Frame::Part(Part::Points(&points)),
                Frame::Part(Part::Points(&[])),
                Frame::Flaw(Problem::NoPoints.into()),
                Frame::Flaw(Problem::Promise { points: 7 }.at(place(3))),
                Frame::End,
            ]
        };
        let expected = [
            format!("{:?}", System::of_epsg(4326)),
            format!("{of_text:?}"),
            format!("{points:?}"),
            "[]".to_owned(),
            ": there are no points".to_owned(),
            format!(", point 3: {}", Problem::Promise { points: 7 }),
            "end".to_owned(),
        ];
        assert_eq!(again(&frames(), 0), expected);
        // A frame that is cut off is none.
        assert_eq!(again(&frames(), 1), expected[..6]);
        assert_eq!(again(&frames()[..6], 1), expected[..5]);
    }
}
