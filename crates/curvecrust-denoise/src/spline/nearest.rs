//! The parameter of the nearest place of a spline, by samples of it.

use glam::DVec2;

use super::basis::Spline;
use crate::tree::Tree;

/// Samples an interval.
const DENSITY: usize = 8;
/// How far the nearest place may move along the curve from one fit to the next, in samples.
const REACH: usize = 2 * DENSITY;

/// Places of a spline in order, eight an interval.
#[derive(Clone, Debug)]
pub(crate) struct Samples {
    places: Vec<DVec2>,
    closed: bool,
}

impl Samples {
    pub(crate) fn of(spline: &Spline) -> Self {
        let count = spline.intervals() * DENSITY + usize::from(!spline.closed());
        let at = |i: usize| spline.point(i as f64 / DENSITY as f64);
        Self {
            places: (0..count).map(at).collect(),
            closed: spline.closed(),
        }
    }

    pub(crate) fn places(&self) -> &[DVec2] {
        &self.places
    }

    /// The parameters nearest to points that may be anywhere.
    pub(crate) fn nearest_of_all(&self, points: &[DVec2]) -> Vec<f64> {
        let tree = Tree::new(&self.places);
        let nearest = |p: &DVec2| {
            let sample = tree.nearest_one(*p).unwrap_or(0);
            self.refined(*p, sample).0
        };
        points.iter().map(nearest).collect()
    }

    fn step(&self, sample: usize, steps: isize) -> Option<usize> {
        let count = self.places.len();
        if self.closed {
            // Steps are far fewer than samples, or go round.
            let round = count as isize;
            usize::try_from((sample as isize + steps).rem_euclid(round)).ok()
        } else {
            sample.checked_add_signed(steps).filter(|&i| i < count)
        }
    }

    /// The parameter on the two segments at a sample, and the distance.
    pub(crate) fn refined(&self, p: DVec2, sample: usize) -> (f64, f64) {
        let a = self.places[sample];
        let mut best = (sample as f64, a.distance(p));
        for step in [-1, 1] {
            let Some(next) = self.step(sample, step) else {
                continue;
            };
            let b = self.places[next] - a;
            let squared = b.length_squared();
            let share = if squared > 0.0 {
                (p - a).dot(b) / squared
            } else {
                0.0
            };
            let share = share.clamp(0.0, 1.0);
            let distance = (a + b * share).distance(p);
            if distance < best.1 {
                best = (sample as f64 + step as f64 * share, distance);
            }
        }
        (best.0 / DENSITY as f64, best.1)
    }

    /// The nearest parameter not far from a known one.
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "a parameter of the spline, times eight"
    )]
    fn near(&self, p: DVec2, t: f64) -> f64 {
        let centre = ((t * DENSITY as f64).round().max(0.0) as usize).min(self.places.len() - 1);
        let mut best = (centre, self.places[centre].distance_squared(p));
        for steps in 1..=REACH as isize {
            for step in [-steps, steps] {
                if let Some(sample) = self.step(centre, step) {
                    let squared = self.places[sample].distance_squared(p);
                    if squared < best.1 {
                        best = (sample, squared);
                    }
                }
            }
        }
        self.refined(p, best.0).0
    }
}

/// Moves parameters to the nearest places of a spline that has changed a little.
pub(crate) fn follow(samples: &Samples, points: &[DVec2], parameters: &mut [f64]) {
    for (p, t) in points.iter().zip(parameters) {
        *t = samples.near(*p, *t);
    }
}
