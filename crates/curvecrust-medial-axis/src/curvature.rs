//! Curvature of the smooth curve itself, where dense points say too little of it.

use curvecrust_curve::{Curve, CurveParam, DenseCurve};
use curvecrust_geometry::{DVec2, SegmentTree};

use crate::crossing::chord;
use crate::span::{Span, curvature, segment};

/// The smaller radius of curvature at the two ends of a gap, seen from within its segment: an upper
/// bound of lfs there, which a coarse medial axis may not show yet. Infinite where the curve does
/// not bend or its parameter stands still.
pub(crate) fn least_radius(curve: &Curve, from: CurveParam, to: CurveParam) -> f64 {
    let span = Span::new(curve, from, to);
    span.radius(span.from).min(span.radius(span.to))
}

/// The centres of curvature on both sides of every join that belong to the medial axis, each with
/// the dense point at the join; `gap_to_lfs` is what the dense points were refined to.
///
/// Where curvature jumps, a branch of the axis ends at the centre of the tighter side. No three
/// dense points lie on its circle: the nearest circumcentres miss it by a share of the radius that
/// only falls with the gap, while elsewhere it falls with the square. A centre counts if its
/// osculating disc holds no other part of the curve.
pub(crate) fn centres_at_joins(
    curve: &Curve,
    dense: &DenseCurve,
    gap_to_lfs: f64,
) -> Vec<(usize, DVec2)> {
    // A chord cuts into the disc of a curve on its boundary by (gap / radius)^2 / 8 of the radius.
    let free = 1.0 - gap_to_lfs * gap_to_lfs;
    let chords = (0..dense.len()).filter(|&i| dense.next(i).is_some());
    let tree = SegmentTree::new(chords.map(|i| chord(dense, i)));
    let is_join = |&i: &usize| dense.params()[i].t <= 0.0;
    (0..dense.len())
        .filter(is_join)
        .flat_map(|i| {
            let before = dense
                .previous(i)
                .map(|j| (segment(curve, dense.params()[j]), 1.0));
            let after = Some((segment(curve, dense.params()[i]), 0.0));
            [before, after]
                .into_iter()
                .flatten()
                .map(move |side| (i, side))
        })
        .filter_map(|(i, (bezier, t))| {
            let radius = 1.0 / curvature(bezier, t);
            let left = bezier.derivative(t).normalize_or_zero().perp();
            let centre = dense.points()[i] + left * radius;
            let (_, distance) = tree.nearest(centre)?;
            (distance >= free * radius.abs()).then_some((i, centre))
        })
        .collect()
}
