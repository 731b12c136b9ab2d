//! The figures of `docs/algorithms.md`: what each algorithm does on the same six inputs.

use crate::compare::true_curves::arc;
use crate::figure::{Figure, Panel};
use crate::paper::figures::marked;
use curvecrust::DVec2;
use curvecrust::geometry::{Component, EdgeSet, PointSet, Random};
use curvecrust::reconstruct::{ALGORITHMS, Reconstructor};
use std::f64::consts::TAU;

/// Points, and the edges along the curves that they are of.
struct Input {
    name: &'static str,
    points: PointSet,
    truth: EdgeSet,
}

/// The points of a curve in order, and whether the last is joined with the first.
type Strand = (Vec<DVec2>, bool);

impl Input {
    fn new(name: &'static str, strands: Vec<Strand>) -> anyhow::Result<Self> {
        let mut points = Vec::new();
        let mut edges = Vec::new();
        for (strand, closed) in strands {
            let component = Component {
                range: points.len()..points.len() + strand.len(),
                closed,
            };
            edges.extend(component.edges());
            points.extend(strand);
        }
        Ok(Self {
            name,
            truth: EdgeSet::new(points.len(), edges),
            points: PointSet::new(points)?,
        })
    }

    /// What an algorithm makes of it.
    fn panel(&self, algorithm: &dyn Reconstructor) -> Panel {
        let found = algorithm.reconstruct(&self.points);
        let missing = self.truth.difference(&found).count();
        let added = found.difference(&self.truth).count();
        let verdict = if missing + added == 0 {
            String::from("right")
        } else {
            format!("{missing} missing, {added} wrong")
        };
        Panel {
            caption: format!("{}\n{verdict}", self.name),
            ..marked("", &self.points, &found)
        }
    }
}

/// A closed curve with a waist, at steps that vary by a factor of three.
fn uneven() -> Vec<Strand> {
    let steps = (0..36).map(|i| 1.0 + 0.5 * (f64::from(i) * 1.7).sin());
    let steps: Vec<f64> = steps.collect();
    let sum: f64 = steps.iter().sum();
    let mut along = 0.0;
    let at = steps.into_iter().map(|step| {
        along += TAU * step / sum;
        (3.0 + (2.0 * along).cos()) * DVec2::from_angle(along)
    });
    vec![(at.collect(), true)]
}

/// Two rings, one inside the other, nearer to each other than the inner one is wide.
fn rings() -> Vec<Strand> {
    let outer = arc(DVec2::ZERO, 4.0, 0.0, TAU, 30);
    vec![
        (outer, true),
        (arc(DVec2::X, 1.8, 0.1, TAU + 0.1, 16), true),
    ]
}

/// Three quarters of a circle, and a wave.
fn open() -> Vec<Strand> {
    let arc = arc(DVec2::ZERO, 3.0, 0.6, TAU - 0.6, 26);
    let wave = (0..16).map(|i| {
        let x = f64::from(i) * 0.6;
        DVec2::new(x - 4.5, 4.6 + 0.7 * x.sin())
    });
    vec![(arc, false), (wave.collect(), false)]
}

/// A star with five tips of 40 degrees.
fn corners() -> Vec<Strand> {
    let vertex = |i: u32| {
        let radius = if i.is_multiple_of(2) { 4.0 } else { 1.7 };
        radius * DVec2::from_angle(TAU * (f64::from(i) / 10.0 - 0.25))
    };
    let side = |i: u32| {
        let (from, to) = (vertex(i), vertex(i + 1));
        (0..5).map(move |step| from.lerp(to, f64::from(step) / 5.0))
    };
    vec![((0..10).flat_map(side).collect(), true)]
}

/// A figure of eight, which crosses itself between samples.
fn crossing() -> Vec<Strand> {
    let at = (0..40).map(|i| {
        let t = TAU * (f64::from(i) + 0.35) / 40.0;
        DVec2::new(4.0 * t.sin(), 3.0 * (2.0 * t).sin())
    });
    vec![(at.collect(), true)]
}

/// A ring, with some points that belong to nothing.
fn outliers() -> Vec<Strand> {
    let mut random = Random::new(5);
    let mut all = vec![(arc(DVec2::ZERO, 3.0, 0.0, TAU, 30), true)];
    all.extend((0..6).map(|_| {
        let radius = random.between(0.5, 1.7) * 2.2;
        let angle = random.between(0.0, TAU);
        (vec![radius * DVec2::from_angle(angle)], false)
    }));
    all
}

fn inputs() -> anyhow::Result<Vec<Input>> {
    [
        ("Uneven steps", uneven()),
        ("Two rings", rings()),
        ("Open curves", open()),
        ("Corners of 40 degrees", corners()),
        ("A crossing", crossing()),
        ("Outliers", outliers()),
    ]
    .into_iter()
    .map(|(name, strands)| Input::new(name, strands))
    .collect()
}

/// For every algorithm the name of its file, and its figure.
pub(crate) fn figures() -> anyhow::Result<Vec<(String, Figure)>> {
    let inputs = inputs()?;
    let figure = |&algorithm: &&'static dyn Reconstructor| {
        let name = algorithm.info().name;
        let figure = Figure {
            title: format!("{name} on six inputs"),
            columns: 3,
            panels: inputs.iter().map(|input| input.panel(algorithm)).collect(),
        };
        (format!("docs/images/algorithms/{name}.svg"), figure)
    };
    Ok(ALGORITHMS.iter().map(figure).collect())
}
