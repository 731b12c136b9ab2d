//! What is stored of a curve.

use crate::tiles::records::Record;
use curvecrust::DVec2;
use curvecrust::tiles::{Area, Curve, CurveId};

/// A whole curve. Rings run counter-clockwise.
#[derive(Clone, Copy, Debug)]
pub(super) struct Row {
    pub(super) id: CurveId,
    pub(super) closed: bool,
    pub(super) count: u64,
    pub(super) length: f64,
    /// The area inside a ring; 0 for an open curve.
    pub(super) inside: f64,
    pub(super) area: Area,
    pub(super) leftmost: DVec2,
}

/// A curve and where it lies in others.
#[derive(Clone, Copy, Debug)]
pub(super) struct Nested {
    pub(super) row: Row,
    /// How many rings lie around a ring; `records::NONE` for an open curve.
    pub(super) nesting: u64,
    /// The number of the ring right around it; `records::NONE` if there is none.
    pub(super) parent: u64,
}

/// The bytes of a [`Row`], and of a [`Nested`] one.
pub(super) const ROW_BYTES: usize = 8 * 12;
pub(super) const NESTED_BYTES: usize = 8 * 14;

/// The name of the curve that such bytes start with.
pub(super) fn id(bytes: &[u8]) -> (u64, u64) {
    let (words, _) = bytes.as_chunks::<8>();
    let word = |at: usize| words.get(at).map_or(0, |word| u64::from_le_bytes(*word));
    (word(0), word(1))
}

impl From<&Curve> for Row {
    fn from(curve: &Curve) -> Self {
        Self {
            id: curve.id,
            closed: curve.closed,
            count: curve.count,
            length: curve.length,
            inside: curve.signed_area.abs(),
            area: curve.area,
            leftmost: curve.leftmost,
        }
    }
}

impl Record<12> for Row {
    fn words(&self) -> [u64; 12] {
        let CurveId { first, second } = self.id;
        let [left, below, right, above] = self.area.words();
        let [length, inside, x, y] =
            [self.length, self.inside, self.leftmost.x, self.leftmost.y].map(f64::to_bits);
        let closed = u64::from(self.closed);
        [
            first, second, closed, self.count, length, inside, left, below, right, above, x, y,
        ]
    }

    fn of(words: [u64; 12]) -> Self {
        let [
            first,
            second,
            closed,
            count,
            length,
            inside,
            left,
            below,
            right,
            above,
            x,
            y,
        ] = words;
        Self {
            id: CurveId { first, second },
            closed: closed != 0,
            count,
            length: f64::from_bits(length),
            inside: f64::from_bits(inside),
            area: <Area as Record<4>>::of([left, below, right, above]),
            leftmost: DVec2::new(f64::from_bits(x), f64::from_bits(y)),
        }
    }
}

impl Record<14> for Nested {
    fn words(&self) -> [u64; 14] {
        let mut words = [self.nesting; 14];
        words[..12].copy_from_slice(&self.row.words());
        words[13] = self.parent;
        words
    }

    fn of(words: [u64; 14]) -> Self {
        let [row @ .., nesting, parent] = words;
        Self {
            row: Row::of(row),
            nesting,
            parent,
        }
    }
}
