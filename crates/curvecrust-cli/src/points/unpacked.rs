//! How much may be unpacked: far more comes out of a few bytes than any memory holds.

/// How many times as much as went in, and how much in any case.
pub(super) const RATIO: u64 = 64;
const LEAST: u64 = 64 << 20;

/// The most bytes that a number of packed ones may unpack to.
pub(super) const fn most(packed: u64) -> u64 {
    packed.saturating_mul(RATIO).saturating_add(LEAST)
}
