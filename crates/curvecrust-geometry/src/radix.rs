//! A sort of 64-bit numbers by their upper halves, in time linear in their number.

use crate::parallel::*;

/// Fewer numbers than this are compared: counting 256 digits costs more.
const FEW: usize = 256;

/// Fewer numbers than this stay in the cache, whatever order they are written in.
const CACHED: usize = 1 << 15;

/// The digits of the upper half, the lowest first: places of bytes.
const DIGITS: [usize; 4] = [4, 5, 6, 7];

/// Sorts numbers by their upper halves.
///
/// By digits of a byte, the lowest first; many numbers are first parted by the highest one, and the
/// parts, which fit into the cache, are sorted on all threads. Needs as much memory again as the
/// numbers take.
pub(crate) fn sort_by_upper_half(numbers: &mut [u64]) {
    if numbers.len() < FEW {
        return numbers.sort_unstable();
    }
    let mut scratch = vec![0; numbers.len()];
    if numbers.len() < CACHED {
        return by_digits(&DIGITS, numbers, &mut scratch);
    }
    let [lower @ .., highest] = DIGITS;
    let mut counts = [[0; 256]];
    count(&[highest], numbers, &mut counts);
    distribute(highest, &counts[0], numbers, &mut scratch);
    let mut parts = Vec::with_capacity(256);
    let (mut to, mut from) = (numbers, scratch.as_mut_slice());
    for length in counts[0] {
        let (a, b);
        (a, to) = to.split_at_mut(length);
        (b, from) = from.split_at_mut(length);
        parts.push((a, b));
    }
    parts.into_par_iter().for_each(|(part, parted)| {
        if part.len() < FEW {
            part.copy_from_slice(parted);
            part.sort_unstable();
        } else {
            // An odd number of digits: the last of them is distributed into `part`.
            by_digits(&lower, parted, part);
        }
    });
}

/// Sorts by some digits, between two places: an even number of them ends where it began.
fn by_digits<const N: usize>(digits: &[usize; N], numbers: &mut [u64], other: &mut [u64]) {
    let mut counts = [[0; 256]; N];
    count(digits, numbers, &mut counts);
    let (mut from, mut to) = (numbers, other);
    for (&digit, counts) in digits.iter().zip(&counts) {
        distribute(digit, counts, from, to);
        (from, to) = (to, from);
    }
}

#[inline(always)]
fn digit_of(number: u64, digit: usize) -> usize {
    usize::from(number.to_le_bytes()[digit])
}

/// How often each digit has each value.
fn count<const N: usize>(digits: &[usize; N], numbers: &[u64], counts: &mut [[usize; 256]; N]) {
    for &number in numbers {
        for (&digit, counts) in digits.iter().zip(&mut *counts) {
            counts[digit_of(number, digit)] += 1;
        }
    }
}

/// Writes numbers to another place in the order of one digit; those with equal ones stay in order.
fn distribute(digit: usize, counts: &[usize; 256], from: &[u64], to: &mut [u64]) {
    let mut next = [0; 256];
    let mut start = 0;
    for (next, count) in next.iter_mut().zip(counts) {
        *next = start;
        start += count;
    }
    for &number in from {
        let place = &mut next[digit_of(number, digit)];
        to[*place] = number;
        *place += 1;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// Numbers whose upper halves have few or many different bytes.
    fn numbers(mask: u64) -> impl Strategy<Value = Vec<u64>> {
        let lengths = prop_oneof![0..2 * FEW, CACHED - 2..CACHED + 2, Just(3 * CACHED)];
        lengths.prop_flat_map(move |length| {
            prop::collection::vec(any::<u64>().prop_map(move |n| n & mask), length)
        })
    }

    fn assert_sorts(mut numbers: Vec<u64>) -> Result<(), TestCaseError> {
        let mut expected = numbers.clone();
        sort_by_upper_half(&mut numbers);
        prop_assert!(numbers.is_sorted_by_key(|number| number >> 32));
        expected.sort_unstable();
        numbers.sort_unstable();
        prop_assert_eq!(numbers, expected);
        Ok(())
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(16))]

        #[test]
        fn any_numbers_are_sorted(numbers in numbers(u64::MAX)) {
            assert_sorts(numbers)?;
        }

        #[test]
        fn numbers_of_few_parts_are_sorted(numbers in numbers(0x0300_ff01_ffff_ffff)) {
            assert_sorts(numbers)?;
        }
    }
}
