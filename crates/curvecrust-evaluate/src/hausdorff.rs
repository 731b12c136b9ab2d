//! The Hausdorff distance between a polygon and the smooth curve it stands for.
//!
//! The distance from curve to polygon is the supremum, over all points of the curve, of the distance
//! to the nearest point of the polygon; the other direction likewise. Neither is attained at
//! vertices only, so vertices alone would bound it from below and nothing more. Here both ends of
//! the answer are known: segments are halved until no part that could exceed the lower bound by
//! more than the tolerance is left.
//!
//! Cost: near-linear in edges and Béziers for a tolerance that is a fixed share of the distance.

use std::cmp::Ordering;
use std::collections::BinaryHeap;

use curvecrust_curve::{CubicBezier, Curve};
use curvecrust_geometry::{EdgeSet, PointSet, Segment, SegmentTree};

/// A number that is known to lie between two others.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bounds {
    /// It is at least this.
    pub lower: f64,
    /// It is at most this.
    pub upper: f64,
}

/// The two directed distances. Both are infinite when the polygon has no edge.
#[derive(Clone, Copy, Debug, PartialEq)]
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
/// ```
/// use curvecrust_curve::Curve;
/// use curvecrust_evaluate::hausdorff;
/// use curvecrust_geometry::{DVec2, Edge, EdgeSet, PointSet};
///
/// // A half circle of radius 1, and the chord that joins its ends: the vertices of the chord lie on
/// // the curve, yet the curve rises 1 above it.
/// let curve = Curve::from_path_data("M -1 0 A 1 1 0 0 1 1 0")?;
/// let points = PointSet::new(vec![DVec2::new(-1.0, 0.0), DVec2::new(1.0, 0.0)])?;
/// let ids: Vec<_> = points.ids().collect();
/// let chord = EdgeSet::new(2, Edge::new(ids[0], ids[1]));
/// let found = hausdorff(&curve, &points, &chord, 1e-4);
/// assert!(found.curve_to_polygon.lower < 1.0 && 1.0 < found.curve_to_polygon.upper + 1e-3);
/// assert!(found.curve_to_polygon.upper - found.curve_to_polygon.lower < 3e-4);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[must_use]
pub fn hausdorff(curve: &Curve, points: &PointSet, edges: &EdgeSet, tolerance: f64) -> Hausdorff {
    let tolerance = tolerance.max(1e-7 * curve.extent());
    // The chords are this near to the curve, and the curve to them.
    let flatness = tolerance / 4.0;
    let chords: Vec<Segment> = curve
        .components()
        .iter()
        .flat_map(|component| component.segments())
        .flat_map(|bezier| flattened(bezier, flatness))
        .collect();
    let polygon: Vec<Segment> = edges
        .edges()
        .iter()
        .filter(|edge| edge.b().index() < points.len())
        .map(|edge| Segment::new(points[edge.a()], points[edge.b()]))
        .collect();
    let between = |from: &[Segment], to: &[Segment]| {
        let found = directed(from, &SegmentTree::new(to.iter().copied()), tolerance);
        Bounds {
            lower: (found.lower - flatness).max(0.0),
            upper: found.upper + flatness,
        }
    };
    if polygon.is_empty() {
        let none = Bounds {
            lower: f64::INFINITY,
            upper: f64::INFINITY,
        };
        return Hausdorff {
            curve_to_polygon: none,
            polygon_to_curve: none,
        };
    }
    Hausdorff {
        curve_to_polygon: between(&chords, &polygon),
        polygon_to_curve: between(&polygon, &chords),
    }
}

/// Chords at equal steps of the parameter, so many that none is farther than `flatness` from its
/// arc: the chord of a step h deviates by at most h^2 / 8 times the largest second derivative, which
/// is linear along a cubic.
fn flattened(bezier: &CubicBezier, flatness: f64) -> impl Iterator<Item = Segment> + '_ {
    let bend = bezier
        .second_derivative(0.0)
        .length()
        .max(bezier.second_derivative(1.0).length());
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "clamped"
    )]
    let steps = (bend / (8.0 * flatness)).sqrt().ceil().clamp(1.0, 1e6) as u32;
    let at = move |i: u32| bezier.point(f64::from(i) / f64::from(steps));
    (0..steps).map(move |i| Segment::new(at(i), at(i + 1)))
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
    let nearest = |p| to.nearest(p).unwrap_or((Segment::new(p, p), f64::INFINITY));
    let mut lower = 0.0f64;
    let mut parts: BinaryHeap<Part> = from
        .iter()
        .map(|&segment| {
            let nearest = [nearest(segment.a), nearest(segment.b)];
            lower = lower.max(nearest[0].1).max(nearest[1].1);
            Part::new(segment, nearest)
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
        let at_middle = nearest(middle);
        lower = lower.max(at_middle.1);
        let [at_a, at_b] = part.nearest;
        parts.push(Part::new(Segment::new(a, middle), [at_a, at_middle]));
        parts.push(Part::new(Segment::new(middle, b), [at_middle, at_b]));
    }
    Bounds {
        lower,
        upper: lower,
    }
}
