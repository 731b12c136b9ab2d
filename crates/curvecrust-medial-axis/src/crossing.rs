//! Where dense polylines cross.

use curvecrust_curve::DenseCurve;
use curvecrust_geometry::{DVec2, Segment, orient2d};

use crate::error::MedialAxisError;

/// The chord of the gap after dense point `i`; a point where a curve ends.
pub(crate) fn chord(dense: &DenseCurve, i: usize) -> Segment {
    let points = dense.points();
    Segment::new(points[i], points[dense.next(i).unwrap_or(i)])
}

/// The first proper crossing of one of the `gaps` with any chord of the curve.
pub(crate) fn find(dense: &DenseCurve, gaps: &[usize]) -> Option<MedialAxisError> {
    gaps.iter().find_map(|&gap| {
        let this = chord(dense, gap);
        (0..dense.len()).find_map(|other| {
            let at = crossing_point(this, chord(dense, other))?;
            let components = [gap, other].map(|i| dense.component_of(i));
            Some(MedialAxisError::Crossing { at, components })
        })
    })
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
