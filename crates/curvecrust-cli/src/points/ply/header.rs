//! The header of a PLY file: lines that name the encoding, the elements and their properties.

use super::{Flaw, Place, Problem, quoted};
use std::io::{BufRead, Read};

/// Bytes of a header.
const LONGEST: u64 = 1 << 16;

pub(super) struct Header {
    pub(super) encoding: Encoding,
    pub(super) elements: Vec<Element>,
    /// The lines of the header.
    pub(super) lines: u64,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Encoding {
    Text,
    Bytes { big_endian: bool },
}

/// So many things of one kind, such as vertices.
pub(super) struct Element {
    pub(super) name: String,
    pub(super) count: u64,
    pub(super) properties: Vec<Property>,
}

pub(super) struct Property {
    pub(super) name: String,
    pub(super) kind: Kind,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    Scalar(Type),
    List { length: Type, of: Type },
}

/// The type of a number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Type {
    I8,
    U8,
    I16,
    U16,
    I32,
    U32,
    F32,
    F64,
}

impl Property {
    pub(super) fn is_scalar(&self) -> bool {
        matches!(self.kind, Kind::Scalar(_))
    }
}

impl Type {
    fn of_name(name: &str) -> Option<Self> {
        Some(match name {
            "char" | "int8" => Self::I8,
            "uchar" | "uint8" => Self::U8,
            "short" | "int16" => Self::I16,
            "ushort" | "uint16" => Self::U16,
            "int" | "int32" => Self::I32,
            "uint" | "uint32" => Self::U32,
            "float" | "float32" => Self::F32,
            "double" | "float64" => Self::F64,
            _ => return None,
        })
    }

    /// Its bytes.
    pub(super) fn size(self) -> usize {
        match self {
            Self::I8 | Self::U8 => 1,
            Self::I16 | Self::U16 => 2,
            Self::I32 | Self::U32 | Self::F32 => 4,
            Self::F64 => 8,
        }
    }

    /// The number of as many bytes, the least significant first.
    pub(super) fn value(self, bytes: &[u8]) -> f64 {
        match (self, bytes) {
            (Self::I8, &[a]) => i8::from_le_bytes([a]).into(),
            (Self::U8, &[a]) => a.into(),
            (Self::I16, &[a, b]) => i16::from_le_bytes([a, b]).into(),
            (Self::U16, &[a, b]) => u16::from_le_bytes([a, b]).into(),
            (Self::I32, &[a, b, c, d]) => i32::from_le_bytes([a, b, c, d]).into(),
            (Self::U32, &[a, b, c, d]) => u32::from_le_bytes([a, b, c, d]).into(),
            (Self::F32, &[a, b, c, d]) => f32::from_le_bytes([a, b, c, d]).into(),
            (Self::F64, &[a, b, c, d, e, f, g, h]) => f64::from_le_bytes([a, b, c, d, e, f, g, h]),
            _ => f64::NAN,
        }
    }
}

impl Type {
    /// The same of a whole number that counts something.
    pub(super) fn count(self, bytes: &[u8]) -> u64 {
        match (self, bytes) {
            (Self::U8, &[a]) => a.into(),
            (Self::U16, &[a, b]) => u16::from_le_bytes([a, b]).into(),
            (Self::U32, &[a, b, c, d]) => u32::from_le_bytes([a, b, c, d]).into(),
            (Self::I8, &[a]) => u64::try_from(i8::from_le_bytes([a])).unwrap_or(0),
            (Self::I16, &[a, b]) => u64::try_from(i16::from_le_bytes([a, b])).unwrap_or(0),
            (Self::I32, &[a, b, c, d]) => {
                u64::try_from(i32::from_le_bytes([a, b, c, d])).unwrap_or(0)
            }
            _ => 0,
        }
    }
}

/// Reads the lines up to `end_header`, and no byte of what follows.
pub(super) fn read(input: &mut impl BufRead) -> Result<Header, Flaw> {
    let mut encoding = None;
    let mut elements: Vec<Element> = Vec::new();
    let mut left = LONGEST;
    for line in 1.. {
        let mut text = Vec::new();
        let read = input.by_ref().take(left).read_until(b'\n', &mut text)?;
        left -= read as u64;
        if text.last() != Some(&b'\n') {
            return Err(Problem::Ply("its header does not end".into()).into());
        }
        let unknown = || {
            let found = quoted(text.trim_ascii());
            Problem::Ply(format!("`{found}` is no line of a header")).at(Place::Line(line))
        };
        let words = str::from_utf8(&text).map_err(|_| unknown())?;
        let words: Vec<&str> = words.split_ascii_whitespace().collect();
        match words[..] {
            ["ply"] if line == 1 => {}
            _ if line == 1 => return Err(Problem::Ply("it starts otherwise".into()).into()),
            [] | ["comment" | "obj_info", ..] => {}
            ["format", name, _] => encoding = Some(encoding_of(name).ok_or_else(unknown)?),
            ["element", name, count] => elements.push(Element {
                name: name.to_owned(),
                count: count.parse().map_err(|_| unknown())?,
                properties: Vec::new(),
            }),
            ["property", ref property @ ..] => {
                let element = elements.last_mut().ok_or_else(unknown)?;
                element
                    .properties
                    .push(property_of(property).ok_or_else(unknown)?);
            }
            ["end_header"] => {
                let encoding = encoding.ok_or_else(|| Problem::Ply("it has no format".into()))?;
                // Without properties, any number of them would take no byte.
                elements.retain(|element| !element.properties.is_empty());
                return Ok(Header {
                    encoding,
                    elements,
                    lines: line,
                });
            }
            _ => return Err(unknown()),
        }
    }
    Err(Problem::Ply("its header does not end".into()).into())
}

fn encoding_of(name: &str) -> Option<Encoding> {
    match name {
        "ascii" => Some(Encoding::Text),
        "binary_little_endian" => Some(Encoding::Bytes { big_endian: false }),
        "binary_big_endian" => Some(Encoding::Bytes { big_endian: true }),
        _ => None,
    }
}

fn property_of(words: &[&str]) -> Option<Property> {
    let (kind, name) = match *words {
        ["list", length, of, name] => {
            let length = Type::of_name(length).filter(|of| !matches!(of, Type::F32 | Type::F64));
            let (length, of) = (length?, Type::of_name(of)?);
            (Kind::List { length, of }, name)
        }
        [of, name] => (Kind::Scalar(Type::of_name(of)?), name),
        _ => return None,
    };
    let name = name.to_owned();
    Some(Property { name, kind })
}
