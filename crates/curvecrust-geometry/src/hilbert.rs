//! Positions along the Hilbert curve: cells that are close on it are close in the plane.

/// Cells along each axis of the grid on which keys are taken.
pub(crate) const SIDE: f64 = 65_536.0;

/// For a state of the curve and four bits of x and of y: eight bits of the key, and the next state
/// above them.
static STEPS: [[u16; 256]; 4] = steps();

/// The key of a cell, coordinates below 2^16: its position along the curve.
#[inline(always)]
pub(crate) fn key(x: u32, y: u32) -> u32 {
    let mut state = 0;
    let mut key = 0;
    for shift in [12, 8, 4, 0] {
        let digits = (x >> shift & 15) << 4 | (y >> shift & 15);
        let step = u32::from(STEPS[state & 3][digits as usize & 255]);
        key = key << 8 | step & 255;
        state = (step >> 8) as usize;
    }
    key
}

/// A quadrant is drawn mirrored at the diagonal (bit 0 of the state), at the centre (bit 1), both
/// or neither.
const fn steps() -> [[u16; 256]; 4] {
    let mut steps = [[0; 256]; 4];
    let mut start = 0;
    while start < 4 {
        let mut digits = 0;
        while digits < 256 {
            let (mut state, mut key, mut bit) = (start, 0, 4);
            while bit > 0 {
                bit -= 1;
                let turned = (state >> 1) * 3;
                let quadrant = ((digits >> (4 + bit) & 1) << 1 | (digits >> bit & 1)) ^ turned;
                let (x, y) = if state & 1 == 0 {
                    (quadrant >> 1, quadrant & 1)
                } else {
                    (quadrant & 1, quadrant >> 1)
                };
                key = key << 2 | (3 * x) ^ y;
                if y == 0 {
                    state ^= 1 | x << 1;
                }
            }
            steps[start as usize][digits as usize] = state << 8 | key;
            digits += 1;
        }
        start += 1;
    }
    steps
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn consecutive_keys_are_adjacent_cells() {
        let side = 64i32;
        let mut cells: Vec<(u32, i32, i32)> = (0..side)
            .flat_map(|x| (0..side).map(move |y| (x, y)))
            .map(|(x, y)| (key(x.cast_unsigned(), y.cast_unsigned()), x, y))
            .collect();
        cells.sort_unstable();
        for (i, pair) in (0u32..).zip(cells.windows(2)) {
            let [(key, x, y), (_, x2, y2)] = [pair[0], pair[1]];
            assert_eq!(key, i);
            assert_eq!((x - x2).abs() + (y - y2).abs(), 1);
        }
    }

    #[test]
    fn the_last_cell_has_the_last_key() {
        assert_eq!(key(65_535, 0), u32::MAX);
    }
}
