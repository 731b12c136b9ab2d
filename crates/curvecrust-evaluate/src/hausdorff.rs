//! The Hausdorff distance between a polygon and the smooth curve it stands for.
//!
//! The distance from curve to polygon is the supremum, over all points of the curve, of the
//! distance to the nearest point of the polygon; the other direction likewise. Neither is attained
//! at vertices only, so vertices alone would bound it from below and nothing more. Here both ends
//! of the answer are known: segments are halved until no part that could exceed the lower bound by
//! more than the tolerance is left.
//!
//! Cost: near-linear in edges and Béziers for a tolerance that is a fixed share of the distance.

use std::cmp::Ordering;
use std::collections::BinaryHeap;

use curvecrust_curve::Curve;
use curvecrust_geometry::{DVec2, EdgeSet, PointSet, Segment, SegmentTree};

use crate::bounds::Bounds;
use crate::reference::{Polygon, Reference};

/// The two directed distances. Both are infinite when the polygon has no edge.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Hausdorff {
    /// The largest distance of a point of the curve to the polygon: how much of it was missed.
    pub curve_to_polygon: Bounds,
    /// The largest distance of a point of the polygon to the curve: how far it strays.
    pub polygon_to_curve: Bounds,
}

impl Hausdorff {
    /// The Hausdorff distance: the larger of the two.
    #[must_use]
    pub fn distance(self) -> Bounds {
        let (c, p) = (self.curve_to_polygon, self.polygon_to_curve);
        Bounds {
            lower: c.lower.max(p.lower),
            upper: c.upper.max(p.upper),
        }
    }
}

/// The Hausdorff distance between a curve and the edges of a reconstruction, with bounds about
/// `tolerance` apart: a length in the unit of the curve; 1e-4 of its extent is a fair choice. It is
/// taken as at least 1e-7 of the extent.
///
/// For many reconstructions of one curve, [`Reference::distances`] prepares the curve once.
///
/// ```
/// use curvecrust_curve::Curve;
/// use curvecrust_evaluate::hausdorff;
/// use curvecrust_geometry::{DVec2, Edge, EdgeSet, PointSet};
///
/// // An arc, and the chord that joins its ends.
/// let curve = Curve::from_path_data("M -1 0 C -1 2 1 2 1 0")?;
/// let ends = [DVec2::new(-1.0, 0.0), DVec2::new(1.0, 0.0)];
/// let points = PointSet::new(ends.to_vec())?;
/// let ids: Vec<_> = points.ids().collect();
/// let chord = EdgeSet::new(2, Edge::new(ids[0], ids[1]));
///
/// // A distance of vertices only, as some libraries have it, sees nothing: the vertices of the
/// // curve and of the polygon are the same.
/// let beziers = curve.components()[0].segments().iter();
/// let vertices: Vec<DVec2> = beziers.flat_map(|bezier| [bezier.start(), bezier.end()]).collect();
/// let farthest = |from: &[DVec2], to: &[DVec2]| {
///     let nearest = |p: &DVec2| to.iter().map(|q| p.distance(*q)).fold(f64::INFINITY, f64::min);
///     from.iter().map(nearest).fold(0.0, f64::max)
/// };
/// assert_eq!(farthest(&vertices, &ends).max(farthest(&ends, &vertices)), 0.0);
///
/// // Yet the arc rises 1.5 above the chord.
/// let found = hausdorff(&curve, &points, &chord, 1e-4).distance();
/// assert!(found.lower <= 1.5 && 1.5 <= found.upper && found.upper - found.lower < 3e-4);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[must_use]
pub fn hausdorff(curve: &Curve, points: &PointSet, edges: &EdgeSet, tolerance: f64) -> Hausdorff {
    let tolerance = tolerance.max(1e-7 * curve.extent());
    let reference = Reference::of_curve(curve, tolerance / 4.0);
    between(&reference, &Polygon::new(points, edges), tolerance)
}

/// The two directed distances, each with bounds `tolerance` and twice the flatness apart.
pub(crate) fn between(reference: &Reference, polygon: &Polygon, tolerance: f64) -> Hausdorff {
    let widened = |found: Bounds| Bounds {
        lower: (found.lower - reference.flatness()).max(0.0),
        upper: found.upper + reference.flatness(),
    };
    if polygon.sides.is_empty() {
        return Hausdorff {
            curve_to_polygon: Bounds::exactly(f64::INFINITY),
            polygon_to_curve: Bounds::exactly(f64::INFINITY),
        };
    }
    let curve_to_polygon = directed(reference.chords(), &polygon.tree, tolerance);
    let polygon_to_curve = directed(&polygon.sides, reference.tree(), tolerance);
    Hausdorff {
        curve_to_polygon: widened(curve_to_polygon),
        polygon_to_curve: widened(polygon_to_curve),
    }
}

/// A part of a segment, and how far it can be from the target at most.
struct Part {
    segment: Segment,
    /// Upper bound of the distance of its points.
    upper: f64,
    /// The nearest target segment of each end, and its distance.
    nearest: [(Segment, f64); 2],
}

impl Part {
    fn new(segment: Segment, nearest: [(Segment, f64); 2]) -> Self {
        let [(near_a, a), (near_b, b)] = nearest;
        // Distance is 1-Lipschitz; and the distance to one segment, a convex set, is convex.
        let lipschitz = f64::midpoint(a, b) + 0.5 * segment.length();
        let upper = lipschitz
            .min(a.max(near_a.distance(segment.b)))
            .min(b.max(near_b.distance(segment.a)));
        Self {
            segment,
            upper,
            nearest,
        }
    }
}

impl PartialEq for Part {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other).is_eq()
    }
}

impl Eq for Part {}

impl PartialOrd for Part {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Part {
    fn cmp(&self, other: &Self) -> Ordering {
        self.upper.total_cmp(&other.upper)
    }
}

/// The largest distance of a point of `from` to the nearest of `to`, by branch and bound.
fn directed(from: &[Segment], to: &SegmentTree, tolerance: f64) -> Bounds {
    let none = |p| (Segment::new(p, p), f64::INFINITY);
    let mut lower = 0.0f64;
    // Segments mostly start where the one before ends: its answer is a good guess, or the answer.
    let mut last: Option<(DVec2, (Segment, f64))> = None;
    let mut parts: BinaryHeap<Part> = from
        .iter()
        .map(|&segment| {
            let at = |p, last| match last {
                Some((at, found)) if at == p => found,
                Some((_, (near, _))) => to.nearest_after(p, near).unwrap_or(none(p)),
                None => to.nearest(p).unwrap_or(none(p)),
            };
            let at_a = at(segment.a, last);
            let at_b = at(segment.b, Some((segment.a, at_a)));
            last = Some((segment.b, at_b));
            lower = lower.max(at_a.1).max(at_b.1);
            Part::new(segment, [at_a, at_b])
        })
        .collect();
    while let Some(part) = parts.pop() {
        if part.upper <= lower + tolerance {
            return Bounds {
                lower,
                upper: part.upper.max(lower),
            };
        }
        let Segment { a, b } = part.segment;
        let middle = a.midpoint(b);
        let [at_a, at_b] = part.nearest;
        let at_middle = to.nearest_after(middle, at_a.0).unwrap_or(none(middle));
        lower = lower.max(at_middle.1);
        parts.push(Part::new(Segment::new(a, middle), [at_a, at_middle]));
        parts.push(Part::new(Segment::new(middle, b), [at_middle, at_b]));
    }
    Bounds {
        lower,
        upper: lower,
    }
}
