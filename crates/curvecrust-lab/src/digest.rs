//! Short digests, the same on every machine.

/// FNV-1a in 64 bits: G. Fowler, L. C. Noll, K.-P. Vo, 1991.
pub(crate) fn fnv1a(bytes: impl Iterator<Item = u8>) -> u64 {
    bytes.fold(0xcbf2_9ce4_8422_2325, |hash, byte| {
        (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3)
    })
}
