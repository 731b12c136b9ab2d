//! Points as integers, for signs that floating point cannot settle.

use curvecrust_geometry::DVec2;
use num_bigint::BigInt;
use num_traits::{RefNum, Signed};

/// A vector of integers, of 128 bits or any number of them.
pub(crate) type Vector<T = BigInt> = [T; 2];

/// Points multiplied by the power of two that makes all their coordinates integers, and that
/// power's negative exponent: `points[i] = integers[i] * 2^exponent`.
pub(crate) fn integers<const N: usize>(points: [DVec2; N]) -> ([Vector; N], i32) {
    let exponent = common_exponent(&points);
    (points.map(|p| integer(p, exponent)), exponent)
}

/// Where points lie as seen from the first one, in units of the power of two that makes all
/// integers, if polynomials of a degree in their differences fit into 128 bits, as for those of low
/// degree and on a grid.
pub(crate) fn small_integers<const N: usize>(
    points: [DVec2; N],
    degree: i32,
) -> Option<[Vector<i128>; N]> {
    // Differences have a bit more, and at least 12 bits are left for sums of products.
    let limit = 2f64.powi((108 / degree).min(53));
    let exponent = common_exponent(&points);
    let unit = 2f64.powi(exponent);
    let mut integers = [[0; 2]; N];
    for (integer, point) in integers.iter_mut().zip(points) {
        // Exact if it is small: both are multiples of the unit.
        let offset = (point - points[0]) / unit;
        if offset.abs().max_element() >= limit {
            return None;
        }
        #[expect(clippy::cast_possible_truncation, reason = "an integer below 2^53")]
        let as_integer = |x: f64| x as i128;
        *integer = offset.to_array().map(as_integer);
    }
    Some(integers)
}

/// The largest power of two, by its exponent, of which all coordinates are multiples.
pub(crate) fn common_exponent(points: &[DVec2]) -> i32 {
    let coordinates = points.iter().flat_map(|p| [p.x, p.y]);
    let last_bits = coordinates.filter(|&x| x != 0.0).map(|x| parts(x).1);
    last_bits.min().unwrap_or(0)
}

/// The point divided by 2^exponent, which must divide it.
pub(crate) fn integer(point: DVec2, exponent: i32) -> Vector {
    [point.x, point.y].map(|x| {
        let (mantissa, own) = parts(x);
        BigInt::from(mantissa) << own.saturating_sub(exponent).max(0).unsigned_abs()
    })
}

/// `x = mantissa * 2^exponent` with an odd mantissa, or zero.
fn parts(x: f64) -> (i64, i32) {
    let bits = x.to_bits();
    let biased = i32::try_from(bits >> 52 & 0x7ff).unwrap_or(0);
    let fraction = (bits & ((1 << 52) - 1)).cast_signed();
    // Subnormal numbers lack the leading bit.
    let (mantissa, exponent) = match biased {
        0 => (fraction, -1074),
        _ => (fraction + (1 << 52), biased - 1075),
    };
    let zeros = mantissa.trailing_zeros() % 64;
    let odd = mantissa >> zeros;
    let signed = if x.is_sign_negative() { -odd } else { odd };
    (signed, exponent + zeros.cast_signed())
}

pub(crate) fn sub<T: Signed>(p: &Vector<T>, q: &Vector<T>) -> Vector<T>
where
    for<'t> &'t T: RefNum<T>,
{
    [&p[0] - &q[0], &p[1] - &q[1]]
}

pub(crate) fn dot<T: Signed>(u: &Vector<T>, v: &Vector<T>) -> T
where
    for<'t> &'t T: RefNum<T>,
{
    &u[0] * &v[0] + &u[1] * &v[1]
}

/// Positive iff `v` is to the left of `u`.
pub(crate) fn cross<T: Signed>(u: &Vector<T>, v: &Vector<T>) -> T
where
    for<'t> &'t T: RefNum<T>,
{
    &u[0] * &v[1] - &u[1] * &v[0]
}

#[cfg(test)]
mod tests {
    use super::*;
    use curvecrust_geometry::PointSet;
    use num_traits::ToPrimitive;

    #[test]
    fn integers_are_the_points() {
        let (big, small) = (PointSet::MAX_MAGNITUDE, PointSet::MIN_MAGNITUDE);
        let points = [
            DVec2::new(1.5, -3.0),
            DVec2::new(0.1, 0.0),
            DVec2::new(-big, small),
            DVec2::new(5e-324, 2f64.powi(-1022)),
        ];
        for p in points {
            let (near, exponent) = integers([p, DVec2::X]);
            let back = near[0].clone().map(|x| x.to_f64().unwrap());
            // Two steps: a power of two may be out of range where the product is not.
            let half = 2f64.powi(exponent / 2);
            let rest = 2f64.powi(exponent - exponent / 2);
            assert_eq!(DVec2::from(back) * half * rest, p);
        }
        assert_eq!(integers([DVec2::new(6.0, -4.0)]).1, 1);
        assert_eq!(integers([DVec2::ZERO]), ([[0.into(), 0.into()]], 0));
    }

    #[test]
    fn small_integers_are_seen_from_the_first_point() {
        for unit in [1.0, 2f64.powi(-40), 2f64.powi(100)] {
            let from = DVec2::new(1e6, -7.0);
            let to = [DVec2::new(262_143.0, -3.0), DVec2::new(1.0, -262_143.0)];
            let points = [from, from + to[0], from + to[1]].map(|p| p * unit);
            let expected = [[0, 0], [262_143, -3], [1, -262_143]];
            assert_eq!(small_integers(points, 6), Some(expected));
        }
        for (degree, bits) in [(2, 53), (4, 27), (6, 18)] {
            let seen = |far| small_integers([DVec2::ZERO, DVec2::new(3.0, far)], degree);
            let limit = 2f64.powi(bits);
            let last = (1 << bits) - 1;
            assert_eq!(seen(1.0 - limit), Some([[0, 0], [3, -last]]));
            for far in [limit, -limit, 1e300] {
                assert_eq!(seen(far), None, "{degree} {far}");
            }
        }
    }
}
