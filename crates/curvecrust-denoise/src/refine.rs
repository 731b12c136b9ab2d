//! Curves cut where points do not carry them, and joined where they do.
//!
//! Chains are made from what is near; whether a gap is one, or a stretch of curve only runs through
//! the background, is a question for the score of the whole model.

use glam::DVec2;

use curvecrust_geometry::Interrupt;
use curvecrust_reconstruct::Shape;

use crate::area::hull_area;
use crate::evidence;
use crate::model::{Arc, Model, model};
use crate::options::Options;
use crate::spline::Guide;

/// The most changes that are tried.
const TRIALS: usize = 24;
/// The longest gap that is tried to be joined, in intervals of the splines.
const REACH: f64 = 16.0;
/// The fewest vertices of a piece that is left of a cut.
const FEWEST: usize = 4;

/// A change of the curves, and how promising it is: the higher the better.
struct Change {
    promise: f64,
    guides: Vec<Guide>,
}

/// The model of the best score that cuts and joins lead to, one after the other.
pub(crate) fn refined(
    points: &[DVec2],
    mut best: Model,
    sigma: Option<f64>,
    known: &Options,
) -> Model {
    let interrupt = Interrupt::current();
    let mut left = TRIALS;
    'again: loop {
        let mut changes = cuts(points, &best);
        changes.extend(joins(&best));
        changes.sort_by(|a, b| b.promise.total_cmp(&a.promise));
        for change in changes {
            if left == 0 {
                return best;
            }
            left -= 1;
            interrupt.check();
            let found = model(points, &change.guides, sigma);
            let found = found.filter(|found| {
                found.score > best.score && (agrees(found, known) || !agrees(&best, known))
            });
            if let Some(found) = found {
                best = found;
                continue 'again;
            }
        }
        return best;
    }
}

/// Whether the curves are as they are known to be.
fn agrees(model: &Model, known: &Options) -> bool {
    let count = known.curves.map(|n| n.get() as usize);
    let closed = known.shape.map(|shape| shape == Shape::Closed);
    let mut arcs = model.arcs.iter();
    count.is_none_or(|count| count == model.arcs.len())
        && closed.is_none_or(|closed| arcs.all(|arc| arc.fit.spline.closed() == closed))
}

/// The guides of all arcs but some, and others instead.
fn instead(best: &Model, without: &[usize], others: Vec<Guide>) -> Vec<Guide> {
    let arcs = best.arcs.iter().enumerate();
    let kept = arcs.filter(|(k, _)| !without.contains(k));
    let kept = kept.map(|(_, arc)| guide(arc, arc.from, arc.to, arc.fit.spline.closed()));
    kept.chain(others).collect()
}

/// A guide along an arc between two parameters, of which the second may be beyond the first lap.
fn guide(arc: &Arc, from: f64, to: f64, closed: bool) -> Guide {
    let spline = &arc.fit.spline;
    let pieces = (to - from).round().max(1.0);
    let mut parameters = Vec::new();
    let mut i = 0.0;
    while i <= pieces {
        parameters.push(from + (to - from) * i / pieces);
        i += 1.0;
    }
    let vertices: Vec<DVec2> = parameters.iter().map(|&t| spline.point(t)).collect();
    let lengths: Vec<f64> = vertices.windows(2).map(|w| w[0].distance(w[1])).collect();
    let spacing = |i: usize| {
        let after = lengths.get(i).or(lengths.last()).copied().unwrap_or(0.0);
        let before = i.checked_sub(1).map_or(after, |i| lengths[i]);
        0.5 * (before + after)
    };
    let mut guide = Guide {
        spacing: (0..vertices.len()).map(spacing).collect(),
        sigma: parameters.iter().map(|&t| arc.fit.spread.at(t)).collect(),
        vertices,
        closed,
        creases: Vec::new(),
        even: false,
    };
    if closed {
        guide.vertices.pop();
        guide.spacing.pop();
        guide.sigma.pop();
    }
    guide
}

/// For each arc the stretch that speaks most against it, cut out.
fn cuts(points: &[DVec2], best: &Model) -> Vec<Change> {
    let counts = best.counts();
    let density = best.outliers().max(1) as f64 / hull_area(points);
    let lengths: Vec<f64> = best.arcs.iter().map(Arc::length).collect();
    let mut gains: Vec<Vec<(f64, f64)>> = vec![Vec::new(); best.arcs.len()];
    for place in best.assigned.iter().flatten() {
        let arc = &best.arcs[place.arc];
        let sigma = arc.fit.spread.at(place.parameter).max(f64::MIN_POSITIVE);
        let along = counts[place.arc] as f64 / lengths[place.arc];
        let gain = along.ln() + evidence::log_normal(place.distance, sigma) - density.ln();
        gains[place.arc].push((place.parameter, gain));
    }
    let log_n = (points.len() as f64).ln();
    let pairs = best.arcs.iter().zip(gains).enumerate();
    pairs
        .filter_map(|(k, (arc, gains))| {
            let (loss, from, to) = worst_stretch(arc, gains)?;
            let closed = arc.fit.spline.closed();
            let intervals = arc.fit.spline.intervals() as f64;
            let left = if closed {
                vec![guide(arc, to, from + intervals, false)]
            } else {
                vec![
                    guide(arc, arc.from, from, false),
                    guide(arc, to, arc.to, false),
                ]
            };
            let left = left
                .into_iter()
                .filter(|g| g.vertices.len() >= FEWEST)
                .collect();
            // Two ends more.
            let promise = loss - 2.0 * log_n;
            (promise > 0.0).then(|| Change {
                promise,
                guides: instead(best, &[k], left),
            })
        })
        .collect()
}

/// The stretch between two points of an arc that explains these the least, and by how much the
/// model is better without it. `gains` are by how much each point speaks for the arc.
fn worst_stretch(arc: &Arc, mut gains: Vec<(f64, f64)>) -> Option<(f64, f64, f64)> {
    let count = gains.len();
    gains.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.total_cmp(&b.1)));
    let intervals = arc.fit.spline.intervals() as f64;
    let lengths = arc.lengths();
    let whole = *lengths.last()?;
    let rate = count as f64 / whole;
    let at = |k: usize| {
        let (t, gain) = gains[k % count];
        let lap = if k < count { 0.0 } else { 1.0 };
        (
            t + lap * intervals,
            arc.length_at(&lengths, t) + lap * whole,
            gain,
        )
    };
    let laps = if arc.fit.spline.closed() {
        2 * count
    } else {
        count
    };
    let mut best: Option<(f64, f64, f64)> = None;
    // The point from which on the sum is least; it may not be a lap ago.
    let mut start: Option<(usize, f64)> = None;
    let mut sum = 0.0;
    for k in 0..laps {
        let (t, length, gain) = at(k);
        let before = sum - rate * length;
        if let Some((i, from)) = start
            && k - i < count
            && best.is_none_or(|(loss, ..)| from - before > loss)
        {
            best = Some((from - before, at(i).0, t));
        }
        sum += gain;
        let after = sum - rate * length;
        if start.is_none_or(|(i, from)| after > from || k - i >= count) {
            start = Some((k, after));
        }
    }
    best
}

/// Pairs of ends joined, the nearest first; and open arcs closed.
fn joins(best: &Model) -> Vec<Change> {
    let open: Vec<(usize, &Arc)> = best
        .arcs
        .iter()
        .enumerate()
        .filter(|(_, a)| !a.fit.spline.closed())
        .collect();
    let mut changes = Vec::new();
    for (x, &(k, arc)) in open.iter().enumerate() {
        let own = guide(arc, arc.from, arc.to, false);
        let gap = gap_between(&own, &own);
        if gap <= REACH && own.vertices.len() > FEWEST {
            changes.push(Change {
                promise: -gap,
                guides: instead(best, &[k], vec![own.clone().closed()]),
            });
        }
        for &(l, other) in &open[x + 1..] {
            let other = guide(other, other.from, other.to, false);
            for (a, b) in [(false, false), (false, true), (true, false), (true, true)] {
                let either = |guide: &Guide, is_turned: bool| match is_turned {
                    true => guide.clone().turned(),
                    false => guide.clone(),
                };
                let (first, second) = (either(&own, a), either(&other, b));
                let gap = gap_between(&first, &second);
                if gap <= REACH {
                    let joined = first.and_then(second);
                    changes.push(Change {
                        promise: -gap,
                        guides: instead(best, &[k, l], vec![joined]),
                    });
                }
            }
        }
    }
    changes
}

/// From the last vertex of one guide to the first of another, in intervals.
fn gap_between(first: &Guide, second: &Guide) -> f64 {
    let (Some(a), Some(b)) = (first.vertices.last(), second.vertices.first()) else {
        return f64::INFINITY;
    };
    let spacing = first.spacing.last().copied().unwrap_or(0.0);
    let spacing = spacing.max(second.spacing.first().copied().unwrap_or(0.0));
    a.distance(*b) / spacing
}
