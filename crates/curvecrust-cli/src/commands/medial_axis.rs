//! `curvecrust medial-axis`: the medial axis of curves.

use super::Outcome;
use super::curve_source::CurveSource;
use crate::args;
use crate::console::Console;
use crate::format::Format;
use crate::output::{
    Attribute, Attributes, Feature, GEOMETRIES, Kind, Layer, Number, Output, Picture, Results,
    Shape,
};
use curvecrust::curve::Curve;
use curvecrust::geometry::Segment;
use serde::Serialize;
use std::io::{self, Write};

/// What `--json` prints; the schema is stable, and in `docs/formats.md`.
#[derive(Serialize)]
struct Object {
    segments: Vec<[[f64; 2]; 2]>,
}

/// The properties of the axis in GeoJSON: none.
#[derive(Serialize)]
struct Nothing {}

impl Attributes for Nothing {
    const COLUMNS: &'static [(&'static str, Kind)] = &[];

    fn values(&self) -> Vec<Attribute> {
        Vec::new()
    }
}

/// Which curves are measured, and where the axis goes.
#[derive(Debug)]
pub(crate) struct Job {
    curve: CurveSource,
    results: Results,
}

impl Job {
    pub(crate) fn new(args: args::MedialAxis) -> anyhow::Result<Self> {
        Ok(Self {
            results: Results::new(args.output, args.json, GEOMETRIES)?,
            curve: args.curve.into(),
        })
    }

    pub(crate) fn run(self, console: &Console) -> anyhow::Result<Outcome> {
        let split = self.curve.read(console)?;
        let (split, axis) = self.curve.measure_axis(split, console)?;
        let segments: Vec<Segment> = axis.edges().map(|edge| edge.segment).collect();
        if let Some(output) = &self.results.output {
            write(output, split.pieces(), &segments)?;
        }
        self.results.print_json(|| Ok(object(&segments)))?;
        console.note(format_args!("{} segments", segments.len()));
        Ok(Outcome::Fine)
    }
}

fn write(output: &Output, curve: &Curve, segments: &[Segment]) -> anyhow::Result<()> {
    match output.format {
        Format::Csv => output.write(|out| write_csv(out, segments)),
        Format::Json => output.write_json(&object(segments)),
        Format::Svg => {
            let layers = vec![Layer::Curve(curve), Layer::Axis(segments)];
            output.write(|out| Picture { layers }.write(out))
        }
        _ => {
            let shape = Shape::Segments(segments);
            let properties = Nothing {};
            output.write_features(std::iter::once(Feature { shape, properties }), None)
        }
    }
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
