//! Where dense polylines cross, and where the curve itself does.

use curvecrust_curve::{Curve, DenseCurve};
use curvecrust_geometry::{DVec2, Segment, orient2d};
use rstar::primitives::{GeomWithData, Rectangle};
use rstar::{RTree, RTreeObject};

use crate::error::MedialAxisError;
use crate::span::Span;

/// The chord of the gap after dense point `i`; a point where a curve ends.
pub(crate) fn chord(dense: &DenseCurve, i: usize) -> Segment {
    let points = dense.points();
    Segment::new(points[i], points[dense.next(i).unwrap_or(i)])
}

/// The first proper crossing of one of the `gaps` with any chord of the curve.
pub(crate) fn find(dense: &DenseCurve, gaps: &[usize]) -> Option<MedialAxisError> {
    let (pair, at) = crossing_chords(dense, gaps).next()?;
    Some(error(dense, pair, at))
}

/// A crossing of the curve itself, by a chord of `gaps` and another one that cross: they still do
/// when the curve between their ends is halved again and again.
///
/// Two strands that cross at a small angle are near each other for long. To refine until dense
/// points tell them apart takes millions of these, where some dozen halvings find the crossing.
pub(crate) fn of_curve(
    curve: &Curve,
    dense: &DenseCurve,
    gaps: &[usize],
) -> Option<MedialAxisError> {
    let params = dense.params();
    let span = |i: usize| Span::new(curve, params[i], params[dense.next(i).unwrap_or(i)]);
    crossing_chords(dense, gaps).find_map(|(pair, _)| {
        let at = halved(pair.map(span))?;
        Some(error(dense, pair, at))
    })
}

/// The chords that cross chords of `gaps` properly, gap by gap, and where.
fn crossing_chords<'a>(
    dense: &'a DenseCurve,
    gaps: &'a [usize],
) -> impl Iterator<Item = ([usize; 2], DVec2)> + 'a {
    let boxed = |i: usize| {
        let Segment { a, b } = chord(dense, i);
        GeomWithData::new(Rectangle::from_corners(a.to_array(), b.to_array()), i)
    };
    // Most curves have no such gap in the end.
    let chords = if gaps.is_empty() { 0 } else { dense.len() };
    let tree = RTree::bulk_load((0..chords).map(boxed).collect());
    gaps.iter().flat_map(move |&gap| {
        let this = chord(dense, gap);
        let near = tree.locate_in_envelope_intersecting(boxed(gap).envelope());
        let mut others: Vec<usize> = near.map(|other| other.data).collect();
        others.sort_unstable();
        others.into_iter().filter_map(move |other| {
            let at = crossing_point(this, chord(dense, other))?;
            Some(([gap, other], at))
        })
    })
}

fn error(dense: &DenseCurve, chords: [usize; 2], at: DVec2) -> MedialAxisError {
    let components = chords.map(|i| dense.component_of(i));
    MedialAxisError::Crossing { at, components }
}

/// A gap is halved so often, to a millionth of it.
const HALVINGS: u32 = 20;
/// A crossing is found among four pairs for each halving.
const MOST_PAIRS: u32 = 8 * HALVINGS;

/// Where two spans cross: their chords do, and those of halves of them, so many times. `None` also
/// where that is not found among so many pairs, as for spans that lie on each other.
fn halved(spans: [Span<'_>; 2]) -> Option<DVec2> {
    let mut open = vec![(spans, 0)];
    for _ in 0..MOST_PAIRS {
        let ([first, second], halvings) = open.pop()?;
        let Some(at) = crossing_point(first.chord(), second.chord()) else {
            continue;
        };
        if halvings == HALVINGS {
            return Some(at);
        }
        for p in first.halves() {
            open.extend(second.halves().map(|q| ([p, q], halvings + 1)));
        }
    }
    None
}

/// The point where two segments cross inside both of them, decided exactly.
fn crossing_point(p: Segment, q: Segment) -> Option<DVec2> {
    let apart = |x: f64, y: f64| (x > 0.0 && y < 0.0) || (x < 0.0 && y > 0.0);
    let (qa, qb) = (orient2d(p.a, p.b, q.a), orient2d(p.a, p.b, q.b));
    let (pa, pb) = (orient2d(q.a, q.b, p.a), orient2d(q.a, q.b, p.b));
    (apart(qa, qb) && apart(pa, pb)).then(|| q.a.lerp(q.b, qa / (qa - qb)))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The first piece of a curve and its second one.
    fn crossing_of(d: &str) -> Option<MedialAxisError> {
        let curve = Curve::from_path_data(d).unwrap();
        let dense = DenseCurve::per_segment(&curve, 4).unwrap();
        let gaps: Vec<usize> = (0..dense.len()).collect();
        of_curve(&curve, &dense, &gaps)
    }

    #[test]
    fn a_small_angle_is_found_at_once() {
        // A parabola of height 1e-4, which a line crosses at an angle of 1e-4.
        let parabola = "M 0 0 Q 2 2e-4 4 0";
        let Some(MedialAxisError::Crossing { at, components }) =
            crossing_of(&format!("{parabola} M -1 -2.2e-4 L 3 1.8e-4"))
        else {
            panic!("they cross")
        };
        assert_eq!(components, [0, 1]);
        // On the line y = 1e-4 (x - 1.2), and on the parabola y = 1e-4 x (1 - x / 4).
        let x = 2.0 * f64::sqrt(1.2);
        let place = DVec2::new(x, 1e-4 * (x - 1.2));
        assert!(at.distance(place) < 1e-6, "{at}");
    }

    #[test]
    fn chords_that_cross_are_not_enough() {
        // Four chords of the arc leave room for a line that the arc does not reach.
        assert_eq!(crossing_of("M 0 0 Q 2 4 4 0 M 1.2 2.01 L 2.8 2.01"), None);
        // Chords of the inner arc cross those of the outer one.
        let (inner, outer) = (
            "M -2 0 A 2 2 0 0 0 2 0",
            "M -1.9 -.7 A 2.02 2.02 0 0 0 1.9 -.7",
        );
        assert_eq!(crossing_of(&format!("{inner} {outer}")), None);
    }

    #[test]
    fn segments_cross_inside_only() {
        let s = |ax: f64, ay: f64, bx: f64, by: f64| {
            Segment::new(DVec2::new(ax, ay), DVec2::new(bx, by))
        };
        let cross = crossing_point(s(0.0, 0.0, 4.0, 0.0), s(1.0, -1.0, 1.0, 3.0));
        assert_eq!(cross, Some(DVec2::new(1.0, 0.0)));
        for touching in [
            s(4.0, 0.0, 4.0, 3.0),
            s(1.0, 0.0, 1.0, 2.0),
            s(5.0, -1.0, 5.0, 1.0),
        ] {
            assert_eq!(crossing_point(s(0.0, 0.0, 4.0, 0.0), touching), None);
        }
    }
}
