//! `curvecrust sample`: samples of curves, as sparse as a condition allows.

use super::{Outcome, curves};
use crate::args::{self, Distance};
use crate::console::Console;
use crate::format::Format;
use crate::output::{self, Feature, Layer, Number, Output, Picture, Shape};
use anyhow::bail;
use curvecrust::DVec2;
use curvecrust::curve::Curve;
use curvecrust::evaluate::hausdorff;
use curvecrust::sampling::{Bound, Condition, SampledCurve, sample_greedy};
use serde::Serialize;
use serde_json::{Map, json};
use std::io::{self, Write};

/// The formats of samples, the one of stdout first.
const FORMATS: &[Format] = &[
    Format::Csv,
    Format::Text,
    Format::Json,
    Format::Geojson,
    Format::Svg,
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
    count: usize,
    hausdorff: Bounds,
}

/// Which samples belong to a component of the curve: those from `start` up to, without it, `end`.
#[derive(Serialize)]
struct Component {
    start: usize,
    end: usize,
    closed: bool,
}

/// The Hausdorff distance between the curve and the polygon of the samples lies between these; null
/// is infinite.
#[derive(Serialize)]
struct Bounds {
    lower: f64,
    upper: f64,
}

pub(crate) fn run(args: &args::Sample, console: &Console) -> anyhow::Result<Outcome> {
    let output = Output::new(&args.output, args.json, FORMATS)?;
    let curve = curves::read(&args.curve.path)?;
    let condition = condition(&args.condition, &curve)?;
    let measured = curves::measured(&args.curve, &curve, console)?;
    let samples = console.during("sampling", || sample_greedy(&measured, condition));
    if let Some(output) = output {
        match output.format {
            Format::Csv => output.write(|out| write_csv(out, &samples))?,
            Format::Text => output.write(|out| write_text(out, &samples))?,
            Format::Json => output.write_json(&object(&curve, &samples, condition)?)?,
            Format::Svg => {
                let layers = vec![Layer::Points(samples.points().to_vec())];
                output.write(|out| Picture { layers }.write(out))?;
            }
            _ => output.write_features(&features(&samples))?,
        }
    }
    if args.json {
        output::print_json(&object(&curve, &samples, condition)?)?;
    }
    let (name, bound) = bound(condition);
    console.say(format_args!(
        "{} samples for {name} < {bound}",
        samples.len()
    ));
    let closing = samples.closing_intervals().iter();
    let failing = closing.filter(|interval| !interval.holds);
    let failing: Vec<_> = failing.map(|interval| interval.component).collect();
    for component in &failing {
        console.say(format_args!(
            "curve {component}: the interval from the last sample back to the first fails the condition"
        ));
    }
    Ok(Outcome::fine_if(failing.is_empty()))
}

/// The condition that was typed, with a length for a share of the curve's extent.
fn condition(args: &args::Condition, curve: &Curve) -> anyhow::Result<Condition> {
    let condition = match (args.rho, args.epsilon) {
        (Some(rho), None) => Condition::rho(rho)?,
        (None, Some(epsilon)) => Condition::epsilon(epsilon)?,
        _ => bail!("give either --rho or --epsilon"),
    };
    Ok(match args.max_distance {
        None => condition,
        Some(Distance::Length(limit)) => condition.with_hausdorff_limit(limit)?,
        Some(Distance::Percent(share)) => {
            condition.with_hausdorff_limit(share / 100.0 * curve.extent())?
        }
    })
}

fn bound(condition: Condition) -> (&'static str, f64) {
    match condition.bound() {
        Bound::Epsilon(epsilon) => ("epsilon", epsilon),
        Bound::Rho(rho) => ("rho", rho),
    }
}

fn object(curve: &Curve, samples: &SampledCurve, condition: Condition) -> anyhow::Result<Object> {
    let tolerance = HAUSDORFF_TOLERANCE * curve.extent();
    let polygon = samples.manifold_boundary();
    let distance = hausdorff(curve, &samples.point_set()?, &polygon, tolerance).distance();
    let (name, bound) = bound(condition);
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
        hausdorff: Bounds {
            lower: distance.lower,
            upper: distance.upper,
        },
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

fn features(samples: &SampledCurve) -> Vec<Feature> {
    let feature = |(curve, part): (usize, &[DVec2])| {
        let mut properties = Map::new();
        properties.insert(String::from("curve"), json!(curve));
        Feature {
            shape: Shape::Points(part.to_vec()),
            properties,
        }
    };
    parts(samples).enumerate().map(feature).collect()
}
