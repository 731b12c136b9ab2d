//! The true curve, prepared once for many reconstructions of it.

use curvecrust_curve::{CubicBezier, Curve};
use curvecrust_geometry::{DVec2, EdgeSet, PointSet, Segment, SegmentTree};

/// A curve as chords near to it, ready for [distances](Self::distances).
///
/// ```
/// use curvecrust_evaluate::Reference;
/// use curvecrust_geometry::{DVec2, Edge, EdgeSet, PointSet, Segment};
///
/// // The true curve is a segment; what was found is a parallel one.
/// let truth = Reference::of_segments([Segment::new(DVec2::ZERO, DVec2::new(8.0, 0.0))]);
/// let points = PointSet::new(vec![DVec2::new(0.0, 0.5), DVec2::new(8.0, 0.5)])?;
/// let ids: Vec<_> = points.ids().collect();
/// let found = truth.distances(&points, &EdgeSet::new(2, Edge::new(ids[0], ids[1])), 1e-3);
/// assert_eq!(found.hausdorff.distance().lower, 0.5);
/// assert!(found.rms.curve_to_polygon.lower < 0.5 && 0.5 < found.rms.curve_to_polygon.upper);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct Reference {
    chords: Vec<Segment>,
    tree: SegmentTree,
    flatness: f64,
    extent: f64,
}

impl Reference {
    /// A smooth curve, by chords no farther than `flatness` from their arcs: a length in the unit
    /// of the curve, which is part of all bounds; taken as at least 1e-8 of the extent.
    #[must_use]
    pub fn of_curve(curve: &Curve, flatness: f64) -> Self {
        let flatness = flatness.max(1e-8 * curve.extent());
        let beziers = curve
            .components()
            .iter()
            .flat_map(|component| component.segments());
        let chords = beziers.flat_map(|bezier| flattened(bezier, flatness));
        Self {
            flatness,
            ..Self::of_segments(chords)
        }
    }

    /// A curve that consists of segments.
    #[must_use]
    pub fn of_segments(segments: impl IntoIterator<Item = Segment>) -> Self {
        let chords: Vec<Segment> = segments.into_iter().collect();
        let ends = || chords.iter().flat_map(|chord| [chord.a, chord.b]);
        let low = ends().fold(DVec2::INFINITY, DVec2::min);
        let high = ends().fold(DVec2::NEG_INFINITY, DVec2::max);
        Self {
            tree: SegmentTree::new(chords.iter().copied()),
            flatness: 0.0,
            extent: (high - low).max_element().max(0.0),
            chords,
        }
    }

    /// The larger side of the bounding box, up to the flatness; 0 without a segment.
    #[must_use]
    pub fn extent(&self) -> f64 {
        self.extent
    }

    pub(crate) fn chords(&self) -> &[Segment] {
        &self.chords
    }

    pub(crate) fn tree(&self) -> &SegmentTree {
        &self.tree
    }

    pub(crate) fn flatness(&self) -> f64 {
        self.flatness
    }
}

/// The edges of a reconstruction as segments.
pub(crate) struct Polygon {
    pub(crate) sides: Vec<Segment>,
    pub(crate) tree: SegmentTree,
}

impl Polygon {
    pub(crate) fn new(points: &PointSet, edges: &EdgeSet) -> Self {
        let inside = |edge: &&curvecrust_geometry::Edge| edge.b().index() < points.len();
        let sides: Vec<Segment> = edges
            .edges()
            .iter()
            .filter(inside)
            .map(|edge| Segment::new(points[edge.a()], points[edge.b()]))
            .collect();
        Self {
            tree: SegmentTree::new(sides.iter().copied()),
            sides,
        }
    }
}

/// Chords at equal steps of the parameter, so many that none is farther than `flatness` from its
/// arc: the chord of a step h deviates by at most h^2 / 8 times the largest second derivative,
/// which is linear along a cubic.
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
