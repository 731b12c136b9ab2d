//! `curvecrust check`: how good samples are, and whether a condition holds.

use super::bare_points::{BarePoints, PointSource};
use super::condition::{Requirement, name_and_bound};
use super::curve_source::{CurveSource, MeasuredStrokes};
use super::guarantee::open_curves;
use super::{Bounds, Outcome};
use crate::args::{self, Distance};
use crate::console::Console;
use crate::output::{self, Number};
use anyhow::Context;
use curvecrust::curve::SplitCurve;
use curvecrust::sampling::{
    Attained, Condition, OnPieces, Verdict, check, effective_epsilon, effective_rho,
    project_on_pieces,
};
use serde::Serialize;
use std::io::{self, Write};

/// What `--json` prints; the schema is stable, and in `docs/formats.md`.
#[derive(Serialize)]
struct Object {
    effective_epsilon: Option<Bounds>,
    effective_rho: Option<Bounds>,
    /// `None` without a condition.
    holds: Option<bool>,
    /// Whether it is certain to hold between dense points too.
    certain: Option<bool>,
    /// The samples at the ends of open curves, by their position in the input.
    termini: Vec<u32>,
    violations: Vec<Violation>,
}

/// An interval on which the condition does not hold.
#[derive(Serialize)]
struct Violation {
    component: usize,
    /// The samples around it, by their position in the input; `None` if the curve has no sample.
    samples: [Option<u32>; 2],
    value: Bounds,
    /// The worst point.
    at: [f64; 2],
    /// How far the curve is from the chord.
    distance: Bounds,
}

/// Which samples are measured on which curve, and what they have to satisfy.
#[derive(Debug)]
pub(crate) struct Job {
    curve: CurveSource,
    points: PointSource,
    requirement: Option<Requirement>,
    tolerance: Distance,
    json: bool,
}

impl Job {
    pub(crate) fn new(args: args::Check) -> anyhow::Result<Self> {
        Ok(Self {
            requirement: Requirement::new(&args.condition)?,
            curve: args.curve.into(),
            points: args.points.into(),
            tolerance: args.tolerance.tolerance,
            json: args.json,
        })
    }

    pub(crate) fn run(self, console: &Console) -> anyhow::Result<Outcome> {
        let split = self.curve.read(console)?;
        let bare = self.points.read(console)?;
        let asked = |split: &SplitCurve| {
            let on = |r: Requirement| r.on(split.pieces());
            self.requirement.map(on).transpose()
        };
        let strokes = self.curve.measure_strokes(split, asked, console)?;
        let (split, condition) = (&strokes.split, strokes.condition);
        let tolerance = self.tolerance.of_extent(split.pieces().extent());
        let points = bare.points.points();
        let placed = project_on_pieces(split, &strokes.pieces, points, tolerance)
            .with_context(|| self.points.name())?;
        if let Some(first) = placed.missed.first() {
            console.note(format_args!(
                "{}: no sample is at {} of the corners, first ({}, {}), where the local feature size \
                 is 0: nothing holds beside them",
                self.curve.name(),
                placed.missed.len(),
                Number(first.x),
                Number(first.y)
            ));
        }
        if let Some(open) = open_curves(split.components()) {
            console.note(format_args!("{}: {open}", self.curve.name()));
        }
        let object = object(&strokes, &placed, condition, &bare);
        if self.json {
            output::print_json(&object)?;
        } else {
            output::to_stdout(|out| write(out, &object, condition))?;
        }
        Ok(Outcome::fine_if(object.holds != Some(false)))
    }
}

fn object(
    strokes: &MeasuredStrokes,
    placed: &OnPieces,
    condition: Option<Condition>,
    bare: &BarePoints,
) -> Object {
    let measured = &placed.measured;
    let verdict = condition.map(|condition| check(measured, &placed.samples, condition));
    let stroke = |piece: usize| {
        let strokes = strokes.split.components().iter();
        strokes
            .take_while(|stroke| stroke.range.end <= piece)
            .count()
    };
    let row = |sample: usize| {
        let id = bare.points.ids().nth(placed.indices[sample]);
        id.map(|id| bare.row(id))
    };
    let violations = verdict.iter().flat_map(|verdict| &verdict.violations);
    let epsilon = effective_epsilon(measured, &placed.samples);
    let rho = effective_rho(measured, &placed.samples);
    Object {
        effective_epsilon: epsilon.as_ref().map(value),
        effective_rho: rho.as_ref().map(value),
        holds: verdict.as_ref().map(Verdict::holds),
        certain: verdict.as_ref().map(|verdict| verdict.certain),
        termini: termini(strokes, placed)
            .into_iter()
            .filter_map(row)
            .collect(),
        violations: violations
            .map(|found| Violation {
                component: stroke(found.interval.component),
                samples: found.interval.samples.map(|sample| sample.and_then(row)),
                value: value(found),
                at: found.at.to_array(),
                distance: Bounds {
                    lower: found.deviation,
                    upper: found.deviation_at_most,
                },
            })
            .collect(),
    }
}

/// The samples at the ends of strokes that are open.
fn termini(strokes: &MeasuredStrokes, placed: &OnPieces) -> Vec<usize> {
    let pieces = placed.measured.dense().components().iter();
    let pieces = pieces.zip(placed.samples.components()).enumerate();
    let open = pieces.filter(|(_, (piece, _))| !piece.closed);
    open.flat_map(|(index, (piece, samples))| {
        let [before, after] = strokes.split.meetings(index);
        samples.clone().filter(move |&sample| {
            let place = placed.samples.placements()[sample];
            let is_at = |end: usize| place.dense == end && place.t <= 0.0;
            before.is_none() && is_at(piece.range.start)
                || after.is_none() && is_at(piece.range.end - 1)
        })
    })
    .collect()
}

fn value(found: &Attained) -> Bounds {
    Bounds {
        lower: found.bound,
        upper: found.at_most,
    }
}

fn write(out: &mut dyn Write, object: &Object, condition: Option<Condition>) -> io::Result<()> {
    let effective = [
        ("epsilon", object.effective_epsilon),
        ("rho", object.effective_rho),
    ];
    for (name, value) in effective {
        if let Some(Bounds { lower, upper }) = value {
            writeln!(out, "effective {name}: {lower:.4}, at most {upper:.4}")?;
        }
    }
    let Some(condition) = condition else {
        return Ok(());
    };
    let (name, bound) = name_and_bound(condition);
    for violation in &object.violations {
        let end = |sample: Option<u32>| match sample {
            Some(row) => format!("sample {row}"),
            None => String::from("no sample"),
        };
        let [from, to] = violation.samples.map(end);
        writeln!(
            out,
            "violated on curve {} from {from} to {to}: {name} is {:.4} near ({:.6}, {:.6}), distance {:.6}",
            violation.component,
            violation.value.lower,
            violation.at[0],
            violation.at[1],
            violation.distance.lower
        )?;
    }
    let verdict = match (object.holds, object.certain) {
        (Some(true), Some(true)) => "holds",
        (Some(true), _) => {
            "holds at every dense point; a smaller --gap may make it certain in between"
        }
        _ => "does not hold",
    };
    let limit = match condition.hausdorff_limit() {
        Some(limit) => format!(", within a distance of {limit:.6},"),
        None => String::new(),
    };
    writeln!(out, "{name} < {bound}{limit} {verdict}")
}
