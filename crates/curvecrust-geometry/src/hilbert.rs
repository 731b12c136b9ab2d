//! Keys along the Hilbert curve: points close by in the order are close by in the plane.

use glam::DVec2;

/// The position along the Hilbert curve of the cell (`x`, `y`) of a 2^32 x 2^32 grid.
///
/// Consecutive positions are neighbouring cells; 0 is the cell (0, 0).
#[must_use]
pub fn hilbert_index(x: u32, y: u32) -> u64 {
    let (mut x, mut y) = (x, y);
    let mut index = 0u64;
    for bit in (0..32).rev() {
        let (rx, ry) = ((x >> bit) & 1, (y >> bit) & 1);
        index = index << 2 | u64::from((3 * rx) ^ ry);
        // Into the frame of the quadrant: the lower bits mirrored and swapped.
        if ry == 0 {
            if rx == 1 {
                (x, y) = (!x, !y);
            }
            (x, y) = (y, x);
        }
    }
    index
}

/// The Hilbert keys of points, in their order, on a grid of 2^32 x 2^32 cells over a square around
/// them.
///
/// Scaling finite points by a power of two, and shifting them exactly, leaves their keys unchanged.
#[must_use]
pub fn hilbert_keys(points: &[DVec2]) -> Vec<u64> {
    let low = points.iter().copied().fold(DVec2::INFINITY, DVec2::min);
    let high = points.iter().copied().fold(DVec2::NEG_INFINITY, DVec2::max);
    let extent = (high - low).max_element();
    let cell = |offset: f64| {
        // A cast saturates: rounding at the far side cannot leave the grid, and 0 / 0 is cell 0.
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "the cell is the integer part; float casts saturate"
        )]
        let cell = (offset / extent * 4_294_967_296.0) as u32;
        cell
    };
    points
        .iter()
        .map(|&p| hilbert_index(cell(p.x - low.x), cell(p.y - low.y)))
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn consecutive_positions_are_neighbouring_cells() {
        // The curve of order 5 is the start of the curve of order 32.
        let mut cell_at = vec![None; 1 << 10];
        for x in 0..32u32 {
            for y in 0..32u32 {
                let index = usize::try_from(hilbert_index(x, y)).unwrap();
                assert!(cell_at[index].replace((x, y)).is_none());
            }
        }
        for pair in cell_at.windows(2) {
            let ((x0, y0), (x1, y1)) = (pair[0].unwrap(), pair[1].unwrap());
            assert_eq!(x0.abs_diff(x1) + y0.abs_diff(y1), 1);
        }
    }

    #[test]
    fn one_point_and_none() {
        assert_eq!(hilbert_keys(&[]), []);
        assert_eq!(hilbert_keys(&[DVec2::new(3.0, 4.0)]), [0]);
    }
}
