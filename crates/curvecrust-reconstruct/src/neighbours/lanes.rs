//! Sixteen numbers at a time, in loops that compilers turn into vector instructions.

#[cfg(not(all(target_arch = "wasm32", target_feature = "simd128")))]
use halves::{greater, plus, reduce, smaller};
#[cfg(all(target_arch = "wasm32", target_feature = "simd128"))]
use pairs::{greater, plus, reduce, smaller};

/// Points of a leaf, and children of a node.
pub(super) const WIDTH: usize = 16;

/// A function compiled for AVX-512, for AVX2 and for all processors, of which one is chosen at run
/// time; what it calls has to be inlined. With the feature `portable` once only.
macro_rules! compiled_for_each_processor {
    ($function:item) => {
        #[cfg_attr(
            not(feature = "portable"),
            multiversion::multiversion(targets(
                "x86_64+avx512f+avx512bw+avx512cd+avx512dq+avx512vl+bmi1+bmi2+lzcnt+popcnt",
                "x86_64+avx2+bmi1+bmi2+lzcnt+popcnt"
            ))
        )]
        $function
    };
}
pub(super) use compiled_for_each_processor;

/// The smaller of two numbers; the second if one is NaN. Unlike that of the standard library it is
/// one instruction.
#[inline(always)]
pub(super) fn min(a: f64, b: f64) -> f64 {
    if a < b { a } else { b }
}

/// The greater of two numbers; the first if one is NaN.
#[inline(always)]
pub(super) fn max(a: f64, b: f64) -> f64 {
    if a < b { b } else { a }
}

/// The sum, in an order of its own.
#[inline(always)]
pub(super) fn sum(values: &[f64; WIDTH]) -> f64 {
    reduce(values, plus)
}

/// The smallest of the numbers that are not NaN; infinite if there is none.
#[inline(always)]
pub(super) fn least(values: &[f64; WIDTH]) -> f64 {
    let mut known = *values;
    for value in &mut known {
        *value = min(*value, f64::INFINITY);
    }
    reduce(&known, smaller)
}

/// The greatest of the numbers that are not NaN; minus infinity if there is none.
#[inline(always)]
pub(super) fn most(values: &[f64; WIDTH]) -> f64 {
    let mut known = *values;
    for value in &mut known {
        *value = max(-f64::INFINITY, *value);
    }
    reduce(&known, greater)
}

/// Combines all values by halves: vectors with vectors, not one number after the other.
#[cfg(not(all(target_arch = "wasm32", target_feature = "simd128")))]
mod halves {
    use super::WIDTH;
    pub(super) use super::{max as greater, min as smaller};

    #[inline(always)]
    pub(super) fn plus(a: f64, b: f64) -> f64 {
        a + b
    }

    #[inline(always)]
    pub(super) fn reduce(v: &[f64; WIDTH], combine: impl Fn(f64, f64) -> f64) -> f64 {
        let v: [f64; 8] = std::array::from_fn(|i| combine(v[i], v[i + 8]));
        let v: [f64; 4] = std::array::from_fn(|i| combine(v[i], v[i + 4]));
        combine(combine(v[0], v[2]), combine(v[1], v[3]))
    }
}

/// The same in the same order for WebAssembly, where compilers make vectors of numbers that are
/// combined only when told.
#[cfg(all(target_arch = "wasm32", target_feature = "simd128"))]
mod pairs {
    use super::WIDTH;
    use std::arch::wasm32::*;

    #[inline(always)]
    pub(super) fn plus(a: v128, b: v128) -> v128 {
        f64x2_add(a, b)
    }

    /// The second if one is NaN, as of `min`.
    #[inline(always)]
    pub(super) fn smaller(a: v128, b: v128) -> v128 {
        f64x2_pmin(b, a)
    }

    #[inline(always)]
    pub(super) fn greater(a: v128, b: v128) -> v128 {
        f64x2_pmax(a, b)
    }

    #[inline(always)]
    pub(super) fn reduce(v: &[f64; WIDTH], combine: impl Fn(v128, v128) -> v128) -> f64 {
        let pair = |i: usize| f64x2(v[i], v[i + 1]);
        let eight = |i: usize| combine(pair(i), pair(i + 8));
        let four = |i: usize| combine(eight(i), eight(i + 4));
        let two = combine(four(0), four(2));
        f64x2_extract_lane::<0>(combine(two, i64x2_shuffle::<1, 0>(two, two)))
    }
}

/// The indices below 16 for which a condition holds, as bits.
#[inline(always)]
pub(super) fn bits(holds: impl Fn(usize) -> bool) -> u32 {
    let mut mask = 0;
    for i in 0..WIDTH {
        mask |= u32::from(holds(i)) << i;
    }
    mask
}

/// The indices that are set in a mask below 2^16, ascending.
#[inline(always)]
pub(super) fn indices(mut mask: u32) -> impl Iterator<Item = u32> {
    std::iter::from_fn(move || {
        let index = mask.trailing_zeros();
        (mask != 0).then(|| {
            mask &= mask - 1;
            // Below 16 already: this spares the checks of those who index by it.
            index % 16
        })
    })
}
