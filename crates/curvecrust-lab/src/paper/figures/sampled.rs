//! Figures 1, 9 and 10: curves, their samplings, and what HNN-Crust makes of the bare samples.

use super::edges;
use crate::figure::{Figure, Layer, Panel};
use crate::paper::measure::{Points, Run};
use crate::paper::models::Model;
use crate::paper::page::Exhibit;
use anyhow::Context;
use curvecrust::DVec2;
use curvecrust::curve::DenseCurve;
use curvecrust::evaluate::EdgeComparison;
use curvecrust::geometry::Segment;
use curvecrust::medial_axis::{MeasuredCurve, MedialAxis};
use curvecrust::reconstruct::hnn_crust;
use curvecrust::sampling::{Condition, sample_as_published};

/// The setting of the authors' program, so that the numbers are those of its tables.
pub(super) const SETTING: Run = Run::ShrinkingBall(Points::PerSegment);
/// Points a segment of a drawn curve.
const DRAWN: u32 = 24;
/// Points a segment for a drawn medial axis.
const AXIS: u32 = 60;
/// The Hausdorff limit of Figure 10, in per cent of the larger extent.
pub(super) const LIMIT_PERCENT: f64 = 1.0;

/// A curve sampled under one condition.
struct Sampling {
    count: usize,
    panel: Panel,
}

/// The teaser under three conditions.
pub(crate) fn figure_1(models: &[Model]) -> anyhow::Result<Exhibit> {
    let model = named(models, "teaser")?;
    let measured = SETTING.measure(model)?;
    let conditions = [third()?, ("ε < 0.47", Condition::epsilon(0.47)?), rho()?];
    let samplings = conditions.map(|(name, condition)| sampling(model, &measured, name, condition));
    let [third, epsilon, rho] = samplings;
    let (mut third, mut epsilon, mut rho) = (third?, epsilon?, rho?);
    let axis = medial_axis(model)?;
    for sampling in [&mut third, &mut epsilon, &mut rho] {
        sampling
            .panel
            .layers
            .insert(0, Layer::MedialAxis(axis.clone()));
    }
    let text = format!(
        "A smooth curve with its medial axis under three sampling conditions, each of which is \
         enough for HNN-Crust to return the polygon in curve order: ε < 1/3, the best bound \
         before the paper, takes {} samples; ε < 0.47, the paper's bound for the same condition, \
         {}; and ρ < 0.9, its new condition, {}. The first takes {} % more than the last.",
        third.count,
        epsilon.count,
        rho.count,
        more(third.count, rho.count),
    );
    Ok(Exhibit {
        number: 1,
        heading: "one curve, three conditions".to_owned(),
        text,
        figure: Figure {
            title: "One curve under three sampling conditions, with its medial axis, its samples, \
                    and their reconstruction by HNN-Crust"
                .to_owned(),
            columns: 3,
            panels: [third, epsilon, rho].map(|sampling| sampling.panel).into(),
        },
    })
}

/// Parallel lines, bunny and cat under two conditions.
pub(crate) fn figure_9(models: &[Model]) -> anyhow::Result<Exhibit> {
    let mut panels = Vec::new();
    let mut counts = Vec::new();
    for name in ["parallel", "bunny", "cat"] {
        let [third, rho] = compared(models, name, None)?;
        counts.push(format!(
            "{} against {} on the {name} curve",
            third.count, rho.count
        ));
        panels.extend([third.panel, rho.panel]);
    }
    Ok(Exhibit {
        number: 9,
        heading: "ε < 1/3 against ρ < 0.9".to_owned(),
        text: format!(
            "Left the best bound before the paper, right its new condition, on three curves. Both \
             samplings of each are reconstructed; the right one takes far fewer samples, {}.",
            counts.join(", ")
        ),
        figure: Figure {
            title: "Three curves sampled under epsilon < 1/3 and under rho < 0.9, and \
                   reconstructed by HNN-Crust"
                .to_owned(),
            columns: 2,
            panels,
        },
    })
}

/// The bunny of Figure 9 alone.
pub(crate) fn bunny(models: &[Model]) -> anyhow::Result<Figure> {
    let [third, rho] = compared(models, "bunny", None)?;
    Ok(Figure {
        title: "A rabbit sampled under epsilon < 1/3 and under rho < 0.9, and reconstructed by \
               HNN-Crust"
            .to_owned(),
        columns: 2,
        panels: vec![third.panel, rho.panel],
    })
}

/// The bunny under two conditions, within a Hausdorff distance.
pub(crate) fn figure_10(models: &[Model]) -> anyhow::Result<Exhibit> {
    let [third, rho] = compared(models, "bunny", Some(LIMIT_PERCENT))?;
    let [.., free] = compared(models, "bunny", None)?;
    let text = format!(
        "The polygon has to stay within {LIMIT_PERCENT} % of the curve's larger extent. Under ρ < \
         0.9 that takes {} samples, {} more than without the limit; ε < 1/3 takes {}, {} % more, \
         which add nothing at that precision.",
        rho.count,
        rho.count.saturating_sub(free.count),
        third.count,
        more(third.count, rho.count),
    );
    Ok(Exhibit {
        number: 10,
        heading: "within a Hausdorff distance of 1 %".to_owned(),
        text,
        figure: Figure {
            title: "A rabbit sampled under two conditions so that the polygon stays within 1 % of \
                   its extent"
                .to_owned(),
            columns: 2,
            panels: vec![third.panel, rho.panel],
        },
    })
}

fn third() -> anyhow::Result<(&'static str, Condition)> {
    Ok(("ε < 1/3", Condition::epsilon(1.0 / 3.0)?))
}

fn rho() -> anyhow::Result<(&'static str, Condition)> {
    Ok(("ρ < 0.9", Condition::rho(0.9)?))
}

fn compared(
    models: &[Model],
    name: &str,
    limit_percent: Option<f64>,
) -> anyhow::Result<[Sampling; 2]> {
    let model = named(models, name)?;
    let measured = SETTING.measure(model)?;
    let sampled = |(name, condition): (&str, Condition)| match limit_percent {
        Some(percent) => {
            let limit = percent / 100.0 * model.curve.extent();
            let name = format!("{name} within {percent} %");
            sampling(
                model,
                &measured,
                &name,
                condition.with_hausdorff_limit(limit)?,
            )
        }
        None => sampling(model, &measured, name, condition),
    };
    Ok([sampled(third()?)?, sampled(rho()?)?])
}

fn named<'a>(models: &'a [Model], name: &str) -> anyhow::Result<&'a Model> {
    let model = models.iter().find(|model| model.name == name);
    model.with_context(|| format!("no curve is called {name}"))
}

fn sampling(
    model: &Model,
    measured: &MeasuredCurve,
    name: &str,
    condition: Condition,
) -> anyhow::Result<Sampling> {
    let samples = sample_as_published(measured, condition).samples;
    let points = samples.point_set()?;
    let found = hnn_crust(&points);
    let exact = EdgeComparison::new(&samples.manifold_boundary(), &found).is_exact();
    let verdict = if exact { "" } else { ", not reconstructed" };
    let dense = DenseCurve::per_segment(&model.curve, DRAWN)?;
    let parts = dense.components().iter().map(|part| {
        let points = &dense.points()[part.range.clone()];
        (points.to_vec(), part.closed)
    });
    let layers = vec![
        Layer::Curve(parts.collect()),
        Layer::Edges(edges(&points, &found)),
        Layer::Points(points.points().to_vec()),
    ];
    Ok(Sampling {
        count: samples.len(),
        panel: Panel {
            caption: format!("{name}: {} samples{verdict}", samples.len()),
            frame: None,
            layers,
        },
    })
}

/// The part of it within the curve's bounding box.
fn medial_axis(model: &Model) -> anyhow::Result<Vec<Segment>> {
    let (low, high) = model.curve.bounding_box();
    let inside = |p: DVec2| p.cmpge(low).all() && p.cmple(high).all();
    let axis = MedialAxis::new(&DenseCurve::per_segment(&model.curve, AXIS)?)?;
    let segments = axis.edges().map(|edge| edge.segment);
    Ok(segments
        .filter(|segment| inside(segment.a) && inside(segment.b))
        .collect())
}

/// How many per cent more than `few` are `many`.
fn more(many: usize, few: usize) -> String {
    format!("{:.0}", 100.0 * (many as f64 / few as f64 - 1.0))
}
