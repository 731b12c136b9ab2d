//! How samples are written.

use super::super::Bounds;
use super::super::condition::name_and_bound;
use super::super::guarantee::Guaranteed;
use super::Sampled;
use super::formats::{features, write_csv, write_text};
use crate::format::Format;
use crate::output::{Layer, Output, Picture, npy};
use curvecrust::curve::Curve;
use curvecrust::evaluate::hausdorff;
use curvecrust::geometry::{Edge, EdgeSet, PointSet};
use curvecrust::sampling::{SampledCurve, Sampling};
use serde::Serialize;

/// How exactly the Hausdorff distance is computed, as a share of the extent.
const HAUSDORFF_TOLERANCE: f64 = 1e-4;

/// What `--json` prints; the schema is stable, and in `docs/formats.md`.
#[derive(Serialize)]
pub(super) struct Object {
    samples: Vec<[f64; 2]>,
    components: Vec<Component>,
    condition: &'static str,
    bound: f64,
    max_distance: Option<f64>,
    /// The largest value that the samples attain.
    attained: Option<Bounds>,
    count: usize,
    /// The samples at the ends of open components.
    termini: Vec<usize>,
    /// Between the curve and the polygon of the samples.
    hausdorff: Bounds,
    /// `together`, `cut` or `apart`.
    strokes: &'static str,
    /// Where strokes touch or cross that are cut: samples of those that run through.
    places: Vec<[f64; 2]>,
    guaranteed: Guaranteed,
    /// Whose polygon it was compared with, or that the theorem is about.
    decoder: &'static str,
    /// How many more samples than the condition asks for.
    added: usize,
}

/// Which samples belong to a component of the curve: those from `start` up to, without it, `end`.
#[derive(Serialize)]
struct Component {
    start: usize,
    end: usize,
    closed: bool,
}

pub(super) fn write(output: &Output, curve: &Curve, sampled: &Sampled) -> anyhow::Result<()> {
    let samples = &sampled.sampling.samples;
    match output.format {
        Format::Csv => output.write(|out| write_csv(out, samples)),
        Format::Text => output.write(|out| write_text(out, samples)),
        Format::Npy => {
            let rows = samples.points().iter().map(|p| p.to_array());
            output.write(|out| npy::write_f64(out, rows))
        }
        Format::Json => output.write_json(&object(curve, sampled)?),
        Format::Svg => {
            let layers = vec![Layer::Points(samples.points())];
            output.write(|out| Picture { layers }.write(out))
        }
        _ => output.write_features(features(samples), None),
    }
}

pub(super) fn object(curve: &Curve, sampled: &Sampled) -> anyhow::Result<Object> {
    let condition = sampled.condition;
    let Sampling {
        samples, attained, ..
    } = &sampled.sampling;
    let tolerance = HAUSDORFF_TOLERANCE * curve.extent();
    let (points, polygon) = polygon(samples)?;
    let distance = hausdorff(curve, &points, &polygon, tolerance).distance();
    let (name, bound) = name_and_bound(condition);
    let components = samples.components().iter().map(|component| Component {
        start: component.range.start,
        end: component.range.end,
        closed: component.closed,
    });
    Ok(Object {
        samples: samples.points().iter().map(|p| p.to_array()).collect(),
        components: components.collect(),
        condition: name,
        bound,
        max_distance: condition.hausdorff_limit(),
        count: samples.len(),
        termini: samples.termini(),
        attained: attained.map(|attained| Bounds {
            lower: attained.bound,
            upper: attained.at_most,
        }),
        hausdorff: distance.into(),
        strokes: sampled.strokes,
        places: sampled.places.iter().map(|p| p.to_array()).collect(),
        guaranteed: sampled.guaranteed,
        decoder: sampled.decoder,
        added: sampled.added,
    })
}

/// The samples as one set, and the polygon that joins them; strokes that are apart may share some.
fn polygon(samples: &SampledCurve) -> anyhow::Result<(PointSet, EdgeSet)> {
    let merged = PointSet::merging_duplicates(samples.points().to_vec())?;
    let boundary = samples.manifold_boundary();
    let edges = boundary.edges().iter().filter_map(|edge| {
        let [a, b] = edge.ends().map(|v| merged.representative[v.index()]);
        Edge::new(a, b)
    });
    let edges = EdgeSet::new(merged.points.len(), edges);
    Ok((merged.points, edges))
}
