//! The part of the plane that a picture shows.

use super::{Layer, Picture};
use crate::output::Number;
use curvecrust::DVec2;
use std::io::{self, Write};

/// A box around the data, with a margin.
pub(super) struct Frame {
    /// The corner with the smallest coordinates.
    pub(super) low: DVec2,
    /// Width and height.
    pub(super) extent: DVec2,
    /// The length of a pixel.
    pub(super) pixel: f64,
    /// How many legends stand below each other under the data.
    pub(super) legends: u8,
}

/// The larger side of the data on a page, in pixels.
const SIZE: f64 = 800.0;
/// Around the data, in pixels.
const MARGIN: f64 = 24.0;
/// Below them, for a legend.
pub(super) const LEGEND: f64 = 48.0;

/// Colours on a dark page; those on a light one are attributes.
const DARK: &str = "<style>@media (prefers-color-scheme: dark) {
#page { fill: #14161a } #points, #legend, #reasons { fill: #eee } #curve { stroke: #7d7d7d }
#medial-axis { stroke: #6fb1f5 } #edges path, .certified, #fitted { stroke: #ff6f61 }
#band { fill: #ff6f61 } #outliers { stroke: #6fb1f5 }
.completed { stroke: #c79bf2 } .exchanged, #violations { stroke: #ffa640 }
.required { stroke: #62cc78 } .rejected { stroke: #a0a0a0 }
}</style>";

impl Frame {
    pub(super) fn around(picture: &Picture<'_>) -> Self {
        let (low, high) = picture
            .layers
            .iter()
            .flat_map(framed)
            .fold((DVec2::INFINITY, DVec2::NEG_INFINITY), |(low, high), p| {
                (low.min(p), high.max(p))
            });
        let extent = high - low;
        // Points without extent, and no points, still make a picture.
        let (low, extent) = if extent.max_element() > 0.0 {
            (low, extent)
        } else if low.is_finite() {
            (low - 0.5, DVec2::ONE)
        } else {
            (DVec2::ZERO, DVec2::ONE)
        };
        let pixel = extent.max_element() / SIZE;
        let has = |is_it: fn(&Layer<'_>) -> bool| u8::from(picture.layers.iter().any(is_it));
        let legends = has(|layer| matches!(layer, Layer::Lfs(_)))
            + has(|layer| matches!(layer, Layer::Why(..) | Layer::Dots(_)));
        let below = f64::from(legends) * LEGEND;
        Self {
            low: low - MARGIN * pixel,
            extent: extent + DVec2::new(2.0 * MARGIN, 2.0 * MARGIN + below) * pixel,
            pixel,
            legends,
        }
    }

    /// Opens the document, on white, or on black where readers prefer that.
    pub(super) fn open(&self, out: &mut dyn Write) -> io::Result<()> {
        let Self {
            low, extent, pixel, ..
        } = *self;
        let size = (extent / pixel).round();
        let [x, y, width, height] = [low.x, low.y, extent.x, extent.y].map(Number);
        writeln!(
            out,
            r#"<svg xmlns="http://www.w3.org/2000/svg" width="{}" height="{}" viewBox="{x} {y} {width} {height}">"#,
            size.x, size.y
        )?;
        writeln!(out, "{DARK}")?;
        writeln!(
            out,
            r##"<rect id="page" x="{x}" y="{y}" width="{width}" height="{height}" fill="#fff"/>"##
        )
    }
}

/// The points of a layer that have to be in the picture.
fn framed<'a>(layer: &'a Layer<'_>) -> Box<dyn Iterator<Item = DVec2> + 'a> {
    match layer {
        Layer::Curve(curve) => Box::new(<[DVec2; 2]>::from(curve.bounding_box()).into_iter()),
        Layer::Lfs(measured) => Box::new(measured.dense().points().iter().copied()),
        Layer::Edges(paths) => Box::new(paths.iter().flat_map(|path| path.0.iter())),
        Layer::Points(points) => Box::new(points.iter().copied()),
        Layer::FittedPoints(points, _) => Box::new(points.points().iter().copied()),
        Layer::Fitted(fitted) => Box::new(
            fitted
                .curves
                .iter()
                .flat_map(|c| c.cubics.iter().flatten().copied()),
        ),
        Layer::Why(points, _) => Box::new(points.points().iter().copied()),
        Layer::Joins(dots) | Layer::Dots(dots) => Box::new(dots.points().points().iter().copied()),
        Layer::Axis(_) | Layer::Marks { .. } => Box::new(std::iter::empty()),
    }
}
