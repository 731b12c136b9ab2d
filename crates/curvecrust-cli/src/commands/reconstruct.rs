//! `curvecrust reconstruct`: points to curves.

mod polygons;
mod result;
mod summary;
mod why;

use super::Outcome;
use super::bare_points::BarePoints;
use crate::args;
use crate::console::Console;
use crate::format::Format;
use crate::output::{self, Layer, Output, Picture, npy};
use anyhow::anyhow;
use curvecrust::geometry::{EdgeSet, PointId, PointSet};
use curvecrust::reconstruct::{
    ALGORITHMS, Explanation, ReconstructError, Reconstruction, Reconstructor,
};
use result::Found;
pub(crate) use result::paths;
use summary::Summary;

/// The formats of a reconstruction, the one of stdout first.
const FORMATS: &[Format] = &[
    Format::Csv,
    Format::Json,
    Format::Geojson,
    Format::Wkt,
    Format::Dxf,
    Format::Svg,
    Format::Npy,
];

pub(crate) fn run(args: &args::Reconstruct, console: &Console) -> anyhow::Result<Outcome> {
    let output = Output::new(&args.output, args.json, FORMATS)?;
    let algorithm = algorithm(&args.algorithm)?;
    let bare = BarePoints::read(&args.points, console)?;
    let termini = args.terminus.iter().map(|&row| bare.point(row));
    let termini: Vec<PointId> = termini.collect::<Result<_, _>>()?;
    // Objects alone have room for reasons, which take longer to find than the edges.
    let is_object = output.as_ref().is_some_and(|o| o.format == Format::Json);
    let (edges, why) = console.during("reconstructing", |_| {
        if args.json || is_object {
            explained(algorithm, &bare.points, &termini)
        } else {
            Ok((algorithm.reconstruct_open(&bare.points, &termini)?, None))
        }
    })?;
    let summary = Summary::new(&bare, &edges, &termini);
    console.during("writing", |_| {
        write(output.as_ref(), args, &bare, edges, why)
    })?;
    console.say(summary);
    Ok(Outcome::Fine)
}

/// The algorithm of a name.
pub(crate) fn algorithm(name: &str) -> anyhow::Result<&'static dyn Reconstructor> {
    let mut all = ALGORITHMS.iter().copied();
    all.find(|algorithm| algorithm.info().name == name)
        .ok_or_else(|| anyhow!("there is no algorithm {name}: see `curvecrust algorithms`"))
}

/// The edges, with reasons by algorithms that give some.
pub(crate) fn explained(
    algorithm: &dyn Reconstructor,
    points: &PointSet,
    termini: &[PointId],
) -> Result<(EdgeSet, Option<Explanation>), ReconstructError> {
    match algorithm.explain(points, termini)? {
        Some(why) => Ok((why.edge_set(points.len()), Some(why))),
        None => Ok((algorithm.reconstruct_open(points, termini)?, None)),
    }
}

fn write(
    output: Option<&Output>,
    args: &args::Reconstruct,
    bare: &BarePoints,
    edges: EdgeSet,
    why: Option<Explanation>,
) -> anyhow::Result<()> {
    // Edges alone need not be ordered, for which many points would take much memory.
    if let Some(output) = output.filter(|output| output.format == Format::Npy) {
        let rows = edges
            .edges()
            .iter()
            .map(|edge| edge.ends().map(|v| bare.row(v)));
        output.write(|out| npy::write_u32(out, rows))?;
        if !args.json {
            return Ok(());
        }
    }
    let found = Found {
        algorithm: &args.algorithm,
        bare,
        curves: Reconstruction::new(&bare.points, edges)?,
        why,
    };
    if let Some(output) = output {
        match output.format {
            Format::Csv => output.write(|out| found.write_csv(out))?,
            Format::Json => output.write_json(&found)?,
            Format::Svg => {
                let edges = Layer::Edges(paths(&bare.points, &found.curves));
                let layers = vec![edges, Layer::Points(bare.points.points())];
                output.write(|out| Picture { layers }.write(out))?;
            }
            Format::Npy => {}
            _ => output.write_features(found.features(&found.rings()))?,
        }
    }
    if args.json {
        output::print_json(&found)?;
    }
    Ok(())
}
