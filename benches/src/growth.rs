//! How processor time grows with the size of what is given.

use std::error::Error;
use std::time::{Duration, Instant};

use curvecrust_curve::DenseCurve;
use curvecrust_geometry::PointSet;
use curvecrust_medial_axis::{Estimator, MeasuredCurve};
use curvecrust_reconstruct::Reconstructor;
use curvecrust_testing::drawings::Drawing;
use curvecrust_testing::hard_points::HardPoints;
use curvecrust_testing::strategies::point_set;

/// Dense points on each cubic of a drawing.
pub const PER_SEGMENT: u32 = 30;

/// How many times as large the larger size is. Caches and a loaded machine change times by some ten
/// per cent, and so exponents by a few hundredths.
const APART: usize = 16;

/// Runs of one measurement, of which the fastest counts.
const RUNS: usize = 5;

/// What a size takes, and what about a sixteenth of it takes.
#[derive(Clone, Copy, Debug)]
pub struct Growth {
    /// The smaller size and its seconds.
    pub few: (usize, f64),
    /// The larger one.
    pub many: (usize, f64),
}

impl Growth {
    /// The exponent of the power of the size by which the time grows.
    #[must_use]
    pub fn exponent(&self) -> f64 {
        (self.many.1 / self.few.1).ln() / (self.many.0 as f64 / self.few.0 as f64).ln()
    }

    /// Seconds for each of the larger number of things.
    #[must_use]
    pub fn each(&self) -> f64 {
        self.many.1 / self.many.0 as f64
    }
}

/// That of the local feature size of a drawing with about so many dense points.
///
/// # Errors
///
/// That of a drawing without one.
pub fn of_lfs(drawing: &Drawing, points: usize) -> Result<Growth, Box<dyn Error>> {
    let time = |points: usize| -> Result<_, Box<dyn Error>> {
        let curve = (drawing.curve)(points / PER_SEGMENT as usize);
        let dense = DenseCurve::per_segment(&curve, PER_SEGMENT)?;
        let measure = || MeasuredCurve::new(dense.clone(), Estimator::Voronoi);
        measure()?;
        Ok((dense.len(), seconds(measure)))
    };
    Ok(Growth {
        few: time(points / APART)?,
        many: time(points)?,
    })
}

/// That of an algorithm on about so many points.
#[must_use]
pub fn of_algorithm(algorithm: &dyn Reconstructor, hard: &HardPoints, points: usize) -> Growth {
    let time = |points: usize| {
        let points: PointSet = point_set((hard.points)(points));
        (points.len(), seconds(|| algorithm.reconstruct(&points)))
    };
    Growth {
        few: time(points / APART),
        many: time(points),
    }
}

/// The seconds of processor time that the fastest of a few runs takes, in all threads.
pub fn seconds<T>(run: impl Fn() -> T) -> f64 {
    let mut least = f64::INFINITY;
    for _ in 0..RUNS {
        let start = Instant::now();
        let before = processor_time();
        let result = std::hint::black_box(run());
        let after = processor_time();
        let taken = match before.zip(after) {
            Some((before, after)) => after.saturating_sub(before),
            None => start.elapsed(),
        };
        drop(result);
        least = least.min(taken.as_secs_f64());
    }
    least
}

/// What all threads of this process have taken, where the system tells it.
fn processor_time() -> Option<Duration> {
    // Linux counts what a thread took when it leaves the processor, else some 250 times a second.
    std::thread::yield_now();
    let tasks = std::fs::read_dir("/proc/self/task").ok()?;
    let nanoseconds = tasks.map(|task| {
        let told = std::fs::read_to_string(task.ok()?.path().join("schedstat")).ok()?;
        told.split(' ').next()?.parse::<u64>().ok()
    });
    nanoseconds.sum::<Option<u64>>().map(Duration::from_nanos)
}

#[cfg(test)]
mod tests {
    use super::*;
    use curvecrust_testing::drawings::DRAWINGS;

    #[test]
    fn every_drawing_is_dense_enough_to_be_measured() {
        for drawing in DRAWINGS {
            assert!(of_lfs(drawing, 40_000).is_ok(), "{}", drawing.name);
        }
    }

    #[test]
    fn exponents_are_those_of_powers() {
        let growth = Growth {
            few: (10, 2.0),
            many: (40, 16.0),
        };
        assert!((growth.exponent() - 1.5).abs() < 1e-12);
    }
}
