//! Curves with corners, split there into smooth pieces.
//!
//! A curve with a corner has local feature size 0 there, and no finite sampling. Its pieces are
//! smooth curves each, which meet at their ends.

use curvecrust_geometry::Component;
use glam::DVec2;

use crate::bezier::{CubicBezier, bounds};
use crate::bezier_path::BezierPath;
use crate::curve::{Curve, checked};
use crate::error::{Corner, CurveError};
use crate::path_data;
use crate::svg::Drawing;

/// Curves that may have corners, as smooth pieces.
///
/// # Guarantees
/// - The pieces are smooth as a [`Curve`] is. A component without a corner is one piece; of the
///   others, each piece starts where the one before it ends, bit by bit.
/// - A closed component with corners has three pieces at least: one with a single corner, or two,
///   is cut again where pieces have half of their length, into four.
///
/// ```
/// use curvecrust_curve::SplitCurve;
///
/// let split = SplitCurve::from_path_data("M 0 0 H 4 A 1 1 0 0 1 4 2 H 0 Z")?;
/// assert_eq!((split.pieces().components().len(), split.corners().len()), (4, 2));
/// assert_eq!(split.components()[0].range, 0..4);
/// # Ok::<(), curvecrust_curve::CurveError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct SplitCurve {
    pieces: Curve,
    components: Vec<Component>,
    corners: Vec<Corner>,
    snapped: Vec<DVec2>,
    is_apart: bool,
}

impl SplitCurve {
    /// Segments that are no longer than this share of the extent of all components are rounding
    /// errors of drawing programs: they are left out, and what they join is joined without them.
    /// Open components whose ends are no farther apart are closed.
    pub const SNAP: f64 = 1e-4;

    /// Splits components at their corners, after joining gaps of rounding errors
    /// ([`SNAP`](Self::SNAP)).
    ///
    /// # Errors
    /// Those of [`Curve::new`] other than [`CurveError::Corners`]. A cusp inside a segment stays an
    /// error: the radius of curvature goes to 0 towards it, and with it the local feature size of
    /// the pieces.
    pub fn new(components: Vec<BezierPath>) -> Result<Self, CurveError> {
        Self::snapping(components, Self::SNAP)
    }

    /// [`new`](Self::new) with another share than [`SNAP`](Self::SNAP), 0 for none.
    ///
    /// # Errors
    /// Those of [`new`](Self::new).
    pub fn snapping(components: Vec<BezierPath>, share: f64) -> Result<Self, CurveError> {
        let (low, high) = bounds(components.iter().flat_map(BezierPath::segments));
        let tolerance = share * (high - low).max_element();
        let mut snapped = Vec::new();
        let join = |path: BezierPath| {
            if tolerance > 0.0 {
                let (path, places) = path.snapped(tolerance);
                snapped.extend(places);
                path
            } else {
                path
            }
        };
        let components: Vec<BezierPath> = components.into_iter().map(join).collect();
        let split = Self::cutting(&components, &[])?;
        Ok(Self { snapped, ..split })
    }

    /// Splits components at their corners, and where the given segments start: each by the index of
    /// its component and its own.
    pub(crate) fn cutting(
        components: &[BezierPath],
        cuts: &[(usize, usize)],
    ) -> Result<Self, CurveError> {
        let (components, corners) = checked(components)?;
        let (mut pieces, mut split) = (Vec::new(), Vec::with_capacity(components.len()));
        for (index, component) in components.into_iter().enumerate() {
            let first = pieces.len();
            let closed = component.is_closed();
            let here = corners.iter().filter(|c| c.component == index);
            let cuts = cuts.iter().filter(|(component, _)| *component == index);
            let mut starts: Vec<usize> = here.map(|c| c.segment).collect();
            starts.extend(cuts.map(|&(_, segment)| segment));
            starts.sort_unstable();
            starts.dedup();
            if starts.is_empty() {
                pieces.push(component);
            } else {
                pieces.extend(cut(component.segments(), closed, &starts));
            }
            let range = first..pieces.len();
            split.push(Component { range, closed });
        }
        Ok(Self {
            pieces: Curve::of_pieces(pieces),
            components: split,
            corners,
            snapped: Vec::new(),
            is_apart: false,
        })
    }

    /// As [`Curve::from_path_data`], but split at corners.
    ///
    /// # Errors
    /// [`CurveError::PathData`], or what [`SplitCurve::new`] finds.
    pub fn from_path_data(d: &str) -> Result<Self, CurveError> {
        Self::new(path_data::drawn(d)?)
    }

    /// As [`Curve::from_svg`], but split at corners.
    ///
    /// # Errors
    /// Those of [`Curve::from_svg`], but for [`CurveError::Corners`].
    pub fn from_svg(document: &str) -> Result<Self, CurveError> {
        Self::from_drawing(&Drawing::new(document)?, Self::SNAP)
    }

    /// The strokes of a drawing, split at corners, with gaps up to a share of the extent joined, as
    /// by [`snapping`](Self::snapping).
    ///
    /// # Errors
    /// Those of [`new`](Self::new), which name the element.
    pub fn from_drawing(drawing: &Drawing, share: f64) -> Result<Self, CurveError> {
        let split = Self::snapping(drawing.components().to_vec(), share);
        split.map_err(|error| drawing.with_element(error))
    }

    /// The same curves with each component on its own: lfs takes no account of the others. So they
    /// may touch and cross, where lfs with respect to all of them is 0.
    ///
    /// ```
    /// use curvecrust_curve::SplitCurve;
    ///
    /// let plus = SplitCurve::from_path_data("M 0 1 H 2 M 1 0 V 2")?.apart();
    /// assert_eq!(plus.smooth_parts().len(), 2);
    /// # Ok::<(), curvecrust_curve::CurveError>(())
    /// ```
    #[must_use]
    pub fn apart(self) -> Self {
        Self {
            is_apart: true,
            ..self
        }
    }

    /// Whether each component is [on its own](Self::apart).
    #[must_use]
    pub fn is_apart(&self) -> bool {
        self.is_apart
    }

    /// Whether a piece counts for the lfs of another one: not where components are
    /// [apart](Self::apart) and these are of two.
    #[must_use]
    pub fn sees(&self, piece: usize, other: usize) -> bool {
        let here = self.component_of(piece);
        !self.is_apart || here.is_some_and(|component| component.contains(other))
    }

    /// Where gaps of rounding errors were joined, in the order of the components.
    #[must_use]
    pub fn snapped(&self) -> &[DVec2] {
        &self.snapped
    }

    /// The pieces, each a component; they touch where they meet.
    #[must_use]
    pub fn pieces(&self) -> &Curve {
        &self.pieces
    }

    /// The components, in the order in which they were given: each is the range of its pieces, in
    /// order along it.
    #[must_use]
    pub fn components(&self) -> &[Component] {
        &self.components
    }

    /// Whether each component is one piece: it has no corner, and was not cut where strokes touch.
    ///
    /// ```
    /// use curvecrust_curve::SplitCurve;
    ///
    /// assert!(SplitCurve::from_path_data("M 0 0 H 4")?.is_smooth());
    /// assert!(!SplitCurve::from_path_data("M 0 0 H 4 V 2")?.is_smooth());
    /// # Ok::<(), curvecrust_curve::CurveError>(())
    /// ```
    #[must_use]
    pub fn is_smooth(&self) -> bool {
        self.pieces.components().len() == self.components.len()
    }

    /// The corners, in the order of the curve; their segments are those of the components as given.
    #[must_use]
    pub fn corners(&self) -> &[Corner] {
        &self.corners
    }

    /// The component that a piece belongs to; `None` if there is no such piece.
    #[must_use]
    pub fn component_of(&self, piece: usize) -> Option<&Component> {
        self.components.iter().find(|c| c.contains(piece))
    }

    /// What is smooth by itself: the components without a corner, all together unless they are
    /// [apart](Self::apart), and each piece of the others; each part with the indices of its
    /// pieces.
    #[must_use]
    pub fn smooth_parts(&self) -> Vec<(Vec<usize>, Curve)> {
        let (whole, cut): (Vec<_>, Vec<_>) = self
            .components
            .iter()
            .map(|c| c.range.clone())
            .partition(|pieces| pieces.len() == 1);
        let whole: Vec<usize> = whole.into_iter().flatten().collect();
        let together = match self.is_apart {
            true => whole.into_iter().map(|piece| vec![piece]).collect(),
            false => vec![whole],
        };
        let alone = cut.into_iter().flatten().map(|piece| vec![piece]);
        let parts = together.into_iter().chain(alone);
        let curve = |pieces: &[usize]| {
            let components = pieces.iter().map(|&i| self.pieces.components()[i].clone());
            Curve::of_pieces(components.collect())
        };
        let parts = parts.filter(|pieces| !pieces.is_empty());
        let with_curve = |pieces: Vec<usize>| {
            let curve = curve(&pieces);
            (pieces, curve)
        };
        parts.map(with_curve).collect()
    }

    /// Where a piece meets others of its component: at its start, at its end, each with the index
    /// of the piece there.
    #[must_use]
    pub fn meetings(&self, piece: usize) -> [Option<(usize, DVec2)>; 2] {
        let Some(component) = self.component_of(piece) else {
            return [None; 2];
        };
        let segments = self.pieces.components()[piece].segments();
        let (Some(first), Some(last)) = (segments.first(), segments.last()) else {
            return [None; 2];
        };
        if component.len() == 1 {
            return [None; 2];
        }
        let (before, after) = (component.previous(piece), component.next(piece));
        [
            before.map(|i| (i, first.start())),
            after.map(|i| (i, last.end())),
        ]
    }
}

/// Each component is a piece.
impl From<Curve> for SplitCurve {
    fn from(pieces: Curve) -> Self {
        let component = |(index, path): (usize, &BezierPath)| Component {
            range: index..index + 1,
            closed: path.is_closed(),
        };
        Self {
            components: pieces
                .components()
                .iter()
                .enumerate()
                .map(component)
                .collect(),
            pieces,
            corners: Vec::new(),
            snapped: Vec::new(),
            is_apart: false,
        }
    }
}

/// The pieces of a component between corners, which are where the segments in `starts` start.
fn cut(segments: &[CubicBezier], closed: bool, starts: &[usize]) -> Vec<BezierPath> {
    let first = if closed { starts[0] } else { 0 };
    let turned = [&segments[first..], &segments[..first]].concat();
    let mut cuts: Vec<usize> = starts.iter().map(|s| s - first).collect();
    if !closed {
        cuts.insert(0, 0);
    }
    let ends = cuts.iter().skip(1).copied().chain([turned.len()]);
    let parts = cuts.iter().zip(ends);
    let mut pieces: Vec<Vec<CubicBezier>> =
        parts.map(|(&from, to)| turned[from..to].to_vec()).collect();
    while closed && pieces.len() < 3 {
        pieces = pieces.iter().flat_map(|piece| halves(piece)).collect();
    }
    let open = pieces
        .into_iter()
        .map(|piece| BezierPath::new(piece, false));
    open.collect()
}

/// A chain of segments in two, cut in the middle of the segment that has half of the length before
/// it, by the lengths of control polygons.
fn halves(segments: &[CubicBezier]) -> [Vec<CubicBezier>; 2] {
    let length = |s: &CubicBezier| s.arms().iter().map(|arm| arm.length()).sum::<f64>();
    let half = segments.iter().map(length).sum::<f64>() / 2.0;
    let mut before = 0.0;
    let middle = segments.iter().position(|s| {
        before += length(s);
        before >= half
    });
    let middle = middle.unwrap_or(0);
    let [left, right] = segments[middle].halves();
    let first = segments[..middle].iter().copied().chain([left]);
    let second = [right]
        .into_iter()
        .chain(segments[middle + 1..].iter().copied());
    [first.collect(), second.collect()]
}
