//! `curvecrust evaluate`: what algorithms find, against the curve that was sampled.

use super::bare_points::{BarePoints, PointSource};
use super::curve_source::CurveSource;
use super::{Bounds, Outcome};
use crate::args::{self, Algorithm, Distance};
use crate::console::Console;
use crate::output;
use anyhow::Context;
use curvecrust::curve::Curve;
use curvecrust::evaluate::{EdgeComparison, hausdorff};
use curvecrust::geometry::{Edge, EdgeSet};
use curvecrust::sampling::PlacedSamples;
use serde::Serialize;
use std::io::{self, Write};

/// How exactly the Hausdorff distance is computed, as a share of the extent.
const HAUSDORFF_TOLERANCE: f64 = 1e-4;

/// What `--json` prints; the schema is stable, and in `docs/formats.md`. Points are known by their
/// position in the input.
#[derive(Serialize)]
struct Object {
    points: usize,
    true_edges: usize,
    results: Vec<Evaluation>,
}

#[derive(Serialize)]
struct Evaluation {
    algorithm: &'static str,
    exact: bool,
    correct: usize,
    missing: Vec<[u32; 2]>,
    wrong: Vec<[u32; 2]>,
    curve_to_polygon: Bounds,
    polygon_to_curve: Bounds,
}

/// Which algorithms are compared, on which samples of which curve.
#[derive(Debug)]
pub(crate) struct Job {
    curve: CurveSource,
    points: PointSource,
    algorithms: Vec<Algorithm>,
    tolerance: Distance,
    json: bool,
}

impl From<args::Evaluate> for Job {
    fn from(args: args::Evaluate) -> Self {
        Self {
            curve: args.curve.into(),
            points: args.points.into(),
            algorithms: args.algorithm,
            tolerance: args.tolerance.tolerance,
            json: args.json,
        }
    }
}

impl Job {
    pub(crate) fn run(self, console: &Console) -> anyhow::Result<Outcome> {
        let split = self.curve.read(console)?;
        let bare = self.points.read(console)?;
        let strokes = self.curve.measure_strokes(split, |_| Ok(None), console)?;
        let (curve, measured) = (strokes.split.pieces(), strokes.measured);
        let tolerance = self.tolerance.of_extent(curve.extent());
        let placed = PlacedSamples::project(&measured, bare.points.points(), tolerance)
            .with_context(|| self.points.name())?;
        let truth = placed.manifold_boundary(&measured);
        let algorithms = self.algorithms.iter();
        let results = console.during("evaluating", |_| {
            algorithms
                .map(|&algorithm| evaluate(curve, &bare, &truth, algorithm))
                .collect()
        });
        let object = Object {
            points: bare.points.len(),
            true_edges: truth.len(),
            results,
        };
        if self.json {
            output::print_json(&object)?;
        } else {
            output::to_stdout(|out| write(out, &object))?;
        }
        Ok(Outcome::fine_if(
            object.results.iter().all(|result| result.exact),
        ))
    }
}

fn evaluate(curve: &Curve, bare: &BarePoints, truth: &EdgeSet, algorithm: Algorithm) -> Evaluation {
    let found = algorithm.reconstruct(&bare.points);
    let comparison = EdgeComparison::new(truth, &found);
    let tolerance = HAUSDORFF_TOLERANCE * curve.extent();
    let distance = hausdorff(curve, &bare.points, &found, tolerance);
    let rows = |edges: &[Edge]| {
        let edges = edges.iter();
        edges.map(|edge| edge.ends().map(|v| bare.row(v))).collect()
    };
    Evaluation {
        algorithm: algorithm.info().name,
        exact: comparison.is_exact(),
        correct: comparison.correct.len(),
        missing: rows(&comparison.missing),
        wrong: rows(&comparison.wrong),
        curve_to_polygon: distance.curve_to_polygon.into(),
        polygon_to_curve: distance.polygon_to_curve.into(),
    }
}

fn write(out: &mut dyn Write, object: &Object) -> io::Result<()> {
    let Object {
        points, true_edges, ..
    } = object;
    writeln!(out, "{points} points, {true_edges} true edges")?;
    writeln!(
        out,
        "{:18} {:>8} {:>8} {:>8} {:>14} {:>14}",
        "algorithm", "correct", "missing", "wrong", "curve to edges", "edges to curve"
    )?;
    for result in &object.results {
        writeln!(
            out,
            "{:18} {:>8} {:>8} {:>8} {:>14.4} {:>14.4}",
            result.algorithm,
            result.correct,
            result.missing.len(),
            result.wrong.len(),
            result.curve_to_polygon.upper,
            result.polygon_to_curve.upper
        )?;
    }
    Ok(())
}
