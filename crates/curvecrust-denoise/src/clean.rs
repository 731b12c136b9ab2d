//! Whether points lie on their curves, and which of them do not when the rest does.

use std::f64::consts::PI;

use glam::DVec2;

use curvecrust_geometry::{Chain, EdgeSet, PointSet};
use curvecrust_reconstruct::{HnnCrust, LeastDetour, Reconstructor};

use crate::chain::as_set;
use crate::model::{Assigned, Model};
use crate::robust::{NORMAL, median};

/// Points are clean whose residuals from the cubic through their neighbours have a deviation below
/// this share of the spacing.
const CLEAN: f64 = 0.05;
/// Points are not clean if HNN-Crust sees them scatter by as many spacings. It is far faster than
/// least detour on points that scatter, and sees a little more noise.
const SCATTERED: f64 = 4.0 * CLEAN;
/// A spike: a point whose removal takes this much of the turning about it, in radians,
const SPIKE: f64 = 0.7;
/// and leaves less than this share of it.
const LEFT: f64 = 0.5;
/// The points on each side about which turning is measured.
const SIDE: usize = 4;
/// A chain of the background has this many times the usual spacing.
const SPARSE: f64 = 3.0;
/// The points on each side of a point that tell whether it alone misses the curve.
const BESIDE: usize = 3;
/// A point near a curve is looked at, within this many spacings.
const NEAR: f64 = 4.0;
const ROUNDS: usize = 10;

/// The edges of least detour through the points, if these lie on them.
pub(crate) fn edges_if_clean(points: &PointSet) -> Option<EdgeSet> {
    if noise(points, &HnnCrust::MUTUAL.reconstruct(points).chains()) >= SCATTERED {
        return None;
    }
    let edges = LeastDetour.reconstruct(points);
    (noise(points, &edges.chains()) < CLEAN).then_some(edges)
}

/// Whether any point stands out of the curves that edges form, or is on none.
pub(crate) fn has_outliers(points: &PointSet, edges: &EdgeSet) -> bool {
    !outliers(points.points(), edges, |_| false).is_empty()
}

/// The deviation of points from the cubics through their neighbours in a chain, in spacings;
/// infinite of fewer than five such points.
fn noise(points: &PointSet, chains: &[Chain]) -> f64 {
    let mut residuals = Vec::new();
    for chain in chains {
        let along: Vec<DVec2> = chain.vertices().iter().map(|&v| points[v]).collect();
        let count = along.len();
        let (least, skip) = if chain.is_closed() { (6, 0) } else { (5, 2) };
        if count < least {
            continue;
        }
        let inner = skip..count - skip;
        residuals.extend(inner.filter_map(|i| {
            residual([count - 2, count - 1, 0, 1, 2].map(|step| along[(i + step) % count]))
        }));
    }
    if residuals.len() < 5 {
        return f64::INFINITY;
    }
    NORMAL * median(&mut residuals)
}

/// How far the middle of five points lies from the cubic through the others, across the curve, in
/// spacings; scaled so that white noise keeps its deviation.
fn residual([a, b, p, c, d]: [DVec2; 5]) -> Option<f64> {
    let (before, after) = (b.distance(p), p.distance(c));
    let gap = b.distance(c);
    // The parameter must not depend on the point itself: the gap of its neighbours, in proportion.
    let share = gap / (before + after);
    let (t1, t2) = (-before * share, after * share);
    let nodes = [t1 - a.distance(b), t1, t2, t2 + c.distance(d)];
    let mut place = DVec2::ZERO;
    let mut squares = 1.0;
    for (i, q) in [a, b, c, d].into_iter().enumerate() {
        let others = (0..4).filter(|&j| j != i);
        let weight: f64 = others.map(|j| nodes[j] / (nodes[j] - nodes[i])).product();
        place += weight * q;
        squares += weight * weight;
    }
    let across = (c - b).normalize_or_zero().perp_dot(p - place);
    let spacing = (a.distance(b) + before + after + c.distance(d)) / 4.0;
    let residual = across.abs() / squares.sqrt() / spacing;
    residual.is_finite().then_some(residual)
}

/// The sum of the angles by which a polyline turns.
fn turning(points: &[DVec2]) -> f64 {
    let turn = |w: &[DVec2]| {
        let [a, b] = [w[1] - w[0], w[2] - w[1]];
        a.perp_dot(b).atan2(a.dot(b)).abs().min(PI)
    };
    points.windows(3).map(turn).sum()
}

/// The points without those that stand out of clean curves.
pub(crate) fn without_spikes_at_all(points: &[DVec2]) -> Option<Vec<bool>> {
    let all = vec![true; points.len()];
    without_spikes(points, &all, all.clone())
}

/// The points that lie on clean curves: those of the band and those near the curves of the model,
/// without those that alone miss theirs, and without spikes.
pub(crate) fn on_curves(points: &[DVec2], band: &[bool], model: &Model) -> Option<Vec<bool>> {
    let counts = model.counts();
    let arcs = model.arcs.iter().zip(counts);
    let spacing: Vec<f64> = arcs.map(|(a, n)| a.length() / n.max(1) as f64).collect();
    let is_near = |a: &Assigned| a.distance < NEAR * spacing[a.arc];
    let near: Vec<bool> = model.nearest.iter().map(is_near).collect();
    let stays = near.iter().zip(band).zip(lone(model));
    let stays = stays.map(|((&near, &band), lone)| (near || band) && !lone);
    without_spikes(points, &near, stays.collect())
}

/// Whether each point misses its curve where nearly all points before and behind it are on it. At a
/// corner, which a spline rounds, several miss it one after the other.
fn lone(model: &Model) -> Vec<bool> {
    let mut along: Vec<Vec<(f64, usize)>> = vec![Vec::new(); model.arcs.len()];
    for (i, place) in model.nearest.iter().enumerate() {
        along[place.arc].push((place.parameter, i));
    }
    let mut lone = vec![false; model.nearest.len()];
    for (arc, mut along) in model.arcs.iter().zip(along) {
        along.sort_unstable_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
        let count = along.len();
        let is_on = |k: usize| model.assigned[along[k].1].is_some();
        for k in 0..count {
            let around = (1..=BESIDE).flat_map(|step| {
                let round = arc.fit.spline.closed() && count > 2 * BESIDE;
                let before = k.checked_sub(step).or(round.then(|| k + count - step));
                let after = Some(k + step).filter(|&j| j < count);
                [before, after.or(round.then(|| (k + step) % count))]
            });
            let around: Vec<bool> = around.flatten().map(is_on).collect();
            let on = around.iter().filter(|&&on| on).count();
            lone[along[k].1] = !is_on(k) && on > BESIDE && on + 1 >= around.len();
        }
    }
    lone
}

/// The points that stay, without spikes and isolated points; without ends that turn off, and chains
/// that are short or far sparser than the others, where these are not near a curve.
fn without_spikes(points: &[DVec2], near: &[bool], mut stays: Vec<bool>) -> Option<Vec<bool>> {
    for _ in 0..ROUNDS {
        let ids: Vec<usize> = (0..points.len()).filter(|&i| stays[i]).collect();
        let set = as_set(ids.iter().map(|&i| points[i]))?;
        let found = LeastDetour.reconstruct(&set.points);
        let id = |i: usize| ids[set.origin[i]];
        let dropped = outliers(set.points.points(), &found, |i| !near[id(i)]);
        if dropped.is_empty() {
            break;
        }
        for i in dropped {
            stays[id(i)] = false;
        }
    }
    Some(stays)
}

/// The points that stand out of the chains of edges, and those without an edge; `is_outside` are
/// the points far from the curves of the model.
fn outliers(places: &[DVec2], edges: &EdgeSet, is_outside: impl Fn(usize) -> bool) -> Vec<usize> {
    let pairs = edges.edges().iter().map(|e| e.ends().map(|v| v.index()));
    let usual = spacing(places, pairs);
    let mut dropped: Vec<usize> = edges.isolated().iter().map(|v| v.index()).collect();
    for chain in edges.chains() {
        let along: Vec<usize> = chain.vertices().iter().map(|v| v.index()).collect();
        let outside = along.iter().filter(|&&i| is_outside(i)).count();
        let own = spacing(places, along.windows(2).map(|w| [w[0], w[1]]));
        if 2 * outside > along.len() && (along.len() < 5 || own > SPARSE * usual) {
            dropped.extend(along);
            continue;
        }
        if along.len() < 5 {
            continue;
        }
        dropped.extend(spikes(places, &along, chain.is_closed()));
        if !chain.is_closed() {
            dropped.extend(loose_ends(places, &along).filter(|&i| is_outside(i)));
        }
    }
    dropped
}

/// The median distance of pairs of places; 0 of none.
fn spacing(places: &[DVec2], pairs: impl Iterator<Item = [usize; 2]>) -> f64 {
    let mut lengths: Vec<f64> = pairs.map(|[i, j]| places[i].distance(places[j])).collect();
    median(&mut lengths)
}

/// Inner points of a chain that stand out; of those near each other only the worst.
fn spikes(places: &[DVec2], along: &[usize], closed: bool) -> Vec<usize> {
    let count = along.len();
    let round = closed && count > 2 * SIDE;
    let inner = if closed { 0..count } else { 1..count - 1 };
    let mut found = Vec::new();
    for i in inner {
        let window: Vec<usize> = if round {
            (0..=2 * SIDE)
                .map(|k| (i + count + k - SIDE) % count)
                .collect()
        } else {
            (i.saturating_sub(SIDE)..=(i + SIDE).min(count - 1)).collect()
        };
        let at = |k: &usize| places[along[*k]];
        let with: Vec<DVec2> = window.iter().map(at).collect();
        let without: Vec<DVec2> = window.iter().filter(|&&k| k != i).map(at).collect();
        let (with, without_it) = (turning(&with), turning(&without));
        if without.len() >= 4 && with - without_it > SPIKE && without_it < LEFT * with {
            found.push((with - without_it, i));
        }
    }
    found.sort_unstable_by(|a, b| b.0.total_cmp(&a.0).then(a.1.cmp(&b.1)));
    let mut taken: Vec<usize> = Vec::new();
    for (_, i) in found {
        let apart = |&j: &usize| {
            let d = i.abs_diff(j);
            if closed { d.min(count - d) > 3 } else { d > 3 }
        };
        if taken.iter().all(apart) {
            taken.push(i);
        }
    }
    taken.iter().map(|&i| along[i]).collect()
}

/// Ends of an open chain that turn off or stand far away.
fn loose_ends<'a>(places: &'a [DVec2], along: &'a [usize]) -> impl Iterator<Item = usize> + 'a {
    let inwards = [along.to_vec(), along.iter().rev().copied().collect()];
    inwards.into_iter().filter_map(|ids: Vec<usize>| {
        let at: Vec<DVec2> = ids.iter().take(6).map(|&i| places[i]).collect();
        let steps: Vec<f64> = at.windows(2).map(|w| w[0].distance(w[1])).collect();
        let (first, rest) = steps.split_first()?;
        let longest = rest.iter().copied().fold(0.0, f64::max);
        (turning(&at[..3]) > 1.0 || *first > 3.0 * longest).then_some(ids[0])
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn circle(n: u32) -> Vec<DVec2> {
        let angle = |i: u32| f64::from(i) * std::f64::consts::TAU / f64::from(n);
        (0..n).map(|i| DVec2::from_angle(angle(i))).collect()
    }

    #[test]
    fn a_circle_has_no_noise() {
        let points = PointSet::new(circle(40)).unwrap();
        let found = LeastDetour.reconstruct(&points);
        // The fourth power of an eighth of a radian, and a share of it since chords stand for arcs.
        let noise = noise(&points, &found.chains());
        assert!(noise < 2e-3, "{noise}");
    }

    #[test]
    fn a_spike_is_found_and_nothing_else() {
        let mut points = circle(40);
        points.push(DVec2::from_angle(0.08) * 1.2);
        let stays = without_spikes_at_all(&points).unwrap();
        assert_eq!(stays.iter().filter(|&&s| !s).count(), 1);
        assert!(!stays[40]);
    }
}
