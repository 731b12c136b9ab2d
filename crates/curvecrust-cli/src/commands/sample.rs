//! `curvecrust sample`: samples of curves, as sparse as a condition allows.

use super::condition::{Requirement, name_and_bound};
use super::curve_source::CurveSource;
use super::{Bounds, Outcome};
use crate::args::{self, Corners, Count};
use crate::console::Console;
use crate::format::Format;
use crate::output::{Feature, Layer, Number, Output, Picture, Places, Results, Shape, npy};
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

/// The properties of the samples of a component in GeoJSON.
#[derive(Serialize)]
struct Properties {
    curve: usize,
}

/// Which curves are sampled and how, and where the samples go.
#[derive(Debug)]
pub(crate) struct Job {
    curve: CurveSource,
    requirement: Requirement,
    method: Method,
    results: Results,
}

/// How samples are taken.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Method {
    /// Of smooth curves.
    Smooth(Count),
    /// Of curves split at their corners.
    Split,
}

impl Job {
    pub(crate) fn new(args: args::Sample) -> anyhow::Result<Self> {
        let results = Results::new(args.output, args.json, FORMATS)?;
        let requirement = Requirement::new(&args.condition)?;
        let curve = CurveSource::from(args.curve);
        let method = match args.corners {
            Corners::Refuse => Method::Smooth(args.count),
            Corners::Split => Method::Split,
        };
        if method == Method::Split
            && (curve.discretisation().is_some() || args.count != Count::Fewest)
        {
            bail!("--corners split cannot be used with --gap, --per-segment or --count");
        }
        Ok(Self {
            curve,
            requirement: requirement.context("give either --rho or --epsilon")?,
            method,
            results,
        })
    }

    pub(crate) fn run(self, console: &Console) -> anyhow::Result<Outcome> {
        let (curve, sampled) = match self.method {
            Method::Smooth(count) => {
                let curve = self.curve.read_or_advise_split()?;
                let sampled = self.sample_smooth(&curve, count, console)?;
                (curve, sampled)
            }
            Method::Split => {
                let split = self.curve.read_split()?;
                let sampled = self.sample_pieces(&split, console);
                let sampled = sampled.with_context(|| self.curve.name())?;
                (split.pieces().clone(), sampled)
            }
        };
        if let Some(output) = &self.results.output {
            write(output, &curve, &sampled)?;
        }
        self.results.print_json(|| object(&curve, &sampled))?;
        let (name, bound) = name_and_bound(sampled.condition);
        let verified = if self.method == Method::Smooth(Count::Verified) {
            ", fewer than the condition asks for: verified for this sample set only"
        } else {
            ""
        };
        console.note(format_args!(
            "{} samples for {name} < {bound}{verified}",
            sampled.sampling.samples.len()
        ));
        Ok(Outcome::Fine)
    }

    /// Samples of every smooth piece, put together; what attains the bound is a piece.
    fn sample_pieces(&self, split: &SplitCurve, console: &Console) -> anyhow::Result<Sampled> {
        let condition = self.requirement.on(split.pieces())?;
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
            console.note(format_args!(
                "{corners} corners, which no theorem covers: HNN-Crust {found} of these samples"
            ));
        }
        Ok(Sampled {
            condition,
            sampling,
        })
    }

    /// Samples of smooth curves, at the dense points that were asked for or at as many as needed.
    fn sample_smooth(
        &self,
        curve: &Curve,
        count: Count,
        console: &Console,
    ) -> anyhow::Result<Sampled> {
        let condition = self.requirement.on(curve)?;
        let measured = (self.curve.discretisation().is_some())
            .then(|| self.curve.measure(curve, None, console))
            .transpose()?;
        let sampling = chosen(curve, measured, condition, count, console);
        Ok(Sampled {
            condition,
            sampling: sampling.with_context(|| self.curve.name())?,
        })
    }
}

/// Samples, and the condition that they were taken for.
struct Sampled {
    condition: Condition,
    sampling: Sampling,
}

/// The samples that were asked for among all that satisfy the condition.
fn chosen(
    curve: &Curve,
    measured: Option<MeasuredCurve>,
    condition: Condition,
    count: Count,
    console: &Console,
) -> anyhow::Result<Sampling> {
    let greedy = match measured {
        Some(measured) => sample(&measured, condition)?,
        None => console.during("sampling", |progress| {
            let progress = Progress::new(progress);
            sample_curve_with(curve, condition, &SampleOptions { progress })
        })?,
    };
    match count {
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

fn write(output: &Output, curve: &Curve, sampled: &Sampled) -> anyhow::Result<()> {
    let samples = &sampled.sampling.samples;
    match output.format {
        Format::Csv => output.write(|out| write_csv(out, samples)),
        Format::Text => output.write(|out| write_text(out, samples)),
        Format::Npy => {
            let rows = samples.points().iter().map(|p| p.to_array());
            output.write(|out| npy::write_f64(out, rows))
        }
        Format::Json => output.write_json(&object(curve, sampled)?),
        Format::Svg => {
            let layers = vec![Layer::Points(samples.points())];
            output.write(|out| Picture { layers }.write(out))
        }
        _ => output.write_features(features(samples)),
    }
}

fn object(curve: &Curve, sampled: &Sampled) -> anyhow::Result<Object> {
    let condition = sampled.condition;
    let Sampling {
        samples, attained, ..
    } = &sampled.sampling;
    let tolerance = HAUSDORFF_TOLERANCE * curve.extent();
    let polygon = samples.manifold_boundary();
    let distance = hausdorff(curve, &samples.point_set()?, &polygon, tolerance).distance();
    let (name, bound) = name_and_bound(condition);
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
