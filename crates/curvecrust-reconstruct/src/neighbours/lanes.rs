//! Sixteen numbers at a time, in loops that compilers turn into vector instructions.

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

/// Combines all values by halves: vectors with vectors, not one number after the other.
#[inline(always)]
pub(super) fn reduce<T: Copy>(v: &[T; WIDTH], combine: impl Fn(T, T) -> T) -> T {
    let v: [T; 8] = std::array::from_fn(|i| combine(v[i], v[i + 8]));
    let v: [T; 4] = std::array::from_fn(|i| combine(v[i], v[i + 4]));
    combine(combine(v[0], v[2]), combine(v[1], v[3]))
}

/// The sum, in an order of its own.
#[inline(always)]
pub(super) fn sum(values: &[f64; WIDTH]) -> f64 {
    reduce(values, |a, b| a + b)
}

/// The smallest of the numbers that are not NaN.
#[inline(always)]
pub(super) fn least(values: &[f64; WIDTH]) -> f64 {
    reduce(values, f64::min)
}

/// The greatest of the numbers that are not NaN.
#[inline(always)]
pub(super) fn most(values: &[f64; WIDTH]) -> f64 {
    reduce(values, f64::max)
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
