//! Strokes that touch or cross, cut there into strands that do not.
//!
//! Where curves touch or cross, lfs is 0 with respect to all of them, and no reconstruction by
//! chains has three or four edges at a point. Cut a little short, strands can be sampled together:
//!
//! 1. Every stroke becomes points, an eighth of the gap apart. Two strokes, or two parts of one,
//!    touch where points of both are that near.
//! 2. Of two strokes that touch, the one that ends there is cut; if both or none do, the later one.
//! 3. The part around the place that is nearer to the other stroke than the gap is cut off. So
//!    strokes that lie on each other are drawn once.
//! 4. The other stroke runs through the place, which becomes an end of two of its pieces, hence a
//!    sample.
//!
//! Cost: O(n) for n points, by a grid, unless many strokes meet in one place.

mod touch;

use curvecrust_geometry::Component;
use glam::DVec2;

use crate::bezier_path::BezierPath;
use crate::error::CurveError;
use crate::split::SplitCurve;
use touch::{Dense, Touch};

/// How far strands end from the strokes that they touch, as a share of the extent of all.
const GAP: f64 = 0.01;

/// Strokes that have been cut where they touch or cross.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Strands {
    /// The strands, in the order of the strokes and along them.
    pub curve: SplitCurve,
    /// Where strokes touched or crossed: points of the strand that runs through.
    pub places: Vec<DVec2>,
    /// How near the other strands come to these places.
    pub gap: f64,
    /// Strands that were shorter than the gap, and are left out: a point of each.
    pub left_out: Vec<DVec2>,
}

/// Cuts strokes where they touch or cross, themselves or each other, as [this module](self) says.
///
/// # Errors
/// [`CurveError`] if nothing is left, or a part of a stroke is not sound by itself.
///
/// ```
/// use curvecrust_curve::{SplitCurve, strands};
///
/// let plus = SplitCurve::from_path_data("M 0 1 H 2 M 1 0 V 2")?;
/// let cut = strands(&plus)?;
/// assert_eq!((cut.curve.components().len(), cut.places.len()), (3, 1));
/// # Ok::<(), curvecrust_curve::CurveError>(())
/// ```
pub fn strands(split: &SplitCurve) -> Result<Strands, CurveError> {
    let gap = GAP * split.pieces().extent();
    let strokes = whole(split);
    let dense: Vec<Dense> = strokes.iter().map(|s| Dense::new(s, gap / 8.0)).collect();
    if dense.iter().map(|d| d.points.len()).sum::<usize>() > touch::POINTS {
        let what = "its strokes are too long to look for places where they touch: select some";
        return Err(CurveError::Unsupported { what: what.into() });
    }
    let (is_cut, touches) = touch::cut(&dense, gap);
    let mut cut = Cut {
        paths: Vec::new(),
        cuts: Vec::new(),
        left_out: Vec::new(),
    };
    for (index, (stroke, dense)) in strokes.iter().zip(&dense).enumerate() {
        let touches: Vec<&Touch> = touches.iter().filter(|t| t.stroke == index).collect();
        for run in runs(&is_cut[index], stroke.is_closed()) {
            cut.add(stroke, dense, run, &touches);
        }
    }
    Ok(Strands {
        curve: SplitCurve::cutting(&cut.paths, &cut.cuts)?,
        places: touches.iter().map(|touch| touch.at).collect(),
        gap,
        left_out: cut.left_out,
    })
}

/// The components as single paths.
fn whole(split: &SplitCurve) -> Vec<BezierPath> {
    let pieces = split.pieces().components();
    let path = |component: &Component| {
        let pieces = &pieces[component.range.clone()];
        let segments = pieces.iter().flat_map(BezierPath::segments).copied();
        BezierPath::new(segments.collect(), component.closed)
    };
    split.components().iter().map(path).collect()
}

/// The longest runs of points that are not cut off: the first of each, and how many gaps it has. A
/// closed stroke without a cut is one run of as many gaps as it has points.
fn runs(is_cut: &[bool], closed: bool) -> Vec<(usize, usize)> {
    let n = is_cut.len();
    let Some(first) = is_cut.iter().position(|&cut| cut) else {
        return vec![(0, if closed { n } else { n.saturating_sub(1) })];
    };
    let start = if closed { first } else { 0 };
    let mut runs = Vec::new();
    let mut open: Option<(usize, usize)> = None;
    for i in start..start + n {
        if is_cut[i % n] {
            runs.extend(open.take());
        } else {
            open = Some(open.map_or((i % n, 0), |(from, gaps)| (from, gaps + 1)));
        }
    }
    runs.extend(open);
    runs
}

/// Whether a place is where a closed stroke of `order` segments starts.
fn is_start((segment, t): (usize, f64), order: usize) -> bool {
    segment == 0 && t <= 0.0 || segment + 1 == order && t >= 1.0
}

/// What is left of strokes.
struct Cut {
    paths: Vec<BezierPath>,
    /// Where paths are cut into pieces: the path, and the segment that starts there.
    cuts: Vec<(usize, usize)>,
    left_out: Vec<DVec2>,
}

impl Cut {
    fn add(
        &mut self,
        stroke: &BezierPath,
        dense: &Dense,
        (from, gaps): (usize, usize),
        touches: &[&Touch],
    ) {
        let n = dense.points.len();
        let is_whole = stroke.is_closed() && gaps == n;
        if !is_whole && gaps < 8 {
            self.left_out.push(dense.points[from]);
            return;
        }
        let order = stroke.segments().len();
        let (start, end) = (dense.places[from], dense.places[(from + gaps) % n]);
        // Stops in units of segments from that of the start, each but the first with what it ends.
        let base = start.0 as f64;
        let ahead = |(segment, t): (usize, f64)| {
            let stop = segment as f64 + t;
            let is_before = stop < base + start.1;
            if is_before {
                stop + order as f64 - base
            } else {
                stop - base
            }
        };
        let last = if is_whole { order as f64 } else { ahead(end) };
        let mut stops: Vec<(f64, bool)> = touches
            .iter()
            .map(|touch| (ahead(touch.place), true))
            .filter(|(stop, _)| *stop > start.1 && *stop < last)
            .collect();
        stops.extend(
            (1..=order)
                .map(|k| (k as f64, false))
                .filter(|(k, _)| *k < last),
        );
        stops.push((last, false));
        stops.sort_by(|a, b| a.0.total_cmp(&b.0));
        let (mut segments, mut at) = (Vec::new(), start.1);
        let path = self.paths.len();
        for (stop, is_touch) in stops {
            // Places at joins, as far as numbers tell.
            if stop - at > 1e-9 {
                let whole = at.floor();
                #[expect(
                    clippy::cast_possible_truncation,
                    clippy::cast_sign_loss,
                    reason = "a number of segments"
                )]
                let index = (start.0 + whole as usize) % order;
                let segment = stroke.segments()[index];
                let (from, to) = (at - whole, (stop - whole).min(1.0));
                segments.push(if to - from >= 1.0 {
                    segment
                } else {
                    segment.part(from, to)
                });
                at = stop;
            }
            if is_touch && !segments.is_empty() {
                self.cuts.push((path, segments.len()));
            }
        }
        let count = segments.len();
        self.cuts
            .retain(|&(of, segment)| of != path || segment < count);
        // Parts end where the next start, but for rounding.
        for i in 1..count {
            let start = segments[i].start();
            segments[i - 1] = segments[i - 1].ending_at(start);
        }
        if is_whole && touches.iter().any(|touch| is_start(touch.place, order)) {
            self.cuts.push((path, 0));
        }
        if is_whole
            && let (Some(first), Some(last)) = (segments.first().copied(), segments.last_mut())
        {
            *last = last.ending_at(first.start());
        }
        self.paths.push(BezierPath::new(segments, is_whole));
    }
}
