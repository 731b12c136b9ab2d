//! A message between the page and the engine: a header in JSON, then numbers.
//!
//! The layout is four bytes with the length of the header, the header, and as many eight-byte
//! floats as follow, all little-endian. Points and edges travel as floats: a hundred thousand
//! points in JSON would take longer to read than to join.

use crate::error::Error;
use curvecrust::DVec2;
use serde_json::{Map, Value, json};

/// A header and numbers that were received.
#[derive(Debug)]
pub struct Received<'a> {
    /// The header, JSON.
    pub header: &'a [u8],
    numbers: &'a [u8],
}

impl<'a> Received<'a> {
    /// Takes a message apart.
    ///
    /// # Errors
    /// [`Error::Message`] if its parts do not have the lengths that it says.
    pub fn parse(bytes: &'a [u8]) -> Result<Self, Error> {
        let (length, rest) = bytes.split_first_chunk().ok_or(Error::Message)?;
        let length = u32::from_le_bytes(*length) as usize;
        let (header, numbers) = rest.split_at_checked(length).ok_or(Error::Message)?;
        Ok(Self { header, numbers })
    }

    /// The numbers, taken for points: x before y.
    #[must_use]
    pub fn points(&self) -> Vec<DVec2> {
        let pairs = self.numbers.chunks_exact(16);
        pairs
            .map(|pair| DVec2::new(float(pair), float(&pair[8..])))
            .collect()
    }

    /// The numbers.
    #[must_use]
    pub fn numbers(&self) -> Vec<f64> {
        self.numbers.chunks_exact(8).map(float).collect()
    }
}

fn float(bytes: &[u8]) -> f64 {
    bytes
        .first_chunk()
        .map_or(f64::NAN, |bytes| f64::from_le_bytes(*bytes))
}

/// An answer while it is put together: values of a header, and arrays that it names.
#[derive(Debug, Default)]
pub(crate) struct Answer {
    header: Map<String, Value>,
    arrays: Map<String, Value>,
    numbers: Vec<f64>,
}

impl Answer {
    /// Puts a value into the header.
    pub(crate) fn value(&mut self, name: &str, value: impl Into<Value>) {
        self.header.insert(name.to_owned(), value.into());
    }

    /// Adds an array of numbers.
    pub(crate) fn array(&mut self, name: &str, numbers: impl IntoIterator<Item = f64>) {
        let start = self.numbers.len();
        self.numbers.extend(numbers);
        let range = json!([start, self.numbers.len()]);
        self.arrays.insert(name.to_owned(), range);
    }

    /// Adds an array of points, x before y.
    pub(crate) fn points(&mut self, name: &str, points: impl IntoIterator<Item = DVec2>) {
        self.array(name, points.into_iter().flat_map(|p| p.to_array()));
    }

    /// Adds an array of pairs of indices, one after another.
    pub(crate) fn pairs(&mut self, name: &str, pairs: impl IntoIterator<Item = [usize; 2]>) {
        let pairs = pairs.into_iter();
        let pairs: Vec<[f64; 2]> = pairs.map(|[p, q]| [exact(p), exact(q)]).collect();
        self.array(name, pairs.as_flattened().iter().copied());
    }

    /// Adds an array of indices.
    pub(crate) fn indices(&mut self, name: &str, indices: impl IntoIterator<Item = usize>) {
        self.array(name, indices.into_iter().map(exact));
    }

    /// The bytes of the message.
    pub(crate) fn into_bytes(mut self) -> Vec<u8> {
        self.header
            .insert("arrays".to_owned(), Value::Object(self.arrays));
        bytes(&Value::Object(self.header), &self.numbers)
    }
}

/// An index as a float: indices are below 2^32, which floats hold exactly.
fn exact(index: usize) -> f64 {
    u32::try_from(index).map_or(f64::NAN, f64::from)
}

/// A message with a header and numbers, as bytes.
#[must_use]
pub fn bytes(header: &Value, numbers: &[f64]) -> Vec<u8> {
    let header = header.to_string();
    let length = u32::try_from(header.len()).unwrap_or(u32::MAX);
    let mut bytes = Vec::with_capacity(4 + header.len() + 8 * numbers.len());
    bytes.extend(length.to_le_bytes());
    bytes.extend(header.as_bytes());
    // Copied in one piece: to push byte after byte takes a tenth of a whole reconstruction.
    let numbers: Vec<[u8; 8]> = numbers.iter().map(|number| number.to_le_bytes()).collect();
    bytes.extend_from_slice(numbers.as_flattened());
    bytes
}

/// A message with an error alone.
pub(crate) fn of_error(error: &Error) -> Vec<u8> {
    bytes(&json!({ "error": error.to_string() }), &[])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_message_comes_back_as_it_was() {
        let sent = bytes(
            &json!({"reconstruct": {}}),
            &[1.0, 2.0, f64::INFINITY, -4.5],
        );
        let received = Received::parse(&sent).unwrap();
        assert_eq!(received.header, br#"{"reconstruct":{}}"#);
        assert_eq!(
            received.points(),
            [DVec2::new(1.0, 2.0), DVec2::new(f64::INFINITY, -4.5)]
        );
    }

    #[test]
    fn what_is_no_message_is_an_error() {
        for bytes in [&b""[..], b"\x01", b"\xff\xff\xff\xff{}", b"\x03\0\0\0{}"] {
            assert!(Received::parse(bytes).is_err(), "{bytes:?}");
        }
    }
}
