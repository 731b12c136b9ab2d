//! The local feature size of the smooth pieces of curves with corners.
//!
//! With respect to the whole curve, lfs goes to 0 at a corner. With respect to one piece alone, lfs
//! ignores what else is near. The value at a point p of a piece is the smallest of these:
//!
//! 1. The lfs with respect to the smooth part: the piece, or all components without corners.
//! 2. Half of the distance to every other piece. Let m be the point nearest to p on the medial axis
//!    of this piece and that one. Its closest points are no farther from m than p is, so p is at
//!    most 2 |pm| from that piece: half of the distance is a lower bound of lfs. Between parallel
//!    lines it is equal to lfs.
//!
//! A piece that meets this one in a corner c counts only where it comes nearer to p than sin 60°
//! |pc|; straight arms that meet at 60° or more never do. Where they meet at a smaller angle a, it
//! counts where it comes nearer than 0.9 sin a |pc|, which straight arms never do either, and lfs
//! is at most half of the length of each arm, so that straight ones get samples. This exception
//! keeps lfs above 0 at a corner, and theory ends there: the theorems on epsilon- and rho-samples
//! hold for smooth curves, hence for every piece by itself. Whether a reconstruction gets round the
//! corner is to be seen by running it.
//!
//! Where components are [apart](SplitCurve::apart), those of other components do not count.
//!
//! The values are made 1-Lipschitz along each piece, as every lfs is. Cost: for n pieces,
//! O(n^2 log n) in their boxes besides what the pieces cost by themselves.

use curvecrust_curve::{CurveParam, DenseCurve, SplitCurve};
use curvecrust_geometry::{Component, DVec2, Progress, SegmentTree};

use crate::axis::MedialAxis;
use crate::crossing::chord;
use crate::discretise::GAP_TO_LFS;
use crate::error::MedialAxisError;
use crate::gaps::GapLimits;
use crate::lfs::LocalFeatureSize;
use crate::measured_curve::MeasuredCurve;
use crate::refine::{TOUCHING, refine_axis, settle};

/// HNN-Crust joins no edges that meet at this angle or less, in degrees (SGP 2016, Section 3).
const LEAST_ANGLE: f64 = 60.0;
/// Its sine.
const SINE: f64 = 0.866_025_403_784_438_6;

/// Below this share of the distance between straight arms, arms of a sharper corner are near.
const SHARP: f64 = 0.9;

/// How [`measure_pieces_with`] goes about it.
#[derive(Clone, Copy, Debug)]
pub struct MeasurePiecesOptions<'a> {
    /// The largest gap between dense points as a fraction of the lfs at both, above 0 and at most
    /// 1; 0.02 by default.
    pub gap_to_lfs: f64,
    /// Where these gaps would make more than 250,000 dense points of one smooth part, gaps grow up
    /// to this fraction of lfs, if it is the larger one; 0 by default, which keeps them.
    pub gap_to_lfs_of_many: f64,
    /// Hears how many smooth parts have their medial axis, of how many.
    pub progress: Progress<'a>,
}

impl Default for MeasurePiecesOptions<'_> {
    fn default() -> Self {
        Self {
            gap_to_lfs: GAP_TO_LFS,
            gap_to_lfs_of_many: 0.0,
            progress: Progress::default(),
        }
    }
}

/// Discretises the pieces of a curve so that no gap is longer than 0.02 of the lfs of its ends,
/// as [this module](self) defines it. The components of the dense curve are the
/// [pieces](SplitCurve::pieces), so that the point at a corner is there twice.
///
/// Without corners it is [`measure`](crate::measure()).
///
/// # Errors
/// Those of [`measure`](crate::measure) for each smooth part;
/// [`Touching`](MedialAxisError::Touching) where two pieces come too near to tell, other than in
/// their corner.
///
/// ```
/// use curvecrust_curve::SplitCurve;
/// use curvecrust_medial_axis::measure_pieces;
///
/// // A bar of 10 by 1: half of its width is the lfs of its long sides.
/// let bar = SplitCurve::from_path_data("M 0 0 H 10 V 1 H 0 Z")?;
/// let measured = measure_pieces(&bar)?;
/// assert_eq!(measured.dense().components().len(), 4);
/// assert!((measured.lfs().minimum() - 0.5).abs() < 1e-9);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn measure_pieces(split: &SplitCurve) -> Result<MeasuredCurve, MedialAxisError> {
    measure_pieces_with(split, &MeasurePiecesOptions::default())
}

/// [`measure_pieces`] by the given [options](MeasurePiecesOptions).
///
/// # Errors
/// Those of [`measure_pieces`], and [`GapToLfs`](MedialAxisError::GapToLfs).
pub fn measure_pieces_with(
    split: &SplitCurve,
    options: &MeasurePiecesOptions<'_>,
) -> Result<MeasuredCurve, MedialAxisError> {
    let MeasurePiecesOptions {
        gap_to_lfs,
        gap_to_lfs_of_many,
        progress,
    } = *options;
    let gaps = GapLimits::new(gap_to_lfs, gap_to_lfs_of_many)?;
    let smooth = split.smooth_parts();
    let total = smooth.len();
    let mut parts = Vec::with_capacity(total);
    for (pieces, curve) in smooth {
        progress.report(parts.len(), total);
        let (axis, measured) = refine_axis(&curve, gaps, Progress::default())?;
        parts.push(Part {
            pieces,
            curve,
            axis,
            measured,
        });
    }
    progress.report(total, total);
    let least = TOUCHING * split.pieces().extent();
    let mut points = 0;
    loop {
        let outlines = outlines(split, &parts);
        for part in &mut parts {
            part.settle(split, &outlines, gaps, least)?;
        }
        // With the points of the outlines, distances to them have settled.
        let now = parts.iter().map(|part| part.measured.dense().len()).sum();
        if now == points {
            return assembled(split, &parts);
        }
        points = now;
    }
}

/// What is smooth by itself.
struct Part {
    /// The pieces that are its components.
    pieces: Vec<usize>,
    curve: curvecrust_curve::Curve,
    axis: MedialAxis,
    measured: MeasuredCurve,
}

/// A piece as others see it.
struct Outline {
    low: DVec2,
    high: DVec2,
    chords: SegmentTree,
}

impl Outline {
    /// A lower bound of the distance between points of two pieces.
    fn distance_of_boxes(&self, other: &Self) -> f64 {
        let apart = (self.low - other.high).max(other.low - self.high);
        apart.max(DVec2::ZERO).length()
    }
}

fn outlines(split: &SplitCurve, parts: &[Part]) -> Vec<Outline> {
    let empty = || Outline {
        low: DVec2::INFINITY,
        high: DVec2::NEG_INFINITY,
        chords: SegmentTree::default(),
    };
    let count = split.pieces().components().len();
    let mut outlines: Vec<Outline> = (0..count).map(|_| empty()).collect();
    for part in parts {
        let dense = part.measured.dense();
        for (&piece, component) in part.pieces.iter().zip(dense.components()) {
            let points = &dense.points()[component.range.clone()];
            let chords = component.pairs().map(|(i, _)| i);
            outlines[piece] = Outline {
                low: points.iter().copied().fold(DVec2::INFINITY, DVec2::min),
                high: points.iter().copied().fold(DVec2::NEG_INFINITY, DVec2::max),
                chords: SegmentTree::new(chords.map(|i| chord(dense, i))),
            };
        }
    }
    outlines
}

/// Another piece, as it matters to one.
struct Neighbour<'a> {
    outline: &'a Outline,
    /// No point of it is nearer to any of this piece.
    at_least: f64,
    /// Where the two meet, and how near it may come there without setting a bound: a share of the
    /// distance to that place.
    meetings: Vec<(DVec2, f64)>,
}

impl Neighbour<'_> {
    /// Whether the two meet at less than 60 degrees.
    fn meets_sharply(&self) -> bool {
        self.meetings.iter().any(|&(_, share)| share < SINE)
    }

    /// The bound that it sets to lfs at a point, if that is below `value`.
    fn bound(&self, p: DVec2, value: f64) -> Option<f64> {
        let free = self.meetings.iter().map(|(c, share)| share * c.distance(p));
        let limit = free.fold(2.0 * value, f64::min);
        let (_, distance) = self.outline.chords.nearest_within(p, limit)?;
        Some(distance / 2.0)
    }
}

/// How near an arm may come to the other one of a corner without setting a bound to lfs.
fn share_at(split: &SplitCurve, at: DVec2) -> f64 {
    let corner = split.corners().iter().find(|corner| corner.at == at);
    let between_arms = corner.map_or(180.0, |corner| 180.0 - corner.angle_deg);
    if between_arms < LEAST_ANGLE {
        SHARP * between_arms.to_radians().sin()
    } else {
        SINE
    }
}

impl Part {
    fn settle(
        &mut self,
        split: &SplitCurve,
        outlines: &[Outline],
        gaps: GapLimits,
        least: f64,
    ) -> Result<(), MedialAxisError> {
        let neighbours: Vec<Vec<Neighbour>> = self
            .pieces
            .iter()
            .map(|&piece| self.neighbours(split, outlines, piece))
            .collect();
        let dense = self.measured.dense().clone();
        self.measured = settle(&self.curve, dense, gaps, Progress::default(), |dense| {
            let mut values = LocalFeatureSize::new(dense, &self.axis).values().to_vec();
            for (component, neighbours) in dense.components().iter().zip(&neighbours) {
                let range = component.range.clone();
                let points = &dense.points()[range.clone()];
                let values = &mut values[range];
                if neighbours.iter().any(Neighbour::meets_sharply) {
                    let length: f64 = points.windows(2).map(|p| p[0].distance(p[1])).sum();
                    for value in &mut *values {
                        *value = value.min(length / 2.0);
                    }
                }
                for (value, &p) in values.iter_mut().zip(points) {
                    for neighbour in neighbours {
                        if neighbour.at_least / 2.0 >= *value {
                            break;
                        }
                        *value = neighbour.bound(p, *value).unwrap_or(*value);
                    }
                }
                make_lipschitz(points, values, component.closed);
            }
            match values.iter().position(|&value| value < least) {
                None => Ok(LocalFeatureSize::from_values(values)),
                Some(i) => Err(MedialAxisError::Touching {
                    at: dense.points()[i],
                    distance: least,
                }),
            }
        })?;
        Ok(())
    }

    /// All pieces of other parts, by how near they may be.
    fn neighbours<'a>(
        &self,
        split: &SplitCurve,
        outlines: &'a [Outline],
        piece: usize,
    ) -> Vec<Neighbour<'a>> {
        let meetings = split.meetings(piece);
        let others = outlines.iter().enumerate();
        let others = others.filter(|&(other, _)| !self.pieces.contains(&other));
        let others = others.filter(|&(other, _)| split.sees(piece, other));
        let mut neighbours: Vec<_> = others
            .map(|(other, outline)| {
                let here = meetings.iter().flatten().filter(|m| m.0 == other);
                Neighbour {
                    outline,
                    at_least: outlines[piece].distance_of_boxes(outline),
                    meetings: here.map(|m| (m.1, share_at(split, m.1))).collect(),
                }
            })
            .collect();
        neighbours.sort_by(|a, b| a.at_least.total_cmp(&b.at_least));
        neighbours
    }
}

/// Lowers values until they change by no more than the way between points.
fn make_lipschitz(points: &[DVec2], values: &mut [f64], closed: bool) {
    let range = 0..points.len();
    let pairs = Component { range, closed }.pairs();
    let mut lower = |from: usize, to: usize| {
        values[to] = values[to].min(values[from] + points[from].distance(points[to]));
    };
    // What comes from the last point of a closed curve is passed on in a second round.
    for _ in 0..if closed { 2 } else { 1 } {
        pairs.clone().for_each(|(i, j)| lower(i, j));
    }
    for _ in 0..if closed { 2 } else { 1 } {
        pairs.clone().rev().for_each(|(i, j)| lower(j, i));
    }
}

/// All pieces, in their order.
fn assembled(split: &SplitCurve, parts: &[Part]) -> Result<MeasuredCurve, MedialAxisError> {
    let mut places = vec![(0, 0); split.pieces().components().len()];
    for (index, part) in parts.iter().enumerate() {
        for (component, &piece) in part.pieces.iter().enumerate() {
            places[piece] = (index, component);
        }
    }
    let (mut points, mut params, mut values) = (Vec::new(), Vec::new(), Vec::new());
    let mut components = Vec::with_capacity(places.len());
    for (piece, (part, component)) in (0u32..).zip(places) {
        let measured = &parts[part].measured;
        let Component { range, closed } = measured.dense().components()[component].clone();
        let start = points.len();
        points.extend_from_slice(&measured.dense().points()[range.clone()]);
        values.extend_from_slice(&measured.lfs().values()[range.clone()]);
        let here = measured.dense().params()[range].iter();
        params.extend(here.map(|&param| CurveParam {
            component: piece,
            ..param
        }));
        components.push(Component {
            range: start..points.len(),
            closed,
        });
    }
    let dense = DenseCurve::new(points, params, components)?;
    Ok(MeasuredCurve::from_parts(
        dense,
        LocalFeatureSize::from_values(values),
    ))
}
