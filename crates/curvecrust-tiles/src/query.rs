//! The search for the choice of an open sample among the samples of all tiles.

use curvecrust_geometry::DVec2;
use curvecrust_geometry::point_set::by_coordinates;
use curvecrust_reconstruct::neighbours::{HalfPlane, HalfRule};

use crate::area::Area;
use crate::claim::Claim;
use crate::error::TilesError;
use crate::open_sample::{Lack, OpenSample};
use crate::sample::Sample;

/// A question to all tiles: which sample does an open sample choose?
///
/// It goes from area to area, the nearest first, for the nearest neighbour if that is not certain,
/// then for the half neighbour. Areas in which nothing better can be are not asked.
#[derive(Clone, Debug)]
pub struct Query {
    sample: Sample,
    rule: HalfRule,
    /// The area that was loaded, and need not be asked.
    seen: Area,
    step: Step,
    best: Option<Found>,
}

#[derive(Clone, Copy, Debug)]
enum Step {
    /// The nearest neighbour is sought. Beside it stands what was loaded: the nearest sample, and
    /// the half neighbour that goes with it.
    Nearest {
        nearest: Option<u64>,
        half: Option<Found>,
    },
    /// The half neighbour is sought.
    Half(HalfPlane),
}

/// A sample and the square of its distance.
#[derive(Clone, Copy, Debug)]
struct Found {
    sample: Sample,
    squared: f64,
}

impl Found {
    fn new(sample: Sample, from: DVec2) -> Self {
        let squared = (sample.point - from).length_squared();
        Self { sample, squared }
    }
}

/// Where a search is at.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Outcome {
    /// A choice was made, and another search follows.
    On(Claim),
    /// The last choice was made, or nothing is left to choose.
    Done(Option<Claim>),
}

impl Query {
    /// The question of an open sample, whose tile has seen all samples of the area `seen`.
    #[must_use]
    pub fn new(open: OpenSample, seen: Area, rule: HalfRule) -> Self {
        let OpenSample {
            sample,
            nearest,
            half,
            ..
        } = open;
        let found = |other: Option<Sample>| other.map(|other| Found::new(other, sample.point));
        let (step, best) = match (open.lacks, nearest) {
            (Lack::Half, Some(n0)) => {
                let plane = HalfPlane::new(rule, sample.point, n0.point);
                (Step::Half(plane), found(half))
            }
            _ => {
                let step = Step::Nearest {
                    nearest: nearest.map(|n0| n0.id),
                    half: found(half),
                };
                (step, found(nearest))
            }
        };
        Self {
            sample,
            rule,
            seen,
            step,
            best,
        }
    }

    /// The least square of a distance that a better sample in an area may have; `None` if none can
    /// be there. The area has to be that of samples, or of several areas.
    #[must_use]
    pub fn reach(&self, area: Area) -> Option<f64> {
        let s = self.sample.point;
        let squared = area.distance_squared(s);
        let worst = self.best.map_or(f64::MAX, |best| best.squared);
        if squared > worst || self.seen.covers(area) {
            return None;
        }
        let Step::Half(plane) = &self.step else {
            return Some(squared);
        };
        // The corner that lies deepest: if it is not in the half-plane, nothing is.
        let inwards = plane.inwards();
        let corner = DVec2::select(inwards.cmpgt(DVec2::ZERO), area.high, area.low);
        plane.contains(corner).then_some(squared)
    }

    /// Takes the best of some samples, if it is better than what is known.
    ///
    /// # Errors
    /// Another sample at the same place.
    pub fn offer(&mut self, samples: &[Sample]) -> Result<(), TilesError> {
        let s = self.sample;
        for &Sample { id, point } in samples {
            let squared = (point - s.point).length_squared();
            let worst = self.best.map_or(f64::INFINITY, |best| best.squared);
            // NaN is not better than anything.
            if squared > worst || squared.is_nan() || id == s.id {
                continue;
            }
            if squared <= 0.0 {
                return Err(TilesError::duplicate(s.id, id, s.point));
            }
            // -0.0 is 0.0, as in point sets.
            let point = point + DVec2::ZERO;
            let is_better = squared < worst
                || self
                    .best
                    .is_none_or(|best| by_coordinates(point, best.sample.point).is_lt());
            let is_wanted = match &self.step {
                Step::Nearest { .. } => true,
                Step::Half(plane) => plane.contains(point),
            };
            if is_better && is_wanted {
                let sample = Sample { id, point };
                self.best = Some(Found { sample, squared });
            }
        }
        Ok(())
    }

    /// Takes the best for what was sought, when no area is left that may hold a better one.
    pub(crate) fn settle(&mut self) -> Outcome {
        let chosen = self.best.map(|best| best.sample);
        let claim = chosen.map(|to| Claim {
            from: self.sample.id,
            to: to.id,
        });
        let (Step::Nearest { nearest, half }, Some(n0), Some(claim)) = (self.step, chosen, claim)
        else {
            return Outcome::Done(claim);
        };
        self.step = Step::Half(HalfPlane::new(self.rule, self.sample.point, n0.point));
        if nearest == Some(n0.id) {
            self.best = half;
        } else {
            // What was seen was not searched for this half-plane.
            self.best = None;
            self.seen = Area::NOTHING;
        }
        Outcome::On(claim)
    }
}
