//! Few dense points for long strands that are near each other.
//!
//! Points along a strand at gaps of a fraction of lfs are as many as its length is times 1/lfs. The
//! medial axis between two strands needs far fewer, if the points face each other: let p and q be
//! the two places where a [maximal disc](crate::maximal_disc) touches the strands, and p', q' those
//! of the next one. The four are nearly on a circle, so that the edges p p' and q q' are Delaunay,
//! and the Voronoi edge of p and q is the tangent of the axis at the centre of their disc. Up to
//! half-way to the next centre it leaves the axis by about h^2 / 8 R, for gaps of h and a radius of
//! curvature R.
//!
//! So a gap is fine, however small lfs is, if it faces another one on each side where the strands
//! are near, h^2 is below a share of R times the radius of the disc, and h is as small as ever
//! beside the discs on a side that faces nothing. Gaps that are not fine are halved, and the point
//! in the middle gets the points that face it, across all near strands of the stack it lies in.
//! Where a gap has no such partner, as near a branch of the axis, halving ends at a quarter of the
//! radius of the discs, and nothing is near the gap any more.
//!
//! No strands cross between points that face each other: the curve is within h^2 / 8 R of its
//! chords, which is less than one part in a hundred of their distance, and chords that cross are no
//! Delaunay edges. Nor does a branch of the axis start there: discs at both ends would tell.
//!
//! Cost: a search among n spans for each point, O(log n) for most.

use std::collections::BTreeMap;

use curvecrust_curve::{Curve, CurveParam, DenseCurve, DenseError};
use curvecrust_geometry::{DVec2, Interrupt};

use crate::facing::Facing;
use crate::maximal_disc::{MaximalDisc, MaximalDiscs};
use crate::span::{Span, segment};

/// The square of a gap that faces another is at most this share of the product of the radius of
/// curvature and that of the disc: at most 0.13 % of lfs are lost.
const BEND: f64 = 0.01;
/// Places are one if they are so near to each other that the axis moves by less than this share of
/// lfs.
const SAME: f64 = 1e-3;
/// Rounding errors, as a share of the extent of the curve, with a wide margin.
const ROUNDING: f64 = 1e-14;
/// What is near: gaps are longer than this share of the radius of the disc.
const NEAR: f64 = 0.25;
/// Gaps are not halved below this share of the extent of the curve.
const SHORT: f64 = 1e-7;

/// Points that face each other where strands are near, and those of `start` elsewhere; `None` if
/// more than `most` points would face others.
///
/// Beside discs that are not near, gaps are at most `gap_to_radius` of their radius.
pub(crate) fn facing_points(
    curve: &Curve,
    start: &DenseCurve,
    gap_to_radius: f64,
    most: usize,
) -> Result<Option<Facing>, DenseError> {
    let mut ladder = Ladder {
        curve,
        discs: MaximalDiscs::new(curve, start),
        gap_to_radius,
        extent: curve.extent(),
        places: BTreeMap::new(),
        open: Vec::new(),
    };
    ladder.begin(&DenseCurve::per_segment(curve, 2)?);
    if !ladder.halve(most) {
        return Ok(None);
    }
    ladder.dense(start).map(Some)
}

/// The name of a place, in order along the curve: component, segment, and the bits of its
/// parameter, which is not negative.
type Key = (u32, u32, u64);

fn key(at: CurveParam) -> Key {
    // Of the two zeros, one.
    (at.component, at.segment, (at.t + 0.0).to_bits())
}

/// A point of the curve and the maximal discs on its left and on its right.
struct Place {
    at: CurveParam,
    point: DVec2,
    discs: [MaximalDisc; 2],
}

/// What becomes of a gap.
enum Gap {
    /// It is left to others: what is near is no nearer than its length.
    Plain,
    /// It faces others wherever strands are near.
    Facing(Faced),
    /// It is to be halved.
    Long,
}

/// What a gap faces.
struct Faced {
    /// The radius of the smaller disc at the ends of the gap.
    radius: f64,
    /// The first places of the gaps that it faces, on the left and on the right.
    gaps: [Option<Key>; 2],
}

/// Places on the curve, which face each other like the ends of rungs.
struct Ladder<'a> {
    curve: &'a Curve,
    discs: MaximalDiscs<'a>,
    gap_to_radius: f64,
    extent: f64,
    places: BTreeMap<Key, Place>,
    /// Places whose next gap is new.
    open: Vec<Key>,
}

impl Ladder<'_> {
    /// Takes the first places, and those that face them.
    fn begin(&mut self, first: &DenseCurve) {
        for (&at, &point) in first.params().iter().zip(first.points()) {
            self.add(at, point);
        }
        for &at in first.params() {
            self.insert(at);
        }
    }

    /// Adds a place before anything is known of its discs.
    fn add(&mut self, at: CurveParam, point: DVec2) {
        let unknown = MaximalDisc {
            radius: 0.0,
            touches: None,
        };
        let discs = [unknown; 2];
        self.places.insert(key(at), Place { at, point, discs });
    }

    /// Halves gaps until none is long; whether that took no more than `most` places.
    fn halve(&mut self, most: usize) -> bool {
        let interrupt = Interrupt::current();
        let most = most.saturating_add(self.places.len());
        loop {
            while let Some(start) = self.open.pop() {
                interrupt.check();
                if self.is_long(start) {
                    self.halve_after(start);
                }
                if self.places.len() > most {
                    return false;
                }
            }
            // What a gap faced may have been divided since.
            let starts = self.places.keys().copied();
            self.open = starts.filter(|&start| self.is_long(start)).collect();
            if self.open.is_empty() {
                return true;
            }
        }
    }

    fn is_long(&self, start: Key) -> bool {
        let end = self.next(start);
        end.is_some_and(|end| matches!(self.gap(start, end), Gap::Long))
    }

    /// Adds the place in the middle of a gap.
    fn halve_after(&mut self, start: Key) {
        let Some(end) = self.next(start) else { return };
        let span = self.span(start, end);
        let t = f64::midpoint(span.from, span.to);
        let at = self.places[&start].at;
        self.insert(CurveParam { t, ..at });
    }

    /// Adds a place and those that face it, across all strands that are near.
    fn insert(&mut self, at: CurveParam) {
        let mut facing = self.place(at);
        while let Some((disc, length)) = facing.pop() {
            // Another one may have brought the place meanwhile.
            if let (Some(at), None) = (disc.touches, self.facing_end(&disc, length)) {
                facing.extend(self.place(at));
            }
        }
    }

    /// Adds a place, or looks for discs anew at one that is there. Its discs that touch strands
    /// which are near are returned, with the length of the gap around it.
    fn place(&mut self, at: CurveParam) -> Vec<(MaximalDisc, f64)> {
        let key = key(at);
        let length = self.length_around(key);
        let point = segment(self.curve, at).point(at.t);
        let disc = |left| self.discs.at(at, left, length / self.gap_to_radius);
        let discs = [true, false].map(disc);
        self.places.insert(key, Place { at, point, discs });
        self.open.extend(self.previous(key));
        self.open.push(key);
        let near = discs.into_iter().filter(|disc| NEAR * disc.radius < length);
        near.map(|disc| (disc, length)).collect()
    }

    /// The length of the gap that a place divides, or of the longer one beside it.
    fn length_around(&self, key: Key) -> f64 {
        let (previous, next) = (self.previous(key), self.next(key));
        match (previous, next) {
            (Some(a), Some(b)) if !self.places.contains_key(&key) => self.span(a, b).length(),
            _ => {
                let before = previous.map_or(0.0, |a| self.span(a, key).length());
                next.map_or(0.0, |b| self.span(key, b).length()).max(before)
            }
        }
    }

    /// What becomes of the gap between two places.
    fn gap(&self, start: Key, end: Key) -> Gap {
        let span = self.span(start, end);
        let length = span.length();
        let radius = |side: usize| {
            let radii = [start, end].map(|key| self.places[&key].discs[side].radius);
            radii[0].min(radii[1])
        };
        let radii = [0, 1].map(radius);
        let least = radii[0].min(radii[1]);
        if length <= NEAR * least || length <= SHORT * self.extent {
            return Gap::Plain;
        }
        let is_short = |radius: f64| length <= self.gap_to_radius * radius;
        // What is not near need not have got places that face it.
        let faced = |side: usize| {
            let is_near = NEAR * radii[side] < length;
            is_near.then(|| self.faced(start, end, side)).flatten()
        };
        let gaps = [faced(0), faced(1)];
        let fine = |side: usize| is_short(radii[side]) || gaps[side].is_some();
        if is_short(span.least_radius()) && fine(0) && fine(1) {
            let radius = least;
            Gap::Facing(Faced { radius, gaps })
        } else {
            Gap::Long
        }
    }

    /// The gap that one faces on a side, near enough for their lengths, by its first place.
    fn faced(&self, start: Key, end: Key, side: usize) -> Option<Key> {
        let here = self.span(start, end);
        let [a, b] = [start, end].map(|key| &self.places[&key].discs[side]);
        let first = self.facing_end(a, here.length())?;
        let second = self.facing_end(b, here.length())?;
        let (first, second) = if self.next(first) == Some(second) {
            (first, second)
        } else {
            (self.next(second) == Some(first)).then_some((second, first))?
        };
        let there = self.span(first, second);
        let bend = here.least_radius().min(there.least_radius());
        let longest = (BEND * bend * a.radius.min(b.radius)).sqrt();
        let [here, there] = [here, there].map(Span::length);
        let (short, long) = (here.min(there), here.max(there));
        (long <= longest && long <= 2.0 * short).then_some(first)
    }

    /// The place where a disc touches, if it is one of the places, for gaps of a length.
    fn facing_end(&self, disc: &MaximalDisc, length: f64) -> Option<Key> {
        let at = disc.touches?;
        // Two points that miss each other by d lean their Voronoi edge by d / 2 r, which moves it
        // by d / 4 r of the length at the ends of the gap.
        let lean = 4.0 * SAME * disc.radius * (disc.radius / length).min(1.0);
        // The circle of three points that are nearer to each other is smaller than the disc if
        // rounding has its way.
        let distance = lean.max((ROUNDING * self.extent * disc.radius).sqrt());
        let point = segment(self.curve, at).point(at.t);
        let key = key(at);
        let here = self.places.contains_key(&key).then_some(key);
        let near = [here, self.previous(key), self.next(key)];
        let found = near.into_iter().flatten();
        found
            .into_iter()
            .find(|key| self.places[key].point.distance(point) <= distance)
    }

    fn span(&self, start: Key, end: Key) -> Span<'_> {
        let at = |key: Key| CurveParam {
            component: key.0,
            segment: key.1,
            t: f64::from_bits(key.2),
        };
        Span::new(self.curve, at(start), at(end))
    }

    /// The first place of the component behind another one, or round its seam.
    fn next(&self, key: Key) -> Option<Key> {
        let later = self.places.range((key.0, key.1, key.2 + 1)..).next();
        self.of_component(key, later, || self.of(key.0).next())
    }

    /// The last place of the component before another one, or round its seam.
    fn previous(&self, key: Key) -> Option<Key> {
        let earlier = self.places.range(..key).next_back();
        self.of_component(key, earlier, || self.of(key.0).next_back())
    }

    /// The place that was found, or that at the other end of the component if it is closed.
    fn of_component<'a>(
        &'a self,
        key: Key,
        found: Option<(&'a Key, &'a Place)>,
        other_end: impl Fn() -> Option<(&'a Key, &'a Place)>,
    ) -> Option<Key> {
        let component = key.0;
        let is_closed = || self.curve.components()[component as usize].is_closed();
        let found = found.filter(|(found, _)| found.0 == component);
        let found = found.or_else(|| is_closed().then(other_end).flatten());
        found.map(|(&key, _)| key)
    }

    /// The gaps that face others which face them, by their first places in order, each with its
    /// radius.
    fn facing(&self) -> Vec<(Key, f64)> {
        let gap = |&start: &Key| match self.gap(start, self.next(start)?) {
            Gap::Facing(faced) => Some((start, faced)),
            Gap::Plain | Gap::Long => None,
        };
        let mut all: Vec<(Key, Faced)> = self.places.keys().filter_map(gap).collect();
        loop {
            let faces = |start: &Key| all.binary_search_by_key(start, |(key, _)| *key).is_ok();
            let mutual = all
                .iter()
                .map(|(_, faced)| faced.gaps.iter().flatten().all(faces));
            let mutual: Vec<bool> = mutual.collect();
            if !mutual.contains(&false) {
                return all
                    .into_iter()
                    .map(|(start, faced)| (start, faced.radius))
                    .collect();
            }
            let mut mutual = mutual.into_iter();
            all.retain(|_| mutual.next() == Some(true));
        }
    }

    /// The places as dense points, with those of `start` where no gaps face each other.
    fn dense(mut self, start: &DenseCurve) -> Result<Facing, DenseError> {
        let facing = self.facing();
        let radius = |start: Key| {
            let found = facing.binary_search_by_key(&start, |(key, _)| *key);
            found.ok().map(|index| facing[index].1)
        };
        for (&at, &point) in start.params().iter().zip(start.points()) {
            let before = self.previous(key(at));
            if before
                .is_some_and(|before| radius(before).is_none() && self.is_free(at, point, before))
            {
                self.add(at, point);
            }
        }
        let (mut points, mut params, mut radii) = (Vec::new(), Vec::new(), Vec::new());
        let mut components = start.components().to_vec();
        for (&start, place) in &self.places {
            points.push(place.point);
            params.push(place.at);
            radii.push(radius(start));
            components[start.0 as usize].range.end = points.len();
        }
        for i in 1..components.len() {
            components[i].range.start = components[i - 1].range.end;
        }
        let dense = DenseCurve::new(points, params, components)?;
        Ok(Facing { dense, radii })
    }

    /// Whether no place is at a place, given the one before it.
    fn is_free(&self, at: CurveParam, point: DVec2, before: Key) -> bool {
        let is_there = |key: Key| self.places[&key].point.distance(point) <= SHORT * self.extent;
        !self.places.contains_key(&key(at))
            && !is_there(before)
            && !self.next(before).is_some_and(is_there)
    }

    /// The places of a component.
    fn of(&self, component: u32) -> impl DoubleEndedIterator<Item = (&Key, &Place)> {
        let (first, last) = ((component, 0, 0), (component, u32::MAX, u64::MAX));
        self.places.range(first..=last)
    }
}

#[cfg(test)]
mod tests;
