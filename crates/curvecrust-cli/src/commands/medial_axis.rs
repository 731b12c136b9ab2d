//! `curvecrust medial-axis`: the medial axis of curves.

use super::{Outcome, curves};
use crate::args;
use crate::console::Console;
use crate::format::Format;
use crate::output::{self, Feature, Layer, Number, Output, Picture, Shape};
use curvecrust::geometry::Segment;
use curvecrust::medial_axis::MedialAxis;
use serde::Serialize;
use std::io::{self, Write};

/// The formats of a medial axis, the one of stdout first.
const FORMATS: &[Format] = &[
    Format::Csv,
    Format::Json,
    Format::Geojson,
    Format::Wkt,
    Format::Dxf,
    Format::Svg,
];

/// What `--json` prints; the schema is stable, and in `docs/formats.md`.
#[derive(Serialize)]
struct Object {
    segments: Vec<[[f64; 2]; 2]>,
}

/// What GeoJSON tells about the axis, beside its places.
#[derive(Serialize)]
struct Nothing {}

pub(crate) fn run(args: &args::MedialAxis, console: &Console) -> anyhow::Result<Outcome> {
    let output = Output::new(&args.output, args.json, FORMATS)?;
    let curve = curves::read(&args.curve.path)?;
    let measured = curves::measured(&args.curve, &curve, None, console)?;
    let axis = MedialAxis::new(measured.dense())?;
    let segments: Vec<Segment> = axis.edges().map(|edge| edge.segment).collect();
    if let Some(output) = output {
        match output.format {
            Format::Csv => output.write(|out| write_csv(out, &segments))?,
            Format::Json => output.write_json(&object(&segments))?,
            Format::Svg => {
                let layers = vec![Layer::Curve(&curve), Layer::Axis(&segments)];
                output.write(|out| Picture { layers }.write(out))?;
            }
            _ => {
                let shape = Shape::Segments(&segments);
                let properties = Nothing {};
                output.write_features(std::iter::once(Feature { shape, properties }))?;
            }
        }
    }
    if args.json {
        output::print_json(&object(&segments))?;
    }
    console.say(format_args!("{} segments", segments.len()));
    Ok(Outcome::Fine)
}

fn object(segments: &[Segment]) -> Object {
    let ends = |s: &Segment| [s.a.to_array(), s.b.to_array()];
    Object {
        segments: segments.iter().map(ends).collect(),
    }
}

fn write_csv(out: &mut dyn Write, segments: &[Segment]) -> io::Result<()> {
    writeln!(out, "x0,y0,x1,y1")?;
    for Segment { a, b } in segments {
        let [x0, y0, x1, y1] = [a.x, a.y, b.x, b.y].map(Number);
        writeln!(out, "{x0},{y0},{x1},{y1}")?;
    }
    Ok(())
}
