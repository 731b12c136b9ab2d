//! Cubic B-splines in the plane, open or closed, and their Bézier form.

use glam::DVec2;

use super::knots::{Knots, Row, wrapped};

/// A piece of a spline that is no longer than this is none.
const SLIVER: f64 = 1e-9;

/// How far inside of an interval the spline is evaluated at its end, which belongs to two.
const INSIDE: f64 = 1e-12;

/// A spline of one cubic piece an interval; its parameter runs from 0 to the number of intervals.
#[derive(Clone, Debug)]
pub(crate) struct Spline {
    pub(crate) controls: Vec<DVec2>,
    pub(crate) knots: Knots,
}

impl Spline {
    pub(crate) fn intervals(&self) -> usize {
        self.knots.intervals
    }

    pub(crate) fn closed(&self) -> bool {
        self.knots.closed
    }

    /// The places where its direction may jump.
    pub(crate) fn creases(&self) -> &[usize] {
        &self.knots.creases
    }

    pub(crate) fn row(&self, t: f64) -> Row {
        self.knots.row(t)
    }

    /// A parameter as the spline has it: of a closed one modulo its length.
    pub(crate) fn wrapped(&self, t: f64) -> f64 {
        wrapped(t, self.intervals(), self.closed())
    }

    pub(crate) fn point(&self, t: f64) -> DVec2 {
        self.row(t).point(&self.controls)
    }

    /// The derivative by the parameter.
    pub(crate) fn tangent(&self, t: f64) -> DVec2 {
        self.row(t).tangent(&self.controls)
    }

    /// The derivatives just before and after a whole parameter.
    pub(crate) fn sides(&self, knot: usize) -> [DVec2; 2] {
        let before = if knot > 0 { knot } else { self.intervals() };
        [before as f64 - INSIDE, knot as f64].map(|t| self.tangent(t))
    }

    /// The Bézier pieces between [`breaks`].
    pub(crate) fn beziers(&self, breaks: &[f64]) -> Vec<[DVec2; 4]> {
        let pairs = breaks.windows(2);
        let mut pieces: Vec<_> = pairs.map(|pair| self.bezier(pair[0], pair[1])).collect();
        if let (true, [first, .., last]) = (self.closed(), &mut *pieces) {
            last[3] = first[0];
        }
        for i in 1..pieces.len() {
            pieces[i][0] = pieces[i - 1][3];
        }
        pieces
    }

    /// One cubic between two parameters of one interval: by values and slopes at its ends.
    fn bezier(&self, from: f64, to: f64) -> [DVec2; 4] {
        let whole = from.floor();
        let ends = [from, to].map(|t| {
            let inside = (t - whole).clamp(0.0, 1.0 - INSIDE);
            self.row(whole + inside)
        });
        let [a, b] = ends.map(|row| row.point(&self.controls));
        let third = (to - from) / 3.0;
        let [da, db] = ends.map(|row| row.tangent(&self.controls) * third);
        [a, a + da, b - db, b]
    }
}

/// Where the cubics between two parameters begin, and the last ends: at the parameters and at the
/// whole numbers between. One alone if there is no cubic.
pub(crate) fn breaks(from: f64, to: f64) -> Vec<f64> {
    // A sliver at an end would only be a rounding error long.
    let from = if from.ceil() - from > SLIVER {
        from
    } else {
        from.ceil()
    };
    let to = if to - to.floor() > SLIVER {
        to
    } else {
        to.floor()
    };
    let whole = std::iter::successors(Some(from.floor() + 1.0), |at| Some(at + 1.0));
    let inner = whole.take_while(|&at| at < to);
    let last = (from < to).then_some(to);
    [from].into_iter().chain(inner).chain(last).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn spline(controls: Vec<DVec2>, closed: bool) -> Spline {
        let knots = Knots {
            intervals: controls.len() - if closed { 0 } else { 3 },
            closed,
            creases: Vec::new(),
        };
        Spline { controls, knots }
    }

    #[test]
    fn weights_sum_to_one_and_reproduce_lines() {
        let line: Vec<DVec2> = (0..9).map(|i| DVec2::new(f64::from(i), 2.0)).collect();
        let spline = spline(line, false);
        for t in [0.0, 0.25, 1.0, 3.7, 6.0] {
            let row = spline.row(t);
            assert!((row.weights.iter().sum::<f64>() - 1.0).abs() < 1e-12);
            assert!((spline.point(t) - DVec2::new(t + 1.0, 2.0)).length() < 1e-12);
            assert!((row.tangent(&spline.controls) - DVec2::X).length() < 1e-12);
        }
    }

    #[test]
    fn slivers_at_ends_are_no_pieces() {
        assert_eq!(breaks(0.25, 2.5), [0.25, 1.0, 2.0, 2.5]);
        assert_eq!(breaks(1.0 - 1e-12, 2.0 + 1e-12), [1.0, 2.0]);
        assert_eq!(breaks(0.0, 3.0), [0.0, 1.0, 2.0, 3.0]);
        assert_eq!(breaks(2.0, 2.0), [2.0]);
        assert_eq!(breaks(0.5, 0.75), [0.5, 0.75]);
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
            let spline = spline(controls.clone(), closed);
            let end = spline.intervals() as f64;
            let (from, to) = if closed { (0.0, end) } else { (0.3, end - 0.4) };
            let pieces = spline.beziers(&breaks(from, to));
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
