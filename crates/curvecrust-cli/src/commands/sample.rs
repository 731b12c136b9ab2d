//! `curvecrust sample`: samples of curves, as sparse as a condition allows.

use super::{Bounds, Outcome, curves};
use crate::args::{self, Corners, Count};
use crate::console::Console;
use crate::format::Format;
use crate::input;
use crate::output::{self, Feature, Layer, Number, Output, Picture, Places, Shape, npy};
use anyhow::{Context, bail};
use curvecrust::DVec2;
use curvecrust::curve::{Curve, SplitCurve};
use curvecrust::evaluate::hausdorff;
use curvecrust::geometry::Progress;
use curvecrust::medial_axis::MeasuredCurve;
use curvecrust::reconstruct::hnn_crust;
use curvecrust::sampling::{
    Condition, DeviationLimit, SampleOptions, SampledCurve, Sampling, VerifyOptions, sample,
    sample_curve_with, sample_fewest_with, sample_split_with, sample_verified_with,
};
use serde::Serialize;
use std::io::{self, Write};

/// The formats of samples, the one of stdout first.
const FORMATS: &[Format] = &[
    Format::Csv,
    Format::Text,
    Format::Json,
    Format::Geojson,
    Format::Wkt,
    Format::Dxf,
    Format::Svg,
    Format::Npy,
];

/// How exactly the Hausdorff distance is computed, as a share of the extent.
const HAUSDORFF_TOLERANCE: f64 = 1e-4;

/// What `--json` prints; the schema is stable, and in `docs/formats.md`.
#[derive(Serialize)]
struct Object {
    samples: Vec<[f64; 2]>,
    components: Vec<Component>,
    condition: &'static str,
    bound: f64,
    max_distance: Option<f64>,
    /// The largest value that the samples attain.
    attained: Option<Bounds>,
    count: usize,
    /// Between the curve and the polygon of the samples.
    hausdorff: Bounds,
}

/// Which samples belong to a component of the curve: those from `start` up to, without it, `end`.
#[derive(Serialize)]
struct Component {
    start: usize,
    end: usize,
    closed: bool,
}

/// What GeoJSON tells about the samples of a component.
#[derive(Serialize)]
struct Properties {
    curve: usize,
}

pub(crate) fn run(args: &args::Sample, console: &Console) -> anyhow::Result<Outcome> {
    let output = Output::new(&args.output, args.json, FORMATS)?;
    let (curve, condition, sampling) = match args.corners {
        Corners::Refuse => {
            let curve = curves::read_or_say_split(&args.curve.path)?;
            let condition = condition(args, &curve)?;
            let given = (args.curve.gap.is_some() || args.curve.per_segment.is_some())
                .then(|| curves::measured(&args.curve, &curve, None, console))
                .transpose()?;
            let sampling = taken(args, &curve, given, condition, console)
                .with_context(|| input::name(&args.curve.path))?;
            (curve, condition, sampling)
        }
        Corners::Split => {
            let split = curves::read_split(&args.curve.path)?;
            let (condition, sampling) = from_corner_to_corner(args, &split, console)
                .with_context(|| input::name(&args.curve.path))?;
            (split.pieces().clone(), condition, sampling)
        }
    };
    let samples = &sampling.samples;
    if let Some(output) = output {
        match output.format {
            Format::Csv => output.write(|out| write_csv(out, samples))?,
            Format::Text => output.write(|out| write_text(out, samples))?,
            Format::Npy => {
                let rows = samples.points().iter().map(|p| p.to_array());
                output.write(|out| npy::write_f64(out, rows))?;
            }
            Format::Json => output.write_json(&object(&curve, condition, &sampling)?)?,
            Format::Svg => {
                let layers = vec![Layer::Points(samples.points())];
                output.write(|out| Picture { layers }.write(out))?;
            }
            _ => output.write_features(features(samples))?,
        }
    }
    if args.json {
        output::print_json(&object(&curve, condition, &sampling)?)?;
    }
    let (name, bound) = curves::bound(condition);
    let verified = if args.count == Count::Verified {
        ", fewer than the condition asks for: verified for this sample set only"
    } else {
        ""
    };
    console.say(format_args!(
        "{} samples for {name} < {bound}{verified}",
        samples.len()
    ));
    Ok(Outcome::Fine)
}

fn condition(args: &args::Sample, curve: &Curve) -> anyhow::Result<Condition> {
    let condition = curves::condition(&args.condition, curve)?;
    condition.context("give either --rho or --epsilon")
}

/// Samples of every smooth piece, put together; what attains the bound is a piece.
fn from_corner_to_corner(
    args: &args::Sample,
    split: &SplitCurve,
    console: &Console,
) -> anyhow::Result<(Condition, Sampling)> {
    if args.curve.gap.is_some() || args.curve.per_segment.is_some() || args.count != Count::Fewest {
        bail!("--corners split goes without --gap, --per-segment and --count");
    }
    let condition = condition(args, split.pieces())?;
    let sampling = console.during("sampling", |progress| {
        let progress = Progress::new(progress);
        sample_split_with(split, condition, &SampleOptions { progress })
    })?;
    let samples = &sampling.samples;
    let corners = split.corners().len();
    if corners > 0 {
        let found = if hnn_crust(&samples.point_set()?) == samples.manifold_boundary() {
            "returns exactly the polygon"
        } else {
            "does not return the polygon"
        };
        console.say(format_args!(
            "{corners} corners, which no theorem covers: HNN-Crust {found} of these samples"
        ));
    }
    Ok((condition, sampling))
}

/// Samples as they were asked for, at dense points that are given, or as many as needed.
fn taken(
    args: &args::Sample,
    curve: &Curve,
    given: Option<MeasuredCurve>,
    condition: Condition,
    console: &Console,
) -> anyhow::Result<Sampling> {
    let greedy = match given {
        Some(measured) => sample(&measured, condition)?,
        None => console.during("sampling", |progress| {
            let progress = Progress::new(progress);
            sample_curve_with(curve, condition, &SampleOptions { progress })
        })?,
    };
    match args.count {
        Count::Greedy => Ok(greedy),
        Count::Fewest => Ok(console.during("sampling from every start", |progress| {
            let progress = Progress::new(progress);
            sample_fewest_with(&greedy.measured, condition, &SampleOptions { progress })
        })?),
        Count::Verified => Ok(console.during("taking samples away", |progress| {
            let default = VerifyOptions::default();
            let limit = condition.hausdorff_limit();
            let options = VerifyOptions {
                deviation: limit.map_or(default.deviation, DeviationLimit::Length),
                progress: Progress::new(progress),
                ..default
            };
            sample_verified_with(&greedy, &options)
        })?),
    }
}

fn object(curve: &Curve, condition: Condition, sampling: &Sampling) -> anyhow::Result<Object> {
    let Sampling {
        samples, attained, ..
    } = sampling;
    let tolerance = HAUSDORFF_TOLERANCE * curve.extent();
    let polygon = samples.manifold_boundary();
    let distance = hausdorff(curve, &samples.point_set()?, &polygon, tolerance).distance();
    let (name, bound) = curves::bound(condition);
    let components = samples.components().iter().map(|component| Component {
        start: component.range.start,
        end: component.range.end,
        closed: component.closed,
    });
    Ok(Object {
        samples: samples.points().iter().map(|p| p.to_array()).collect(),
        components: components.collect(),
        condition: name,
        bound,
        max_distance: condition.hausdorff_limit(),
        count: samples.len(),
        attained: attained.map(|attained| Bounds {
            lower: attained.bound,
            upper: attained.at_most,
        }),
        hausdorff: distance.into(),
    })
}

/// The samples of every component, in order along it.
fn parts(samples: &SampledCurve) -> impl Iterator<Item = &[DVec2]> {
    let components = samples.components().iter();
    components.map(|component| &samples.points()[component.range.clone()])
}

fn write_csv(out: &mut dyn Write, samples: &SampledCurve) -> io::Result<()> {
    writeln!(out, "curve,x,y")?;
    for (curve, part) in parts(samples).enumerate() {
        for p in part {
            writeln!(out, "{curve},{},{}", Number(p.x), Number(p.y))?;
        }
    }
    Ok(())
}

fn write_text(out: &mut dyn Write, samples: &SampledCurve) -> io::Result<()> {
    let mut points = samples.points().iter();
    points.try_for_each(|p| writeln!(out, "{} {}", Number(p.x), Number(p.y)))
}

fn features(samples: &SampledCurve) -> impl Iterator<Item = Feature<'_, Properties>> {
    parts(samples).enumerate().map(|(curve, part)| Feature {
        shape: Shape::Points(Places::all(part)),
        properties: Properties { curve },
    })
}
