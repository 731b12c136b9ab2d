//! Bounds of the sampling conditions of given samples, without a medial axis.
//!
//! Samples are an epsilon-sample if for each point p of the curve the disc about p whose radius is
//! the distance from the nearest sample, divided by epsilon, is free of the medial axis. A box of
//! the plane is free of it if each of its points has one nearest point: if only one stretch of the
//! curve can be nearest, and along it the squared distance from each point of the box falls, is
//! strictly convex, and rises. So boxes are halved until each is free of the axis or apart from all
//! discs.

use crate::interval::Interval;
use crate::spline::{ClosedSpline, Piece};
use crate::vector::Vector;

/// Closed curves and samples on them.
#[derive(Clone, Debug, PartialEq)]
pub struct SampledSplines {
    /// The curves.
    pub splines: Vec<ClosedSpline>,
    /// For each curve its samples in order: the segment and the parameter in it, from 0 to below 1.
    pub samples: Vec<Vec<(usize, f64)>>,
}

/// Which condition.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SamplingCondition {
    /// Each point is nearer to a sample than epsilon times its lfs (SGP 2016, Definition 1).
    Epsilon,
    /// Each point between two consecutive samples is nearer to one of them than rho times the reach
    /// of the curve between them (Definition 3).
    Rho,
}

/// A box that is neither free of the medial axis nor apart from the discs.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[error("the medial axis may be in the box {x:?}, {y:?}")]
pub struct Undecided {
    /// The least and the largest x.
    pub x: [f64; 2],
    /// The least and the largest y.
    pub y: [f64; 2],
}

impl SampledSplines {
    /// Proves that the samples satisfy a condition for a bound, and returns how many boxes it took.
    /// Boxes narrower than `least` are given up.
    ///
    /// # Errors
    ///
    /// The first box that is given up.
    pub fn prove(
        &self,
        condition: SamplingCondition,
        bound: f64,
        least: f64,
    ) -> Result<usize, Undecided> {
        let pieces = self.pieces();
        let ends = self.ends();
        let farthest = match condition {
            SamplingCondition::Epsilon => None,
            SamplingCondition::Rho => Some(self.farthest(&pieces, &ends)),
        };
        let proof = Proof {
            sampled: self,
            ends,
            farthest,
            bound: Interval::point(bound),
            least: Interval::point(least),
        };
        let mut all = Vec::new();
        for piece in &pieces {
            let radius = Interval::new(-1.0, 1.0) * proof.radius(piece);
            all.push(piece.place + Vector::new(radius, radius));
        }
        let Some(region) = all.into_iter().reduce(Vector::hull) else {
            return Ok(0);
        };
        let mut boxes = 0;
        let mut open = vec![(region, pieces.clone(), pieces)];
        while let Some((region, near, discs)) = open.pop() {
            boxes += 1;
            open.extend(proof.step(region, near, discs)?.into_iter().flatten());
        }
        Ok(boxes)
    }

    /// The stretches between samples and joints, in order.
    fn pieces(&self) -> Vec<Piece> {
        let mut pieces = Vec::new();
        let mut between = 0;
        for (component, spline) in self.splines.iter().enumerate() {
            let first = between;
            between += self.samples[component].len();
            let mut interval = between - 1;
            let mut next = self.samples[component].iter().peekable();
            for segment in 0..spline.len() {
                let mut start = 0.0;
                while let Some((_, at)) = next.next_if(|(of, _)| *of == segment) {
                    let part = Interval::new(start, *at);
                    if part.has_length() {
                        pieces.push(spline.piece([component, segment, interval], part));
                    }
                    interval = if interval + 1 == between {
                        first
                    } else {
                        interval + 1
                    };
                    start = *at;
                }
                let part = Interval::new(start, 1.0);
                pieces.push(spline.piece([component, segment, interval], part));
            }
        }
        pieces
    }

    /// For each interval between samples, rectangles about its ends.
    fn ends(&self) -> Vec<[Vector; 2]> {
        let mut ends = Vec::new();
        for (spline, samples) in self.splines.iter().zip(&self.samples) {
            let place = |(segment, at): (usize, f64)| {
                let [x, y] = spline.point(segment, at);
                Vector::new(x, y)
            };
            let following = samples.iter().skip(1).chain(samples.first());
            ends.extend(
                samples
                    .iter()
                    .zip(following)
                    .map(|(a, b)| [place(*a), place(*b)]),
            );
        }
        ends
    }

    /// For each interval, an upper bound of the distance of its points from the nearer end.
    fn farthest(&self, pieces: &[Piece], ends: &[[Vector; 2]]) -> Vec<Interval> {
        let mut farthest = vec![Interval::point(0.0); ends.len()];
        let mut open = pieces.to_vec();
        for _ in 0..FINENESS {
            for piece in &open {
                let known = &mut farthest[piece.between];
                *known = known.max(nearer(piece, ends).lower());
            }
            open.retain(|piece| !nearer(piece, ends).is_below(farthest[piece.between]));
            let halves = open.iter().flat_map(|piece| self.halves(piece));
            open = halves.collect();
        }
        for piece in &open {
            let known = &mut farthest[piece.between];
            *known = known.max(nearer(piece, ends));
        }
        farthest.into_iter().map(Interval::upper).collect()
    }

    fn halves(&self, piece: &Piece) -> [Piece; 2] {
        self.splines[piece.component].halves(piece)
    }
}

/// How often pieces are halved to find the point that is farthest from both ends.
const FINENESS: u32 = 24;

/// How far the points of a piece are from the nearer end of their interval.
fn nearer(piece: &Piece, ends: &[[Vector; 2]]) -> Interval {
    let [a, b] = ends[piece.between].map(|end| (piece.place - end).square().sqrt());
    a.min(b)
}

struct Proof<'a> {
    sampled: &'a SampledSplines,
    ends: Vec<[Vector; 2]>,
    /// The largest distances from the nearer end, if they count for all of an interval.
    farthest: Option<Vec<Interval>>,
    bound: Interval,
    least: Interval,
}

/// A box, the pieces that may be nearest to its points, and those whose discs may meet it.
type Open = (Vector, Vec<Piece>, Vec<Piece>);

impl Proof<'_> {
    /// The radius of the discs about the points of a piece, from above.
    fn radius(&self, piece: &Piece) -> Interval {
        let distance = match &self.farthest {
            Some(farthest) => farthest[piece.between],
            None => nearer(piece, &self.ends).upper(),
        };
        distance / self.bound
    }

    /// What is left of a box: nothing, or its halves.
    fn step(
        &self,
        region: Vector,
        mut near: Vec<Piece>,
        mut discs: Vec<Piece>,
    ) -> Result<Option<[Open; 2]>, Undecided> {
        discs.retain(|piece| !self.radius(piece).is_below(region.distance(piece.place)));
        if discs.is_empty() {
            return Ok(None);
        }
        let distance = |piece: &Piece| region.distance(piece.place);
        let within = near.iter().map(|piece| distance(piece).upper());
        let Some(within) = within.reduce(Interval::min) else {
            return Ok(None);
        };
        near.retain(|piece| !within.is_below(distance(piece)));
        if self.has_one_nearest(&mut near, region) {
            return Ok(None);
        }
        let width = region.width();
        if width.is_below(self.least) {
            let [x, y] = [region.x, region.y].map(|side| [side.low(), side.high()]);
            return Err(Undecided { x, y });
        }
        let (near, discs) = (self.finer(near, width), self.finer(discs, width));
        let [lower, upper] = region.halves();
        Ok(Some([
            (lower, near.clone(), discs.clone()),
            (upper, near, discs),
        ]))
    }

    /// Pieces no wider than a box.
    fn finer(&self, pieces: Vec<Piece>, width: Interval) -> Vec<Piece> {
        let mut finer = Vec::with_capacity(pieces.len());
        for piece in pieces {
            if width.is_below(piece.place.width()) {
                finer.extend(self.sampled.halves(&piece));
            } else {
                finer.push(piece);
            }
        }
        finer
    }

    /// Whether pieces in order are one stretch of a curve, and along it the squared distance from
    /// each point of a box falls, is strictly convex, and rises: then it is least at one point.
    fn has_one_nearest(&self, pieces: &mut [Piece], region: Vector) -> bool {
        let count = pieces.len();
        let follows = |i: &usize| self.joins(&pieces[(i + count - 1) % count], &pieces[*i]);
        let mut starts = (0..count).filter(|i| !follows(i));
        let (Some(start), None) = (starts.next(), starts.next()) else {
            return false;
        };
        pieces.rotate_left(start);
        let falling = |piece: &&Piece| piece.slope(region).is_negative();
        let convex = |piece: &&Piece| piece.bend(region).is_positive();
        let mut rest = pieces.iter().skip_while(falling).skip_while(convex);
        rest.all(|piece| piece.slope(region).is_positive())
    }

    /// Whether a piece ends where another one starts.
    fn joins(&self, a: &Piece, b: &Piece) -> bool {
        let segments = self.sampled.splines[a.component].len();
        let (end, start) = (a.parameter.upper(), b.parameter.lower());
        let same = a.segment == b.segment && end == start;
        let next = (a.segment + 1) % segments == b.segment
            && end == Interval::point(1.0)
            && start == Interval::point(0.0);
        a.component == b.component && (same || next)
    }
}
