//! A cell: one input at one value of the sweep, from which each trial draws points with a known
//! truth.

use super::drawn::Sampled;
use super::experiment::{Ends, Experiment, Input, Over, Tip};
use super::jumps::{Bound, Jumps};
use super::outlines::Outlines;
use super::shapes;
use super::true_curves::{Named, Part, TrueCurves};
use anyhow::Context;
use curvecrust::DVec2;
use curvecrust::geometry::{Component, EdgeSet, PointId, PointSet, Random};
use curvecrust::sampling::{Outliers, with_outliers};
use std::collections::BTreeMap;
use std::sync::Arc;

/// The curves of names: they are measured once.
pub(super) type Fixtures = BTreeMap<Named, Arc<TrueCurves>>;

/// What to run: an input of an experiment at a value of its sweep.
#[derive(Clone, Debug)]
pub(super) struct Job {
    pub(super) experiment: Arc<Experiment>,
    pub(super) input: Input,
    /// The curve, for inputs that have several.
    pub(super) curve: Option<Named>,
    /// The outlines, for inputs that are of files.
    pub(super) outlines: Option<Arc<Outlines>>,
    pub(super) x: f64,
    pub(super) trials: u32,
}

/// A job that is ready for its trials.
pub(super) struct Cell {
    pub(super) curves: Arc<TrueCurves>,
    steps: Vec<Steps>,
    ends: Ends,
    /// In spacings.
    noise: f64,
    /// For each sample.
    outliers: f64,
}

/// How a part of the curves is sampled.
enum Steps {
    /// Under a condition.
    Jumps { jumps: Jumps, thinning: f64 },
    /// At jittered equal lengths.
    Lengths {
        spacing: f64,
        jitter: f64,
        start: Start,
    },
}

/// Where the first sample of a closed part is.
#[derive(Clone, Copy)]
enum Start {
    /// Anywhere.
    Random,
    /// On the first point.
    Sampled,
    /// So that the first point is in the middle of an interval.
    Skipped,
}

/// How far outliers may be outside of the bounding box, in extents.
const MARGIN: f64 = 0.05;

impl Job {
    /// The name of the series: the group's, and the curve's.
    pub(super) fn series(&self) -> String {
        let (Input::Curves { group, .. }
        | Input::Teardrop { group, .. }
        | Input::Racetracks { group, .. }
        | Input::Circles { group, .. }
        | Input::Sine { group, .. }
        | Input::Spiral { group, .. }
        | Input::Arcs { group, .. }
        | Input::Shapes { group, .. }
        | Input::Outlines { group }
        | Input::Planted { group }) = &self.input;
        match (&self.curve, &self.outlines) {
            (Some(curve), _) => format!("{group}/{curve}"),
            (None, Some(outlines)) => format!("{group}, {}", outlines.name),
            (None, None) => group.clone(),
        }
    }

    /// Makes the curves ready.
    pub(super) fn prepare(&self, fixtures: &Fixtures) -> anyhow::Result<Cell> {
        let x = self.x;
        let over = self.experiment.sweep.over;
        let unmarked = |curves: TrueCurves, jitter: f64, start: Start| {
            Cell::evenly(curves, 1.0, jitter, start, Ends::Unmarked)
        };
        Ok(match &self.input {
            Input::Curves {
                epsilon,
                thinning,
                ends,
                ..
            } => {
                let curves = self.curve.as_ref().and_then(|name| fixtures.get(name));
                let curves = curves.context("its curve was not measured")?;
                let bound = match (over, epsilon) {
                    (Over::Rho, _) => Bound::Rho(x),
                    (_, Some(epsilon)) => Bound::Epsilon(*epsilon),
                    (_, None) => Bound::Epsilon(x),
                };
                let steps = |part: &Part| Steps::Jumps {
                    jumps: Jumps::new(part, bound),
                    thinning: *thinning,
                };
                Cell {
                    steps: curves.parts.iter().map(steps).collect(),
                    curves: Arc::clone(curves),
                    ends: *ends,
                    noise: if over == Over::Noise { x } else { 0.0 },
                    outliers: if over == Over::Outliers { x } else { 0.0 },
                }
            }
            Input::Teardrop { tip, jitter, .. } => {
                let start = match tip {
                    Tip::Sampled => Start::Sampled,
                    Tip::Skipped => Start::Skipped,
                };
                unmarked(TrueCurves::teardrop(x), *jitter, start)
            }
            Input::Racetracks { jitter, .. } => {
                unmarked(TrueCurves::racetracks(x), *jitter, Start::Random)
            }
            Input::Circles { jitter, .. } => {
                unmarked(TrueCurves::circles(x), *jitter, Start::Random)
            }
            Input::Sine { jitter, ends, .. } => {
                Cell::evenly(TrueCurves::sine(), x, *jitter, Start::Random, *ends)
            }
            Input::Spiral { jitter, ends, .. } => {
                Cell::evenly(TrueCurves::spiral(), x, *jitter, Start::Random, *ends)
            }
            Input::Arcs { jitter, ends, .. } => {
                Cell::evenly(TrueCurves::arcs(), x, *jitter, Start::Random, *ends)
            }
            Input::Shapes { shape, jitter, .. } => {
                unmarked(shapes::curves(*shape, x), *jitter, Start::Random)
            }
            Input::Outlines { .. } => anyhow::bail!("outlines are points already"),
            Input::Planted { .. } => anyhow::bail!("planted points are for run times only"),
        })
    }
}

impl Cell {
    fn evenly(curves: TrueCurves, spacing: f64, jitter: f64, start: Start, ends: Ends) -> Self {
        let steps = || Steps::Lengths {
            spacing,
            jitter,
            start,
        };
        Self {
            steps: curves.parts.iter().map(|_| steps()).collect(),
            curves: Arc::new(curves),
            ends,
            noise: 0.0,
            outliers: 0.0,
        }
    }

    /// Draws the points of a trial.
    pub(super) fn draw(&self, seed: u64) -> anyhow::Result<Sampled> {
        let mut random = Random::new(seed);
        let mut points = Vec::new();
        let mut edges = Vec::new();
        let mut termini = Vec::new();
        for (part, steps) in self.curves.parts.iter().zip(&self.steps) {
            let samples = match steps {
                Steps::Jumps { jumps, thinning } => jumps.sample(*thinning, &mut random),
                Steps::Lengths {
                    spacing,
                    jitter,
                    start,
                } => along(part, *spacing, *jitter, *start, &mut random),
            };
            let first = points.len();
            points.extend(samples);
            let component = Component {
                range: first..points.len(),
                closed: part.closed,
            };
            edges.extend(component.edges());
            if !part.closed && self.ends == Ends::Marked {
                let mut inner = first..points.len();
                let ends = [inner.next(), inner.next_back()];
                termini.extend(ends.into_iter().flatten().filter_map(PointId::new));
            }
        }
        let boundary = EdgeSet::new(points.len(), edges);
        if self.noise > 0.0 {
            points = self.displaced(&points, &boundary, &mut random);
        }
        if self.outliers > 0.0 {
            let count = rounded(points.len() as f64 * self.outliers);
            let outliers = Outliers {
                count,
                margin: MARGIN,
                seed: !seed,
            };
            points = with_outliers(&points, outliers)?;
        }
        Ok(Sampled {
            boundary: EdgeSet::new(points.len(), boundary.edges().iter().copied()),
            points: PointSet::new(points)?,
            termini,
        })
    }

    /// Normal noise, whose deviation is a share of the mean length of the edges at a sample.
    fn displaced(&self, points: &[DVec2], boundary: &EdgeSet, random: &mut Random) -> Vec<DVec2> {
        let mut around = vec![(0.0, 0.0); points.len()];
        for edge in boundary.edges() {
            let [a, b] = edge.ends().map(PointId::index);
            for i in [a, b] {
                around[i].0 += points[a].distance(points[b]);
                around[i].1 += 1.0;
            }
        }
        let moved = |(&p, (sum, count)): (&DVec2, (f64, f64))| {
            p + self.noise * sum / f64::max(count, 1.0)
                * DVec2::new(random.normal(), random.normal())
        };
        points.iter().zip(around).map(moved).collect()
    }
}

/// Samples at nearly equal lengths along a part, each moved by up to half of `jitter` of the
/// spacing.
fn along(part: &Part, spacing: f64, jitter: f64, start: Start, random: &mut Random) -> Vec<DVec2> {
    let mut corners = part.points.clone();
    if part.closed {
        corners.extend(part.points.first());
    }
    let mut lengths = vec![0.0];
    for pair in corners.windows(2) {
        lengths.push(lengths[lengths.len() - 1] + pair[0].distance(pair[1]));
    }
    let total = lengths[lengths.len() - 1];
    let at = |length: f64| {
        let after = lengths
            .partition_point(|l| *l < length)
            .clamp(1, corners.len() - 1);
        let (from, to) = (lengths[after - 1], lengths[after]);
        corners[after - 1].lerp(corners[after], (length - from) / (to - from))
    };
    let count = rounded(total / spacing).max(if part.closed { 3 } else { 1 });
    let step = total / count as f64;
    let mut jittered = |i: usize| (i as f64 + random.between(-0.5, 0.5) * jitter) * step;
    if !part.closed {
        let inner: Vec<f64> = (1..count).map(jittered).collect();
        return [0.0]
            .into_iter()
            .chain(inner)
            .chain([total])
            .map(at)
            .collect();
    }
    match start {
        Start::Sampled => {
            let others: Vec<f64> = (1..count).map(jittered).collect();
            [0.0].into_iter().chain(others).map(at).collect()
        }
        Start::Skipped => (0..count).map(|i| at(jittered(i) + 0.5 * step)).collect(),
        Start::Random => {
            let places: Vec<f64> = (0..count).map(jittered).collect();
            let phase = random.unit() * total;
            places
                .iter()
                .map(|place| at((place + phase).rem_euclid(total)))
                .collect()
        }
    }
}

#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "a count of points"
)]
pub(super) fn rounded(value: f64) -> usize {
    value.round() as usize
}

#[cfg(test)]
mod tests {
    use super::*;

    fn part() -> Part {
        let square = [(0.0, 0.0), (10.0, 0.0), (10.0, 10.0), (0.0, 10.0)];
        Part {
            points: square.map(|(x, y)| DVec2::new(x, y)).to_vec(),
            closed: true,
            lfs: Vec::new(),
        }
    }

    #[test]
    fn the_tip_is_sampled_or_skipped() {
        let mut random = Random::new(1);
        let mut nearest = |start| {
            let samples = along(&part(), 1.0, 0.3, start, &mut random);
            assert_eq!(samples.len(), 40);
            samples
                .iter()
                .map(|p| p.length())
                .fold(f64::INFINITY, f64::min)
        };
        assert!(nearest(Start::Sampled) < 1e-12);
        assert!(nearest(Start::Skipped) > 0.3);
    }

    #[test]
    fn open_parts_have_both_ends() {
        let open = Part {
            closed: false,
            ..part()
        };
        let samples = along(&open, 2.0, 0.5, Start::Random, &mut Random::new(2));
        assert_eq!(samples.len(), 16);
        assert_eq!(samples[0], open.points[0]);
        assert!(samples[15].distance(open.points[3]) < 1e-12);
        for pair in samples.windows(2) {
            assert!(pair[0].distance(pair[1]) < 3.0 + 1e-9);
        }
    }
}
