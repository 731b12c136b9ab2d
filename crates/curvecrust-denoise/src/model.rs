//! A model of all points: fitted curves, and which points belong to them.

use glam::DVec2;
use rayon::prelude::*;
use rstar::RTree;
use rstar::primitives::{GeomWithData, Line};

use crate::area::hull_area;
use crate::evidence;
use crate::spline::{Fit, Guide, Rough, Samples, fit};
use crate::tree::Tree;

/// A point within this many deviations of the chain takes part in the first fit.
const NEAR: f64 = 4.0;
/// Or within this share of the spacing of the chain.
const NEAR_CHAIN: f64 = 0.3;
/// A point belongs to a curve within this many local deviations.
const INLIER: f64 = 3.5;
/// The least deviation, in spacings of the points.
const FINEST: f64 = 1e-3;
/// Chords an interval, by which lengths are measured.
const DENSITY: f64 = 8.0;
/// The fewest points of a curve.
const FEWEST: usize = 6;
/// The expected number of points beyond an end, when points scatter by one spacing:
/// 1 / sqrt(2 pi).
const BEYOND: f64 = 0.399;

/// What a corner costs beside the freedom of its fit, in log n.
const CORNER: f64 = 0.5;

/// A fitted curve from one parameter to another.
#[derive(Clone, Debug)]
pub(crate) struct Arc {
    pub(crate) fit: Fit,
    pub(crate) from: f64,
    pub(crate) to: f64,
}

/// Where a point belongs.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Assigned {
    pub(crate) arc: usize,
    pub(crate) parameter: f64,
    pub(crate) distance: f64,
}

/// Curves and the points of each.
#[derive(Clone, Debug)]
pub(crate) struct Model {
    pub(crate) arcs: Vec<Arc>,
    /// By point; `None` for outliers.
    pub(crate) assigned: Vec<Option<Assigned>>,
    /// By point, outliers too.
    pub(crate) nearest: Vec<Assigned>,
    /// The log-likelihood, less log n for two degrees of freedom, an end or a corner.
    pub(crate) score: f64,
    likelihood: f64,
    /// By how many times its degrees of freedom the model explains the points better than if they
    /// were spread evenly over their hull.
    pub(crate) evidence: f64,
}

/// Fits a curve along each guide; `None` if no curve stands out from the background.
pub(crate) fn model(points: &[DVec2], guides: &[Guide], sigma: Option<f64>) -> Option<Model> {
    let near = members_of(points, guides);
    let fits: Vec<Option<Fit>> = guides
        .par_iter()
        .zip(&near)
        .map(|(guide, members)| {
            let enough = members.len() >= FEWEST;
            enough
                .then(|| fit(guide, members, sigma, Rough::Changes))
                .flatten()
        })
        .collect();
    Model::of(points, fits.into_iter().flatten().collect())
}

/// For each guide the points that lie near it and nearer than to any other.
fn members_of(points: &[DVec2], guides: &[Guide]) -> Vec<Vec<DVec2>> {
    let mut edges = Vec::new();
    for (g, guide) in guides.iter().enumerate() {
        let count = guide.vertices.len();
        let last = if guide.closed {
            count
        } else {
            count.saturating_sub(1)
        };
        for i in 0..last {
            let j = (i + 1) % count;
            let [a, b] = [guide.vertices[i], guide.vertices[j]];
            if a != b {
                let sigma = guide.sigma[i].max(guide.sigma[j]);
                let limit = (NEAR * sigma).max(NEAR_CHAIN * guide.spacing[i]);
                edges.push(GeomWithData::new(
                    Line::new(a.to_array(), b.to_array()),
                    (g, limit),
                ));
            }
        }
    }
    let tree = RTree::bulk_load(edges);
    let nearest: Vec<Option<usize>> = points
        .par_iter()
        .map(|p| {
            use rstar::PointDistance;
            let edge = tree.nearest_neighbor(p.to_array())?;
            let (guide, limit) = edge.data;
            (edge.geom().distance_2(&p.to_array()) < limit * limit).then_some(guide)
        })
        .collect();
    let mut members = vec![Vec::new(); guides.len()];
    for (&p, guide) in points.iter().zip(nearest) {
        if let Some(guide) = guide {
            members[guide].push(p);
        }
    }
    members
}

/// Assigns each point to the nearest curve, if it lies within the curve's spread; `None` without
/// curves.
fn assign(points: &[DVec2], fits: Vec<Fit>) -> Option<Model> {
    let samples: Vec<Samples> = fits.iter().map(|f| Samples::of(&f.spline)).collect();
    let mut all = Vec::new();
    let mut of = Vec::new();
    for (arc, samples) in samples.iter().enumerate() {
        all.extend_from_slice(samples.places());
        of.extend((0..samples.places().len()).map(|i| (arc, i)));
    }
    if all.is_empty() {
        return None;
    }
    let tree = Tree::new(&all);
    let place = |p: &DVec2| {
        let nearest = tree.nearest_one(*p).unwrap_or(0);
        let (arc, sample) = of[nearest];
        let (parameter, distance) = samples[arc].refined(*p, sample);
        let parameter = fits[arc].spline.wrapped(parameter);
        Assigned {
            arc,
            parameter,
            distance,
        }
    };
    let nearest: Vec<Assigned> = points.par_iter().map(place).collect();
    let floor: Vec<f64> = (0..fits.len())
        .map(|arc| {
            let count = nearest.iter().filter(|a| a.arc == arc).count();
            FINEST * length(samples[arc].places()) / count.max(1) as f64
        })
        .collect();
    let belongs = |a: &Assigned| {
        let sigma = fits[a.arc].spread.at(a.parameter).max(floor[a.arc]);
        a.distance <= INLIER * sigma
    };
    let assigned = nearest.iter().map(|&a| belongs(&a).then_some(a));
    let assigned: Vec<Option<Assigned>> = assigned.collect();
    let arcs = fits.into_iter().enumerate().map(|(k, fit)| {
        let own = assigned.iter().flatten().filter(|a| a.arc == k);
        let (from, to) = ends(&fit, own.map(|a| a.parameter).collect());
        Arc { fit, from, to }
    });
    let arcs = arcs.collect();
    Some(Model {
        arcs,
        assigned,
        nearest,
        score: f64::NEG_INFINITY,
        likelihood: f64::NEG_INFINITY,
        evidence: 0.0,
    })
}

/// The parameters between which a curve runs.
///
/// Points that scatter along an open curve lie beyond its end too. The end is where their density
/// has fallen to one half: beyond it are as many as scatter by a deviation lets expect.
fn ends(fit: &Fit, mut parameters: Vec<f64>) -> (f64, f64) {
    let whole = fit.spline.intervals() as f64;
    if fit.spline.closed() || parameters.len() < FEWEST {
        return (0.0, whole);
    }
    parameters.sort_unstable_by(f64::total_cmp);
    let end = |inwards: &[f64]| {
        // The density near the end, by a tenth of the points, but not by very few.
        let some = (inwards.len() / 10)
            .clamp(FEWEST - 1, 40)
            .min(inwards.len() - 1);
        let (first, inner) = (inwards[0], inwards[some]);
        let reach = fit.spline.point(first).distance(fit.spline.point(inner));
        let spacing = reach / some as f64;
        let sigma = fit.spread.at(first);
        let beyond = if spacing > 0.0 {
            BEYOND * sigma / spacing
        } else {
            0.0
        };
        let beyond = beyond.min(some as f64 - 1.0);
        // Half a spacing beyond the last point is as likely as short of it.
        let (mut i, mut left) = (0, beyond);
        while left >= 1.0 && i + 1 < inwards.len() {
            (i, left) = (i + 1, left - 1.0);
        }
        inwards[i] + left * (inwards[i + 1] - inwards[i])
    };
    let from = end(&parameters);
    parameters.reverse();
    let to = end(&parameters);
    if from < to { (from, to) } else { (0.0, whole) }
}

fn length(places: &[DVec2]) -> f64 {
    places
        .windows(2)
        .map(|pair| pair[0].distance(pair[1]))
        .sum()
}

impl Model {
    /// The model of fitted curves; `None` if none stands out from the background.
    pub(crate) fn of(points: &[DVec2], fits: Vec<Fit>) -> Option<Self> {
        let area = hull_area(points);
        let mut model = assign(points, fits)?;
        // A curve that the background explains as well goes, and its points are assigned anew.
        loop {
            let evidence = model.evidence_of_each(points.len(), area);
            if evidence.iter().all(|&e| e > 0.0) {
                break;
            }
            let arcs = model
                .arcs
                .into_iter()
                .zip(evidence)
                .filter(|(_, e)| *e > 0.0);
            model = assign(points, arcs.map(|(arc, _)| arc.fit).collect())?;
        }
        let (likelihood, freedom) = (model.likelihood(area), model.freedom());
        model.likelihood = likelihood;
        model.evidence = model.evidence_against(area);
        // Half of log n for a number that is fitted; an end, and a corner, is found among all
        // places of the curve.
        let log_n = (points.len() as f64).ln();
        let found = model.ends() + CORNER * model.corners();
        model.score = likelihood - (0.5 * freedom + found) * log_n;
        Some(model)
    }

    /// The points of each curve.
    pub(crate) fn counts(&self) -> Vec<usize> {
        let mut counts = vec![0; self.arcs.len()];
        for place in self.assigned.iter().flatten() {
            counts[place.arc] += 1;
        }
        counts
    }

    pub(crate) fn outliers(&self) -> usize {
        self.assigned.iter().filter(|a| a.is_none()).count()
    }

    /// For each curve, by how much it explains its points better than the background, less its
    /// degrees of freedom times log n.
    fn evidence_of_each(&self, count: usize, area: f64) -> Vec<f64> {
        let log_n = (count as f64).ln();
        let background = self.outliers().max(1) as f64 / area;
        let pairs = self.arcs.iter().zip(self.counts());
        pairs
            .map(|(arc, count)| {
                if count < FEWEST {
                    return f64::NEG_INFINITY;
                }
                let (length, sigma) = (arc.length(), arc.fit.spread.common());
                let gain = evidence::of_band(count as f64, length, sigma, background);
                gain - arc.fit.freedom * log_n
            })
            .collect()
    }

    /// The logarithm of the density of all points under the model.
    fn likelihood(&self, area: f64) -> f64 {
        let n = self.assigned.len() as f64;
        let outside = ((self.outliers() + 1) as f64 / n / area).ln();
        let pairs = self.arcs.iter().zip(self.counts());
        let lengths: Vec<f64> = self.arcs.iter().map(Arc::length).collect();
        let along = pairs
            .zip(&lengths)
            .map(|((_, c), l)| (c as f64 / n / l).ln());
        let along: Vec<f64> = along.collect();
        self.assigned
            .iter()
            .map(|place| match place {
                None => outside,
                Some(a) => {
                    let arc = &self.arcs[a.arc];
                    let finest = FINEST / n * lengths[a.arc];
                    let sigma = arc.fit.spread.at(a.parameter).max(finest);
                    along[a.arc] + evidence::log_normal(a.distance, sigma)
                }
            })
            .sum()
    }

    /// By how many times its degrees of freedom the model explains the points better than if they
    /// were spread evenly over an area.
    pub(crate) fn evidence_against(&self, area: f64) -> f64 {
        let nothing = -(self.assigned.len() as f64) * area.ln();
        (self.likelihood - nothing) / self.freedom()
    }

    /// The degrees of freedom of all curves. Each has a deviation and a share of the points
    /// besides.
    fn freedom(&self) -> f64 {
        self.arcs.iter().map(|arc| arc.fit.freedom + 2.0).sum()
    }

    /// The number of corners.
    fn corners(&self) -> f64 {
        let corners = self.arcs.iter().map(|arc| arc.fit.spline.creases().len());
        corners.sum::<usize>() as f64
    }

    /// The number of ends of open curves.
    fn ends(&self) -> f64 {
        let open = self.arcs.iter().filter(|arc| !arc.fit.spline.closed());
        2.0 * open.count() as f64
    }
}

impl Arc {
    /// The length of the curve, by eight chords an interval.
    pub(crate) fn length(&self) -> f64 {
        let whole = self.lengths().last().copied().unwrap_or(0.0);
        whole.max(f64::MIN_POSITIVE)
    }

    /// The lengths from the start up to places at equal steps of the parameter, eight or more an
    /// interval, both ends included.
    pub(crate) fn lengths(&self) -> Vec<f64> {
        let steps = ((self.to - self.from) * DENSITY).ceil().max(1.0);
        let (mut lengths, mut length, mut i) = (vec![0.0], 0.0, 1.0);
        let mut last = self.fit.spline.point(self.from);
        while i <= steps {
            let next = self.from + (self.to - self.from) * (i / steps);
            let next = self.fit.spline.point(next);
            length += last.distance(next);
            lengths.push(length);
            (last, i) = (next, i + 1.0);
        }
        lengths
    }

    /// The length up to a parameter, from [`lengths`](Self::lengths).
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "between 0 and the number of steps"
    )]
    pub(crate) fn length_at(&self, lengths: &[f64], t: f64) -> f64 {
        let last = lengths.len() - 1;
        let share = ((t - self.from) / (self.to - self.from)).clamp(0.0, 1.0);
        let place = share * last as f64;
        let i = (place.floor() as usize).min(last.saturating_sub(1));
        let j = (i + 1).min(last);
        lengths[i] + (place - i as f64) * (lengths[j] - lengths[i])
    }
}
