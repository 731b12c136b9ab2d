//! A model of all points: fitted curves, and which points belong to them.

use glam::DVec2;
use rayon::prelude::*;
use rstar::RTree;
use rstar::primitives::{GeomWithData, Line};

use crate::band::area_of;
use crate::chain::{Chain, Place};
use crate::spline::{Fit, Guide, Samples, fit};
use crate::tree::Tree;

/// A point within this many deviations of the chain takes part in the first fit.
const NEAR: f64 = 4.0;
/// Or within this share of the spacing of the chain.
const NEAR_CHAIN: f64 = 0.3;
/// A point belongs to a curve within this many local deviations.
const INLIER: f64 = 3.5;
/// The least deviation, in spacings of the points.
const FINEST: f64 = 1e-3;
/// The fewest points of a curve.
const FEWEST: usize = 6;
/// The width of a normal distribution that is as high as at its middle, in sigma.
const WIDTH: f64 = 4.13;
/// The expected number of points beyond an end, when points scatter by one spacing:
/// 1 / sqrt(2 pi).
const BEYOND: f64 = 0.399;

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
    /// The log-likelihood less the degrees of freedom times log n.
    pub(crate) score: f64,
}

/// Fits a curve to each chain; `None` if no curve stands out from the background.
pub(crate) fn model(
    points: &[DVec2],
    places: &[Place],
    chains: &[Chain],
    sigma: Option<f64>,
) -> Option<Model> {
    let near = members_of(points, places, chains);
    let fits: Vec<Option<Fit>> = chains
        .par_iter()
        .zip(&near)
        .map(|(chain, members)| {
            if members.len() < FEWEST {
                return None;
            }
            fit(&guide(places, chain), members, sigma)
        })
        .collect();
    let mut fits: Vec<Fit> = fits.into_iter().flatten().collect();
    let mut model = assign(points, &fits)?;
    // A curve that the background explains as well goes, and its points are assigned anew.
    loop {
        let evidence = model.evidence(points);
        let mut stands = evidence.iter().map(|&e| e > 0.0);
        let before = fits.len();
        fits.retain(|_| stands.next().unwrap_or(false));
        if fits.is_empty() {
            return None;
        }
        if fits.len() == before {
            break;
        }
        model = assign(points, &fits)?;
    }
    model.score = model.score(points);
    Some(model)
}

/// The polyline of a chain; at the ends of an open one a spacing longer, for points that scatter
/// beyond.
fn guide(places: &[Place], chain: &Chain) -> Guide {
    let mut along: Vec<Place> = chain.vertices.iter().map(|&v| places[v]).collect();
    let next = along.iter().cycle().skip(1);
    let area: f64 = along.iter().zip(next).map(|(a, b)| a.at.perp_dot(b.at)).sum();
    if chain.closed && area < 0.0 {
        along.reverse();
    }
    let mut vertices: Vec<DVec2> = along.iter().map(|p| p.at).collect();
    let mut spacing: Vec<f64> = along.iter().map(|p| p.spacing).collect();
    if let (false, [first, second, .., before, last]) = (chain.closed, &*along) {
        let beyond = |end: &Place, inner: &Place| {
            end.at + (end.at - inner.at).normalize_or_zero() * end.spacing
        };
        vertices.insert(0, beyond(first, second));
        spacing.insert(0, first.spacing);
        vertices.push(beyond(last, before));
        spacing.push(last.spacing);
    }
    Guide { vertices, spacing, closed: chain.closed }
}

/// For each chain the points that lie near it and nearer than to any other.
fn members_of(points: &[DVec2], places: &[Place], chains: &[Chain]) -> Vec<Vec<DVec2>> {
    let mut edges = Vec::new();
    for (c, chain) in chains.iter().enumerate() {
        let vertices = &chain.vertices;
        let after = vertices.iter().skip(1).chain(vertices.first().filter(|_| chain.closed));
        for (&a, &b) in vertices.iter().zip(after) {
            let [a, b] = [places[a], places[b]];
            if a.at != b.at {
                let limit = (NEAR * a.sigma.max(b.sigma)).max(NEAR_CHAIN * a.spacing);
                let line = Line::new(a.at.to_array(), b.at.to_array());
                edges.push(GeomWithData::new(line, (c, limit)));
            }
        }
    }
    let tree = RTree::bulk_load(edges);
    let nearest: Vec<Option<usize>> = points
        .par_iter()
        .map(|p| {
            use rstar::PointDistance;
            let edge = tree.nearest_neighbor(p.to_array())?;
            let (chain, limit) = edge.data;
            (edge.geom().distance_2(&p.to_array()) < limit * limit).then_some(chain)
        })
        .collect();
    let mut members = vec![Vec::new(); chains.len()];
    for (&p, chain) in points.iter().zip(nearest) {
        if let Some(chain) = chain {
            members[chain].push(p);
        }
    }
    members
}

/// Assigns each point to the nearest curve, if it lies within the curve's spread.
fn assign(points: &[DVec2], fits: &[Fit]) -> Option<Model> {
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
        let (nearest, _) = tree.nearest(*p).next()?;
        let (arc, sample) = of[nearest];
        let (parameter, distance) = samples[arc].refined(*p, sample);
        let parameter = fits[arc].spline.wrapped(parameter);
        Some(Assigned { arc, parameter, distance })
    };
    let mut assigned: Vec<Option<Assigned>> = points.par_iter().map(place).collect();
    let floor: Vec<f64> = (0..fits.len())
        .map(|arc| {
            let count = assigned.iter().flatten().filter(|a| a.arc == arc).count();
            FINEST * length(samples[arc].places()) / count.max(1) as f64
        })
        .collect();
    for place in &mut assigned {
        *place = place.filter(|a| {
            let sigma = fits[a.arc].spread.at(a.parameter).max(floor[a.arc]);
            a.distance <= INLIER * sigma
        });
    }
    let arcs = fits.iter().enumerate().map(|(k, fit)| {
        let own = assigned.iter().flatten().filter(|a| a.arc == k);
        let (from, to) = ends(fit, own.map(|a| a.parameter).collect());
        Arc { fit: fit.clone(), from, to }
    });
    Some(Model { arcs: arcs.collect(), assigned, score: f64::NEG_INFINITY })
}

/// The parameters between which a curve runs.
///
/// Points that scatter along an open curve lie beyond its end too. The end is where their density
/// has fallen to one half: beyond it are as many as scatter by a deviation lets expect.
fn ends(fit: &Fit, mut parameters: Vec<f64>) -> (f64, f64) {
    let whole = fit.spline.intervals() as f64;
    if fit.spline.closed || parameters.len() < FEWEST {
        return (0.0, whole);
    }
    parameters.sort_unstable_by(f64::total_cmp);
    let end = |inwards: &[f64]| {
        // The density near the end, by a tenth of the points, but not by very few.
        let some = (inwards.len() / 10).clamp(FEWEST - 1, 40).min(inwards.len() - 1);
        let (first, inner) = (inwards[0], inwards[some]);
        let reach = fit.spline.point(first).distance(fit.spline.point(inner));
        let spacing = reach / some as f64;
        let sigma = fit.spread.at(first);
        let beyond = if spacing > 0.0 { BEYOND * sigma / spacing } else { 0.0 };
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
    places.windows(2).map(|pair| pair[0].distance(pair[1])).sum()
}

impl Model {
    /// The points of each curve.
    fn counts(&self) -> Vec<usize> {
        let mut counts = vec![0; self.arcs.len()];
        for place in self.assigned.iter().flatten() {
            counts[place.arc] += 1;
        }
        counts
    }

    fn outliers(&self) -> usize {
        self.assigned.iter().filter(|a| a.is_none()).count()
    }

    /// For each curve, by how much it explains its points better than the background, less its
    /// degrees of freedom times log n.
    fn evidence(&self, points: &[DVec2]) -> Vec<f64> {
        let log_n = (points.len() as f64).ln();
        let background = self.outliers().max(1) as f64 / area_of(points);
        let pairs = self.arcs.iter().zip(self.counts());
        pairs
            .map(|(arc, count)| {
                if count < FEWEST {
                    return f64::NEG_INFINITY;
                }
                let (count, length) = (count as f64, arc.length());
                let width = WIDTH * arc.fit.spread.common().max(0.05 * length / count);
                let gain = (count / (length * width) / background).ln() - 1.0;
                count * gain - arc.fit.freedom * log_n
            })
            .collect()
    }

    fn score(&self, points: &[DVec2]) -> f64 {
        let n = points.len() as f64;
        let outside = ((self.outliers() + 1) as f64 / n / area_of(points)).ln();
        let pairs = self.arcs.iter().zip(self.counts());
        let along: Vec<f64> = pairs.map(|(a, c)| (c as f64 / n / a.length()).ln()).collect();
        let likelihood: f64 = self
            .assigned
            .iter()
            .map(|place| match place {
                None => outside,
                Some(a) => {
                    let arc = &self.arcs[a.arc];
                    let finest = FINEST / n * arc.length();
                    let sigma = arc.fit.spread.at(a.parameter).max(finest);
                    let z = a.distance / sigma;
                    along[a.arc] - 0.5 * z * z - (sigma * std::f64::consts::TAU.sqrt()).ln()
                }
            })
            .sum();
        let freedom: f64 = self.arcs.iter().map(|a| a.fit.freedom + 2.0).sum();
        likelihood - freedom * n.ln()
    }
}

impl Arc {
    /// The length of the curve, by eight chords an interval.
    pub(crate) fn length(&self) -> f64 {
        length(&self.polyline(8.0)).max(f64::MIN_POSITIVE)
    }

    /// Places in order along the curve, some an interval, both ends included.
    fn polyline(&self, density: f64) -> Vec<DVec2> {
        let steps = ((self.to - self.from) * density).ceil().max(1.0);
        let mut places = Vec::new();
        let mut i = 0.0;
        while i <= steps {
            let t = self.from + (self.to - self.from) * (i / steps);
            places.push(self.fit.spline.point(t));
            i += 1.0;
        }
        places
    }
}
