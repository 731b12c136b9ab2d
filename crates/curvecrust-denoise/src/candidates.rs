//! Models at several scales and of several topologies, of which the score chooses one.

use std::num::NonZeroU32;

use curvecrust_reconstruct::{Known, Shape};

use crate::band::{Rule, Search, Windows, band};
use crate::chain::{Chain, Place, bridged, chains, guide, thinned};
use crate::ellipse::Ellipse;
use crate::known::{agreeing, through};
use crate::model::{Model, model};
use crate::options::Options;
use crate::refine::refined;
use crate::spline::Guide;

/// By how much larger the windows are than their scale asks for; the likelihood chooses.
const FACTORS: [f64; 4] = [0.75, 1.0, 1.4, 2.0];
/// With more points than this the scale itself is good enough.
const MANY: usize = 5_000;
/// Windows with these numbers of nearest points are tried too,
const NEAREST: [usize; 3] = [10, 20, 40];
/// if there are at most this many points: of few points a scale is hard to estimate.
const FEW: usize = 2_000;
/// Of more chains than this no tour is made: they are no pieces of one curve, and it takes long.
const PIECES: usize = 12;
/// How many of the models with the best scores have their curves cut and joined.
const REFINED: usize = 4;
/// The least evidence of curves against points that form none. Such points, spread evenly, reach
/// 0.4.
const EVIDENCE: f64 = 0.5;
/// The least evidence where none is taken away before, where windows hold the nearest points,
/// which always look like something, and of one tour of all. Even points reach 1.05.
const RELAXED_EVIDENCE: f64 = 2.0;
/// The least evidence of a ring against an ellipse that is filled. Points of squares reach 0.94.
const RING_EVIDENCE: f64 = 1.0;
/// If no curve is found: how many round neighbourhoods may pass for strokes.
const ALARMS: [f64; 3] = [1e2, 1e4, 1e6];

/// A model, and which points its band holds.
struct Candidate {
    model: Model,
    in_band: Vec<bool>,
}

/// The model of the best score, and which points its band holds; `None` if there is no curve. What
/// is known of sigma is in the unit of the windows.
pub(crate) fn best(
    all: &Windows,
    sigma: Option<f64>,
    options: &Options,
) -> Option<(Model, Vec<bool>)> {
    let trial = Trial {
        all,
        sigma,
        options,
    };
    let mut found = trial.sieved();
    if found.is_empty() {
        found = trial.relaxed();
    }
    found.sort_by(|a, b| b.model.score.total_cmp(&a.model.score));
    found.truncate(REFINED);
    let refined = found.into_iter().map(|candidate| {
        let points = &all.points;
        let model = refined(points, candidate.model, trial.sigma, options);
        (model, candidate.in_band)
    });
    // The first of equal ones.
    refined.reduce(|a, b| if b.0.score > a.0.score { b } else { a })
}

struct Trial<'a> {
    all: &'a Windows,
    sigma: Option<f64>,
    options: &'a Options,
}

impl Trial<'_> {
    fn sieved(&self) -> Vec<Candidate> {
        let count = self.all.points.len();
        let factors = match count > MANY {
            true => &FACTORS[1..2],
            false => &FACTORS[..],
        };
        let mut found = Vec::new();
        let search = |factor| Search {
            factor,
            sieve: true,
        };
        for &factor in factors {
            self.at(self.all, search(factor), EVIDENCE, &mut found);
        }
        if count <= FEW {
            for nearest in NEAREST {
                let windows = Windows::new(self.all.points.clone(), Rule::Nearest(nearest));
                self.at(&windows, search(1.0), RELAXED_EVIDENCE, &mut found);
            }
            found.extend(self.ring());
        }
        found
    }

    /// One closed curve that starts as an ellipse: a ring whose points scatter so much that no
    /// window shows a stroke still leaves a hole.
    fn ring(&self) -> Option<Candidate> {
        if !self.may_be_a_ring() {
            return None;
        }
        let points = &self.all.points;
        let ellipse = Ellipse::of(points);
        let model = model(points, &[ellipse.guide()], self.sigma)?;
        let is_ring = model.evidence_against(ellipse.area()) >= RING_EVIDENCE;
        is_ring.then(|| Candidate {
            model,
            in_band: vec![true; points.len()],
        })
    }

    /// Models where none is taken away before, and any stroke counts.
    fn relaxed(&self) -> Vec<Candidate> {
        let search = Search {
            factor: 1.0,
            sieve: false,
        };
        let mut found = Vec::new();
        for alarms in ALARMS {
            let all = Windows::new(self.all.points.clone(), Rule::Stroke { alarms });
            self.at(&all, search, RELAXED_EVIDENCE, &mut found);
            if !found.is_empty() {
                break;
            }
        }
        found
    }

    /// Adds the models along the chains of one search: as they are, and as one closed curve.
    fn at(&self, all: &Windows, search: Search, evidence: f64, found: &mut Vec<Candidate>) {
        let points = &all.points;
        let (members, in_band) = band(all, &search);
        if members.is_empty() {
            return;
        }
        let places = thinned(points, &members);
        let chains = bridged(chains(&places), &places, points, &all.tree);
        let one = self.as_one(&chains, &places);
        let chains = agreeing(chains, &places, self.options);
        let one = one.map(|one| (one, RELAXED_EVIDENCE));
        for (chains, evidence) in [Some((chains, evidence)), one].into_iter().flatten() {
            let guides: Vec<Guide> = chains.iter().map(|chain| guide(&places, chain)).collect();
            self.add(&guides, in_band.clone(), evidence, found);
        }
    }

    /// One closed chain instead of several or an open one, unless it is known to be another.
    fn as_one(&self, chains: &[Chain], places: &[Place]) -> Option<Vec<Chain>> {
        let is_one = matches!(chains, [chain] if chain.closed);
        if is_one || chains.len() > PIECES || !self.may_be_a_ring() {
            return None;
        }
        let one = Known {
            shape: Some(Shape::Closed),
            curves: NonZeroU32::new(1),
            termini: Vec::new(),
        };
        through(chains, places, &one)
    }

    /// Whether one closed curve agrees with what is known.
    fn may_be_a_ring(&self) -> bool {
        self.options.shape != Some(Shape::Open)
            && self.options.curves.is_none_or(|count| count.get() == 1)
    }

    fn add(&self, guides: &[Guide], in_band: Vec<bool>, evidence: f64, found: &mut Vec<Candidate>) {
        let model = model(&self.all.points, guides, self.sigma);
        if let Some(model) = model.filter(|model| model.evidence >= evidence) {
            found.push(Candidate { model, in_band });
        }
    }
}
