//! `cargo xtask docs`: the files under docs that are made, not written.

use crate::root::root;
use crate::whole::write_whole;
use anyhow::Context;
use curvecrust::curve::{Curve, DenseCurve};
use curvecrust::geometry::Segment;
use curvecrust::medial_axis::{Discretisation, Estimator, MedialAxis, measure};
use curvecrust::reconstruct::hnn_crust;
use curvecrust::report::{Figure, Layer, Panel};
use curvecrust::sampling::{Condition, sample_greedy};
use std::process::ExitCode;

/// What was typed.
#[derive(clap::Args)]
pub(crate) struct Args {
    /// Write nothing; exit with status 1 if a file is not what would be written
    #[arg(long)]
    check: bool,
}

const TEASER: &str = include_str!("../../fixtures/curves/teaser.svg");

/// Writes or checks every generated file.
pub(crate) fn run(args: &Args) -> anyhow::Result<ExitCode> {
    let mut stale = false;
    let files = [("docs/images/teaser.svg", teaser()?)];
    for (name, text) in files {
        let path = root().join(name);
        if !args.check {
            write_whole(&path, &text)?;
            println!("wrote {name}");
        } else if std::fs::read_to_string(&path).ok().as_ref() != Some(&text) {
            println!("{name} is stale: run cargo xtask docs");
            stale = true;
        }
    }
    Ok(ExitCode::from(u8::from(stale)))
}

/// The paper's Figure 1 on our own curve: three conditions, each sampling reconstructed.
fn teaser() -> anyhow::Result<String> {
    let curve = Curve::from_svg(TEASER).context("fixtures/curves/teaser.svg")?;
    let measured = measure(
        &curve,
        Discretisation::Adaptive { gap_to_lfs: 0.01 },
        Estimator::Voronoi,
    )?;
    let coarse = DenseCurve::per_segment(&curve, 24)?;
    let (low, high) = curve.bounding_box();
    let axis = MedialAxis::new(&DenseCurve::per_segment(&curve, 40)?)?;
    let inside = |segment: &Segment| {
        let contains = |p: curvecrust::DVec2| p.cmpge(low).all() && p.cmple(high).all();
        contains(segment.a) && contains(segment.b)
    };
    let axis: Vec<Segment> = axis
        .edges()
        .map(|edge| edge.segment)
        .filter(inside)
        .collect();

    let conditions = [
        ("ε < 1/3", Condition::epsilon(1.0 / 3.0)?),
        ("ε < 0.47", Condition::epsilon(0.47)?),
        ("ρ < 0.9", Condition::rho(0.9)?),
    ];
    let panels = conditions.into_iter().map(|(name, condition)| {
        let samples = sample_greedy(&measured, condition);
        let points = samples.point_set()?;
        let edges = hnn_crust(&points);
        let ends =
            |edge: &curvecrust::geometry::Edge| Segment::new(points[edge.a()], points[edge.b()]);
        Ok(Panel {
            caption: format!("{name}: {} samples", samples.len()),
            layers: vec![
                Layer::MedialAxis(axis.clone()),
                Layer::Curve(vec![(coarse.points().to_vec(), true)]),
                Layer::Edges(edges.edges().iter().map(ends).collect()),
                Layer::Points(points.points().to_vec()),
            ],
        })
    });
    let figure = Figure {
        title: "One curve under three sampling conditions: curve (grey), medial axis (blue), \
                samples, and their reconstruction by HNN-Crust (red)"
            .to_owned(),
        panels: panels.collect::<anyhow::Result<_>>()?,
    };
    Ok(figure.to_svg())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn generated_files_are_fresh() {
        assert_eq!(run(&Args { check: true }).unwrap(), ExitCode::SUCCESS);
    }
}
