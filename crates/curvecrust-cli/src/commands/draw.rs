//! `curvecrust draw`: pictures of curves, points and what is found from them.

use super::bare_points::BarePoints;
use super::{Outcome, curves, reconstruct};
use crate::args;
use crate::console::Console;
use crate::format::Format;
use crate::output::{Layer, Output, Picture};
use curvecrust::DVec2;
use curvecrust::geometry::PointId;
use curvecrust::medial_axis::MedialAxis;
use curvecrust::reconstruct::Reconstruction;
use std::path::Path;

/// The algorithm whose violations are marked if none is drawn.
const DEFAULT: &str = "hnn-crust";

pub(crate) fn run(args: &args::Draw, console: &Console) -> anyhow::Result<Outcome> {
    let to = args::Output {
        output: args.output.clone(),
        to: None,
        force: args.force,
    };
    let output = Output::new(&to, false, &[Format::Svg])?;
    let mut layers = Vec::new();
    if let Some(path) = &args.curve {
        draw_curve(args, path, console, &mut layers)?;
    }
    if let Some(path) = &args.points {
        draw_points(args, path, console, &mut layers)?;
    }
    if let Some(output) = output {
        output.write(|out| Picture { layers }.write(out))?;
    }
    Ok(Outcome::Fine)
}

fn draw_curve(
    args: &args::Draw,
    path: &Path,
    console: &Console,
    layers: &mut Vec<Layer>,
) -> anyhow::Result<()> {
    let curve = curves::read(path)?;
    if !(args.medial_axis || args.lfs) {
        layers.push(Layer::Curve(curve));
        return Ok(());
    }
    let settings = args::Curve {
        path: path.to_owned(),
        gap: None,
        per_segment: None,
    };
    let measured = curves::measured(&settings, &curve, None, console)?;
    if args.medial_axis {
        let axis = MedialAxis::new(measured.dense())?;
        layers.push(Layer::Axis(axis.edges().map(|edge| edge.segment).collect()));
    }
    layers.push(if args.lfs {
        Layer::Lfs(measured)
    } else {
        Layer::Curve(curve)
    });
    Ok(())
}

fn draw_points(
    args: &args::Draw,
    path: &Path,
    console: &Console,
    layers: &mut Vec<Layer>,
) -> anyhow::Result<()> {
    let source = args::Points {
        path: path.to_owned(),
        from: args.from,
        merge_duplicates: args.merge_duplicates,
    };
    let bare = BarePoints::read(&source, console)?;
    if args.edges.is_some() || args.violations {
        let name = args.edges.as_deref().unwrap_or(DEFAULT);
        let algorithm = reconstruct::algorithm(name)?;
        let found = console.during("reconstructing", |_| {
            Reconstruction::by(algorithm, &bare.points)
        });
        let places = |ids: Vec<PointId>| -> Vec<DVec2> {
            ids.into_iter().map(|id| bare.points[id]).collect()
        };
        if args.edges.is_some() {
            layers.push(Layer::Edges(reconstruct::paths(&bare, &found)));
        }
        if args.violations {
            layers.push(Layer::Marks {
                leaves: places(found.leaves()),
                isolated: places(found.isolated()),
                junctions: places(found.junctions()),
            });
        }
    }
    layers.push(Layer::Points(bare.points.points().to_vec()));
    Ok(())
}
