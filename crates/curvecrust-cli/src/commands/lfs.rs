//! `curvecrust lfs`: the local feature size along curves.

use super::{Outcome, curves};
use crate::args;
use crate::console::Console;
use crate::format::Format;
use crate::output::{self, Number, Output};
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

pub(crate) fn run(args: &args::Lfs, console: &Console) -> anyhow::Result<Outcome> {
    let output = Output::new(&args.output, args.json, FORMATS)?;
    let curve = curves::read(&args.curve.path)?;
    let measured = curves::measured(&args.curve, &curve, None, console)?;
    if let Some(output) = output {
        match output.format {
            Format::Json => output.write_json(&object(&measured))?,
            _ => output.write(|out| write_csv(out, &measured))?,
        }
    }
    if args.json {
        output::print_json(&object(&measured))?;
    }
    console.say(format_args!(
        "{} points, local feature size {} and more",
        measured.dense().len(),
        Number(measured.lfs().minimum())
    ));
    Ok(Outcome::Fine)
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
