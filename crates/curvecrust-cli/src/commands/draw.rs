//! `curvecrust draw`: pictures of curves, points and their reconstruction.

use super::bare_points::{BarePoints, PointSource};
use super::curve_source::CurveSource;
use super::{Outcome, fit, reconstruct};
use crate::args::{self, Algorithm};
use crate::console::Console;
use crate::format::Format;
use crate::output::{Layer, Output, Picture, Places};
use curvecrust::curve::Curve;
use curvecrust::denoise::{Fitted, denoise};
use curvecrust::geometry::Segment;
use curvecrust::medial_axis::MeasuredCurve;
use curvecrust::reconstruct::{Explanation, HnnCrust, Known, Reconstruction};

/// What is drawn, and where the picture goes.
#[derive(Debug)]
pub(crate) struct Job {
    curve: Option<CurveLayers>,
    points: Option<PointLayers>,
    output: Output,
}

/// A curve, and what is drawn of it.
#[derive(Debug)]
struct CurveLayers {
    source: CurveSource,
    medial_axis: bool,
    lfs: bool,
}

/// Points, and what is drawn of them.
#[derive(Debug)]
struct PointLayers {
    source: PointSource,
    /// The algorithm whose edges are drawn.
    edges: Option<Algorithm>,
    why: bool,
    fit: bool,
    violations: bool,
}

impl Job {
    pub(crate) fn new(args: args::Draw) -> anyhow::Result<Self> {
        Ok(Self {
            output: Output::new(args.output, None, args.force, &[Format::Svg])?,
            curve: args.curve.map(|path| CurveLayers {
                source: CurveSource::of(path, args.strokes),
                medial_axis: args.medial_axis,
                lfs: args.lfs,
            }),
            points: args.points.map(|path| PointLayers {
                source: PointSource::new(path, args.reading),
                edges: args.edges,
                why: args.why,
                fit: args.fit,
                violations: args.violations,
            }),
        })
    }

    pub(crate) fn run(self, console: &Console) -> anyhow::Result<Outcome> {
        let curve = self.curve.as_ref();
        let curve = curve.map(|asked| asked.read(console)).transpose()?;
        let points = self.points.as_ref();
        let points = points.map(|asked| asked.find(console)).transpose()?;
        let mut layers = Vec::new();
        layers.extend(curve.iter().flat_map(DrawnCurve::layers));
        layers.extend(points.iter().flat_map(DrawnPoints::layers));
        self.output.write(|out| Picture { layers }.write(out))?;
        Ok(Outcome::Fine)
    }
}

/// A curve, and what was measured on it.
struct DrawnCurve<'a> {
    asked: &'a CurveLayers,
    curve: Curve,
    measured: Option<MeasuredCurve>,
    axis: Vec<Segment>,
}

impl CurveLayers {
    fn read(&self, console: &Console) -> anyhow::Result<DrawnCurve<'_>> {
        let split = self.source.read(console)?;
        let (split, measured) = if self.lfs {
            let strokes = self.source.measure_strokes(split, |_| Ok(None), console)?;
            (strokes.split, Some(strokes.measured))
        } else {
            (split, None)
        };
        let (split, axis) = if self.medial_axis {
            let (split, axis) = self.source.measure_axis(split, console)?;
            (split, axis.edges().map(|edge| edge.segment).collect())
        } else {
            (split, Vec::new())
        };
        let curve = split.pieces().clone();
        Ok(DrawnCurve {
            asked: self,
            curve,
            measured,
            axis,
        })
    }
}

impl DrawnCurve<'_> {
    fn layers(&self) -> Vec<Layer<'_>> {
        let axis = self.asked.medial_axis.then_some(Layer::Axis(&self.axis));
        let curve = match &self.measured {
            Some(measured) if self.asked.lfs => Layer::Lfs(measured),
            _ => Layer::Curve(&self.curve),
        };
        axis.into_iter().chain([curve]).collect()
    }
}

/// Points, and what was found from them.
struct DrawnPoints<'a> {
    asked: &'a PointLayers,
    bare: BarePoints,
    curves: Option<Reconstruction>,
    why: Option<Explanation>,
    fitted: Option<Fitted>,
}

impl PointLayers {
    fn find(&self, console: &Console) -> anyhow::Result<DrawnPoints<'_>> {
        let bare = self.source.read(console)?;
        let mut drawn = DrawnPoints {
            asked: self,
            bare,
            curves: None,
            why: None,
            fitted: None,
        };
        if self.fit {
            let points = &drawn.bare.points;
            drawn.fitted = Some(console.during("fitting", |_| denoise(points)));
        }
        if self.edges.is_none() && !self.violations {
            return Ok(drawn);
        }
        let points = &drawn.bare.points;
        // Violations alone are those of HNN-Crust: by its theorem, its leaves show where samples
        // are too sparse.
        let algorithm = self.edges.unwrap_or(&HnnCrust::MUTUAL);
        let (edges, why) = console.during("reconstructing", |_| {
            if self.why {
                reconstruct::explained(algorithm, points, &Known::default())
            } else {
                Ok((algorithm.reconstruct(points), None))
            }
        })?;
        reconstruct::ensure_reasons(self.why, why.as_ref(), algorithm)?;
        drawn.curves = Some(Reconstruction::new(points, edges)?);
        drawn.why = why;
        Ok(drawn)
    }
}

impl DrawnPoints<'_> {
    fn layers(&self) -> Vec<Layer<'_>> {
        let points = &self.bare.points;
        let mut layers = Vec::new();
        if let Some(why) = &self.why {
            layers.push(Layer::Why(points, why));
        } else if let Some(curves) = self.curves.as_ref().filter(|_| self.asked.edges.is_some()) {
            layers.push(Layer::Edges(reconstruct::paths(points, curves)));
        }
        if let Some(curves) = self.curves.as_ref().filter(|_| self.asked.violations) {
            layers.push(Layer::Marks {
                leaves: Places::named(points, curves.leaves()),
                isolated: Places::named(points, curves.isolated()),
                junctions: Places::named(points, curves.junctions()),
            });
        }
        match &self.fitted {
            Some(fitted) => layers.extend(fit::layers(&self.bare, fitted)),
            None => layers.push(Layer::Points(points.points())),
        }
        layers
    }
}
