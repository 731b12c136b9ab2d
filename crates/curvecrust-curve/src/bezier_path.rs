//! Paths of cubic Béziers, and the rule by which a subpath of SVG is closed.

use glam::DVec2;

use crate::bezier::{CubicBezier, bounds};

/// Cubic Béziers that follow each other, open or closed: a connected component of a curve.
///
/// By itself a plain value; [`Curve::new`](crate::Curve::new) checks it.
#[derive(Clone, Debug, PartialEq)]
pub struct BezierPath {
    segments: Vec<CubicBezier>,
    closed: bool,
}

/// Ends that are nearer than this fraction of the extent of their subpath meet.
const CLOSING_GAP: f64 = 1e-6;

impl BezierPath {
    /// The path of the given segments; in a closed one the last has to end where the first starts.
    ///
    /// Segments whose four control points are equal draw nothing and are left out.
    #[must_use]
    pub fn new(mut segments: Vec<CubicBezier>, closed: bool) -> Self {
        segments.retain(|s| !s.is_point());
        Self { segments, closed }
    }

    /// A subpath of SVG, which is closed by `Z`, or when its ends meet within 1e-6 of its extent.
    pub(crate) fn from_subpath(segments: Vec<CubicBezier>, z: bool) -> Self {
        let mut path = Self::new(segments, z);
        let segments = &mut path.segments;
        let (low, high) = bounds(segments.iter());
        let (Some(first), Some(last)) = (segments.first().copied(), segments.last_mut()) else {
            return path;
        };
        let gap = first.start() - last.end();
        if gap.length() <= CLOSING_GAP * (high - low).max_element() {
            *last = last.ending_at(first.start());
            path.closed = true;
        } else if z {
            let closing = CubicBezier::line(last.end(), first.start());
            segments.push(closing);
        }
        path
    }

    /// The path without segments that are no longer than a tolerance, and closed if its ends are no
    /// farther apart; with the places that were joined so. The segment before such a gap ends where
    /// the next one starts. A path that is as short as a whole stays as it is.
    pub(crate) fn snapped(self, tolerance: f64) -> (Self, Vec<DVec2>) {
        let length = |s: &CubicBezier| s.arms().iter().map(|arm| arm.length()).sum::<f64>();
        let is_crumb = |s: &CubicBezier| length(s) <= tolerance;
        let mut kept: Vec<CubicBezier> = self.segments.clone();
        kept.retain(|s| !is_crumb(s));
        let (Some(first), Some(last)) = (kept.first(), kept.last()) else {
            return (self, Vec::new());
        };
        let closed =
            self.closed || kept.len() > 1 && first.start().distance(last.end()) <= tolerance;
        let mut places = Vec::new();
        for index in 0..kept.len() {
            let next = match kept.get(index + 1) {
                Some(next) => next.start(),
                None if closed => kept[0].start(),
                None => break,
            };
            if kept[index].end() != next {
                kept[index] = kept[index].ending_at(next);
                places.push(next);
            }
        }
        (Self::new(kept, closed), places)
    }

    /// The segments, in order along the path.
    #[must_use]
    pub fn segments(&self) -> &[CubicBezier] {
        &self.segments
    }

    /// Whether the end of the last segment is the start of the first.
    #[must_use]
    pub fn is_closed(&self) -> bool {
        self.closed
    }

    pub(crate) fn map(&self, f: impl Fn(DVec2) -> DVec2) -> Self {
        let segments = self.segments.iter().map(|s| s.map(&f)).collect();
        Self::new(segments, self.closed)
    }
}
