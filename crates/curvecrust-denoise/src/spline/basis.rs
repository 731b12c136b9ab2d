//! Uniform cubic B-splines in the plane, open or closed, and their Bézier form.

use glam::DVec2;

/// A spline of one cubic piece an interval; its parameter runs from 0 to the number of intervals.
#[derive(Clone, Debug)]
pub(crate) struct Spline {
    /// The control points: as many as intervals if it is closed, else three more.
    pub(crate) controls: Vec<DVec2>,
    pub(crate) closed: bool,
}

/// Weights of the four control points that a place of a spline depends on.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Row {
    pub(crate) columns: [usize; 4],
    pub(crate) weights: [f64; 4],
    /// Those of the derivative by the parameter.
    pub(crate) slopes: [f64; 4],
}

/// The number of control points of a spline.
pub(crate) fn controls_of(intervals: usize, closed: bool) -> usize {
    if closed { intervals } else { intervals + 3 }
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

/// The interval of a parameter that [`wrapped`] gave, and the place in it.
#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "between 0 and the number of intervals"
)]
pub(crate) fn interval(t: f64, intervals: usize) -> (usize, f64) {
    let j = (t.floor() as usize).min(intervals.saturating_sub(1));
    (j, t - j as f64)
}

/// The weights of the control points at a parameter.
pub(crate) fn row(t: f64, intervals: usize, closed: bool) -> Row {
    let (j, u) = interval(wrapped(t, intervals, closed), intervals);
    let v = 1.0 - u;
    let count = controls_of(intervals, closed);
    Row {
        columns: [0, 1, 2, 3].map(|a| if closed { (j + a) % count } else { j + a }),
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

impl Spline {
    pub(crate) fn intervals(&self) -> usize {
        self.controls.len() - if self.closed { 0 } else { 3 }
    }

    pub(crate) fn row(&self, t: f64) -> Row {
        row(t, self.intervals(), self.closed)
    }

    /// A parameter as the spline has it: of a closed one modulo its length.
    pub(crate) fn wrapped(&self, t: f64) -> f64 {
        wrapped(t, self.intervals(), self.closed)
    }

    pub(crate) fn point(&self, t: f64) -> DVec2 {
        self.row(t).point(&self.controls)
    }

    /// The Bézier pieces from one parameter to a later one.
    pub(crate) fn beziers(&self, from: f64, to: f64) -> Vec<[DVec2; 4]> {
        let mut pieces = Vec::new();
        let mut start = from;
        while start < to {
            let next = (start.floor() + 1.0).min(to);
            // A sliver at an end would only be a rounding error long.
            if next - start > 1e-9 {
                pieces.push(self.bezier(start, next));
            }
            start = next;
        }
        if let (true, [first, .., last]) = (self.closed, &mut *pieces) {
            last[3] = first[0];
        }
        for i in 1..pieces.len() {
            pieces[i][0] = pieces[i - 1][3];
        }
        pieces
    }

    /// One cubic between two parameters of one interval: by values and slopes at its ends.
    fn bezier(&self, from: f64, to: f64) -> [DVec2; 4] {
        // Evaluated inside of the interval, whose ends belong to two.
        let whole = from.floor();
        let ends = [from, to].map(|t| {
            let inside = (t - whole).clamp(0.0, 1.0 - 1e-12);
            self.row(whole + inside)
        });
        let [a, b] = ends.map(|row| row.point(&self.controls));
        let third = (to - from) / 3.0;
        let [da, db] = ends.map(|row| row.tangent(&self.controls) * third);
        [a, a + da, b - db, b]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn weights_sum_to_one_and_reproduce_lines() {
        let line: Vec<DVec2> = (0..9).map(|i| DVec2::new(f64::from(i), 2.0)).collect();
        let spline = Spline {
            controls: line,
            closed: false,
        };
        for t in [0.0, 0.25, 1.0, 3.7, 6.0] {
            let row = spline.row(t);
            assert!((row.weights.iter().sum::<f64>() - 1.0).abs() < 1e-12);
            assert!((spline.point(t) - DVec2::new(t + 1.0, 2.0)).length() < 1e-12);
            assert!((row.tangent(&spline.controls) - DVec2::X).length() < 1e-12);
        }
    }

    #[test]
    fn beziers_are_the_spline() {
        let controls = [
            (0.0, 0.0),
            (2.0, 1.0),
            (3.0, -1.0),
            (1.0, -4.0),
            (-2.0, -1.0),
        ];
        let controls: Vec<DVec2> = controls.map(DVec2::from).to_vec();
        for closed in [true, false] {
            let spline = Spline {
                controls: controls.clone(),
                closed,
            };
            let end = spline.intervals() as f64;
            let (from, to) = if closed { (0.0, end) } else { (0.3, end - 0.4) };
            let pieces = spline.beziers(from, to);
            let mut start = from;
            for piece in &pieces {
                let next = (start.floor() + 1.0).min(to);
                let [a, b, c, d] = *piece;
                let middle = (a + 3.0 * b + 3.0 * c + d) / 8.0;
                assert!((middle - spline.point((start + next) / 2.0)).length() < 1e-9);
                start = next;
            }
            assert_eq!(pieces.len(), if closed { 5 } else { 2 });
        }
    }
}
