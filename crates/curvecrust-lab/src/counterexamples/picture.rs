//! The files that are made of counterexamples: what the program reads, and a picture of all.

use super::{Counterexample, Dense, all};
use crate::figure::{Figure, Layer, Panel, Polyline};
use curvecrust::DVec2;
use curvecrust::geometry::{Component, Segment};

/// Dense points of a segment, for pictures.
const PER_SEGMENT: usize = 12;

/// The names of the files below the root, and what they should hold.
///
/// # Errors
/// If the counterexamples cannot be read.
pub(crate) fn made() -> anyhow::Result<Vec<(String, String)>> {
    let all = all()?;
    let mut files = Vec::new();
    for one in &all {
        let folder = |(name, text)| (format!("fixtures/counterexamples/{name}"), text);
        files.extend(one.files()?.map(folder));
    }
    let panels = all.iter().map(panel).collect::<anyhow::Result<_>>()?;
    let figure = Figure {
        title: "Samples of smooth closed curves on which algorithms fail".to_owned(),
        columns: 3,
        panels,
    };
    files.push((
        "docs/images/counterexamples.svg".to_owned(),
        figure.to_svg(),
    ));
    Ok(files)
}

/// The curve, the samples, and the edges that the algorithm returns.
fn panel(one: &Counterexample) -> anyhow::Result<Panel> {
    let points = one.samples.points()?;
    let edges = one.reconstructor()?.reconstruct(&points);
    let segment = |ends: [_; 2]| {
        let [start, end] = ends.map(|id| points[id]);
        Segment::new(start, end)
    };
    let caption = format!(
        "{}, {} < {}",
        one.algorithm,
        one.samples.condition(),
        one.samples.bound.value()
    );
    Ok(Panel {
        caption,
        frame: None,
        layers: vec![
            Layer::Curve(curves(&one.samples.control())),
            Layer::Edges(
                edges
                    .edges()
                    .iter()
                    .map(|edge| segment(edge.ends()))
                    .collect(),
            ),
            Layer::Points(points.points().to_vec()),
        ],
    })
}

/// Splines as dense polygons.
fn curves(control: &[Vec<DVec2>]) -> Vec<Polyline> {
    let Some(dense) = Dense::new(control, PER_SEGMENT) else {
        return Vec::new();
    };
    let polygon = |component: &Component| {
        let points = dense.points()[component.range.clone()].to_vec();
        (points, component.closed)
    };
    dense.components().iter().map(polygon).collect()
}
