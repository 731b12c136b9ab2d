//! Curves and samples as numbers that a search can change a little.

use crate::counterexamples::dense::{Dense, Stretch};
use curvecrust::DVec2;
use curvecrust::geometry::Random;
use curvecrust::sampling::Bound;
use std::f64::consts::TAU;

/// Closed splines, and how their samples are placed.
#[derive(Clone, Debug)]
pub(super) struct Shape {
    /// The control points of each spline. All but the first are small rings.
    pub(super) splines: Vec<Vec<DVec2>>,
    /// Where the first sample of the first spline is, as a share of its parameters.
    start: f64,
    /// How long the first steps between its samples are, as shares of the longest possible ones.
    steps: Vec<f64>,
}

/// How many steps have shares of their own.
const STEPS: usize = 10;

/// The share of the longest step that others take, and those of rings.
const OTHER_STEPS: f64 = 0.7;
const STEPS_OF_RINGS: f64 = 0.35;

/// Steps are no shorter than this share.
const SHORTEST: f64 = 0.05;

impl Shape {
    /// A spline about the origin, and rings anywhere near it.
    pub(super) fn random(random: &mut Random, control: usize, rings: usize) -> Self {
        let on_circle = |i: usize, of: usize| DVec2::from_angle(TAU * i as f64 / of as f64);
        let main = (0..control).map(|i| {
            let radius = (1.0 + 0.35 * random.normal()).max(0.2);
            on_circle(i, control) * radius
        });
        let mut splines = vec![main.collect()];
        for _ in 0..rings {
            let centre = DVec2::new(random.normal(), random.normal());
            let ring = (0..5).map(|i| centre + 0.03 * on_circle(i, 5));
            splines.push(ring.collect());
        }
        Self {
            splines,
            start: random.unit(),
            steps: (0..STEPS).map(|_| random.between(0.3, 1.0)).collect(),
        }
    }

    /// A shape nearby: some of its numbers change, by about `size`.
    pub(super) fn changed(&self, random: &mut Random, size: f64) -> Self {
        let mut shape = self.clone();
        let all = random.unit() < 0.3;
        let [main, rings @ ..] = &mut shape.splines[..] else {
            return shape;
        };
        let chosen = random.below(main.len());
        for (i, point) in main.iter_mut().enumerate() {
            if all || i == chosen || random.unit() < 0.15 {
                let share = if all { 0.3 } else { 1.0 };
                *point += share * size * DVec2::new(random.normal(), random.normal());
            }
        }
        for ring in rings {
            let centre = ring.iter().sum::<DVec2>() / ring.len() as f64;
            let moved = centre + size * DVec2::new(random.normal(), random.normal());
            let scale = (0.5 * size * random.normal()).exp();
            for point in ring {
                *point = moved + (*point - centre) * scale;
            }
        }
        if random.unit() < 0.5 {
            shape.start += 0.3 * size * random.normal();
        }
        for step in &mut shape.steps {
            if random.unit() < 0.3 {
                *step = (*step + 2.0 * size * random.normal()).clamp(SHORTEST, 1.0);
            }
        }
        shape
    }

    /// The indices of dense points that are samples, spline by spline, each as far from the one
    /// before it as its share of the longest step; none if dense points are too coarse for that.
    pub(super) fn samples(&self, dense: &Dense, bound: Bound) -> Option<Vec<Vec<usize>>> {
        let mut samples = Vec::new();
        for (index, component) in dense.components().iter().enumerate() {
            let count = component.len();
            let start = if index == 0 {
                self.start.rem_euclid(1.0)
            } else {
                0.0
            };
            let first = component.range.start + part(start, count) % count;
            let share = |step: usize| match index {
                0 => self.steps.get(step).copied().unwrap_or(OTHER_STEPS),
                _ => STEPS_OF_RINGS,
            };
            let mut placed = Vec::new();
            let mut at = 0;
            loop {
                let first = component.after(first, at);
                placed.push(first);
                let stretch = |length| Stretch {
                    component,
                    first,
                    length,
                };
                let longest = longest(count - at, |length| dense.holds(&stretch(length), bound))?;
                if at + longest == count {
                    break;
                }
                at += part(share(placed.len() - 1), longest).max(1);
            }
            if placed.len() < 3 {
                return None;
            }
            placed.sort_unstable();
            samples.push(placed);
        }
        Some(samples)
    }
}

/// A share of a number, rounded down.
#[allow(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "a share is from 0 to 1"
)]
fn part(share: f64, of: usize) -> usize {
    (share * of as f64) as usize
}

/// The largest length up to `most` that holds, as if shorter ones held too; none if 1 does not.
fn longest(most: usize, holds: impl Fn(usize) -> bool) -> Option<usize> {
    if !holds(1) {
        return None;
    }
    let (mut length, mut step) = (1, 1);
    while length + step <= most && holds(length + step) {
        length += step;
        step *= 2;
    }
    while step > 0 {
        if length + step <= most && holds(length + step) {
            length += step;
        } else {
            step /= 2;
        }
    }
    Some(length)
}
