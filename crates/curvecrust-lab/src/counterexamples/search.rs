//! The search for curves and samples on which an algorithm fails.

use crate::compare::algorithms::named;
use crate::counterexamples::Counterexample;
use crate::counterexamples::dense::Dense;
use crate::counterexamples::proven::{ProvenSamples, polygons, prove, sampled};
use crate::counterexamples::shape::Shape;
use anyhow::Context;
use curvecrust::geometry::{PointSet, Random};
use curvecrust::reconstruct::Reconstructor;
use curvecrust::sampling::Bound;

/// What is searched for, and for how long.
#[derive(Clone, Copy, Debug)]
pub struct Search<'a> {
    /// The name of the algorithm that has to fail.
    pub algorithm: &'a str,
    /// Whether samples are placed by the rho condition instead of epsilon.
    pub rho: bool,
    /// How many control points the first spline has.
    pub control: usize,
    /// How many small rings there are beside it.
    pub rings: usize,
    /// Where random numbers start.
    pub seed: u64,
    /// How many shapes are tried.
    pub trials: usize,
}

/// Dense points of a segment, in the search and in its last part.
const COARSE: usize = 40;
const FINE: usize = 120;

/// Bounds that are tried for a random shape.
const BOUNDS: std::ops::Range<u32> = 20..160;

/// How many bounds above the one at dense points are tried to be proven, in steps of 0.0001.
const MORE: u32 = 500;

/// Factors of the least bound so far that are tried for a changed shape.
const LOWER: [f64; 6] = [0.9999, 0.9985, 0.995, 0.98, 0.95, 0.9];

/// A shape on which the algorithm fails for samples of a bound.
#[derive(Clone)]
struct Found {
    bound: f64,
    shape: Shape,
}

impl Search<'_> {
    /// The best counterexample that was found: its bound is the least one with four decimals that
    /// is proven, not much above the one at dense points.
    ///
    /// # Errors
    /// If there is no such algorithm, or no bound near the one at dense points is proven.
    pub fn run(&self) -> anyhow::Result<Option<Counterexample>> {
        let run = Run {
            search: *self,
            algorithm: named(self.algorithm)?,
        };
        let Some(Found { bound, shape }) = run.best() else {
            return Ok(None);
        };
        let dense = Dense::new(&shape.splines, FINE).context("a curve with a cusp")?;
        let samples = shape
            .samples(&dense, run.bound(bound))
            .context("no samples")?;
        let sampled = sampled(&shape.splines, &dense, &samples);
        let first = (bound * 1e4).ceil();
        let values = (0..MORE).map(|i| (first + f64::from(i)) / 1e4);
        let mut bounds = values.map(|value| run.bound(value));
        let bound = bounds.find(|bound| prove(&sampled, *bound).is_ok());
        Ok(Some(Counterexample {
            algorithm: self.algorithm.to_owned(),
            samples: ProvenSamples {
                bound: bound.context("no bound near the one at dense points is proven")?,
                sampled,
            },
        }))
    }
}

/// A search and its algorithm.
struct Run<'a> {
    search: Search<'a>,
    algorithm: &'static dyn Reconstructor,
}

impl Run<'_> {
    /// The shape of the least bound, at dense points.
    ///
    /// A part of the trials are random shapes. The best of them are changed at random as long as
    /// the algorithm fails at a smaller bound; then the best of these, and the best of those alone,
    /// with finer dense points.
    fn best(&self) -> Option<Found> {
        let trials = self.search.trials;
        let mut random = Random::new(self.search.seed);
        let starts = (0..trials / 10).filter_map(|_| self.start(&mut random));
        let mut found: Vec<Found> = starts.collect();
        for (keep, percent, dense) in [(12, 20, COARSE), (4, 30, COARSE), (1, 40, FINE)] {
            found.sort_by(|a, b| a.bound.total_cmp(&b.bound));
            found.truncate(keep);
            let each = trials * percent / 100 / found.len().max(1);
            for one in &mut found {
                self.settle(one, dense);
                self.improve(one, dense, each, &mut random);
            }
        }
        found.into_iter().next().filter(|one| one.bound.is_finite())
    }

    fn bound(&self, value: f64) -> Bound {
        if self.search.rho {
            Bound::Rho(value)
        } else {
            Bound::Epsilon(value)
        }
    }

    /// A random shape, if the algorithm fails on it.
    fn start(&self, random: &mut Random) -> Option<Found> {
        let shape = Shape::random(random, self.search.control, self.search.rings);
        let dense = Dense::new(&shape.splines, COARSE).filter(Dense::is_fine)?;
        let mut bounds = BOUNDS.map(|percent| f64::from(percent) / 100.0);
        let bound = bounds.find(|bound| self.fails(&shape, &dense, *bound))?;
        Some(Found { bound, shape })
    }

    /// Raises the bound to where the algorithm fails with these dense points.
    fn settle(&self, found: &mut Found, per_segment: usize) {
        let Some(dense) = Dense::new(&found.shape.splines, per_segment) else {
            return;
        };
        let mut bounds = (0..100).map(|i| found.bound * 1.002_f64.powi(i));
        let fails = bounds.find(|bound| self.fails(&found.shape, &dense, *bound));
        found.bound = fails.unwrap_or(f64::INFINITY);
    }

    /// Changes a shape as long as it gets better.
    fn improve(&self, found: &mut Found, per_segment: usize, trials: usize, random: &mut Random) {
        let mut size = 0.1_f64;
        for _ in 0..trials {
            let shape = found.shape.changed(random, size);
            match self.lower(&shape, found.bound, per_segment) {
                Some(bound) => {
                    *found = Found { bound, shape };
                    size = (1.6 * size).min(0.3);
                }
                None if size < 2e-4 => size = 0.05,
                None => size *= 0.98,
            }
        }
    }

    /// The least bound that was tried, below another one, at which the algorithm fails.
    fn lower(&self, shape: &Shape, than: f64, per_segment: usize) -> Option<f64> {
        let dense = Dense::new(&shape.splines, per_segment).filter(Dense::is_fine)?;
        let bounds = LOWER.map(|factor| factor * than).into_iter().rev();
        bounds
            .filter(|bound| bound.is_finite())
            .find(|bound| self.fails(shape, &dense, *bound))
    }

    /// Whether the algorithm does not return the polygons of the samples.
    fn fails(&self, shape: &Shape, dense: &Dense, bound: f64) -> bool {
        let Some(samples) = shape.samples(dense, self.bound(bound)) else {
            return false;
        };
        let places = samples.iter().flatten().map(|i| dense.points()[*i]);
        let Ok(points) = PointSet::new(places.collect()) else {
            return false;
        };
        let counts: Vec<usize> = samples.iter().map(Vec::len).collect();
        self.algorithm.reconstruct(&points) != polygons(&counts)
    }
}
