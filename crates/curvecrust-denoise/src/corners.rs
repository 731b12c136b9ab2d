//! Corners: creases of a curve, where these raise the score of the model.
//!
//! A spline rounds a corner, and its penalty yields there. Where a curve turns much within few
//! intervals, it is fitted once more with a crease: a threefold knot, across which only the place
//! is common, so that the corner is where two one-sided fits meet. The weakest creases are taken
//! away one after the other, and the best score of all these models is kept. A corner costs what
//! its fit is freer, and log n for its place, which is found among all places of the curve.

use glam::DVec2;

use curvecrust_geometry::Interrupt;

use crate::model::{Arc, Model};
use crate::spline::{Fit, Guide, Rough, fit};

/// A corner is looked for where the curve turns by this angle or more
const ANGLE: f64 = 0.35;
/// within this many intervals to each side, over which a spline rounds it.
const ROUND: f64 = 1.5;
/// The least distance of two corners, in intervals.
const APART: f64 = 3.0;
/// Samples an interval, by which the turning is measured.
const DENSITY: f64 = 8.0;
/// A point within this many deviations takes part in the fit.
const NEAR: f64 = 4.0;
/// The share of the corners that is taken away at a time.
const DROPPED: usize = 6;
/// What is rough about the sides of a corner. Fits with a penalty on third derivatives take creases
/// for bends of outlines that are round: a crease saves them more freedom than it costs.
const SIDES: Rough = Rough::Bends;
/// How often the best model is fitted anew from itself.
const POLISH: usize = 4;

/// Where a curve turns much, and where its sides would meet.
#[derive(Clone, Copy, Debug)]
struct Corner {
    parameter: f64,
    at: DVec2,
}

impl Corner {
    fn of(arc: &Arc, parameter: f64) -> Self {
        let at = meeting(arc, parameter);
        Self { parameter, at }
    }
}

/// The model with corners where these raise its score.
pub(crate) fn cornered(points: &[DVec2], mut best: Model, sigma: Option<f64>) -> Model {
    for k in 0..best.arcs.len() {
        if let Some(found) = of_arc(points, &best, k, sigma) {
            best = found;
        }
    }
    best
}

/// A better model with corners of one arc, if there is one.
fn of_arc(points: &[DVec2], model: &Model, k: usize, sigma: Option<f64>) -> Option<Model> {
    let arc = &model.arcs[k];
    let corners = suspects(arc);
    if corners.is_empty() {
        return None;
    }
    let near = |i: &usize| {
        let place = model.nearest[*i];
        place.arc == k && place.distance <= NEAR * arc.fit.spread.at(place.parameter)
    };
    let members: Vec<DVec2> = (0..points.len()).filter(near).map(|i| points[i]).collect();
    let trial = Trial {
        points,
        members,
        model,
        k,
        sigma,
    };
    let best = trial.best(&corners)?;
    let has_corners = !best.arcs[k].fit.spline.creases().is_empty();
    (has_corners && best.score > model.score).then(|| trial.polished(best))
}

/// An arc of a model that is fitted anew.
struct Trial<'a> {
    points: &'a [DVec2],
    /// The points near the arc.
    members: Vec<DVec2>,
    model: &'a Model,
    k: usize,
    sigma: Option<f64>,
}

impl Trial<'_> {
    /// The best model with all, some or none of the corners.
    ///
    /// The fit without any is a rival too: else a crease would be taken for what the new fit alone
    /// gains.
    fn best(&self, all: &[Corner]) -> Option<Model> {
        let mut corners = all.to_vec();
        let mut best: Option<Model> = None;
        loop {
            let fit = self.fitted(&corners)?;
            let jumps = jumps(&fit);
            let found = self.with(fit)?;
            if best.as_ref().is_none_or(|best| found.score > best.score) {
                best = Some(found);
            }
            if corners.is_empty() {
                return best;
            }
            let count = corners.len().div_ceil(DROPPED);
            corners = without_weakest(&corners, &jumps, count);
        }
    }

    /// The arc fitted with creases, and once more from there: the first fit still has some of the
    /// rounded corners in its parameters.
    fn fitted(&self, corners: &[Corner]) -> Option<Fit> {
        Interrupt::current().check();
        let arc = &self.model.arcs[self.k];
        let first = fit(&guide(arc, corners), &self.members, self.sigma, SIDES)?;
        self.again(&whole(first), |creases| creases)
    }

    /// The arc fitted from a fit of it, with some of its creases.
    fn again(&self, whole: &Arc, some: impl Fn(Vec<Corner>) -> Vec<Corner>) -> Option<Fit> {
        let again = guide(whole, &some(creases(whole)));
        fit(&again, &self.members, self.sigma, SIDES)
    }

    /// The model without the weakest corner, one after the other, and fitted anew from itself, as
    /// long as that raises its score.
    fn polished(&self, mut best: Model) -> Model {
        for is_last in [false, true] {
            for _ in 0..POLISH {
                let whole = whole(best.arcs[self.k].fit.clone());
                let jumps = jumps(&whole.fit);
                let fit = self.again(&whole, |creases| match is_last || jumps.len() < 2 {
                    true => creases,
                    false => without_weakest(&creases, &jumps, 1),
                });
                match fit.and_then(|fit| self.with(fit)) {
                    Some(found) if found.score > best.score => best = found,
                    _ => break,
                }
            }
        }
        best
    }

    /// The model with another fit of the arc; `None` if that changes how many curves there are.
    fn with(&self, fit: Fit) -> Option<Model> {
        let fits = self.model.arcs.iter().enumerate();
        let fits = fits.map(|(l, other)| match l == self.k {
            true => fit.clone(),
            false => other.fit.clone(),
        });
        let found = Model::of(self.points, fits.collect())?;
        (found.arcs.len() == self.model.arcs.len()).then_some(found)
    }
}

/// All of a fitted curve as an arc.
fn whole(fit: Fit) -> Arc {
    let to = fit.spline.intervals() as f64;
    Arc { fit, from: 0.0, to }
}

/// The creases of an arc, and where the tangents beside them meet.
fn creases(arc: &Arc) -> Vec<Corner> {
    let creases = arc.fit.spline.creases().iter();
    creases.map(|&k| Corner::of(arc, k as f64)).collect()
}

/// The angle by which a fit turns at each of its creases.
fn jumps(fit: &Fit) -> Vec<f64> {
    let jump = |&crease: &usize| {
        let [before, after] = fit.spline.sides(crease);
        before.angle_to(after).abs()
    };
    fit.spline.creases().iter().map(jump).collect()
}

/// The corners without some that turn the least.
fn without_weakest(corners: &[Corner], jumps: &[f64], count: usize) -> Vec<Corner> {
    let mut order: Vec<usize> = (0..corners.len()).collect();
    order.sort_by(|&i, &j| jumps[i].total_cmp(&jumps[j]).then(i.cmp(&j)));
    let dropped = &order[..count.min(order.len())];
    let kept = (0..corners.len()).filter(|i| !dropped.contains(i));
    kept.map(|i| corners[i]).collect()
}

/// Places where an arc turns much, in order.
fn suspects(arc: &Arc) -> Vec<Corner> {
    let spline = &arc.fit.spline;
    let margin = if spline.closed() { 0.0 } else { ROUND };
    let (from, to) = (arc.from + margin, arc.to - margin);
    let mut found: Vec<(f64, f64)> = Vec::new();
    let mut step = 0.0;
    while from + step / DENSITY < to {
        let t = from + step / DENSITY;
        let directions = [-ROUND, 0.0, ROUND].map(|by| spline.tangent(t + by));
        let [a, b, c] = directions;
        let turning = (a.angle_to(b) + b.angle_to(c)).abs();
        if turning >= ANGLE {
            found.push((turning, t));
        }
        step += 1.0;
    }
    found.sort_by(|a, b| b.0.total_cmp(&a.0).then(a.1.total_cmp(&b.1)));
    let whole = spline.intervals() as f64;
    let apart = |s: f64, t: f64| {
        let d = (s - t).abs();
        let d = if spline.closed() { d.min(whole - d) } else { d };
        d >= APART
    };
    let mut taken: Vec<f64> = Vec::new();
    for (_, t) in found {
        if taken.iter().all(|&s| apart(s, t)) {
            taken.push(t);
        }
    }
    taken.sort_by(f64::total_cmp);
    taken.into_iter().map(|t| Corner::of(arc, t)).collect()
}

/// Where the tangents meet that touch an arc before and after a place; the place itself if they
/// do not meet near it.
fn meeting(arc: &Arc, t: f64) -> DVec2 {
    let spline = &arc.fit.spline;
    let here = spline.point(t);
    let [before, after] = [t - ROUND, t + ROUND];
    let [p, q] = [before, after].map(|t| spline.point(t));
    let [u, v] = [before, after].map(|t| spline.tangent(t).normalize_or_zero());
    let (sine, apart) = (u.perp_dot(v), q - p);
    // p + a u = q - b v
    let (a, b) = (apart.perp_dot(v) / sine, u.perp_dot(apart) / sine);
    let most = 2.0 * (here.distance(p) + here.distance(q));
    let meet = a > 0.0 && b > 0.0 && a < most && b < most;
    if meet { p + a * u } else { here }
}

/// A guide along an arc with creases at its corners; the rounded parts about them are left out.
fn guide(arc: &Arc, corners: &[Corner]) -> Guide {
    let spline = &arc.fit.spline;
    let mut guide = Guide {
        vertices: Vec::new(),
        spacing: Vec::new(),
        sigma: Vec::new(),
        closed: spline.closed(),
        creases: Vec::new(),
        even: true,
    };
    for pair in ends(arc, corners).windows(2) {
        let [(from, corner), (to, next)] = [pair[0], pair[1]];
        guide.creases.extend(corner.map(|_| guide.vertices.len()));
        push(&mut guide, arc, from, corner);
        let margin = |corner: Option<DVec2>| if corner.is_some() { ROUND } else { 1.0 };
        let (low, high) = (from + margin(corner), to - margin(next));
        let pieces = (high - low).round().max(1.0);
        let mut i = 0.0;
        while i <= pieces {
            push(&mut guide, arc, low + (high - low) * i / pieces, None);
            i += 1.0;
        }
    }
    if !guide.closed {
        push(&mut guide, arc, spline.intervals() as f64, None);
    }
    guide
}

/// The parameters where an arc starts, has a corner, and ends. A closed one with corners starts at
/// the first.
fn ends(arc: &Arc, corners: &[Corner]) -> Vec<(f64, Option<DVec2>)> {
    let whole = arc.fit.spline.intervals() as f64;
    let closed = arc.fit.spline.closed();
    let along = corners.iter().map(|c| (c.parameter, Some(c.at)));
    let (start, end) = match corners.first().filter(|_| closed) {
        Some(first) => (None, (first.parameter + whole, Some(first.at))),
        None => (Some((0.0, None)), (whole, None)),
    };
    start.into_iter().chain(along).chain([end]).collect()
}

/// Adds a place of an arc to a guide, or another place instead.
fn push(guide: &mut Guide, arc: &Arc, t: f64, instead: Option<DVec2>) {
    let spline = &arc.fit.spline;
    let here = spline.point(t);
    let [before, after] = [t - ROUND, t + ROUND].map(|t| spline.wrapped(t));
    let apart = here.distance(spline.point(before)) + here.distance(spline.point(after));
    let span = if after > before {
        after - before
    } else {
        2.0 * ROUND
    };
    guide.vertices.push(instead.unwrap_or(here));
    guide.spacing.push(apart / span);
    guide.sigma.push(arc.fit.spread.at(t));
}
