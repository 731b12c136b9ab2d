//! Lines of a table, however its columns are separated.

use super::{Flaw, Place};
use std::io;

/// One record after the other, each a list of fields without white space around them.
pub(super) trait Records {
    /// Whether white space separates the fields.
    const IS_TEXT: bool;

    /// Goes to the next record, if there is one. Lines that are empty or a comment are none.
    fn advance(&mut self) -> io::Result<bool>;

    /// The number of fields.
    fn len(&self) -> usize;

    /// One of the fields.
    fn field(&self, index: usize) -> &[u8];

    /// The line where the record starts, from 1.
    fn line(&self) -> u64;

    /// The place of one of the fields.
    fn place(&self, index: usize) -> Place;

    /// Whether a number may have a comma in front of its decimals.
    fn has_decimal_commas(&self) -> bool;

    /// Why the record has more fields than the first, or fewer.
    fn ragged(&self, expected: usize) -> Flaw;
}
