//! `curvecrust draw`: pictures of curves, points and what is found from them.

use super::bare_points::BarePoints;
use super::{Outcome, curves, reconstruct};
use crate::args;
use crate::console::Console;
use crate::format::Format;
use crate::output::{Layer, Output, Picture, Places};
use anyhow::ensure;
use curvecrust::curve::Curve;
use curvecrust::geometry::Segment;
use curvecrust::medial_axis::{MeasuredCurve, MedialAxis};
use curvecrust::reconstruct::{Explanation, Reconstruction};
use std::path::Path;

/// The algorithm whose violations are marked if none is drawn: by a theorem, its leaves show where samples
/// are too sparse.
const DEFAULT: &str = "hnn-crust";

pub(crate) fn run(args: &args::Draw, console: &Console) -> anyhow::Result<Outcome> {
    let to = args::Output {
        output: args.output.clone(),
        to: None,
        force: args.force,
    };
    let output = Output::new(&to, false, &[Format::Svg])?;
    let curve = args.curve.as_deref();
    let curve = curve
        .map(|path| Drawn::read(args, path, console))
        .transpose()?;
    let points = args.points.as_deref();
    let points = points
        .map(|path| Found::read(args, path, console))
        .transpose()?;
    let mut layers = Vec::new();
    layers.extend(curve.iter().flat_map(|curve| curve.layers(args)));
    layers.extend(points.iter().flat_map(|points| points.layers(args)));
    if let Some(output) = output {
        output.write(|out| Picture { layers }.write(out))?;
    }
    Ok(Outcome::Fine)
}

/// A curve, and what was asked for about it.
struct Drawn {
    curve: Curve,
    measured: Option<MeasuredCurve>,
    axis: Vec<Segment>,
}

impl Drawn {
    fn read(args: &args::Draw, path: &Path, console: &Console) -> anyhow::Result<Self> {
        // A picture alone has nothing against corners.
        let curve = if args.medial_axis || args.lfs {
            curves::read(path)?
        } else {
            curves::read_split(path)?.pieces().clone()
        };
        let settings = args::Curve {
            path: path.to_owned(),
            gap: None,
            per_segment: None,
        };
        let measured = (args.medial_axis || args.lfs)
            .then(|| curves::measured(&settings, &curve, None, console))
            .transpose()?;
        let mut axis = Vec::new();
        if let Some(measured) = measured.as_ref().filter(|_| args.medial_axis) {
            let found = MedialAxis::new(measured.dense())?;
            axis.extend(found.edges().map(|edge| edge.segment));
        }
        Ok(Self {
            curve,
            measured,
            axis,
        })
    }

    fn layers(&self, args: &args::Draw) -> Vec<Layer<'_>> {
        let axis = args.medial_axis.then_some(Layer::Axis(&self.axis));
        let curve = match &self.measured {
            Some(measured) if args.lfs => Layer::Lfs(measured),
            _ => Layer::Curve(&self.curve),
        };
        axis.into_iter().chain([curve]).collect()
    }
}

/// Points, and what was found from them.
struct Found {
    bare: BarePoints,
    curves: Option<Reconstruction>,
    why: Option<Explanation>,
}

impl Found {
    fn read(args: &args::Draw, path: &Path, console: &Console) -> anyhow::Result<Self> {
        let source = args::Points {
            path: path.to_owned(),
            from: args.from,
            merge_duplicates: args.merge_duplicates,
        };
        let bare = BarePoints::read(&source, console)?;
        if args.edges.is_none() && !args.violations {
            return Ok(Self {
                bare,
                curves: None,
                why: None,
            });
        }
        let algorithm = reconstruct::algorithm(args.edges.as_deref().unwrap_or(DEFAULT))?;
        let (edges, why) = console.during("reconstructing", |_| {
            if args.why {
                reconstruct::explained(algorithm, &bare.points, &[])
            } else {
                Ok((algorithm.reconstruct(&bare.points), None))
            }
        })?;
        ensure!(
            why.is_some() || !args.why,
            "{} gives no reasons for its edges: draw without --why",
            algorithm.info().name
        );
        let curves = Some(Reconstruction::new(&bare.points, edges)?);
        Ok(Self { bare, curves, why })
    }

    fn layers(&self, args: &args::Draw) -> Vec<Layer<'_>> {
        let points = &self.bare.points;
        let mut layers = Vec::new();
        if let Some(why) = &self.why {
            layers.push(Layer::Why(points, why));
        } else if let Some(curves) = self.curves.as_ref().filter(|_| args.edges.is_some()) {
            layers.push(Layer::Edges(reconstruct::paths(points, curves)));
        }
        if let Some(curves) = self.curves.as_ref().filter(|_| args.violations) {
            layers.push(Layer::Marks {
                leaves: Places::named(points, curves.leaves()),
                isolated: Places::named(points, curves.isolated()),
                junctions: Places::named(points, curves.junctions()),
            });
        }
        layers.push(Layer::Points(points.points()));
        layers
    }
}
