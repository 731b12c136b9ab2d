//! The files that are made of counterexamples: what the program reads, and pictures.

use super::{Counterexample, Dense, ProvenSamples, all, two_sparser_curves};
use crate::figure::{Figure, Layer, Panel, Polyline};
use curvecrust::DVec2;
use curvecrust::geometry::{Component, EdgeSet, Segment};

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
        files.extend(one.samples.files(&one.name())?.map(folder));
    }
    let panels = all.iter().map(failure).collect::<anyhow::Result<_>>()?;
    let figure = Figure {
        title: "Samples of smooth closed curves on which algorithms fail".to_owned(),
        columns: 3,
        panels,
    };
    files.push((
        "docs/images/counterexamples.svg".to_owned(),
        figure.to_svg(),
    ));
    files.extend(made_of_two_curves()?);
    Ok(files)
}

/// Those of the two curves of one set of samples.
fn made_of_two_curves() -> anyhow::Result<Vec<(String, String)>> {
    let mut files = Vec::new();
    let mut panels = Vec::new();
    for (name, one) in ["petals", "flower"].into_iter().zip(two_sparser_curves()?) {
        let folder = |(name, text)| (format!("fixtures/two-curves/sparser-{name}"), text);
        files.extend(one.files(name)?.map(folder));
        let caption = format!("{name}, {}", condition(&one));
        panels.push(inner(panel(&one, &one.truth(), caption)?));
    }
    let figure = Figure {
        title: "Two smooth curves with the same samples".to_owned(),
        columns: 2,
        panels,
    };
    files.push(("docs/images/two-curves.svg".to_owned(), figure.to_svg()));
    Ok(files)
}

/// How far from the centre of the octagon, in its radii, the picture of the two curves goes; the
/// curves go on.
const INNER: f64 = 3.0;

/// The part of a panel that is near the origin.
fn inner(panel: Panel) -> Panel {
    let near = |p: &DVec2| p.abs().max_element() <= INNER;
    let runs = |(points, _): &Polyline| -> Vec<Polyline> {
        let runs = points.split(|p| !near(p)).filter(|run| !run.is_empty());
        runs.map(|run| (run.to_vec(), false)).collect()
    };
    let cut = |layer| match layer {
        Layer::Curve(curves) => Layer::Curve(curves.iter().flat_map(runs).collect()),
        Layer::Edges(mut edges) => {
            edges.retain(|edge| near(&edge.a) && near(&edge.b));
            Layer::Edges(edges)
        }
        Layer::Points(mut points) => {
            points.retain(near);
            Layer::Points(points)
        }
        other => other,
    };
    Panel {
        frame: Some([DVec2::splat(-INNER), DVec2::splat(INNER)]),
        layers: panel.layers.into_iter().map(cut).collect(),
        ..panel
    }
}

fn condition(samples: &ProvenSamples) -> String {
    format!("{} < {}", samples.condition(), samples.bound.value())
}

/// The curve, the samples, and the edges that the algorithm returns.
fn failure(one: &Counterexample) -> anyhow::Result<Panel> {
    let edges = one.reconstructor()?.reconstruct(&one.samples.points()?);
    let caption = format!("{}, {}", one.algorithm, condition(&one.samples));
    panel(&one.samples, &edges, caption)
}

/// The curve, the samples, and edges between them.
fn panel(samples: &ProvenSamples, edges: &EdgeSet, caption: String) -> anyhow::Result<Panel> {
    let points = samples.points()?;
    let segment = |ends: [_; 2]| {
        let [start, end] = ends.map(|id| points[id]);
        Segment::new(start, end)
    };
    let edges = edges.edges().iter().map(|edge| segment(edge.ends()));
    Ok(Panel {
        caption,
        frame: None,
        layers: vec![
            Layer::Curve(curves(&samples.control())),
            Layer::Edges(edges.collect()),
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
