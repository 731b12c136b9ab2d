//! The knots of cubic splines in the plane: evenly spaced, and threefold at creases.
//!
//! At a threefold knot a cubic spline is continuous, and its derivatives are free: it may have a
//! corner there. On every interval it still depends on four control points in a row.
//!
//! Source: L. Piegl, W. Tiller, *The NURBS Book*, 1997, chapter 2.

use glam::DVec2;

/// A parameter as near to a crease as this is there.
const AT: f64 = 1e-9;

/// The knots of a spline, one at each whole parameter and three at a crease.
#[derive(Clone, Debug)]
pub(crate) struct Knots {
    pub(crate) intervals: usize,
    pub(crate) closed: bool,
    /// Whole parameters, ascending: inner ones of an open spline; of a closed one 0 is the first
    /// if there are any.
    pub(crate) creases: Vec<usize>,
}

/// Weights of the four control points that a place of a spline depends on.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Row {
    pub(crate) columns: [usize; 4],
    pub(crate) weights: [f64; 4],
    /// Those of the derivative by the parameter.
    pub(crate) slopes: [f64; 4],
}

impl Row {
    pub(crate) fn point(&self, controls: &[DVec2]) -> DVec2 {
        let pairs = self.columns.iter().zip(self.weights);
        pairs.map(|(&c, w)| controls[c] * w).sum()
    }

    pub(crate) fn tangent(&self, controls: &[DVec2]) -> DVec2 {
        let pairs = self.columns.iter().zip(self.slopes);
        pairs.map(|(&c, w)| controls[c] * w).sum()
    }
}

/// Where on a spline a parameter lies: of a closed one modulo its length, of an open one clamped.
pub(crate) fn wrapped(t: f64, intervals: usize, closed: bool) -> f64 {
    let length = intervals as f64;
    if closed {
        let t = t.rem_euclid(length);
        if t < length { t } else { 0.0 }
    } else {
        t.clamp(0.0, length)
    }
}

impl Knots {
    /// The number of control points: as many as intervals if the spline is closed, else three more;
    /// and two more for each crease.
    pub(crate) fn controls(&self) -> usize {
        let ends = if self.closed { 0 } else { 3 };
        self.intervals + ends + 2 * self.creases.len()
    }

    /// The control points that interval j depends on.
    pub(crate) fn columns(&self, j: usize) -> [usize; 4] {
        let first = usize::from(self.creases.first() == Some(&0));
        let before = self.creases.partition_point(|&crease| crease <= j) - first.min(1);
        let start = j + 2 * before;
        let count = self.controls();
        [0, 1, 2, 3].map(|a| {
            let column = start + a;
            if self.closed { column % count } else { column }
        })
    }

    /// The weights of the control points at a parameter.
    pub(crate) fn row(&self, t: f64) -> Row {
        let (j, u) = self.interval(wrapped(t, self.intervals, self.closed));
        let columns = self.columns(j);
        match self.around(j) {
            Some(knots) => uneven(columns, knots, u),
            None => even(columns, u),
        }
    }

    /// The weights of the control points of interval j in the second derivative at its start and at
    /// its end; it is linear between.
    pub(crate) fn seconds(&self, j: usize) -> [[f64; 4]; 2] {
        let Some(k) = self.around(j) else {
            return [[1.0, -2.0, 1.0, 0.0], [0.0, 1.0, -2.0, 1.0]];
        };
        let [a, b, c] = [0, 1, 2].map(|i| 3.0 / (k[i + 3] - k[i]));
        let [d, e] = [0, 1].map(|i| 2.0 / (k[i + 3] - k[i + 1]));
        [
            [a * d, -(a + b) * d, b * d, 0.0],
            [0.0, b * e, -(b + c) * e, c * e],
        ]
    }

    /// The weights of the control points of interval j in the third derivative there.
    pub(crate) fn thirds(&self, j: usize) -> [f64; 4] {
        let [start, end] = self.seconds(j);
        [0, 1, 2, 3].map(|a| end[a] - start[a])
    }

    /// Whether the place nearest to a point is a crease itself: the point lies beyond a corner, and
    /// belongs to neither side.
    pub(crate) fn is_at_crease(&self, t: f64) -> bool {
        let is_crease = |&crease: &usize| {
            let apart = (t - crease as f64).abs();
            apart < AT || self.closed && (apart - self.intervals as f64).abs() < AT
        };
        self.creases.iter().any(is_crease)
    }

    /// The interval of a parameter that [`wrapped`] gave, and the place in it.
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "between 0 and the number of intervals"
    )]
    fn interval(&self, t: f64) -> (usize, f64) {
        let j = (t.floor() as usize).min(self.intervals.saturating_sub(1));
        (j, t - j as f64)
    }

    fn is_crease(&self, k: usize, steps: isize) -> bool {
        let Some(k) = k.checked_add_signed(steps) else {
            return self.closed && self.is_crease(k + self.intervals, steps);
        };
        let k = if self.closed { k % self.intervals } else { k };
        self.creases.binary_search(&k).is_ok()
    }

    /// The three knots before the end of interval j and the three after its start, from its start
    /// on; `None` if they are evenly spaced.
    fn around(&self, j: usize) -> Option<[f64; 6]> {
        if self.creases.is_empty() {
            return None;
        }
        let [before, start, end, after] = [-1, 0, 1, 2].map(|steps| self.is_crease(j, steps));
        let (low, next) = match (start, before) {
            (true, _) => (0.0, 0.0),
            (_, true) => (-1.0, -1.0),
            _ => (-2.0, -1.0),
        };
        let (far, high) = match (end, after) {
            (true, _) => (1.0, 1.0),
            (_, true) => (2.0, 2.0),
            _ => (2.0, 3.0),
        };
        let is_even = !(before || start || end || after);
        (!is_even).then_some([low, next, 0.0, 1.0, far, high])
    }
}

/// A row between evenly spaced knots, at a place from 0 to 1.
fn even(columns: [usize; 4], u: f64) -> Row {
    let v = 1.0 - u;
    Row {
        columns,
        weights: [
            v * v * v / 6.0,
            (3.0 * u * u * u - 6.0 * u * u + 4.0) / 6.0,
            (-3.0 * u * u * u + 3.0 * u * u + 3.0 * u + 1.0) / 6.0,
            u * u * u / 6.0,
        ],
        slopes: [
            -v * v / 2.0,
            (3.0 * u * u - 4.0 * u) / 2.0,
            (-3.0 * u * u + 2.0 * u + 1.0) / 2.0,
            u * u / 2.0,
        ],
    }
}

/// A row between any knots, of which the third is 0 and the fourth 1, by the recursion of Cox and
/// de Boor.
fn uneven(columns: [usize; 4], k: [f64; 6], u: f64) -> Row {
    let mut basis = [1.0, 0.0, 0.0, 0.0];
    let mut slopes = [0.0; 4];
    for degree in 1..=3 {
        let mut next = [0.0; 4];
        slopes = [0.0; 4];
        for (i, value) in basis.iter().enumerate().take(degree) {
            // The function spans the knots from `low` to `high`.
            let (low, high) = (k[3 + i - degree], k[3 + i]);
            let share = value / (high - low);
            next[i] += (high - u) * share;
            next[i + 1] += (u - low) * share;
            slopes[i] -= degree as f64 * share;
            slopes[i + 1] += degree as f64 * share;
        }
        basis = next;
    }
    Row {
        columns,
        weights: basis,
        slopes,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn knots(closed: bool, creases: &[usize]) -> Knots {
        Knots {
            intervals: 9,
            closed,
            creases: creases.to_vec(),
        }
    }

    #[test]
    fn even_rows_are_uneven_ones_of_even_knots() {
        for u in [0.0, 0.3, 1.0] {
            let columns = [0, 1, 2, 3];
            let (a, b) = (
                even(columns, u),
                uneven(columns, [-2.0, -1.0, 0.0, 1.0, 2.0, 3.0], u),
            );
            for i in 0..4 {
                assert!((a.weights[i] - b.weights[i]).abs() < 1e-12);
                assert!((a.slopes[i] - b.slopes[i]).abs() < 1e-12);
            }
        }
    }

    #[test]
    fn a_spline_is_smooth_but_at_its_creases() {
        for (closed, creases) in [(false, vec![3, 5]), (true, vec![0, 4, 6]), (true, vec![0])] {
            let knots = knots(closed, &creases);
            let control = |i: usize| DVec2::from_angle(i as f64 * 2.3);
            let controls: Vec<DVec2> = (0..knots.controls()).map(control).collect();
            for k in 1..knots.intervals + usize::from(closed) {
                let t = k as f64;
                let [a, b] = [t - 1e-9, t + 1e-9].map(|t| knots.row(t));
                assert!(a.point(&controls).distance(b.point(&controls)) < 1e-7);
                let bend = a.tangent(&controls).distance(b.tangent(&controls));
                let is_crease = creases.contains(&(k % knots.intervals));
                assert_eq!(bend > 1e-3, is_crease, "{k} {bend}");
            }
        }
    }

    #[test]
    fn thirds_are_the_third_derivative() {
        let knots = knots(true, &[0, 4, 6]);
        for j in 0..knots.intervals {
            let slopes = [0.2, 0.5, 0.8].map(|u| knots.row(j as f64 + u).slopes);
            let thirds = knots.thirds(j);
            for a in 0..4 {
                let second = (slopes[0][a] - 2.0 * slopes[1][a] + slopes[2][a]) / 0.09;
                assert!((second - thirds[a]).abs() < 1e-9);
            }
        }
    }
}
