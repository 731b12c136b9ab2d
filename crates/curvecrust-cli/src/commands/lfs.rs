//! `curvecrust lfs`: the local feature size along curves.

use super::Outcome;
use super::curve_source::CurveSource;
use crate::args;
use crate::console::Console;
use crate::format::Format;
use crate::output::{Number, Results};
use curvecrust::medial_axis::MeasuredCurve;
use serde::Serialize;
use std::io::{self, Write};

/// The formats of a table of lfs, the one of stdout first.
const FORMATS: &[Format] = &[Format::Csv, Format::Json];

/// What `--json` prints; an infinite lfs is null.
#[derive(Serialize)]
struct Object {
    minimum: f64,
    components: Vec<Component>,
}

#[derive(Serialize)]
struct Component {
    closed: bool,
    points: Vec<[f64; 2]>,
    lfs: Vec<f64>,
}

/// Which curves are measured, and where the table goes.
#[derive(Debug)]
pub(crate) struct Job {
    curve: CurveSource,
    results: Results,
}

impl Job {
    pub(crate) fn new(args: args::Lfs) -> anyhow::Result<Self> {
        Ok(Self {
            results: Results::new(args.output, args.json, FORMATS)?,
            curve: args.curve.into(),
        })
    }

    pub(crate) fn run(self, console: &Console) -> anyhow::Result<Outcome> {
        let split = self.curve.read(console)?;
        let strokes = self.curve.measure_strokes(split, |_| Ok(None), console)?;
        let measured = strokes.measured;
        if let Some(output) = &self.results.output {
            match output.format {
                Format::Json => output.write_json(&object(&measured))?,
                _ => output.write(|out| write_csv(out, &measured))?,
            }
        }
        self.results.print_json(|| Ok(object(&measured)))?;
        let corners = match strokes.split.corners().len() {
            0 => "",
            1 => "; at 1 corner it is 0, and what stands there is that of the smooth pieces",
            count => &format!(
                "; at {count} corners it is 0, and what stands there is that of the smooth pieces"
            ),
        };
        console.note(format_args!(
            "{} points, local feature size {} and more{corners}",
            measured.dense().len(),
            Number(measured.lfs().minimum())
        ));
        Ok(Outcome::Fine)
    }
}

fn write_csv(out: &mut dyn Write, measured: &MeasuredCurve) -> io::Result<()> {
    writeln!(out, "curve,x,y,lfs")?;
    let dense = measured.dense();
    let values = measured.lfs().values();
    for (i, (p, &lfs)) in dense.points().iter().zip(values).enumerate() {
        let (x, y, lfs) = (Number(p.x), Number(p.y), Number(lfs));
        writeln!(out, "{},{x},{y},{lfs}", dense.component_of(i))?;
    }
    Ok(())
}

fn object(measured: &MeasuredCurve) -> Object {
    let points = measured.dense().points();
    let components = measured.dense().components().iter();
    let component = |component: &curvecrust::geometry::Component| {
        let range = component.range.clone();
        Component {
            closed: component.closed,
            points: points[range.clone()].iter().map(|p| p.to_array()).collect(),
            lfs: measured.lfs().values()[range].to_vec(),
        }
    };
    Object {
        minimum: measured.lfs().minimum(),
        components: components.map(component).collect(),
    }
}
